#' Convert results to tables
#'
#' `as.data.frame()` and `tidy()` of a result return the same table, with one row per value.
#' `glance()` returns one row. `augment()` adds the results of a calibration to its data.
#'
#' `tidy()`, `glance()` and `augment()` are generics of the package \pkg{generics}, which
#' \pkg{broom} and \pkg{parsnip} also export. codend exports them too.
#'
#' @param x Measures ([measures()]), a state ([settle()]), trajectory ([tow()]), variations
#'   ([vary()]), sensitivities ([sensitivities()]), effects
#'   ([effects()][effects.codend_variations]), uncertainty ([uncertainty()]), calibration
#'   ([calibrate()]), posterior ([sample_posterior()]), optimum ([optimise_gear()]), found values
#'   ([find_value()]) or trade-off ([trade_off()]).
#' @param row.names,optional As in [as.data.frame()]. `optional` is `TRUE` in calls by
#'   [data.frame()], [cbind()] and [merge()].
#' @param wide `TRUE` returns a column for each measure or field: the columns of `x` itself. This
#'   is the default in calls by [data.frame()], [cbind()] and [merge()].
#' @param level Probability of the interval between `lower` and `upper`. Default 0.95.
#' @param newdata Rows to predict, as in [predict()][calibration_methods]. `NULL` uses the data of
#'   the calibration.
#' @param ... Arguments of `as.data.frame()`, such as `what` of a
#'   [state][as.data.frame.codend_state] or a [trajectory][as.data.frame.codend_trajectory].
#' @return A data frame, see the sections below.
#'
#'   `augment()` of a calibration has one row per haul and match: its data, `.match`, `.measured`,
#'   `.fitted`, `.resid` and `.std.resid`. With `newdata` it has the predictions `.fitted`,
#'   `.se.fit`, `.lower` and `.upper`.
#'
#' @section Tables of measures:
#' One row per measure. Columns: `measure`, `value`, `error` (estimated discretisation error) and
#' `unit`. Other columns come first:
#'
#' - Trajectory: `time_s`.
#' - Variations: the fields of the design, named by path and unit.
#' - Trade-off: the fields. `measure` is the name of an objective; its `error` is `NA`. The last
#'   columns are `kept` and `optimal`.
#' - Uncertainty: `error` is the combined standard uncertainty, `lower` and `upper` are the ends of
#'   its interval. The last columns are its parts, see [uncertainty()].
#' - Sensitivities and effects: the columns of the object itself.
#'
#' @section Tables of fields:
#' One row per field. Columns: `field`, `value`, `error`, `unit`, `lower` and `upper`.
#'
#' - Calibration: `error` is the standard error. `lower` and `upper` are the ends of a confidence
#'   interval from the covariance. `begun` is the initial value. `at` names the bound that the field
#'   has reached.
#' - Posterior: `value` is the mean, `error` the standard deviation. `lower` and `upper` are
#'   quantiles. `effective` is the effective number of independent draws.
#' - Found values: `fields` of [find_value()].
#' - Optimum: `error` is `NA`, `lower` and `upper` are the ends of the range. `begun` and `at` are
#'   as above.
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
#' - Sensitivities: `name`, `conditions`, numbers of `fields` and `measures`, and `smooth` (`TRUE`
#'   if all derivatives are).
#' - Uncertainty: `name`, `conditions`, numbers of `measures` and `sources`, `level` and `method`.
#' - Trade-off: `name`, and numbers of `points`, `kept` and `optimal`.
#'
#' @name codend_tidy
#' @seealso [measures()], [uncertainty()] for all other sources of error, [calibration_methods].
#' @examples
#' found <- vary("towed_cable", towing.speed = paste(3:5, "knot"))
#' found$total_drag_kN
#' subset(as.data.frame(found), measure == "total_drag_kN")
#' tidy(found)
#' glance(found)
NULL

# ---- tables --------------------------------------------------------------------------------------

# Returns a long table of a wide one: the columns `fields`, measure, value, error and unit. error: a
# list by measure, or one value for all.
long_table <- function(x, fields, measures, error, unit) {
  x <- unclass(x)
  n <- length(attr(x, "row.names"))
  row <- rep(seq_len(n), length(measures))
  data.frame(
    lapply(x[fields], `[`, row), measure = rep(measures, each = n),
    value = as.double(unlist(x[measures])), error = as.double(unlist(error)),
    unit = rep(unname(unit), each = n), check.names = FALSE
  )
}

# Returns a data frame of the columns alone, without other classes and attributes.
plain_table <- function(x) {
  structure(as.list(unclass(x))[names(x)], class = "data.frame",
    row.names = attr(x, "row.names"), names = names(x))
}

# ---- one row -------------------------------------------------------------------------------------

#' @rdname codend_tidy
#' @export
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
#' @aliases tidy glance augment
#' @export
glance.codend_trajectory <- function(x, ...) {
  last <- x$conditions[length(x$time), ]
  put <- first_of(last$energy_put_through, NA)
  data.frame(
    name = x$si$name, nodes = dim(x$position)[2L], times = length(x$time), until = max(x$time),
    end = x$end, steps = first_of(x$report$steps, 0), repeated = first_of(x$report$repeated, 0),
    energy_imbalance = if (isTRUE(put > 0)) last$energy_imbalance / put else NA_real_
  )
}
