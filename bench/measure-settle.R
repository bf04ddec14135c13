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

# Reports of the levels that settle() goes through, which a state keeps of the finest alone.
levels <- NULL
settle_gear <- codend:::engine_settle_gear
utils::assignInNamespace("engine_settle_gear", function(...) {
  found <- settle_gear(...)
  levels <<- c(levels, found$levels, list(found))
  found
}, "codend")

settle_once <- function() {
  levels <<- NULL
  setTimeLimit(cpu = limit, transient = TRUE)
  on.exit(setTimeLimit())
  if (nodes > 0) settle(gear, nodes, case$netting) else settle(gear)
}
first <- cpu(state <- tryCatch(settle_once(), error = identity))
peak <- memory("VmHWM")

# CPU seconds by part of one settle(): sums over its levels, from the coarsest to the finest. `rest`
# is what no level's report names.
costs_of <- function(levels, whole) {
  parts <- c("lattice", "analysis", "forces", "jacobian", "linear")
  known <- vapply(parts, function(part) {
    sum(vapply(levels, `[[`, 0, paste0("seconds_", part)))
  }, 0)
  c(settle = whole, known, rest = whole - sum(known), coarse = coarse_of(levels))
}

# Of all levels but the finest.
coarse_of <- function(levels) {
  seconds <- function(level) sum(unlist(level[startsWith(names(level), "seconds_")]))
  sum(vapply(levels[-length(levels)], seconds, 0))
}

steps_of <- function(levels) sum(vapply(levels, `[[`, 0L, "factorisations"))

if (inherits(state, "codend_state")) {
  # The first call of a process compiles R code on its way: the next ones tell what a call takes.
  costs <- costs_of(levels, first)
  if (first < 2) {
    costs <- NULL
    begun <- proc.time()
    repeat {
      whole <- cpu(settle_once())
      costs <- cbind(costs, costs_of(levels, whole))
      if (ncol(costs) == 9L || sum((proc.time() - begun)[1:2]) > 2) break
    }
    costs <- apply(costs, 1L, stats::median)
  }
  picture <- tempfile(fileext = ".png")
  results <- c(
    list(
      outcome = "settled", nodes = ncol(state$position), levels = length(levels),
      iterations = state$report$iterations, factorisations = steps_of(levels),
      residual = state$report$residual
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
