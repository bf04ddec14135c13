# Random variations of the shipped trawl: design changes beyond the usual range, and damage at sea.

# Returns variation number `number`, the same on every machine: list(gear, netting). Random factors
# change speed (0.3 to 2) and twine (0.7 to 1.5). Others change warps,
# board area, board mass and hammer mass (0.5 to 2), and hanging ratios of the lines (0.9 to 1.1).
# In 25 % a rope is 5 % shorter; in 12.5 % a board is lost.
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

# The trawl with all ropes of EA 1e8 N.
stiffen_ropes <- function(trawl = assembly(read_gear("midwater_trawl"))) {
  ropes <- names(trawl$plan$ropes)
  do.call(update, c(list(trawl), stats::setNames(
    rep(list("100 MN"), length(ropes)), paste0("ropes.", ropes, ".axial_stiffness")
  )))
}
