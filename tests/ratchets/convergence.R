# Settles 100 random gears in either kind of netting and 12 random rigs (bench/random-gears.R). Most
# rigs have a lost clump or a torn-off net. Compares the number that converge, and the sum of their
# iterations, with the stored table.
library(codend)
source("tools/ratchet.R")
source("bench/random-gears.R")

settle_gear <- function(number) {
  is_rig <- number > 100
  gear <- if (is_rig) random_rig(number - 100) else random_gear(number)
  state <- tryCatch(suppressWarnings(settle(gear, nodes = 1000, netting = attr(gear, "netting"))),
    codend_error = identity)
  converged <- inherits(state, "codend_state")
  data.frame(gear = number, kind = if (is_rig) "rig" else attr(gear, "drawn"),
    converged = converged, iterations = if (converged) state$report$iterations else NA)
}

totals <- function(gears) {
  data.frame(gears = "all gears", converged = sum(gears$converged),
    iterations = sum(gears$iterations, na.rm = TRUE))
}

gears <- do.call(rbind, lapply(1:112, settle_gear))
# Compilers and mathematical libraries round differently, which changes the iterations of a gear.
ratchet(gears, "tests/ratchets/convergence.csv", "gears",
  list(converged = higher(), iterations = lower(relative = 0.02)), totals)
