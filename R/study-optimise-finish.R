# From searches to the optimum that is returned: whole numbers, the last check, the tables.

# accuracy: as in optimise_gear(), a share; NULL stays on the lattice of the search.
finish_optimum <- function(task, runs, accuracy = NULL) {
  best <- best_run(runs)
  if (is.null(best)) abort_not_converged("No gear of the search settles.", report = NULL)
  refined <- refine_optimum(task, best, accuracy)
  whole <- which(whole_fields(task$points$fields))
  if (length(whole)) {
    rounded <- round_optimum(refined$coarse, refined$run, whole)
    refined <- refine_optimum(refined$coarse, rounded, accuracy, rounded$held)
  }
  task <- refined$task
  best <- best_run(c(list(refined$run), begun_run(task, refined$run$best)))
  ended <- best$ended
  tried <- best$best
  found <- optimality_of(task, tried, best$held)
  state <- tried$point$state
  warn_of_doubts(state)
  kinks <- kinks_at(task, tried)
  fields <- optimum_fields(task, tried, found$at)
  result <- list(
    gear = tried$point$gear, state = state,
    aim = optimum_aim(task, tried), fields = fields,
    keep = optimum_keep(task, tried, found$price), optimality = found$left,
    optimal = found$left <= most_optimality && tried$values$worst <= keep_tolerance,
    smooth = !nrow(kinks), kinks = kinks, nodes = state$lattice$nodes,
    accuracy = task_error(task, tried), history = optimum_history(task),
    starts = optimum_starts(task, runs), settles = task$points$count$settles, ended = ended
  )
  if (!all(result$keep$holds)) {
    failed <- result$keep$text[!result$keep$holds]
    cli::cli_warn(
      "No gear was found that settles and keeps {.code {failed}}; the nearest is returned.",
      class = c("codend_warning_conditions_not_kept", "codend_warning"), call = NULL
    )
  }
  structure(result, class = "codend_optimum")
}

# Fields of whole numbers rounded: up and down for the two whose rounding changes the aim most, to
# the nearest for others. The other fields are found again beside each choice.
most_rounded <- 2L
# Settled gears at most for that, each choice.
settles_rounding <- 30L

round_optimum <- function(task, run, whole) {
  tried <- run$best
  exact <- points_values(task$points, tried$scaled)[whole]
  off <- abs(exact - round(exact))
  if (all(off < 1e-6)) return(run)
  telling <- abs(tried$values$aim_slope[whole]) / task$points$width[whole] * (off > 1e-6)
  both <- utils::head(order(-telling), most_rounded)
  both <- both[off[both] > 1e-6]
  choices <- lapply(seq_along(whole), function(k) {
    if (k %in% both) unique(c(floor(exact[k]), ceiling(exact[k]))) else round(exact[k])
  })
  choices <- as.matrix(expand.grid(choices))
  runs <- lapply(seq_len(nrow(choices)), function(k) {
    place <- tried$scaled
    place[whole] <- (choices[k, ] - task$points$lower[whole]) / task$points$width[whole]
    found <- find_optimum(task, place, settles_rounding, held = whole, from = tried$point)
    found$held <- whole
    found
  })
  best <- best_run(runs)
  if (is.null(best)) {
    abort_not_converged("No gear with whole numbers next to the optimum settles.", report = NULL)
  }
  best
}

# The gear as it was, as a search that went nowhere, in a list; none where a tried point is better.
begun_run <- function(task, than) {
  point <- task$base
  if (!is_better(task_values(task, point), than$values)) return(list())
  best <- list(
    scaled = points_scaled(task$points, point$values), point = point,
    values = task_values(task, point, known_slopes(task$points, point, task$of))
  )
  list(list(best = best, ended = "nothing is better than the gear as it was", settles = 0L))
}

# Measures of the aim and the conditions that are not smooth at the optimum by a field.
kinks_at <- function(task, tried) {
  kept <- c("measure", "field", "slope", "slope_unit")
  smooth_by <- tried$point$values != 0 & !whole_fields(task$points$fields)
  fields <- lapply(task$points$fields[smooth_by], `[[`, "paths")
  if (!length(fields) || !length(task$of)) {
    return(data.frame(measure = character(), field = character(), slope = numeric(),
      slope_unit = character()))
  }
  found <- sensitivities(tried$point$state, task$of, fields, secants = FALSE)
  table_rows(as.data.frame(unclass(found))[kept], !found$smooth)
}

optimum_aim <- function(task, tried) {
  begun <- evaluate_formula(task$aim, formula_point(task$points, task$base, task$words))$value
  value <- tried$values$aim
  list(text = task$aim$text, begun = begun, value = value, saving = (begun - value) / abs(begun),
    error = task_errors(task, tried$point)$aim)
}

optimum_fields <- function(task, tried, at) {
  fields <- task$points$fields
  data.frame(
    field = field_names(fields), unit = vapply(fields, `[[`, "", "unit"),
    begun = own_values(fields), value = tried$point$values, lower = lower_ends(fields),
    upper = upper_ends(fields), at = at
  )
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
      values, aim = vapply(rows, `[[`, 0, "aim"), worst = vapply(rows, `[[`, 0, "worst"),
      kept = vapply(rows, `[[`, 0, "worst") <= keep_tolerance,
      settles = vapply(rows, function(row) as.integer(row$settles), 0L), check.names = FALSE
    ),
    gaps = do.call(rbind, lapply(rows, `[[`, "gap"))
  )
}

optimum_starts <- function(task, runs) {
  data.frame(
    start = seq_along(runs),
    aim = vapply(runs, function(run) first_of(run$best$values$aim, NA_real_), 0),
    worst = vapply(runs, function(run) first_of(run$best$values$worst, NA_real_), 0),
    settles = vapply(runs, function(run) as.integer(run$settles), 0L),
    ended = vapply(runs, `[[`, "", "ended")
  )
}
