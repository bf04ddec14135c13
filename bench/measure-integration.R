# One process: integrates one case in time and writes its costs. Arguments: version, case, nodes,
# file.
for (script in c("release", "cases", "own-process", "motion-start")) {
  source(file.path("bench", paste0(script, ".R")))
}
given <- commandArgs(TRUE)
version <- given[1]
library(codend, lib.loc = if (nzchar(versions[[version]])) versions[[version]])
if (version == "release") {
  tow_schedule <- function(...) list(control_every = 10, ...)
  scheme <- "bdf2"
  integrate <- codend:::march_trajectory
} else {
  scheme <- codend:::engine_schemes()$name[1L]
  integrate <- codend:::integrate_trajectory
}
usual_accuracy <- 0.01 # m
case <- compared_motions[[given[2]]]
begun <- case$begin(as.numeric(given[3]))
march <- function(accuracy = usual_accuracy) {
  integrate(begun, case$until, case$every, codend:::tow_method(scheme, accuracy, NULL))
}

# The first call of a process also compiles R code.
found <- march()
seconds <- stats::median(vapply(1:3, function(k) cpu(march()), 0))
report <- found$report
# Cost and root mean square distance of nodes from a run with a thirtieth of the accuracy.
reference <- march(usual_accuracy / 30)
costs <- function(seconds, found) {
  list(cost = seconds / case$until,
    error = sqrt(mean(colSums((found$position - reference$position)^2))))
}
costs_at <- function(accuracy) {
  seconds <- cpu(run <- march(accuracy))
  costs(seconds, run)
}
leave_results(c(list(
  nodes = ncol(begun$position), steps = report$steps,
  repeated = report$repeated, not_found = report$not_found, iterations = report$iterations,
  factorisations = report$factorisations
), unlist(list(
  loose = costs_at(3 * usual_accuracy), usual = costs(seconds, found),
  tight = costs_at(usual_accuracy / 3)
), recursive = FALSE)), given[4])
