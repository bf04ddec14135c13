#' Tidy tables of results
#'
#' Methods for `tidy()`, `glance()` and `augment()` of the package \pkg{generics}, which \pkg{broom}
#' and \pkg{parsnip} also export. They are available if generics, broom or parsnip is installed.
#'
#' @param x A state ([settle()]), trajectory ([tow()]), sensitivities ([sensitivities()]),
#'   calibration ([calibrate()]), posterior ([sample_posterior()]), optimum ([optimise_gear()]),
#'   found values ([find_value()]) or variations ([vary()]).
#' @param conf.int `TRUE` adds `conf.low` and `conf.high`, the ends of a confidence interval from
#'   the covariance.
#' @param conf.level Probability of the interval.
#' @param newdata Rows to predict, as in [predict()][calibration_methods]. `NULL` uses the data of
#'   the calibration.
#' @param ... Not used.
#' @return A data frame. `tidy()` has `term`, `estimate` and `unit`, with one row per
#'
#'   - measure of a state, with `error`, the estimated discretisation error (not a standard error);
#'   - measure and time of a trajectory, with `time` in s;
#'   - measure and field of sensitivities, with `term` the field, `measure`, `elasticity` and
#'     `smooth`;
#'   - field of a calibration, with `std.error`, and `at`, the bound that the field has reached;
#'   - field of a posterior: its mean, with `std.error` (standard deviation), `conf.low`,
#'     `conf.high` (quantiles) and `effective` (effective number of independent draws);
#'   - field of an optimum, with `begun` (initial value), `low` and `high` (bounds) and `at`;
#'   - field of found values, with the columns of `fields` of [find_value()];
#'   - design and measure of variations, with the number of the `design`, its fields and `error`.
#'
#'   `glance()` has one row, see below. `augment()` of a calibration has one row per haul and match:
#'   its data, `.match`, `.measured`, `.fitted`, `.resid` and `.std.resid`. With `newdata` it has
#'   the predictions `.fitted`, `.se.fit`, `.lower` and `.upper`.
#'
#' @section Columns of `glance()`:
#' - State: `name`, `nodes`, `ropes`, `panels`, `pieces`, `converged`, `iterations`, `residual`
#'   (largest net force on a node divided by the largest tension) and `cpu_seconds`.
#' - Trajectory: `name`, `nodes`, `times`, `until` (s), `end`, `steps`, `repeated` and
#'   `energy_imbalance` (fraction of the energy put through).
#' - Calibration: `name`, `nobs`, `df.residual`, `logLik`, `AIC`, `BIC`, `converged` and `n_solves`
#'   (number of solved gears).
#' - Posterior: `draws`, `accepted` (fraction of steps) and `effective` (minimum over all fields).
#' - Optimum: `name`, `objective` (string), `begun`, `value`, `kept` (`TRUE` if all conditions
#'   hold), `optimality` (0 at an optimum), `converged` and `n_solves`.
#' - Found values: `name`, `reached` (`TRUE` if all targets are reached), `n_solves` and `nodes`.
#' - Variations: `name`, `designs`, `done`, `settled` and `warned`.
#'
#' @name codend_tidy
#' @seealso [as.data.frame()][as.data.frame.codend_state], [measures()], [calibration_methods].
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
    term = x$field, measure = x$measure, estimate = x$derivative, unit = x$derivative_unit,
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
