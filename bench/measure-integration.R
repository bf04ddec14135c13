# One process: integrates one case in time and writes its costs. Arguments: version, case, nodes,
# file.
for (script in c("release", "cases", "own-process", "motion-start")) {
  source(file.path("bench", paste0(script, ".R")))
}
given <- commandArgs(TRUE)
version <- given[1]
library(codend, lib.loc = if (nzchar(versions[[version]])) versions[[version]])
case <- compared_motions[[given[2]]]
begun <- case$begin(as.numeric(given[3]))
method <- codend:::tow_method(codend:::engine_schemes()$name[1L], codend:::default_accuracy, NULL)
march <- function() codend:::integrate_trajectory(begun, case$until, case$every, method)

# The first call of a process also compiles R code.
found <- march()
seconds <- stats::median(vapply(1:3, function(k) cpu(march()), 0))
report <- found$report
leave_results(list(
  nodes = begun$mesh$nodes, cpu_per_second = seconds / case$until, steps = report$steps,
  repeated = report$repeated, not_found = report$not_found, iterations = report$iterations,
  factorisations = report$factorisations
), given[4])
