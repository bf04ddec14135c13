# Random variations of the shipped trawl: what designers change, further than they would, and what
# goes wrong at sea.

# Variation number `number`, the same on every machine: list(gear, netting). All of speed (x 0.3 to
# 2), warps (x 0.5 to 2), area of the boards (x 0.5 to 2), mass of boards and of hammers (x 0.5 to
# 2), twine (x 0.7 to 1.5) and hanging ratios of the lines around the net (x 0.9 to 1.1) change; in
# one of four a rope is 5 % shorter, in one of eight a board is lost.
vary_trawl <- function(number, trawl = assembly(read_gear("midwater_trawl"))) {
  set.seed(number, kind = "Mersenne-Twister", normal.kind = "Inversion", sample.kind = "Rejection")
  factor_between <- function(low, high) exp(stats::runif(1, log(low), log(high)))
  plan <- trawl$plan
  changes <- list(towing.speed = times(plan$towing$speed, factor_between(0.3, 2)))
  scale <- function(group, names, field, factor) {
    for (name in names) {
      path <- paste(c(group, name, field), collapse = ".")
      value <- c(changes[[path]], plan[[c(group, name, field)]])[[1L]]
      changes[[path]] <<- times(value, factor)
    }
  }
  roles <- function(group) vapply(plan[[group]], function(part) c(part$role, "")[1L], "")
  of_role <- function(group, role) names(plan[[group]])[roles(group) %in% role]
  scale("ropes", of_role("ropes", "warp"), "length", factor_between(0.5, 2))
  boards <- of_role("pieces", "otter_board")
  scale("pieces", boards, "area", factor_between(0.5, 2))
  scale("pieces", boards, "mass", factor_between(0.5, 2))
  scale("pieces", of_role("pieces", "hammer"), "mass", factor_between(0.5, 2))
  scale("panels", names(plan$panels), c("twine", "diameter"), factor_between(0.7, 1.5))
  for (name in names(plan$ropes)) {
    if (!is.null(plan$ropes[[name]]$along)) {
      field <- if (is.null(plan$ropes[[name]]$length)) "hanging_ratio" else "length"
      scale("ropes", name, field, factor_between(0.9, 1.1))
    }
  }
  netting <- sample(c("bars", "cells"), 1)
  with_length <- names(plan$ropes)[!vapply(plan$ropes, function(r) is.null(r$length), NA)]
  if (stats::runif(1) < 1 / 4) scale("ropes", sample(with_length, 1), "length", 0.95)
  lost <- if (stats::runif(1) < 1 / 8) sample(boards, 1)
  if (length(lost)) {
    changes <- changes[!startsWith(names(changes), paste0("pieces.", lost, "."))]
    changes[paste0("pieces.", lost)] <- list(NULL)
  }
  list(gear = do.call(update, c(list(trawl), changes)), netting = netting)
}

# A plan's value, as "12 m2" or a number, times a factor.
times <- function(value, factor) {
  if (is.numeric(value)) return(value * factor)
  number <- sub(" .*", "", value)
  paste0(signif(as.numeric(number) * factor, 6), substring(value, nchar(number) + 1L))
}

# The trawl with ropes of EA 1e8 N, all of them.
stiffen_ropes <- function(trawl = assembly(read_gear("midwater_trawl"))) {
  ropes <- names(trawl$plan$ropes)
  do.call(update, c(list(trawl), stats::setNames(
    rep(list("100 MN"), length(ropes)), paste0("ropes.", ropes, ".axial_stiffness")
  )))
}
