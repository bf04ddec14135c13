#' Tidy tables, for those who use the tidyverse
#'
#' Methods for `tidy()`, `glance()` and `augment()` of the package \pkg{generics}, which \pkg{broom}
#' and \pkg{parsnip} have too: they are there where one of these is.
#'
#' @param x A state, from [settle()]; a trajectory, from [tow()]; sensitivities, from
#'   [sensitivities()]; a calibration, from [calibrate()]; a posterior, from [sample_posterior()];
#'   an optimum, from [optimise_gear()]; or variations, from [vary()].
#' @param conf.int Whether `conf.low` and `conf.high` are added, the ends of a confidence interval
#'   by the covariance.
#' @param conf.level Share of the interval.
#' @param newdata Rows to predict, as in [predict()][calibration_methods]; the data of the
#'   calibration where it is `NULL`.
#' @param ... Not used.
#' @return A data frame. `tidy()` has `term`, `estimate` and `unit`, with a row per
#'
#'   - measure of a state, with `error`, the estimated discretisation error (no standard error);
#'   - measure and time of a trajectory, with `time` in s;
#'   - measure and field of sensitivities, with `term` the field, `measure`, `elasticity` and
#'     `smooth`;
#'   - field of a calibration, with `std.error`, and `at`: the end of its range where it is at one;
#'   - field of a posterior: its mean, with `std.error` (standard deviation), `conf.low` and
#'     `conf.high` (quantiles) and `effective` (independent draws);
#'   - field of an optimum, with `begun` (its value before), `low` and `high` (its range) and `at`;
#'   - design and measure of variations, with the number of the `design`, its fields and `error`.
#'
#'   `glance()` has one row. Of a state: `name`, `nodes`, `ropes`, `panels`, `pieces`, `converged`,
#'   `iterations`, `residual` (largest net force on a node as a share of the largest tension) and
#'   `cpu_seconds`. Of a trajectory: `name`, `nodes`, `times`, `until` (s), `end`, `steps`,
#'   `repeated` and `energy_imbalance` (as a share of the energy put through). Of a calibration:
#'   `name`, `nobs`, `df.residual`, `logLik`, `AIC`, `BIC`, `converged` and `settles` (gears that
#'   were settled). Of a posterior: `draws`, `accepted` (share of steps) and `effective` (the least
#'   of all fields). Of an optimum: `name`, `objective` (text), `begun`, `value`, `kept` (whether
#'   all conditions hold), `optimality` (0 at an optimum), `converged` and `settles`. Of variations:
#'   `name`, `designs`, `done`, `settled` and `warned`.
#'
#'   `augment()` of a calibration has a row per haul and match: the columns of its data, `.match`,
#'   `.measured`, `.fitted`, `.resid` and `.std.resid`; with `newdata` those of predictions:
#'   `.fitted`, `.se.fit`, `.lower` and `.upper`.
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
