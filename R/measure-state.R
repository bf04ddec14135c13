#' Measures of a state
#'
#' Computes the measures that the plan defines and the standard measures of every gear, such as
#' spreads, heights and drag.
#'
#' Measures of the plan come first. Their names are the plan's names plus the unit: `door_spread`
#' becomes `door_spread_m`. The standard measures that apply to the gear follow, except those with
#' the same name as a measure of the plan. The measures of each net of a rig come last, net by net.
#'
#' A position between two nodes, such as the middle of a rope, is interpolated.
#'
#' `vignette("measures", "codend")` shows the measures in pictures and explains how sensors measure
#' them.
#'
#' @section Discretisation error:
#' The attribute `error` estimates the error from the finite number of nodes.
#' \resultErrorsWithinTwo{} of measures are within two standard errors of the value on a much finer
#' model (`make errors`). Errors of drag coefficients and other inputs are not included; see
#' [uncertainty()].
#'
#' The estimate compares the coarser models that [settle()] goes through. If all of them are coarse,
#' a model with 2.6 times as many nodes is settled when errors are first needed. The fit has two
#' terms:
#' - a drift with the element length to the power 0.75 to 1.5, fitted by generalised least squares;
#' - a scatter between models.
#'
#' Lower limits keep the estimate from being too small by chance:
#' - half of the usual error for the class of measure (forces, openings, positions, slack and
#'   tension of netting);
#' - for gears with netting, 0.2 % at 1,500 nodes, and less with more nodes in proportion to the
#'   element length;
#' - for slack netting, 10 % of its value and 0.3 percentage points.
#'
#' The true error exceeds five estimates for \resultErrorsMissedCoarse{} of the measures with 300 or
#' 500 nodes, and for \resultErrorsMissedDefault{} with 1,500 nodes.
#'
#' A moment of a tow has the relative errors of the settled state at its start. The error in time is
#' added, see [tow()]. The errors are `NA` if the tow did not start from a settled state and has no
#' comparison on another model.
#'
#' @eval measure_help()
#'
#' @param state A state, from [settle()] or [state_at()]; for `measure_definitions()` also `NULL`.
#' @return `measures()` returns named numbers of class `codend_measures`. Each name ends in its
#'   unit. The print lists the main measures first, with the digits that their errors allow.
#'   [as.data.frame()] has the columns `measure`, `value`, `error` and `unit`. Attributes, all named
#'   by measure:
#'   - `unit`: the unit as printed, such as `"m3/h"`.
#'   - `error`: the standard discretisation error, in the unit of the measure.
#'   - `main`: `TRUE` for the main measures, which `settle(accuracy = )` refers to.
#'
#'   Arithmetic returns plain named numbers. `measures(a) / measures(b)` contains the measures of
#'   both states, without ratios of two zeros.
#' @seealso [settle()]; [in_units()] for other units; [findings()] for values that need attention;
#'   [as.data.frame()][as.data.frame.codend_state] for values along the gear; [uncertainty()] for
#'   the effect of uncertain inputs.
#' @examples
#' state <- settle("midwater_trawl", nodes = 300)
#' found <- measures(state)
#' found
#' found[["total_drag_kN"]]
#' attr(found, "error")[["total_drag_kN"]]
#' found["total_drag_kN"] * 1000
#' @export
measures <- function(state) {
  check_given("state")
  check_is_state(state)
  found <- state_values(state)
  measured <- new_measures(found$values, found$kinds, state_errors(state, found), found$light,
    found$net)
  # The measures of a rig come first, then its nets.
  measured[order(match(attr(measured, "net"), c("", names(state$si$nets))))]
}

# Returns measures without errors: list(values (SI, by name), kinds, net (net of a rig that each
# measure belongs to, or ""), light = TRUE if drag is small compared with the weights).
state_values <- function(state) {
  drag <- list(list(kind = "total_drag"))
  values <- measure_values(state, c(measure_request(state$si), drag))
  light <- abs(values[length(values)]) < light_drag * sum(abs(state$mesh$model$load))
  found <- valid_answers(state$si, values[-length(values)])
  c(found, list(net = net_of_names(names(found$values), state$si), light = light))
}

# Returns the names of the main measures of state_values(), for short prints.
printed_names <- function(found) {
  printed_measures(new_measures(found$values, found$kinds, NA * found$values, found$light,
    found$net))
}

# Keeps the answers to measure_request() that apply to the gear; standard measures may be NaN.
# Returns list(values by name, kinds), SI.
valid_answers <- function(si, answers) {
  kinds <- measured_kinds(si)
  applies <- !is.nan(answers) | seq_along(answers) <= length(si$measures)
  list(values = setNames(answers, names(kinds))[applies], kinds = kinds[applies])
}

# Returns kinds of measures by name with unit: measures of the plan, then standard measures.
measured_kinds <- function(si) {
  own <- vapply(si$measures, `[[`, "", "column")
  standard <- setNames(standard_measures, standard_names())
  c(
    setNames(lapply(si$measures, function(measure) measure_kinds[[measure$kind]]), own),
    standard[setdiff(names(standard), own)]
  )
}

# Returns the measures of a gear as a request for measure_values().
measure_request <- function(si) {
  kinds <- measured_kinds(si)
  standard <- kinds[seq_along(kinds) > length(si$measures)]
  c(si$measures, lapply(standard, function(measure) list(kind = measure$kind)))
}

standard_names <- function() with_unit(names(standard_measures), measure_units(standard_measures))

measure_units <- function(kinds) vapply(kinds, `[[`, "", "unit", USE.NAMES = FALSE)

measure_strings <- function(kinds, of = "definition") vapply(kinds, `[[`, "", of, USE.NAMES = FALSE)

#' @return `measure_definitions()` returns a data frame. Without a state it has one row per kind of
#'   measure that a plan may define, and one per standard measure. With a state it has one row per
#'   measure of the state, named as in `measures()`. Columns:
#'   - `name`, `unit`, `definition`: strings.
#'   - `sensor`: the instrument on a vessel or a model, and its systematic differences; `NA` if
#'     unknown.
#'   - `user_defined`: `TRUE` for measures that a plan must define (only without a state).
#' @rdname measures
#' @export
measure_definitions <- function(state = NULL) {
  kinds <- all_kinds()
  if (is.null(state)) {
    name <- names(kinds)
  } else {
    found <- measures(state)
    name <- names(found)
    kinds <- kinds[attr(found, "kind")]
  }
  table <- data.frame(
    name = name, unit = measure_units(kinds), definition = measure_strings(kinds),
    sensor = measure_strings(kinds, "sensor")
  )
  if (is.null(state)) table$user_defined <- !name %in% names(standard_measures)
  table
}

# Returns the kinds of measures that a plan may define, sorted by name.
user_measure_kinds <- function() measure_kinds[sort(names(measure_kinds), method = "radix")]

all_kinds <- function() c(user_measure_kinds(), standard_measures)

measure_help <- function() {
  items <- function(kinds, names) {
    paste0("- `", names, "` (", measure_units(kinds), "): ", measure_strings(kinds))
  }
  asked <- user_measure_kinds()
  c(
    "@section Measures that a plan may define:", items(asked, names(asked)),
    "@section Standard measures:", items(standard_measures, standard_names())
  )
}

# A measure's name on a state or trajectory is an error that names the function to use.
#' @rawNamespace S3method(base::"$",codend_state)
`$.codend_state` <- function(x, name) {
  if (name %in% computed_fields) x[[name]] else field_of(x, name, "A state", "measures(state)")
}

#' @rawNamespace S3method(base::"$",codend_trajectory)
`$.codend_trajectory` <- function(x, name) {
  if (name == "mesh") return(x[[name]])
  field_of(x, name, "A trajectory", "as.data.frame(trajectory)")
}

# Returns an element of a result, NULL if there is none. known: names of all elements. A former
# name is an error.
#' @rawNamespace
#' S3method(base::"$",codend_calibration,result_element)
#' S3method(base::"$",codend_found,result_element)
#' S3method(base::"$",codend_optimum,result_element)
#' S3method(base::"$",codend_uncertainty,result_element)
result_element <- function(x, name, known = names(x)) {
  now <- if (!name %in% known) intersect(former_names[[name]], known)
  if (!length(now)) return(.subset2(x, name))
  abort_argument("{.field {name}} is now called {.field {now}}.")
}

field_of <- function(x, name, what, call) {
  if (name %in% names(x)) return(.subset2(x, name))
  if (name %in% c(standard_names(), names(standard_measures))) {
    abort_argument("{what} has no {.field {name}}; use {.code {call}} for the measures.")
  }
  result_element(x, name, c(names(x), computed_fields))
}

has_towing <- function(state) state$si$towing$speed != 0
