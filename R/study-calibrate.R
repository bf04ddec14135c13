#' Calibrate a gear to measurements
#'
#' `calibrate()` fits fields of a plan, such as the lift coefficient of a board or the friction of
#' the seabed, to measurements. The data are hauls or tank runs. The result includes standard errors
#' of the fields.
#'
#' @details
#' # Fields and priors
#' - Give ranges as in [optimise_gear()]: `list(warps.length = c("300 m", "600 m"))`. A
#'   [normal_value()] is also a prior.
#' - Give paths without a range to use known uncertainties as priors:
#'   `c("multipliers.board_lift", "bridles.upper.length")`. Multipliers then have the posterior of
#'   the validation book. Other fields have the uncertainty in the plan or in the table of kinds, as
#'   in [uncertainty()].
#' - A list can mix both: paths are then items without a name.
#'
#' # Matches
#' - A measure with a unit in its name is in that unit. Without the unit it is in SI, and so is the
#'   column.
#' - Columns of the package units are converted to the unit of the measure.
#' - Rows with `NA` in a matched column are not used for this match.
#'
#' # Method
#' - The steps are Gauss-Newton steps in a trust region within the ranges (`stats::nlminb()`, the
#'   PORT library). Derivatives are exact ([sensitivities()]). Each gear is settled ([settle()])
#'   from its shape in the previous step.
#' - Residuals are normal, with one standard deviation per matched quantity. It covers the sensor,
#'   the model and the variation between hauls.
#' - Without `error`, the standard deviations are estimated. A quantity that fits badly then has
#'   little weight.
#' - Priors add to the likelihood.
#'
#' # Discretisation
#' The gear as given is settled first, as by [settle()] with the same arguments, on up to 3 meshes.
#'
#' - Its number of nodes is the one of the results. With `nodes` alone, all gears have this number.
#' - Otherwise the fields are fitted with 1,500 nodes (or `nodes`). If the results need more, up to
#'   8 hauls are also settled with more nodes at the best values. The difference corrects the coarse
#'   mesh (as in [optimise_gear()]), and the fields are fitted again until they converge.
#' - The remaining discretisation error is part of the errors and intervals of the fields.
#' - Cost: each step settles all hauls. A fit takes 5 to 10 steps.
#'
#' # Workers and resuming
#' - Workers of the package future, such as `future::plan("multisession")`, share the hauls. The
#'   results are the same for any number of workers.
#' - Every step prints a message. Use `suppressMessages()` or `options(codend.steps = FALSE)` to
#'   omit it. If the package progressr is loaded, it reports the progress too.
#' - With `file`, every settled gear is recorded. The same call continues after an interruption: it
#'   repeats the steps and reads recorded gears instead of settling them. Calls with other matches
#'   also use them.
#'
#' # Intervals
#' - The covariance follows from the sensitivities at the best values.
#' - [confint()][stats::confint] follows the likelihood itself: the other fields are fitted again at
#'   each value. With estimated errors it uses Student's t.
#'
#' @param gear A gear, from [read_gear()] or the constructors, or the name or file of a plan.
#' @param data A data frame: one row per haul or run. Columns named by the path of a field
#'   (`towing.speed`, `warps.length`) set it, as in [update()][update.codend_gear]. Values are
#'   numbers in SI, text with a unit, or objects of the package units. A unit may follow the path
#'   (`towing.speed_knot`).
#' @param change The fields to fit: a list of ranges, [value_range()] or [normal_value()] by path,
#'   or a character vector of paths. See the section on fields and priors.
#' @param match A formula or a list of formulas, data columns on the left and measures on the right.
#'   Example: `list(DoorSpread ~ door_spread, (Port + Starboard) / 2 ~ warp_tension_kN)`. See the
#'   section on matches.
#' @param error Standard deviations, one per formula of `match`, in the same units. `NULL` (default)
#'   estimates all; `NA` estimates a single one.
#' @param nodes,netting,accuracy As in [settle()], for the gear as given. Its number of nodes is
#'   used for the results. See the section on discretisation.
#' @param file Path of a file that records settled gears, to resume after an interruption. Default
#'   `NULL`: no record. See the section on resuming.
#'
#' @return An object of class `codend_calibration`, a list:
#'
#'   - `gear`: the gear with the fitted fields.
#'   - `fields`: a data frame, one row per field, in the unit `unit` of the plan. `begun` is the
#'     initial value, `value` the fitted one and `error` its standard error (`NA` at an end of the
#'     range). `mesh` is the part of `error` due to discretisation. `lower` and `upper` are the
#'     range. `at` is `"lower"` or `"upper"` at an end of the range, else empty. `prior_mean` and
#'     `prior_sd` describe the prior.
#'   - `covariance`: the covariance matrix of the fields.
#'   - `matched`: a data frame, one row per haul and match. Columns: `row` (of `data`), `match`,
#'     `measured`, `begun` (with the initial gear), `fitted`, `residual` (measured minus fitted) and
#'     `standardised`.
#'   - `match`: a data frame, one row per match. Columns: `text`, `hauls` (count), `error` (standard
#'     deviation), `estimated` (logical), `bias` (mean residual), and the root mean square of the
#'     residuals before (`rms_begun`) and after (`rms`).
#'   - `left_out`: rows whose gear does not settle.
#'   - `conditions`: names of the columns that set fields.
#'   - `converged`: `TRUE` if the fit converged.
#'   - `n_solves`, `slopes`: numbers of settled gears and of computed sensitivities.
#'   - `nodes`, `accuracy`: number of nodes of the last mesh, and its discretisation error as a
#'     fraction.
#'
#'   Wrong arguments raise an error of class `codend_error_argument`. A wrong field value in the
#'   data raises `codend_error_plan`. Rows that do not settle are left out with a warning of class
#'   `codend_warning_hauls_left_out`.
#' @seealso [calibration_methods] for `coef()`, `confint()`, `predict()` and others;
#'   [sample_posterior()], [explain_misfit()], [uncertainty()];
#'   `vignette("calibrate-to-your-sensors", package = "codend")`.
#' @export
#' @examples
#' # Two speeds and three tensions of a towed cable: how long is it really?
#' runs <- data.frame(
#'   towing.speed = c("3 knot", "3 knot", "4 knot", "4 knot", "5 knot"),
#'   Tension = c(11.9, 12.1, 13.4, 13.3, 15.0)
#' )
#' fit <- calibrate("towed_cable", runs,
#'   change = list(ropes.cable.length = c("800 m", "1500 m")), match = Tension ~ ship_tension_kN
#' )
#' fit
#' confint(fit, level = 0.9)
calibrate <- function(gear, data, change, match, error = NULL, nodes = NULL, netting = NULL,
                      accuracy = NULL, file = NULL) {
  check_given("gear", "data", "change", "match")
  task <- new_calibration(gear, data, change, match, error, nodes, netting, accuracy, file)
  task$steps <- new_steps(fit_steps)
  fit <- fit_fields(task, points_scaled(task$points, own_values(task$points$fields)))
  finish_calibration(refine_fit(task, fit))
}

# Returns the calibration task: list(points, cases (one per distinct setting), case_of (case of each
# row), conditions, data, memory, left_out, words, match, of (measures needed)).
new_calibration <- function(gear, data, change, match, error, nodes, netting, accuracy, file) {
  if (is.character(gear)) gear <- read_gear(gear)
  check_settle_arguments(gear, nodes, netting)
  if (!is.data.frame(data) || !nrow(data)) {
    abort_argument("{.arg data} must be a data frame with one row per haul.")
  }
  data <- data_by_path(data, gear, "data")
  change <- change_with_priors(gear, change)
  fields <- free_fields(gear, change)
  # The gear as given may be unable to settle in conditions that no haul has.
  begun <- tryCatch(
    first_states(gear, nodes, netting, accuracy), codend_error_not_converged = function(e) NULL
  )
  nodes <- requested_nodes(gear, nodes, begun$coarse)
  points <- new_points(gear, fields, nodes, netting, begun, file)
  points$count$n_solves <- length(begun)
  set <- condition_columns(gear, data, points$fields)
  data[set] <- given_value(data[set], "data")
  note_bare_numbers(gear$plan, data[set])
  cases <- new_cases(points, data, set)
  task <- list(
    points = points, cases = cases$cases, case_of = cases$case_of, conditions = set, data = data,
    memory = new.env(parent = emptyenv())
  )
  first <- own_values(points$fields)
  task$memory$near <- settle_points(task$cases, first, vector("list", length(task$cases)))
  task$memory$tried <- list(list(
    scaled = points_scaled(points, first), points = task$memory$near
  ))
  good <- !vapply(task$memory$near, is.null, NA)
  task$begun <- lapply(task$memory$near, `[`, c("values", "measures"))
  if (!any(good)) {
    abort_not_converged("The gear does not settle in any row of the data.", report = NULL)
  }
  task$left_out <- which(!good[task$case_of])
  if (length(task$left_out)) {
    rows <- task$left_out
    warn_as("hauls_left_out", "The gear does not settle in {length(rows)} row{?s} of the data. The
      calibration omits row{?s} {rows}.")
  }
  some <- complete_point(task$cases[[which(good)[1L]]], task$memory$near[[which(good)[1L]]])
  task$words <- formula_names(measures(some$state))
  task$match <- read_matches(match, data, task, error)
  task$of <- formula_measures(task$words, lapply(task$match, `[[`, "formula"))
  task
}

# Returns data as a data frame, with the columns of fields named by path.
data_by_path <- function(data, gear, name) {
  data <- as.data.frame(data)
  dotted <- grep(".", names(data), fixed = TRUE)
  fields <- columns_by_path(data[dotted], gear, name)
  data[dotted] <- fields
  setNames(data, replace(names(data), dotted, names(fields)))
}

# Returns the names of the columns that set fields. A name that starts like a path must be a field.
condition_columns <- function(gear, data, fields) {
  first <- sub("[.].*", "", names(data))
  like_path <- grepl(".", names(data), fixed = TRUE) &
    first %in% names(plan_node(gear$plan)$properties)
  paths <- names(data)[like_path]
  free <- unlist(lapply(fields, `[[`, "paths"))
  for (name in paths) {
    if (is.null(plan_field(gear$plan, name))) {
      near <- nearest(name, given_paths(gear$plan))
      hint <- if (length(near)) paste0(" Did you mean ", near, "?") else ""
      abort_argument("{.arg data} has the column {.field {name}}, which is not a field of this
        plan.{hint}")
    }
    if (name %in% free) {
      abort_argument("{.arg data} has the column {.field {name}}, but {.arg change} calibrates this
        field.")
    }
  }
  paths
}

# Returns list(cases (points with the gear set, one per distinct setting), case_of (by row)).
new_cases <- function(points, data, set) {
  table <- data[set]
  for (name in set) {
    if (anyNA(table[[name]])) {
      row <- which(is.na(table[[name]]))[1L]
      abort_argument("{.arg data} has no value of {.field {name}} in row {row}.")
    }
  }
  key <- if (length(set)) do.call(paste, c(unname(table), sep = "\r")) else rep("", nrow(data))
  rows <- which(!duplicated(key))
  cases <- lapply(rows, function(row) {
    points$gear <- tryCatch(
      with_fields(points$gear, lapply(table, `[[`, row)),
      codend_error_plan = function(e) {
        e$message <- paste0("Row ", row, " of the data: ", plain_message(e))
        stop(e)
      }
    )
    points
  })
  list(cases = cases, case_of = base::match(key, key[rows]))
}

# Returns a list per match: text, formula, measured (by row), error (NA: to be estimated).
read_matches <- function(match, data, task, error) {
  if (inherits(match, "formula")) match <- list(match)
  good <- is.list(match) && length(match) > 0L &&
    all(vapply(match, function(one) inherits(one, "formula") && length(one) == 3L, NA))
  if (!good) {
    abort_argument("{.arg match} must be formulas such as {.code DoorSpread ~ door_spread}, with
      columns on the left and measures on the right.")
  }
  error <- given_value(if (is.null(error)) rep(NA, length(match)) else error, "error")
  abort_error <- function() {
    said <- describe_value(unlist(error))
    abort_argument("{.arg error} is {said}; it must be {length(match)} standard deviation{?s} above
      0, or NA to estimate {?it/them} from the data.")
  }
  known <- is.atomic(error) || is.list(error)
  if (!known || length(error) != length(match)) abort_error()
  Map(function(one, error) {
    text <- paste(trimws(deparse(one[[2L]], width.cutoff = 500L)), collapse = " ")
    lost <- setdiff(all.vars(one[[2L]]), names(data))
    if (length(lost)) {
      abort_argument("{.arg match} uses {.field {lost[1]}}, which is not a column of the data.")
    }
    formula <- ready_expression(one[[3L]], "match", task$words, character(), environment(one))
    measured <- eval(one[[2L]], data, environment(one))
    measured <- formula_numbers(measured, formula, task$words, text)
    if (length(measured) != nrow(data)) {
      abort_argument("{.arg match} has {.code {text}}, which is not a number in every row.")
    }
    measured[!is.finite(measured)] <- NA
    measured[task$left_out] <- NA
    error <- if (identical(is.na(error), TRUE)) NA_real_ else {
      formula_numbers(error, formula, task$words, "error")
    }
    if (length(error) != 1L || !(is.na(error) || error > 0 && is.finite(error))) abort_error()
    hauls <- sum(!is.na(measured))
    if (hauls < 1L || (is.na(error) && hauls < 3L)) {
      abort_argument("{.arg match} has {hauls} row{?s} with {.code {text}}, too few to estimate its
        error: give at least three rows, or give {.arg error}.")
    }
    list(text = text, formula = formula, measured = measured, error = error)
  }, match, error)
}

# ---- the fit -------------------------------------------------------------------------------------

# Settles all cases. Returns list(scaled, points (by case, NULL if unsettled), slopes (by case)).
cases_at <- function(task, scaled, slopes = FALSE) {
  found <- Find(function(one) identical(one$scaled, scaled), task$memory$tried)
  if (is.null(found)) {
    used <- !vapply(task$memory$near, is.null, NA)
    found <- list(scaled = scaled, points = vector("list", length(used)))
    found$points[used] <- settle_points(task$cases[used], points_values(task$points, scaled),
      lapply(task$memory$near[used], function(one) first_of(one$state, task$points$shared$start)))
    settled <- !vapply(found$points, is.null, NA)
    task$memory$near[settled] <- found$points[settled]
  }
  if (slopes && is.null(found$slopes)) {
    settled <- !vapply(found$points, is.null, NA)
    by <- derivatives_of_points(task$cases[settled], found$points[settled], task$of)
    found$slopes <- vector("list", length(settled))
    found$slopes[settled] <- lapply(by, function(one) replace(one, is.na(one), 0))
  }
  others <- Filter(function(one) !identical(one$scaled, scaled), task$memory$tried)
  # `nlminb()` compares a trial with the previous point, so three results are enough.
  task$memory$tried <- utils::head(c(list(found), others), 3L)
  found
}

# Returns a list per match: fitted (by row, NA if unsettled), slopes (rows x fields, or NULL).
model_at <- function(task, scaled, slopes = FALSE) {
  found <- cases_at(task, scaled, slopes)
  model_of(task, found$points, if (slopes) found$slopes)
}

# Returns `model_at()` for points and slopes by case.
model_of <- function(task, points, slopes = NULL) {
  lapply(task$match, function(one) {
    by_case <- lapply(seq_along(task$cases), function(k) {
      point <- points[[k]]
      if (is.null(point$measures)) {
        return(list(value = NA_real_, slope = rep(NA_real_, length(task$points$fields))))
      }
      by <- slopes[[k]]
      if (!is.null(by)) by <- corrected_derivatives(task$cases[[k]], by)
      at <- formula_point(task$cases[[k]], point, task$words, by)
      evaluate_formula(one$formula, at)
    })
    fitted <- vapply(by_case, `[[`, 0, "value")[task$case_of]
    by <- if (!is.null(slopes)) {
      do.call(rbind, lapply(by_case, `[[`, "slope"))[task$case_of, , drop = FALSE]
    }
    list(fitted = fitted, slopes = by)
  })
}

# Returns list(value, slope, curvature): the negative log-likelihood with priors, its gradient and
# its Gauss-Newton Hessian by scaled fields.
misfit_at <- function(task, scaled, slopes = FALSE) {
  model <- model_at(task, scaled, slopes)
  n <- length(scaled)
  found <- list(value = 0, slope = numeric(n), curvature = matrix(0, n, n))
  for (k in seq_along(task$match)) {
    one <- task$match[[k]]
    used <- !is.na(one$measured)
    off <- model[[k]]$fitted[used] - one$measured[used]
    if (anyNA(off)) return(list(value = Inf, slope = numeric(n), curvature = diag(n)))
    variance <- error_of(one, off)^2
    found$value <- found$value + if (is.na(one$error)) {
      length(off) / 2 * log(variance)
    } else {
      sum(off^2) / (2 * variance)
    }
    if (slopes) {
      by <- model[[k]]$slopes[used, , drop = FALSE]
      found$slope <- found$slope + drop(crossprod(by, off)) / variance
      found$curvature <- found$curvature + crossprod(by) / variance
    }
  }
  for (k in which(has_prior(task$points$fields))) {
    prior <- scaled_prior(task$points, k)
    off <- (scaled[k] - prior[1L]) / prior[2L]
    found$value <- found$value + off^2 / 2
    found$slope[k] <- found$slope[k] + off / prior[2L]
    found$curvature[k, k] <- found$curvature[k, k] + 1 / prior[2L]^2
  }
  found
}

# Returns the given standard deviation, or the root mean square (above 0 even for a perfect fit).
error_of <- function(one, off) {
  if (!is.na(one$error)) return(one$error)
  max(sqrt(mean(off^2)), 1e-9 * max(abs(one$measured), na.rm = TRUE), .Machine$double.xmin)
}

has_prior <- function(fields) !vapply(fields, function(field) is.null(field$prior), NA)

# Returns c(mean, standard deviation) of the prior of field k, scaled.
scaled_prior <- function(points, k) {
  prior <- points$fields[[k]]$prior
  c((prior[1L] - points$lower[k]) / points$width[k], prior[2L] / points$width[k])
}

# Largest number of Gauss-Newton steps of a fit.
fit_steps <- 60L

# Fits the fields from the initial guess `place` (scaled). held: numbers of fixed fields.
fit_fields <- function(task, place, held = integer()) {
  free <- setdiff(seq_along(place), held)
  full <- function(x) replace(place, free, x)
  if (!length(free)) {
    return(list(scaled = place, value = misfit_at(task, place)$value, converged = TRUE))
  }
  found <- stats::nlminb(
    place[free],
    function(x) misfit_at(task, full(x))$value,
    function(x) {
      found <- misfit_at(task, full(x), slopes = TRUE)
      report_step(task$steps, "misfit", found$value, full(x))
      found$slope[free]
    },
    function(x) misfit_at(task, full(x), slopes = TRUE)$curvature[free, free, drop = FALSE],
    lower = 0, upper = 1,
    # A relative change of 1e-6 in the log-likelihood is negligible.
    control = list(abs.tol = 0, rel.tol = 1e-6, x.tol = 1e-5, iter.max = fit_steps, eval.max = 120L)
  )
  list(scaled = full(found$par), value = found$objective, converged = found$convergence == 0L)
}
