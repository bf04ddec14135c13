# Entry point of `make bench-tow`: measures cost and error of time integration by scheme.
#
# Every run starts from a prepared trajectory and times only the integration: no plan is read, no
# mesh built and no plot drawn. Errors are distances of nodes from a reference solution on the same
# mesh: maximum and root mean square over all nodes and saved times. Some cases also run in the last
# release, alternately. Argument: largest node count (1e4).
library(codend)
rooms <- c("release", "cases", "own-process", "sizes", "results", "motion-start", "motion-page")
for (script in rooms) source(file.path("bench", paste0(script, ".R")))

given <- commandArgs(TRUE)
most <- if (length(given)) as.numeric(given[1]) else 1e4

# CPU s: shorter runs are repeated and their median counts; longer runs are stopped.
short_run <- 0.3
longest_run <- 40

# Method of a scheme: an accuracy (m), or a constant time step (s; NULL: 0.9 of the longest step
# that is surely stable). The paper's scheme ends its substitutions at 1e-5 m/s.
how <- function(scheme, accuracy = NULL, step = NULL) {
  method <- codend:::tow_method(scheme, if (is.null(accuracy)) 0.01 else accuracy, step)
  if (scheme == "substitution") method$tolerance <- 1e-5
  method
}

# Returns one row: list(CPU s per simulated s, errors, relative energy error, counts, found =
# trajectory). reference: a trajectory, or NULL for the row of the reference itself.
measure_march <- function(begun, until, every, way, reference = NULL) {
  march <- function() codend:::integrate_trajectory(begun, until, every, way$method)
  seconds <- cpu(found <- tryCatch(within_time(march()), error = identity))
  row <- list(nodes = begun$mesh$nodes, scheme = way$method$scheme, setting = way$label)
  if (inherits(found, "error")) return(c(row, remark = conditionMessage(found)))
  if (seconds < short_run) {
    seconds <- stats::median(c(seconds, vapply(1:2, function(k) cpu(march()), 0)))
  }
  last <- found$conditions[nrow(found$conditions), ]
  report <- found$report
  rejected <- report$repeated + report$not_found + report$unbalanced
  row <- c(row, list(
    cpu_per_second = seconds / until, simulated = until, steps = report$steps,
    rejected = rejected / (rejected + report$steps), iterations = report$iterations,
    longest_step = report$longest_step,
    imbalance = abs(last$energy_imbalance) / last$energy_put_through
  ))
  if (is.null(reference)) return(c(row, list(found = found)))
  off <- sqrt(apply((found$position - reference$position)^2, c(2, 3), sum))
  c(row, list(largest_error = max(off), mean_error = sqrt(mean(off^2))))
}

# Returns a value; throws an error if it takes more than `longest_run` CPU seconds.
within_time <- function(value) {
  on.exit(setTimeLimit())
  setTimeLimit(cpu = longest_run, transient = TRUE)
  value
}

# Returns a list of rows of one case: one per method, then the reference. ways: list of list(label,
# method). reference: such a list, or NULL for rows without errors.
measure_case <- function(case, begun, until, every, ways, reference) {
  if (is.null(reference)) {
    rows <- lapply(ways, function(way) measure_march(begun, until, every, way))
  } else {
    reference$label <- paste(reference$label, "(reference)")
    fine <- measure_march(begun, until, every, reference)
    rows <- lapply(ways, function(way) measure_march(begun, until, every, way, fine$found))
    rows <- c(rows, list(fine))
  }
  lapply(rows, function(row) {
    row$found <- NULL
    message(sprintf("%s, %d nodes, %s, %s: %.3g CPU s/s, %.3g m, energy %.2g", case, row$nodes,
      row$scheme, row$setting, shown_of(row$cpu_per_second), shown_of(row$largest_error),
      shown_of(row$imbalance)))
    c(list(case = case), row)
  })
}

shown_of <- function(x) if (is.null(x)) NA_real_ else x

by_accuracy <- function(accuracies) {
  lapply(accuracies, function(accuracy) {
    list(label = sprintf("accuracy %g mm", 1000 * accuracy), method = how("tr_bdf2", accuracy))
  })
}

longest_sure <- function(scheme) list(label = "longest sure step", method = how(scheme))

dir.create(results_folder, showWarnings = FALSE)
rows <- list()
for (nodes in c(1500, 1e4)[c(1500, 1e4) <= most]) {
  # The vessel gains 20 % of its speed in 4 s: fast enough to test every scheme. Explicit schemes
  # integrate only the first part because they are slow.
  fine <- nodes > 5000
  begun <- sped_up_trawl(nodes)
  rows <- c(rows, measure_case(
    "trawl that is sped up", begun, if (fine) 2 else 4, 1,
    by_accuracy(c(0.1, 0.01, if (!fine) 1e-3)),
    if (fine) by_accuracy(1e-4)[[1L]] else longest_sure("rk4")
  ))
  first <- if (fine) 0.02 else 0.5
  rows <- c(rows, measure_case(
    sprintf("trawl that is sped up, the first %g s", first), begun, first, first,
    lapply(c("symplectic_euler", "substitution"), longest_sure),
    if (fine) by_accuracy(1e-4)[[1L]] else longest_sure("rk4")
  ))
  # two minutes of the shipped turn: cost of a tow; the finer one measures only cost
  rows <- c(rows, measure_case(
    "trawl in a turn", turning_trawl(nodes), 120, 20,
    by_accuracy(c(0.1, 0.01)[if (fine) 2L else 1:2]), if (!fine) by_accuracy(1e-3)[[1L]]
  ))
}
rows <- c(rows, measure_case(
  "A: warp, 200 segments", warp_from_rest(), 2170, 10,
  by_accuracy(c(0.1, 0.01, 1e-3)), by_accuracy(1e-4)[[1L]]
))
# released unstretched and still ringing: errors of constant time steps
rows <- c(rows, measure_case(
  "A: warp, 200 segments, its first 20 s", warp_from_rest(), 20, 1,
  by_accuracy(c(0.1, 0.01, 1e-3)),
  list(label = "steps of 1 ms", method = how("tr_bdf2", step = 1e-3))
))
# as long as other programs needed to reach steady state
for (n in c(20, 40, 80)[c(20, 40, 80)^2 <= most]) {
  rows <- c(rows, measure_case(
    sprintf("B: square net, n = %d", n), net_from_rest(n), c("20" = 69, "40" = 169, "80" = 365)[[
      as.character(n)]], 5,
    by_accuracy(c(0.1, 0.01)), by_accuracy(1e-3)[[1L]]
  ))
}
# the purse seine while its first 60 m are shot
for (nodes in c(1300, 1e4)[c(1300, 1e4) <= most]) {
  rows <- c(rows, measure_case(
    "purse seine that is shot", seine_from_vessel(nodes, 20), 20, 5,
    by_accuracy(if (nodes < 5000) c(0.3, 0.1, 0.01) else 0.1),
    if (nodes < 5000) by_accuracy(2e-3)[[1L]]
  ))
}
motion <- bind_rows(rows)
save_table(motion, "motion")

# This tree next to the last release: every case three times, alternately.
build_release()
marched <- bind_rows(unlist(lapply(names(compared_motions), function(name) {
  case <- compared_motions[[name]]
  runs <- expand.grid(version = names(versions), round = 1:3,
    asked = case$sizes[case$sizes <= most], stringsAsFactors = FALSE)
  lapply(seq_len(nrow(runs)), function(k) {
    asked <- format(runs$asked[k], scientific = FALSE)
    found <- in_own_process("measure-integration.R", runs$version[k], name, asked)
    c(list(case = name, version = runs$version[k], asked = runs$asked[k]),
      found[lengths(found) > 0L])
  })
}), recursive = FALSE))
check_sizes(marched)
ratios <- compare_marches(marched)
save_table(ratios, "motion-ratios")
write_motion_page(motion, ratios, whole_run = sum(proc.time()[c("user.self", "sys.self")]))
cat(readLines(file.path(results_folder, "motion.md")), sep = "\n")
