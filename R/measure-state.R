#' Measures of a state
#'
#' What the plan asks to be measured, and the measures that every gear has.
#'
#' Measures of the plan come first, under the plan's names with their unit added (`door_spread`
#' becomes `door_spread_m`). Then follow the standard ones that apply, unless the plan has a measure
#' of the same name.
#'
#' `vignette("measures", "codend")` shows them in pictures, and how sensors see them.
#'
#' @eval measure_help()
#'
#' @param state A state, from [settle()] or [state_at()]; for `measure_definitions()` also `NULL`.
#' @return `measures()` gives named numbers of class `codend_measures`; every name ends in its unit,
#'   which the attribute `unit` has as it is printed (`"m3/h"`), by the measures' names. The
#'   attribute `error` has the standard discretisation error of each, in its unit:
#'   \resultErrorsWithinTwo{} of measures lie within twice their error of the value on a much finer
#'   model (`make errors`). It is estimated from the
#'   coarser models of the gear that [settle()] goes through and, where these are all coarse, from
#'   one 2.6 times as fine that is settled when errors are first needed: a drift with the length of
#'   elements to the power 0.75 to 1.5, as these models show it, and a scatter, fitted by
#'   generalised least squares; at least half of what is usual in the gear's measures of that class
#'   (forces, openings, places, slack and tension of netting) and, of gears with netting, 0.2 % with
#'   1,500 nodes (less with more, by the length of elements; of slack netting 10 % of it and 0.3
#'   points). The true error exceeds five estimates for \resultErrorsMissedCoarse{} of the measures
#'   of models with 300 or 500 nodes, and for \resultErrorsMissedDefault{} with 1,500 nodes. It is
#'   the discretisation's alone, not of drag coefficients. Of a moment of a tow it is that of the
#'   settled state that the tow started from,
#'   as a share of each measure, together with that of the steps by their accuracy: 1.5 times it of
#'   lengths, 2.5 % of forces at 0.01 m; `NA` where the tow did not start from a settled state, as
#'   one that is shot. The attribute `main` says which measures `settle(accuracy = )` looks at.
#' @examples
#' found <- measures(settle("crossing_cables"))
#' found[["total_drag_kN"]]
#' attr(found, "unit")
#' @export
measures <- function(state) {
  check_given("state")
  check_is_state(state)
  found <- state_values(state)
  new_measures(found$values, found$kinds, state_errors(state, found), found$light)
}

# The measures of a state without their errors: list(values (SI, by name), kinds, light = whether
# its drag is little next to its weights).
state_values <- function(state) {
  drag <- list(list(kind = "total_drag"))
  values <- measure_values(state, c(asked_of(state$si), drag))
  light <- abs(values[length(values)]) < light_drag * sum(abs(state$lattice$mesh$load))
  c(told_answers(state$si, values[-length(values)]), light = light)
}

# The engine's answers (SI) to asked_of() a gear, those of the standard ones that apply to it:
# list(values by name, kinds).
told_answers <- function(si, answers) {
  kinds <- measured_kinds(si)
  applies <- !is.nan(answers) | seq_along(answers) <= length(si$measures)
  list(values = setNames(answers, names(kinds))[applies], kinds = kinds[applies])
}

# What measures are of by name, with units: what the plan asks for, then the standard ones.
measured_kinds <- function(si) {
  own <- vapply(si$measures, `[[`, "", "column")
  standard <- setNames(standard_measures, standard_names())
  c(
    setNames(lapply(si$measures, function(measure) measure_kinds[[measure$kind]]), own),
    standard[setdiff(names(standard), own)]
  )
}

# The same as it is asked of the engine, see measure_values().
asked_of <- function(si) {
  kinds <- measured_kinds(si)
  standard <- kinds[seq_along(kinds) > length(si$measures)]
  c(si$measures, lapply(standard, function(measure) list(kind = measure$kind)))
}

# The standard measures' names in a state, with their units.
standard_names <- function() with_unit(names(standard_measures), measure_units(standard_measures))

measure_units <- function(kinds) vapply(kinds, `[[`, "", "unit", USE.NAMES = FALSE)

measure_texts <- function(kinds, of = "definition") vapply(kinds, `[[`, "", of, USE.NAMES = FALSE)

#' @return `measure_definitions()` gives a data frame with `name`, `unit`, `definition` and `sensor`
#'   (what measures it on a vessel or a model, and what that sees otherwise; `NA` where none is
#'   known): without a state a row per kind of measure that a plan may define and per standard
#'   measure, which `asked` distinguishes; of a state a row per measure that it has, under the names
#'   that `measures()` uses.
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
    name = name, unit = measure_units(kinds), definition = measure_texts(kinds),
    sensor = measure_texts(kinds, "sensor")
  )
  if (is.null(state)) table$asked <- !name %in% names(standard_measures)
  table
}

# The kinds of measures that a plan may ask for, in the order of their names.
asked_kinds <- function() measure_kinds[sort(names(measure_kinds), method = "radix")]

all_kinds <- function() c(asked_kinds(), standard_measures)

# The measures' definitions as sections of help.
measure_help <- function() {
  items <- function(kinds, names) {
    paste0("- `", names, "` (", measure_units(kinds), "): ", measure_texts(kinds))
  }
  asked <- asked_kinds()
  c(
    "@section Measures that a plan may define:", items(asked, names(asked)),
    "@section Standard measures:", items(standard_measures, standard_names())
  )
}

# States and trajectories are no lists of measures: one that is asked for by its name says where it
# is.
#' @rawNamespace S3method(base::"$",codend_state)
`$.codend_state` <- function(x, name) {
  if (name %in% computed_fields) x[[name]] else field_of(x, name, "A state", "measures(state)")
}

#' @rawNamespace S3method(base::"$",codend_trajectory)
`$.codend_trajectory` <- function(x, name) {
  if (name == "lattice") return(x[[name]])
  field_of(x, name, "A trajectory", "as.data.frame(trajectory)")
}

field_of <- function(x, name, what, call) {
  if (name %in% names(x)) return(.subset2(x, name))
  if (name %in% c(standard_names(), names(standard_measures))) {
    abort_argument("{what} has no {.field {name}}; its measures are those of {.code {call}}.")
  }
  NULL
}

has_towing <- function(state) state$si$towing$speed != 0
