#' Tidy tables, for those who use the tidyverse
#'
#' Methods for `tidy()` and `glance()` of the package \pkg{generics}, which \pkg{broom} and
#' \pkg{parsnip} have too: they are there where one of these is.
#'
#' @param x A state, from [settle()]; a trajectory, from [tow()]; or slopes, from [sensitivities()].
#' @param ... Not used.
#' @return A data frame. `tidy()` has a row per measure: `term` (the measure's name), `estimate`,
#'   `unit` and `error` (of the lattice; no standard error); of a trajectory a row per measure and
#'   time, with `time` in s; of slopes a row per measure and field: `term` (the field), `measure`,
#'   `estimate` (the slope), `unit` (of the slope), `elasticity` and `smooth`.
#'
#'   `glance()` has one row. Of a state: `name`, `nodes`, `ropes`, `panels`, `pieces`, `converged`,
#'   `iterations`, `residual` (largest net force on a node as a share of the largest tension) and
#'   `cpu_seconds`. Of a trajectory: `name`, `nodes`, `times`, `until` (s), `end`, `steps`,
#'   `repeated` and `energy_imbalance` (as a share of the energy put through).
#' @name codend_tidy
#' @examplesIf requireNamespace("generics", quietly = TRUE)
#' state <- settle("towed_cable")
#' generics::tidy(state)
#' generics::glance(state)
NULL

#' @rdname codend_tidy
#' @exportS3Method generics::tidy
tidy.codend_state <- function(x, ...) {
  table <- measure_table(x)
  data.frame(
    term = table$measure, estimate = table$value, unit = table$unit, error = table$error
  )
}

#' @rdname codend_tidy
#' @exportS3Method generics::tidy
tidy.codend_trajectory <- function(x, ...) {
  table <- as.data.frame.codend_trajectory(x, what = "measures")
  data.frame(
    time = table$time_s, term = table$measure, estimate = table$value, unit = table$unit
  )
}

#' @rdname codend_tidy
#' @exportS3Method generics::tidy
tidy.codend_sensitivities <- function(x, ...) {
  data.frame(
    term = x$field, measure = x$measure, estimate = x$slope, unit = x$slope_unit,
    elasticity = x$elasticity, smooth = x$smooth
  )
}

#' @rdname codend_tidy
#' @exportS3Method generics::glance
glance.codend_state <- function(x, ...) {
  report <- x$report
  data.frame(
    name = x$si$name, nodes = ncol(x$position), ropes = length(x$si$ropes),
    panels = length(x$si$panels), pieces = length(x$si$pieces),
    converged = isTRUE(report$converged), iterations = first_of(report$iterations, NA),
    residual = first_of(report$residual, NA), cpu_seconds = first_of(report$cpu_seconds, NA)
  )
}

#' @rdname codend_tidy
#' @exportS3Method generics::glance
glance.codend_trajectory <- function(x, ...) {
  last <- x$conditions[length(x$time), ]
  put <- first_of(last$energy_put_through, NA)
  data.frame(
    name = x$si$name, nodes = dim(x$position)[2L], times = length(x$time), until = max(x$time),
    end = x$end, steps = first_of(x$report$steps, 0), repeated = first_of(x$report$repeated, 0),
    energy_imbalance = if (isTRUE(put > 0)) last$energy_imbalance / put else NA_real_
  )
}
