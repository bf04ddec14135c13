# One process: settles one neighbour of a case and writes its costs. Arguments: version, case, nodes
# (0: as in the plan), neighbour, CPU limit of one settle() (s), file.
for (script in c("release", "cases", "scaled", "own-process")) {
  source(file.path("bench", paste0(script, ".R")))
}
given <- commandArgs(TRUE)
version <- given[1]
library(codend, lib.loc = if (nzchar(versions[[version]])) versions[[version]])
case <- known_cases[[given[2]]]
nodes <- as.numeric(given[3])
neighbour <- as.integer(given[4])
limit <- as.numeric(given[5])

read <- cpu(gear <- case$gear())
gear <- scaled(gear, case$flow, neighbours[neighbour])
before <- memory("VmRSS")

# Reports of all mesh levels of settle(); the state stores only the finest one.
levels <- NULL
inner <- c(release = "settle_level", now = "engine_settle_gear")[[version]]
settle_inside <- getNamespace("codend")[[inner]]
utils::assignInNamespace(inner, function(...) {
  list(...)  # a coarser level of the release is inside an argument
  found <- settle_inside(...)
  levels <<- c(levels, if (version == "now") c(found$levels, list(found)) else list(found$report))
  found
}, "codend")

settle_once <- function() {
  levels <<- NULL
  setTimeLimit(cpu = limit, transient = TRUE)
  on.exit(setTimeLimit())
  if (nodes > 0) settle(gear, nodes, case$netting[[version]]) else settle(gear)
}
first <- cpu(state <- tryCatch(settle_once(), error = identity))
peak <- memory("VmHWM")

# CPU seconds by part of one settle(): sums over its levels, from the coarsest to the finest. `rest`
# is the time outside the parts that the reports list.
costs_of <- function(levels, whole) {
  parts <- c("mesh", "analysis", "forces", "jacobian", "linear")
  known <- vapply(parts, function(part) {
    sum(unlist(lapply(levels, `[[`, paste0("seconds_", part))))
  }, 0)
  c(settle = whole, known, rest = whole - sum(known), coarse = coarse_of(levels))
}

# CPU seconds of all levels except the finest.
coarse_of <- function(levels) {
  seconds <- function(level) sum(unlist(level[startsWith(names(level), "seconds_")]))
  sum(vapply(levels[-length(levels)], seconds, 0))
}

# Number of nodes that connect three or more bars; NA for netting in cells.
knots_of <- function(state) {
  if (case$netting[[version]] != "bars") return(NA)
  sum(tabulate(state$mesh$model$bars$node)[seq_len(ncol(state$position))] >= 3, na.rm = TRUE)
}

steps_of <- function(levels) sum(vapply(levels, `[[`, 0L, "factorisations"))

if (inherits(state, "codend_state")) {
  # The first call of a process also compiles R code, so short runs are timed again.
  costs <- costs_of(levels, first)
  if (first < 2) {
    costs <- NULL
    begun <- proc.time()
    times <- ceiling(0.05 / cpu(settle_once()))  # because the clock is too coarse
    repeat {
      whole <- cpu(for (k in seq_len(times)) settle_once()) / times
      costs <- cbind(costs, costs_of(levels, whole))
      if (ncol(costs) == 9L || sum((proc.time() - begun)[1:2]) > 2) break
    }
    costs <- apply(costs, 1L, stats::median)
  }
  picture <- tempfile(fileext = ".png")
  results <- c(
    list(
      outcome = "settled", nodes = ncol(state$position), knots = knots_of(state),
      levels = length(levels),
      iterations = state$report$iterations, factorisations = steps_of(levels),
      residual = state$report$residual
    ),
    as.list(costs),
    list(
      first = first, read = read, summary = cpu(summary(state)),
      picture = cpu(plot(state, file = picture)), peak = peak, rise = peak - before
    )
  )
  if (given[2] == "warp_200" && neighbour == 1L) {
    points <- state$mesh$points
    run <- state$position[, points[["lower_end"]]] - state$position[, points[["upper_end"]]]
    # continuum solution, from the notes of the plan
    results$error <- sqrt(sum((run[c(1, 3)] - c(799.121, -581.965))^2))
  }
} else {
  said <- gsub("[[:space:]]+", " ", conditionMessage(state))
  if (grepl("CPU time limit", said)) said <- sprintf("not within %g s", limit)
  results <- list(outcome = said, settle = first, peak = peak, rise = peak - before)
}
leave_results(results, given[6])
