# Counts the cost of reference calls without a clock: iterations, matrix factorisations, force
# evaluations, numbers stored in the factorisation, and megabytes that R allocates.
#
#   Rscript tests/ratchets/cost.R           compares with cost.csv
#   Rscript tests/ratchets/cost.R --accept  stores the counts
source("tools/ratchet.R")
suppressPackageStartupMessages(library(codend))
# Compilation during a call would allocate too.
invisible(compiler::enableJIT(0))

trawl <- read_gear("midwater_trawl")
thin_trawl <- update(read_gear("tests/testthat/plans/trawl_1536.yaml"), netting_drag = "blended")
coarse <- settle(trawl, nodes = 1500)
fine <- settle(trawl, nodes = 10000)
thin <- settle(thin_trawl, nodes = 1500)

# Each call returns a state, a trajectory or sensitivities.
calls <- list(
  trawl_bars = function() settle(trawl, nodes = 1500, netting = "bars"),
  trawl_cells = function() settle(trawl, nodes = 1500, netting = "cells"),
  trawl_10000 = function() settle(trawl, nodes = 10000),
  # The tangent to a speed 10 % higher rotates bars by a third of their length.
  trawl_faster = function() settle(update(trawl, towing.speed = "4.4 knot"), from = coarse),
  # A longer warp rotates four bars of two nodes by more than a tenth.
  trawl_longer_warp = function() settle(update(trawl, warps.length = "606 m"), from = fine),
  # Netting of thin twine needed 363 steps with the screen drag model at large angles.
  thin_trawl = function() settle(thin_trawl, nodes = 1500),
  thin_trawl_faster = function() {
    settle(update(thin_trawl, towing.speed = "5 knot"), from = thin)
  },
  thin_trawl_larger_boards = function() {
    settle(update(thin_trawl, otter_boards.area = "13.2 m2"), from = thin)
  },
  towed_cable = function() settle("towed_cable", nodes = 500),
  crossing_cables = function() settle("crossing_cables", nodes = 500),
  panel_bars = function() settle("flat_panel", nodes = 500, netting = "bars"),
  panel_cells = function() settle("flat_panel", nodes = 500, netting = "cells"),
  model_cage = function() settle("model_cage", nodes = 1500),
  # settle() also checks the stability of this equilibrium.
  cage = function() settle("cage", nodes = 1500),
  purse_seine = function() settle("purse_seine", nodes = 300),
  longline = function() settle("longline", nodes = 1500),
  codend = function() settle("t90_codend", nodes = 1500),
  sensitivities = function() sensitivities(coarse),
  tow = function() tow(trawl, until = 20, every = 5, nodes = 500)
)

# Every shipped trawl from its own state at a speed 1 % higher, with its default number of nodes.
trawls <- c("midwater_trawl", "small_midwater_trawl", "poly_noreastern_trawl", "pair_trawl",
  "beam_trawl", "twin_trawl")
calls[paste0(trawls, "_faster")] <- lapply(trawls, function(name) {
  state <- settle(name)
  speed <- 1.01 * codend:::gear_si(state$gear)$towing$speed
  function() settle(update(state$gear, towing.speed = speed), from = state)
})

counts <- c("iterations", "factorisations", "force_evaluations", "factor_entries")

# Returns the counts of one call; NA for counts that its value does not have.
cost_of <- function(call) {
  log <- tempfile()
  Rprofmem(log, threshold = 1000)
  value <- suppressWarnings(call())
  Rprofmem("")
  sizes <- sub(" :.*", "", grep("^[0-9]+ :", readLines(log), value = TRUE))
  unlink(log)
  report <- if (is.data.frame(value)) attributes(value) else value$report
  found <- vapply(counts, function(name) {
    if (is.null(report[[name]])) NA_real_ else as.numeric(report[[name]])
  }, 0)
  c(found, allocated_mb = round(sum(as.numeric(sizes)) / 1e6, 1))
}

table <- data.frame(call = names(calls), t(vapply(calls, cost_of, numeric(5L))), row.names = NULL)
# Netting slackens and tightens during these solves, and rounding decides which lines do so first.
# Without the engine's kernels for AVX2 and AVX-512, these calls take up to 30 % more iterations.
# The counts of all other calls are then the same.
sensitive <- c("trawl_10000", "trawl_longer_warp", "thin_trawl_faster", "panel_bars",
  "midwater_trawl_faster")

# Moves the counts of sensitive calls into columns whose names begin with "about_".
set_apart <- function(table) {
  for (name in counts[1:3]) {
    about <- table$call %in% sensitive
    table[[paste0("about_", name)]] <- replace(table[[name]], !about, NA)
    table[[name]][about] <- NA
  }
  table
}

limits <- list(lower(), lower(relative = 0.35))[rep(1:2, each = 3)]
names(limits) <- c(counts[1:3], paste0("about_", counts[1:3]))
# Allocation depends on the version of R and of packages.
ratchet(table, "tests/ratchets/cost.csv", "call", c(limits, list(
  factor_entries = lower(), allocated_mb = lower(relative = 0.05, absolute = 0.1)
)), set_apart)
