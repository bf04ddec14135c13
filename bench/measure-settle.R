# One process: settles one case from one crude start and leaves what that took.
# Arguments: case, nodes (0: as the plan says), start, most CPU seconds of one settle(), file.
library(codend)
source("bench/cases.R")
source("bench/crude-starts.R")
source("bench/own-process.R")

given <- commandArgs(TRUE)
case <- known_cases[[given[1]]]
nodes <- as.numeric(given[2])
limit <- as.numeric(given[4])

read <- cpu(gear <- case$gear())
use_start(as.integer(given[3]))
before <- memory("VmRSS")
settle_once <- function() {
  setTimeLimit(cpu = limit, transient = TRUE)
  on.exit(setTimeLimit())
  if (nodes > 0) settle(gear, nodes, case$netting) else settle(gear)
}
first <- cpu(state <- tryCatch(settle_once(), error = identity))
peak <- memory("VmHWM")

parts <- c("lattice", "analysis", "forces", "jacobian", "linear")
# CPU seconds by part of one settle(); `rest` is what the report does not name.
costs_of <- function(report, whole) {
  known <- vapply(parts, function(part) {
    seconds <- report[[paste0("seconds_", part)]]
    if (is.null(seconds)) NA_real_ else seconds
  }, 0)
  c(settle = whole, known, rest = whole - sum(known, na.rm = TRUE))
}

if (inherits(state, "codend_state")) {
  # The first call of a process compiles R code on its way: the next ones tell what a call takes.
  costs <- costs_of(state$report, first)
  if (first < 2) {
    costs <- NULL
    begun <- proc.time()
    repeat {
      whole <- cpu(again <- settle_once())
      costs <- cbind(costs, costs_of(again$report, whole))
      if (ncol(costs) == 9L || sum((proc.time() - begun)[1:2]) > 2) break
    }
    costs <- apply(costs, 1L, stats::median)
  }
  picture <- tempfile(fileext = ".png")
  results <- c(
    list(
      outcome = "settled", nodes = ncol(state$position), iterations = state$report$iterations,
      factorisations = state$report$factorisations, residual = state$report$residual
    ),
    as.list(costs),
    list(
      first = first, read = read, summary = cpu(summary(state)),
      picture = cpu(plot(state, file = picture)), peak = peak, rise = peak - before
    )
  )
  if (given[1] == "warp_200") {
    points <- state$lattice$points
    run <- state$position[, points[["lower_end"]]] - state$position[, points[["upper_end"]]]
    # the continuum's, as the plan's notes say
    results$error <- sqrt(sum((run[c(1, 3)] - c(799.121, -581.965))^2))
  }
} else {
  said <- gsub("[[:space:]]+", " ", conditionMessage(state))
  if (grepl("CPU time limit", said)) said <- sprintf("not within %g s", limit)
  results <- list(outcome = said, settle = first, peak = peak, rise = peak - before)
}
leave_results(results, given[5])
