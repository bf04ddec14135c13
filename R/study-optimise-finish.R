finish_optimum <- function(task, runs) {
  best <- best_run(runs)
  if (is.null(best)) {
    abort_not_converged("The gear does not settle anywhere in the search.", report = NULL)
  }
  refined <- refine_optimum(task, best)
  whole <- which(whole_fields(task$points$fields))
  if (length(whole)) {
    rounded <- round_optimum(refined$coarse, refined$run, whole)
    refined <- refine_optimum(refined$coarse, rounded, rounded$held)
  }
  task <- refined$task
  best <- best_run(c(list(refined$run), initial_run(task, refined$run$best)))
  ended <- best$ended
  tried <- best$best
  found <- optimality_of(task, tried, best$held)
  state <- tried$point$state
  warn_of_doubts(state)
  kinks <- kinks_at(task, tried)
  fields <- task$points$fields
  result <- list(
    gear = tried$point$gear, state = state,
    objective = optimum_objective(task, tried),
    fields = data.frame(
      field = field_names(fields), unit = vapply(fields, `[[`, "", "unit"),
      begun = own_values(fields), value = tried$point$values, lower = lower_ends(fields),
      upper = upper_ends(fields), at = found$at
    ),
    keep = optimum_keep(task, tried, found$price), optimality = found$left,
    optimal = found$left <= most_optimality && tried$values$worst <= keep_tolerance,
    smooth = !nrow(kinks), kinks = kinks, nodes = state$mesh$nodes,
    accuracy = task_error(task, tried), history = optimum_history(task),
    starts = data.frame(
      start = seq_along(runs),
      objective = vapply(runs, function(run) first_of(run$best$values$objective, NA_real_), 0),
      worst = vapply(runs, function(run) first_of(run$best$values$worst, NA_real_), 0),
      n_solves = vapply(runs, function(run) as.integer(run$n_solves), 0L),
      ended = vapply(runs, `[[`, "", "ended")
    ),
    n_solves = task$points$count$n_solves, ended = ended
  )
  if (!all(result$keep$holds)) {
    failed <- result$keep$text[!result$keep$holds]
    warn_as("conditions_not_kept", "No settled gear meets {.code {failed}}; the result is the
      nearest gear.")
  }
  structure(result, class = "codend_optimum")
}

# Fields with the largest effect on the objective are rounded up and down, others to the nearest
# number.
most_rounded <- 2L
# Largest number of settled gears per rounded choice.
n_solves_rounding <- 30L

round_optimum <- function(task, run, whole) {
  tried <- run$best
  exact <- points_values(task$points, tried$scaled)[whole]
  off <- abs(exact - round(exact))
  if (all(off < 1e-6)) return(run)
  telling <- abs(tried$values$objective_gradient[whole]) / task$points$width[whole] * (off > 1e-6)
  both <- utils::head(order(-telling), most_rounded)
  both <- both[off[both] > 1e-6]
  choices <- lapply(seq_along(whole), function(k) {
    if (k %in% both) unique(c(floor(exact[k]), ceiling(exact[k]))) else round(exact[k])
  })
  choices <- as.matrix(expand.grid(choices))
  runs <- lapply(seq_len(nrow(choices)), function(k) {
    place <- tried$scaled
    place[whole] <- (choices[k, ] - task$points$lower[whole]) / task$points$width[whole]
    found <- find_optimum(task, place, n_solves_rounding, held = whole, from = tried$point)
    found$held <- whole
    found
  })
  best <- best_run(runs)
  if (is.null(best)) {
    abort_not_converged("The gear with whole numbers next to the optimum does not settle.", report
      = NULL)
  }
  best
}

# Returns list(the initial gear as a search) if it is better than `than`, else list().
initial_run <- function(task, than) {
  point <- task$base
  if (!is_better(task_values(task, point), than$values)) return(list())
  best <- list(
    scaled = points_scaled(task$points, point$values), point = point,
    values = task_values(task, point, known_derivatives(task$points, point, task$of))
  )
  list(list(best = best, ended = "no gear is better than the initial one", n_solves = 0L))
}

# Returns the measures of the objective and conditions with a kink at the optimum, by field.
kinks_at <- function(task, tried) {
  kept <- c("measure", "field", "derivative", "derivative_unit")
  smooth_by <- tried$point$values != 0 & !whole_fields(task$points$fields)
  fields <- lapply(task$points$fields[smooth_by], `[[`, "paths")
  if (!length(fields) || !length(task$of)) {
    return(data.frame(measure = character(), field = character(), derivative = numeric(),
      derivative_unit = character()))
  }
  state <- complete_point(task$points, tried$point)$state
  found <- sensitivities(state, task$of, fields, secants = FALSE)
  table_rows(as.data.frame(unclass(found))[kept], !found$smooth)
}

optimum_objective <- function(task, tried) {
  begun <- evaluate_formula(task$objective, formula_point(task$points, task$base, task$words))$value
  value <- tried$values$objective
  list(text = task$objective$text, begun = begun, value = value,
    saving = (begun - value) / abs(begun),
    error = task_errors(task, tried$point)$objective)
}

optimum_keep <- function(task, tried, price) {
  values <- tried$values
  error <- task_errors(task, tried$point)$keep
  short <- if (length(error)) values$gap * task$limits + 2 * error
  data.frame(
    text = vapply(task$keep, `[[`, "", "text"), left = values$left, right = values$right,
    holds = values$gap <= keep_tolerance & (!values$equal | values$gap >= -keep_tolerance),
    active = values$equal | values$gap > -active_share, price = price, error = error,
    sure = !values$equal & short <= 0
  )
}

optimum_history <- function(task) {
  rows <- task$history$rows
  values <- do.call(rbind, lapply(rows, `[[`, "values"))
  colnames(values) <- field_names(task$points$fields)
  structure(
    data.frame(
      values, objective = vapply(rows, `[[`, 0, "objective"), worst = vapply(rows, `[[`, 0,
        "worst"),
      kept = vapply(rows, `[[`, 0, "worst") <= keep_tolerance,
      n_solves = vapply(rows, function(row) as.integer(row$n_solves), 0L), check.names = FALSE
    ),
    gaps = do.call(rbind, lapply(rows, `[[`, "gap"))
  )
}
