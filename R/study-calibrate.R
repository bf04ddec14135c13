#' Calibrate a gear to what was measured
#'
#' Finds the values of fields of a plan, such as a board's lift coefficient or the friction of the
#' sea bed, with which the settled gear comes nearest to what sensors said in hauls or tank runs,
#' and how well these values are known.
#'
#' Each row of the data is a haul in its own conditions. Gears are settled from the shapes of the
#' last step, and their [sensitivities()] to the fields are exact: the steps are Gauss and Newton's
#' within a trust region that keeps to the ranges (`stats::nlminb()`, the PORT library). Differences
#' are normal, with one standard deviation for each thing that is matched: of the sensor, of the
#' model and of what varies between hauls together. It is estimated where `error` does not give it,
#' so that what fits badly weighs little. Priors add to the likelihood.
#'
#' A coarse model of the gear, with few nodes, is wrong by a few percent, alike in all hauls, and
#' fields would make up for that. So where its error is more than `accuracy`, up to 8 hauls are
#' settled with more nodes at the best values, the difference corrects the coarse model (as in
#' [optimise_gear()]), and fields are fitted again until they stay. The discretisation error that
#' is left is part of the fields' errors and of their intervals: `lattice` is its part.
#'
#' The covariance is that of the sensitivities at the best values. Intervals of
#' [confint()][stats::confint] follow the likelihood itself, the other fields found again at each
#' value; with estimated errors their reach is that of Student's t.
#'
#' @param gear A gear, from [read_gear()] or the constructors, or the name or file of a plan.
#' @param data A data frame with a row per haul or run. Columns that are named by the path of a
#'   field (`towing.speed`, `warps.length`, `seabed.depth`) set it, as
#'   [update()][update.codend_gear] does: numbers in SI, texts with a unit or objects of the package
#'   units.
#' @param change The fields that may change, with ranges, [value_range()] or [normal_value()], as in
#'   [optimise_gear()]; a normal distribution is a prior as well. Paths alone, as in
#'   `c("multipliers.board_lift", "bridles.upper.length")`, begin from what [uncertainty()] knows of
#'   them: multipliers from the posterior of the validation book, others from the plan or the table
#'   of kinds. They are a character vector, or items of the list without a name.
#' @param match What is measured: a formula or a list of formulas, columns at the left and measures
#'   at the right: `list(DoorSpread ~ door_spread, (Port + Starboard) / 2 ~ warp_tension_kN)`. A
#'   measure without the unit in its name is in SI, and so is the column. Columns that are objects
#'   of the package units are converted to the unit of the measure. Rows with `NA` there are not
#'   matched.
#' @param error Standard deviations by what is matched, in the same order and units; `NULL`, or `NA`
#'   for one of them, to estimate it.
#' @param nodes,netting Of the model that the fit steps with, as in [settle()].
#' @param accuracy Discretisation error of what is fitted, as a share of what is measured: where it
#'   is larger with `nodes`, the fit ends with more nodes. `NULL` stays with `nodes`.
#' @return An object of class `codend_calibration`, a list of
#'
#'   - `gear`: with the fields found, [update()][update.codend_gear]d;
#'   - `fields`: a data frame with `field`, `unit`, `begun`, `value`, `error` (standard error, `NA`
#'     at an end), `lattice` (the part of discretisation), `lower`, `upper`, `at`
#'     (`"lower"`, `"upper"` or empty: the end of the range that it lies at), `prior_mean` and
#'     `prior_sd`;
#'   - `covariance` of the fields;
#'   - `matched`: a data frame with a row per haul and thing matched: `row` of the data, `match`,
#'     `measured`, `begun` (of the gear as it was), `fitted`, `residual` (measured less fitted) and
#'     `standardised`;
#'   - `match`: a data frame with the `text` of each, its `hauls`, standard deviation `error`,
#'     whether it was `estimated`, the mean of residuals (`bias`), and the root mean square of
#'     residuals before (`rms_begun`) and now (`rms`);
#'   - `left_out`: rows whose gear does not settle; `conditions`: columns that set fields;
#'     `converged`, `settles` and `slopes`, counts of gears settled and of their slopes taken;
#'     `nodes` of the last model and `accuracy`, its discretisation error in what is fitted, as a
#'     share.
#'
#'   `coef()`, `vcov()`, `confint()`, `fitted()`, `residuals()`, `predict()`, `logLik()`, `nobs()`,
#'   `summary()` and `plot()` know it; see [calibration_methods], [sample_posterior()] and
#'   [explain_misfit()].
#'   Wrong arguments are an error of class `codend_error_argument`, a wrong value of a field in the
#'   data one of class `codend_error_plan`; rows that do not settle are left out with a warning of
#'   class `codend_warning_hauls_left_out`.
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
calibrate <- function(gear, data, change, match, error = NULL, nodes = 1500, netting = NULL,
                      accuracy = "1 %") {
  check_given("gear", "data", "change", "match")
  if (!is.null(accuracy)) accuracy <- accuracy_share(accuracy)
  task <- new_calibration(gear, data, change, match, error, nodes, netting)
  fit <- fit_fields(task, points_scaled(task$points, own_values(task$points$fields)))
  finish_calibration(refine_fit(task, fit, accuracy))
}

# What is fitted: list(points, cases (a list per different setting: points, rows), words, match (a
# list per formula: text, formula, measured, known), of, memory).
new_calibration <- function(gear, data, change, match, error, nodes, netting) {
  if (is.character(gear)) gear <- read_gear(gear)
  check_settle_arguments(gear, nodes, netting)
  if (!is.data.frame(data) || !nrow(data)) {
    abort_argument("{.arg data} must be a data frame with a row per haul.")
  }
  data <- as.data.frame(data)
  change <- change_with_priors(gear, change)
  points <- new_points(gear, free_fields(gear, change), nodes, netting)
  set <- condition_columns(gear, data, points$fields)
  data[set] <- given_value(data[set], "data")
  cases <- new_cases(points, data, set)
  task <- list(
    points = points, cases = cases$cases, case_of = cases$case_of, conditions = set, data = data,
    memory = new.env(parent = emptyenv())
  )
  task$memory$tried <- list()
  first <- own_values(points$fields)
  # the gear as it was, in every case
  states <- lapply(task$cases, function(case) settle_point(case, first))
  good <- !vapply(states, is.null, NA)
  if (!any(good)) abort_not_converged("The gear settles in no row of the data.", report = NULL)
  task$left_out <- which(!good[task$case_of])
  if (length(task$left_out)) {
    rows <- task$left_out
    cli::cli_warn(
      "The gear does not settle in {length(rows)} row{?s} of the data, which {?is/are} left out:
      {rows}.",
      class = c("codend_warning_hauls_left_out", "codend_warning"), call = NULL
    )
  }
  task$memory$near <- states
  task$words <- formula_words(states[[which(good)[1L]]]$measures)
  task$match <- read_matches(match, data, task, error)
  named <- unlist(lapply(task$match, function(one) one$formula$names))
  task$of <- unique(task$words$column[task$words$name %in% named])
  task
}

# Columns of the data that set fields. A name that begins as a path does and is none is an error.
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
      abort_argument("{.arg data} has the column {.field {name}}, which is no field of this
        plan.{hint}")
    }
    if (name %in% free) {
      abort_argument("{.arg data} sets {.field {name}}, which {.arg change} is to find.")
    }
  }
  paths
}

# Rows with the same settings are one case: list(cases (points with the gear so set), case_of).
new_cases <- function(points, data, set) {
  table <- data[set]
  for (name in set) {
    if (anyNA(table[[name]])) {
      row <- which(is.na(table[[name]]))[1L]
      abort_argument("{.arg data} has no {.field {name}} in row {row}.")
    }
  }
  key <- if (length(set)) do.call(paste, c(unname(table), sep = "\r")) else rep("", nrow(data))
  rows <- which(!duplicated(key))
  cases <- lapply(rows, function(row) {
    points$gear <- tryCatch(
      do.call(update, c(list(points$gear), lapply(table, `[[`, row))),
      codend_error_plan = function(e) {
        e$message <- paste0("Row ", row, " of the data: ", plain_message(e))
        stop(e)
      }
    )
    points
  })
  list(cases = cases, case_of = base::match(key, key[rows]))
}

# Matches made ready: lists of text, formula (of measures), measured (by row of the data), error (NA
# where it is to be estimated).
read_matches <- function(match, data, task, error) {
  if (inherits(match, "formula")) match <- list(match)
  good <- is.list(match) && length(match) > 0L &&
    all(vapply(match, function(one) inherits(one, "formula") && length(one) == 3L, NA))
  if (!good) {
    abort_argument("{.arg match} must be formulas such as {.code DoorSpread ~ door_spread}: columns
      at the left, measures at the right.")
  }
  error <- given_value(if (is.null(error)) rep(NA, length(match)) else error, "error")
  abort_error <- function() {
    said <- unlist(error)
    abort_argument("{.arg error} is {.val {said}}; it must be {length(match)} standard
      deviation{?s} above 0, or NA for what is to be estimated.")
  }
  if (length(error) != length(match)) abort_error()
  Map(function(one, error) {
    text <- paste(trimws(deparse(one[[2L]], width.cutoff = 500L)), collapse = " ")
    lost <- setdiff(all.vars(one[[2L]]), names(data))
    if (length(lost)) {
      abort_argument("{.arg match} names {.field {lost[1]}}, which is no column of the data.")
    }
    formula <- ready_expression(one[[3L]], "match", task$words, character(), environment(one))
    measured <- eval(one[[2L]], data, environment(one))
    measured <- formula_numbers(measured, formula, task$words, text)
    if (length(measured) != nrow(data)) {
      abort_argument("{.arg match} has {.code {text}}, which is no number in every row.")
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
        error: three are the least, or give {.arg error}.")
    }
    list(text = text, formula = formula, measured = measured, error = error)
  }, match, error)
}

# ---- the fit -------------------------------------------------------------------------------------

# Every case at scaled fields: list(points by case (NULL where it does not settle), slopes).
cases_at <- function(task, scaled, slopes = FALSE) {
  found <- Find(function(one) identical(one$scaled, scaled), task$memory$tried)
  if (is.null(found)) {
    values <- points_values(task$points, scaled)
    found <- list(scaled = scaled, points = lapply(seq_along(task$cases), function(k) {
      near <- task$memory$near[[k]]
      if (is.null(near)) return(NULL)
      settle_point(task$cases[[k]], values, near$state)
    }))
    settled <- !vapply(found$points, is.null, NA)
    task$memory$near[settled] <- found$points[settled]
  }
  if (slopes && is.null(found$slopes)) {
    found$slopes <- Map(function(case, point) {
      if (is.null(point)) return(NULL)
      by <- point_slopes(case, point, task$of)
      replace(by, is.na(by), 0)
    }, task$cases, found$points)
  }
  others <- Filter(function(one) !identical(one$scaled, scaled), task$memory$tried)
  # the last few are enough: a trial, and the point that it is compared with
  task$memory$tried <- utils::head(c(list(found), others), 3L)
  found
}

# The model at scaled fields: a list per match of fitted (by row, NA where it does not settle) and,
# where asked for, slopes (rows by fields).
model_at <- function(task, scaled, slopes = FALSE) {
  found <- cases_at(task, scaled, slopes)
  lapply(task$match, function(one) {
    by_case <- lapply(seq_along(task$cases), function(k) {
      point <- found$points[[k]]
      if (is.null(point)) return(list(value = NA_real_, slope = rep(NA_real_, length(scaled))))
      by <- found$slopes[[k]]
      if (!is.null(by)) by <- corrected_slopes(task$cases[[k]], by)
      at <- formula_point(task$cases[[k]], point, task$words, by)
      evaluate_formula(one$formula, at)
    })
    fitted <- vapply(by_case, `[[`, 0, "value")[task$case_of]
    by <- if (slopes) {
      do.call(rbind, lapply(by_case, `[[`, "slope"))[task$case_of, , drop = FALSE]
    }
    list(fitted = fitted, slopes = by)
  })
}

# The negative logarithm of the likelihood (and priors), its slopes and curvature by scaled fields.
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

# The error of a match: given, or the root mean square, which a perfect fit may not take to 0.
error_of <- function(one, off) {
  if (!is.na(one$error)) return(one$error)
  max(sqrt(mean(off^2)), 1e-9 * max(abs(one$measured), na.rm = TRUE), .Machine$double.xmin)
}

has_prior <- function(fields) !vapply(fields, function(field) is.null(field$prior), NA)

# The mean and standard deviation of a field's prior, scaled.
scaled_prior <- function(points, k) {
  prior <- points$fields[[k]]$prior
  c((prior[1L] - points$lower[k]) / points$width[k], prior[2L] / points$width[k])
}

# Fields fitted from a place. held: fields (by number) that stay.
fit_fields <- function(task, place, held = integer()) {
  free <- setdiff(seq_along(place), held)
  full <- function(x) replace(place, free, x)
  if (!length(free)) {
    return(list(scaled = place, value = misfit_at(task, place)$value, converged = TRUE))
  }
  found <- stats::nlminb(
    place[free],
    function(x) misfit_at(task, full(x))$value,
    function(x) misfit_at(task, full(x), slopes = TRUE)$slope[free],
    function(x) misfit_at(task, full(x), slopes = TRUE)$curvature[free, free, drop = FALSE],
    lower = 0, upper = 1,
    # a change of the logarithm of the likelihood that nobody would notice
    control = list(abs.tol = 0, rel.tol = 1e-7, x.tol = 1e-5, iter.max = 60L, eval.max = 120L)
  )
  list(scaled = full(found$par), value = found$objective, converged = found$convergence == 0L)
}
