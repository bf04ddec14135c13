# Settles 100 random gears (bench/random-gears.R) and compares the number that converge, and the
# sum of their iterations, with the stored table.
library(codend)
source("tools/ratchet.R")
source("bench/random-gears.R")

settle_gear <- function(number) {
  gear <- random_gear(number)
  state <- tryCatch(suppressWarnings(settle(gear, nodes = 1000)), codend_error = identity)
  converged <- inherits(state, "codend_state")
  data.frame(gear = number, kind = gear$plan$kind, converged = converged,
    iterations = if (converged) state$report$iterations else NA)
}

totals <- function(gears) {
  data.frame(gears = "all gears", converged = sum(gears$converged),
    iterations = sum(gears$iterations, na.rm = TRUE))
}

gears <- do.call(rbind, lapply(1:100, settle_gear))
# Compilers and mathematical libraries round differently, which changes the iterations of a gear.
ratchet(gears, "tests/ratchets/convergence.csv", "gears",
  list(converged = higher(), iterations = lower(relative = 0.02)), totals)
