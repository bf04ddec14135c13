#' Find the value of a field that gives a required result
#'
#' `find_value()` changes fields of a plan within ranges until measures have the required values.
#' Example: the length of the warps for a door spread of 55 m.
#'
#' @details
#' # Method
#' - Every step settles the gear ([settle()]) from its previous shape and computes exact
#'   [sensitivities()]. The next values follow from them: Newton's method, with shorter steps if a
#'   step increases the distance from the targets. Most searches settle 3 to 6 gears.
#' - All gears have the mesh of the initial gear. It has the accuracy of [settle()].
#' - A target is reached within 1e-4 of its value. The discretisation error is larger, see `error`.
#'
#' # Several solutions
#' A measure can have the same value at several values of a field. The search starts from the value
#' of the plan and follows the derivative, so it usually returns the nearest solution in this
#' direction. Use a narrower range for another solution.
#'
#' # Numbers of fields and targets
#' - More fields than targets: the smallest sum of squared relative changes of the fields.
#' - More targets than fields: the smallest sum of squared relative differences from the targets.
#' - Whole numbers, such as counts of floats: the target is reached if the nearest whole number is
#'   found.
#'
#' # Targets out of reach
#' If no value in the range reaches the target, a second search starts at the other end of the
#' range. The result is the nearest value of both searches. A warning of class
#' `codend_warning_target_not_reached` names it and the fields at an end of their range.
#'
#' @param gear A gear, from [read_gear()] or the constructors, or the name or file of a plan.
#' @param ... One or several fields by path with their ranges, a [value_range()] or two values:
#'   `warps.length = value_range("150 m", "600 m")`. The range must contain the gear's value. Join
#'   fields that change together: `"ropes.a.length + ropes.b.length"`.
#' @param target A list of required values by measure, such as `list(door_spread = "55 m")`. Values
#'   are text with a unit, objects of the package units, or numbers. A measure named without its
#'   unit takes numbers in SI. Formulas as in [optimise_gear()] are names in quotes, with values in
#'   SI: `list("total_drag / door_spread" = 900)`.
#' @param nodes,netting,accuracy Mesh of the gear, as in [settle()].
#' @return An object of class `codend_found`, a list:
#'
#'   - `fields`: a data frame, one row per field, in the unit `unit` of the plan. `value` is the
#'     found value, `start` the value of the plan, `lower` and `upper` are the range. `error` is the
#'     effect of the discretisation errors of the targets; `NA` for whole numbers, at an end of the
#'     range, or without an effect on the targets. `at` is `"lower"` or `"upper"` at an end of the
#'     range, else empty.
#'   - `targets`: a data frame, one row per target. Columns: `measure`, `target`, `value`, `error`
#'     (discretisation error), `unit`, `reached` (`TRUE` or `FALSE`). Formulas are in SI.
#'   - `gear`, `state`: the gear with the found values and its settled state.
#'   - `n_solves`: number of settled gears.
#'
#'   `as.data.frame()` and `tidy()` return `fields`. Wrong arguments raise an error of class
#'   `codend_error_argument`, a wrong field raises `codend_error_plan`. If the gear does not settle
#'   or the search does not converge, the error has the class `codend_error_not_converged`.
#' @seealso [optimise_gear()] for the best value, [sensitivities()], [calibrate()] for measured
#'   data, [codend_tidy].
#' @export
#' @examples
#' # Which length of the warps gives a door spread of 55 m?
#' found <- find_value("small_midwater_trawl", warps.length = value_range("100 m", "400 m"),
#'   target = list(door_spread = "40 m"), nodes = 300)
#' found
#' found$gear
find_value <- function(gear, ..., target, nodes = NULL, netting = NULL, accuracy = NULL) {
  check_given("gear", "target")
  task <- new_find(gear, list(...), target, nodes, netting, accuracy)
  found <- search_targets(task, task$first)
  if (!is_compromise(task) && !all(is_target_reached(found))) found <- search_far_end(task, found)
  finish_find(task, found)
}

is_compromise <- function(task) length(task$targets) > length(task$points$fields)

# Returns the task: list(points, words, targets, of (measures needed), start (values of fields),
# size (of a relative change of 1), scale (of misses), first (the initial gear)).
new_find <- function(gear, change, target, nodes, netting, accuracy) {
  if (is.character(gear)) gear <- read_gear(gear)
  check_settle_arguments(gear, nodes, netting)
  if (!length(change)) {
    abort_argument("{.arg ...} is empty; give a field with its range, such as
      {.code warps.length = value_range(\"150 m\", \"600 m\")}.")
  }
  fields <- free_fields(gear, change, "...")
  if (!is.list(target) || !is_named(target) || anyDuplicated(names(target))) {
    abort_argument("{.arg target} must be a list of values by the names of measures, such as
      {.code list(door_spread = \"55 m\")}.")
  }
  base <- accurate_state(gear, nodes, netting, accuracy)
  points <- new_points(gear, fields, nodes_of(base), netting, list(coarse = base))
  points$count$n_solves <- 1L
  base <- list(values = own_values(fields), gear = gear, state = base, measures = measures(base))
  words <- formula_names(base$measures)
  targets <- read_targets(target, words, vapply(fields, function(field) field$paths[1L], ""))
  task <- list(
    points = points, words = words, targets = targets,
    of = formula_measures(words, lapply(targets, `[[`, "formula")), start = base$values, scale = 1
  )
  task$size <- ifelse(base$values == 0, points$width, abs(base$values))
  scale <- abs(target_numbers(task))
  if (any(scale == 0)) scale[scale == 0] <- abs(new_found(task, base)$value[scale == 0])
  task$scale <- ifelse(scale == 0, 1, scale)
  task$first <- new_found(task, base)
  task
}

# Returns a list per target: formula, target and unit. Single measures are in their own unit,
# formulas in SI.
read_targets <- function(target, words, paths) {
  Map(function(name, value) {
    call <- tryCatch(str2lang(name), error = function(e) {
      abort_argument("{.arg target} has {.val {name}}, which is not a measure or a formula.")
    })
    formula <- ready_expression(call, "target", words, paths)
    number <- formula_numbers(value, formula, words, name)
    if (length(number) != 1L || !is.finite(number)) {
      abort_argument("{.arg target} has the value {.val {value}} for {.code {name}}; it must be one
        number or one text with a unit.")
    }
    row <- words[match(formula$text, words$name), ]
    if (is.na(row$name)) return(list(formula = formula, target = number, unit = ""))
    formula <- ready_expression(as.name(row$column), "target", words, character())
    list(formula = formula, target = number / row$factor, unit = row$unit)
  }, names(target), unname(target))
}

finish_find <- function(task, found) {
  state <- found$point$state
  warn_of_doubts(state)
  if (is.null(found$slopes)) found <- with_slopes(task, found)
  points <- task$points
  formulas <- lapply(task$targets, `[[`, "formula")
  point <- with_errors(points, found$point, points$shared$start)
  error <- formula_errors(points, point, task$words, formulas)
  scaled <- points_scaled(points, found$point$values)
  at <- range_ends(scaled)
  result <- structure(list(
    fields = data.frame(
      field = field_names(points$fields), value = found$point$values,
      error = found_errors(task, found, error, at != "" | whole_fields(points$fields)),
      unit = vapply(points$fields, `[[`, "", "unit"), lower = lower_ends(points$fields),
      upper = upper_ends(points$fields), start = task$start, at = at
    ),
    targets = data.frame(
      measure = vapply(formulas, `[[`, "", "text"), target = target_numbers(task),
      value = found$value, error = error, unit = vapply(task$targets, `[[`, "", "unit"),
      reached = is_target_reached(found), row.names = NULL
    ),
    gear = found$point$gear, state = state, n_solves = points$count$n_solves
  ), class = "codend_found")
  if (!is_compromise(task) && !all(result$targets$reached)) {
    warn_as("target_not_reached", "{not_reached_text(result)}")
  }
  result
}

# Returns the error of every field due to independent `errors` of the targets; NA for `fixed` fields
# and for fields without an effect.
found_errors <- function(task, found, errors, fixed) {
  if (all(fixed)) return(rep(NA_real_, length(fixed)))
  parts <- svd(found$slopes[, !fixed, drop = FALSE])
  used <- parts$d > 1e-8 * max(parts$d, 1e-8)
  inverse <- parts$v[, used, drop = FALSE] %*%
    (t(parts$u[, used, drop = FALSE]) / parts$d[used])
  error <- drop(sqrt(inverse^2 %*% (errors / task$scale)^2))
  error[error == 0] <- NA
  replace(rep(NA_real_, length(fixed)), !fixed, error) * task$size
}
