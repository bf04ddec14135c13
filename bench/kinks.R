# Checks optimise_gear() against the best gear of a grid in ten cases with kinks. The cases are
# trawls of three kinds, all with 300 nodes and without a finer mesh. Writes bench/results/kinks.md.
library(codend)
for (script in c("results", "random-gears")) source(file.path("bench", paste0(script, ".R")))

nodes <- 300
across <- 13  # gears of the grid along each of two fields

# of: gear; aim: objective (maximised, or minimised if sign is 1); limit: measure with a bound,
# given as a fraction (share) of its present value; change: ranges of two fields.
case <- function(of, objective, limit, share, change, sign = -1) {
  list(of = of, objective = objective, limit = limit, share = share, change = change, sign = sign)
}
bottom <- "poly_noreastern_trawl"
middle <- "small_midwater_trawl"
pair <- "pair_trawl"
pair_bridles <- c("19.4 m", "20.6 m")
cases <- list(
  case(pair, "net_mouth_height_m", "total_drag_kN", 1.02, list(
    bridles.upper.length = pair_bridles, floats.number = c(15L, 45L))),
  case(pair, "mouth_area_m2", "total_drag_kN", 1, list(
    bridles.upper.length = pair_bridles, vessels.distance = c("80 m", "130 m"))),
  case(pair, "net_mouth_height_m", "wing_end_spread_m", -0.98, list(
    bridles.upper.length = pair_bridles, bridles.lower.length = pair_bridles)),
  case(pair, "total_drag_kN", "mouth_area_m2", -1, list(
    floats.number = c(15L, 45L), weights.mass = c("40 kg", "160 kg")), 1),
  case(bottom, "net_mouth_height_m", "total_drag_kN", 1.01, list(
    bridles.upper.length = c("53.9 m", "55.9 m"), warps.length = c("80 %", "120 %"))),
  case(bottom, "mouth_area_m2", "total_drag_kN", 1, list(
    bridles.upper.length = c("53.9 m", "55.9 m"), otter_boards.area = c("4 m2", "6 m2"))),
  case(bottom, "total_drag_kN", "mouth_area_m2", -1, list(
    warps.length = c("80 %", "120 %"), otter_boards.area = c("4 m2", "6 m2")), 1),
  case(middle, "net_mouth_height_m", "total_drag_kN", 1.01, list(
    hand_ropes.upper.length = c("69 m", "71 m"), hammers.mass = c("100 kg", "300 kg"))),
  case(middle, "mouth_area_m2", "total_drag_kN", 1, list(
    floats.number = c(20L, 60L), otter_boards.area = c("3 m2", "5 m2"))),
  case(middle, "total_drag_kN", "mouth_area_m2", -1, list(
    hand_ropes.upper.length = c("69 m", "71 m"), otter_boards.area = c("3 m2", "5 m2")), 1)
)

# Converts a range in percent to values: percent of the plan's own value.
own_range <- function(plan, field, range) {
  if (is.numeric(range) || !all(grepl("%$", range))) return(range)
  own <- Reduce(function(x, name) x[[name]], strsplit(field, ".", fixed = TRUE)[[1L]], plan)
  own <- if (is.list(own)) own$value else own
  shares <- as.numeric(sub(" *%", "", range)) / 100
  vapply(shares, function(share) scaled_value(own, share), "", USE.NAMES = FALSE)
}

run <- function(k) {
  one <- cases[[k]]
  gear <- read_gear(one$of)
  start <- measures(settle(gear, nodes = nodes))
  change <- one$change
  for (field in names(change)) change[[field]] <- own_range(gear$plan, field, change[[field]])
  grid <- lapply(change, function(range) {
    if (is.numeric(range)) return(unique(round(seq(range[1L], range[2L], length.out = across))))
    ends <- as.numeric(sub(" .*", "", range))
    paste(seq(ends[1L], ends[2L], length.out = across), sub("^[^ ]* ", "", range[1L]))
  })
  design <- do.call(expand.grid, c(grid, stringsAsFactors = FALSE))
  table <- suppressWarnings(vary(gear, design, nodes = nodes))
  limit <- abs(one$share) * start[[one$limit]]
  kept <- if (one$share > 0) table[[one$limit]] <= limit else table[[one$limit]] >= limit
  best <- max(-one$sign * table[[one$objective]][which(kept)])
  objective <- stats::as.formula(paste("~", if (one$sign < 0) "-", one$objective))
  keep <- stats::as.formula(
    sprintf("~ %s %s %.10g", one$limit, if (one$share > 0) "<=" else ">=", limit))
  found <- suppressWarnings(
    optimise_gear(gear, objective, keep, change, nodes = nodes))
  value <- -found$objective$value
  row <- list(
    gear = one$of, objective = paste(if (one$sign < 0) "large" else "small", one$objective),
    limit = sprintf("%s %s %.4g", one$limit, if (one$share > 0) "at most" else "at least", limit),
    `as it was` = start[[one$objective]], `best of the grid` = -one$sign * best,
    `optimise_gear()` = -one$sign * value,
    `better than the grid, %` = 100 * (value - best) / abs(best),
    kinks = nrow(found$kinks), n_solves = found$n_solves
  )
  cat(k, one$of, names(change), signif(row[["better than the grid, %"]], 3), found$n_solves, "\n")
  row
}

rows <- lapply(seq_along(cases), function(k) {
  tryCatch(run(k), error = function(e) {
    cat(k, conditionMessage(e), "\n")
    NULL
  })
})
rows <- Filter(length, rows)
table <- bind_rows(rows)
names(table) <- names(rows[[1L]])
save_page(c(
  "# Optima at kinks beside the best of a grid", "",
  sprintf("Written by `Rscript bench/kinks.R`: grids of %d by %d gears with %d nodes. %s", across,
    across, nodes, measured_with()), "",
  markdown_table(table)
), "kinks")
