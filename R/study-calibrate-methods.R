#' Coefficients, intervals and predictions of a calibration
#'
#' These methods return values, confidence intervals, residuals and predictions of a calibration
#' from [calibrate()].
#'
#' @param object A calibration, from [calibrate()].
#' @param parm Names or numbers of fields. Default: all.
#' @param level Probability of the intervals, between 0 and 1. Default 0.95.
#' @param method `"profile"` (default): the ends at which the likelihood, with the other fields
#'   fitted again, falls by the amount that `level` requires. `"normal"`: an interval from the
#'   covariance, which takes no time.
#' @param type `"response"` (default): residuals in the units of the match. `"standardised"`:
#'   residuals divided by the error of the match.
#' @param newdata A data frame with columns that set fields, like `data` of [calibrate()]. Default:
#'   the hauls of the calibration.
#' @param ... Not used.
#' @return
#'
#'   - `coef()`: a numeric vector of fitted values by field, in the plan's unit. `vcov()`: their
#'     covariance matrix.
#'   - `confint()`: a matrix, one row per field, with the two ends. An end of the range that the
#'     likelihood does not exclude is returned unchanged.
#'   - `fitted()` and `residuals()`: a numeric vector, one value per row of `matched`.
#'   - `predict()`: a data frame, one row per match and row of `newdata`. Columns: `row`, `match`,
#'     `fit`, `error`, `lower`, `upper` and `measured`. `error` is the standard error of the fit
#'     from the covariance. `lower` and `upper` are the interval of a new haul, including the error
#'     of the match. `measured` is `NA` if `newdata` lacks its columns. Rows that do not settle are
#'     `NA`.
#'   - `logLik()`: the log-likelihood; its degrees of freedom count the fields and the estimated
#'     errors. `nobs()`: the number of matched values.
#'
#'   Wrong arguments raise an error of class `codend_error_argument`.
#' @seealso [calibrate()], [sample_posterior()], [codend_tidy].
#' @name calibration_methods
#' @examples
#' runs <- data.frame(towing.speed = 2:6 / 2, Drag = c(1.9, 3.2, 5, 7.4, 10.2))
#' fit <- calibrate("towed_cable", runs,
#'   change = list(ropes.cable.diameter = c("10 mm", "30 mm")), match = Drag ~ total_drag_kN)
#' coef(fit)
#' predict(fit, data.frame(towing.speed = "7 knot"))
NULL

#' @rdname calibration_methods
#' @importFrom stats coef
#' @export
coef.codend_calibration <- function(object, ...) {
  setNames(object$fields$value, object$fields$field)
}

#' @rdname calibration_methods
#' @importFrom stats vcov
#' @export
vcov.codend_calibration <- function(object, ...) object$covariance

#' @rdname calibration_methods
#' @importFrom stats fitted
#' @export
fitted.codend_calibration <- function(object, ...) object$matched$fitted

#' @rdname calibration_methods
#' @importFrom stats residuals
#' @export
residuals.codend_calibration <- function(object, type = c("response", "standardised"), ...) {
  type <- chosen(type, c("response", "standardised"))
  if (type == "response") object$matched$residual else object$matched$standardised
}

#' @rdname calibration_methods
#' @importFrom stats nobs
#' @export
nobs.codend_calibration <- function(object, ...) nrow(object$matched)

#' @rdname calibration_methods
#' @importFrom stats logLik
#' @export
logLik.codend_calibration <- function(object, ...) {
  match <- object$match
  by <- split(object$matched$residual, factor(object$matched$match, unique(match$text)))
  value <- sum(mapply(function(residual, error, estimated) {
    # The likelihood of an estimated error is largest at the root mean square.
    if (estimated) error <- sqrt(mean(residual^2))
    sum(stats::dnorm(residual, 0, error, log = TRUE))
  }, by, match$error, match$estimated))
  structure(value, df = nrow(object$fields) + sum(match$estimated), nobs = nobs(object),
    class = "logLik")
}

check_is_calibration <- function(calibration) {
  if (inherits(calibration, "codend_calibration")) return(invisible())
  abort_argument("{.arg calibration} must be a calibration, as {.fn calibrate} returns, not
    {.cls {class(calibration)}}.")
}

check_level <- function(level) check_fraction(level, "level", below = 1)

#' @rdname calibration_methods
#' @importFrom stats confint
#' @export
confint.codend_calibration <- function(object, parm, level = 0.95,
                                       method = c("profile", "normal"), ...) {
  method <- chosen(method, c("profile", "normal"))
  check_level(level)
  known <- object$fields$field
  if (missing(parm)) parm <- known
  parm <- chosen_some(if (is.numeric(parm)) known[parm] else parm, known, "parm")
  ends <- t(vapply(match(parm, known), function(k) {
    if (method == "profile") return(profile_ends(object, k, level))
    object$fields$value[k] + c(-1, 1) * reach_of(object, level) * object$fields$error[k]
  }, c(0, 0)))
  shares <- (1 + c(-1, 1) * level) / 2
  dimnames(ends) <- list(parm, with_plain_numbers(paste(format(100 * shares), "%")))
  ends
}

# Returns the half-width in standard errors: Student's t if an error is estimated, else normal.
reach_of <- function(object, level) {
  share <- (1 + level) / 2
  if (any(object$match$estimated)) stats::qt(share, object$task$freedom) else stats::qnorm(share)
}

profile_ends <- function(object, k, level) {
  task <- object$task
  reach <- reach_of(object, level)
  # The fall of the log-likelihood at the ends; with estimated errors exact for a linear model.
  wanted <- sqrt(if (!any(object$match$estimated)) reach^2 / 2 else {
    nobs(object) / 2 * log1p(reach^2 / task$freedom)
  })
  best <- object$scaled
  error <- object$fields$error[k] / task$points$width[k]
  if (!is.finite(error) || error <= 0) error <- 0.1
  least <- object$misfit
  end_of <- function(way) {
    place <- best
    # The square root of the fall is nearly linear in the field: secants converge fast.
    root <- function(x) {
      place[k] <<- x
      found <- fit_fields(task, place, held = k)
      place <<- found$scaled
      sqrt(max(0, found$value - least))
    }
    limit <- if (way < 0) 0 else 1
    before <- c(best[k], 0)
    x <- best[k] + way * reach * error
    for (step in 1:12) {
      x <- min(max(x, 0), 1)
      now <- c(x, root(x))
      if (x == limit && now[2L] <= wanted) return(limit)
      if (abs(now[2L] - wanted) <= 0.01 * wanted) return(x)
      slope <- (now[2L] - before[2L]) / (now[1L] - before[1L])
      # If the likelihood is flat, double the step.
      if (!is.finite(slope) || slope * way <= 0) x <- best[k] + 2 * (x - best[k]) else {
        if (is.finite(now[2L])) before <- now
        x <- now[1L] + (wanted - now[2L]) / slope
      }
    }
    x
  }
  # The likelihood lacks the discretisation error, which widens the interval.
  own <- object$fields$error[k]^2 - object$fields$mesh[k]^2
  wider <- if (is.finite(own) && own > 0) object$fields$error[k] / sqrt(own) else 1
  ends <- best[k] + wider * (c(end_of(-1), end_of(1)) - best[k])
  task$points$lower[k] + pmin(pmax(ends, 0), 1) * task$points$width[k]
}

#' @rdname calibration_methods
#' @importFrom stats predict
#' @export
predict.codend_calibration <- function(object, newdata = NULL, level = 0.95, ...) {
  check_level(level)
  task <- object$task
  old <- is.null(newdata)
  if (old) newdata <- task$data
  if (!is.data.frame(newdata) || !nrow(newdata)) {
    abort_argument("{.arg newdata} must be a data frame with one row per haul.")
  }
  newdata <- data_by_path(newdata, task$points$gear, "newdata")
  if (!old) {
    lost <- setdiff(object$conditions, names(newdata))
    if (length(lost)) {
      abort_argument("{.arg newdata} needs a column {.field {lost}}, like the data of the
        calibration.")
    }
    set <- condition_columns(task$points$gear, newdata, task$points$fields)
    newdata[set] <- given_value(newdata[set], "newdata")
    task[c("cases", "case_of")] <- new_cases(task$points, newdata, set)
    task$memory <- new.env(parent = emptyenv())
    task$memory$tried <- list()
    near <- Find(Negate(is.null), object$task$memory$near)
    task$memory$near <- rep(list(near), length(task$cases))
    task$cases <- with_mean_correction(task$cases, object$task$cases)
  }
  model <- model_at(task, object$scaled, slopes = TRUE)
  width <- task$points$width
  free <- which(object$fields$at == "")
  covariance <- (object$covariance / outer(width, width))[free, free, drop = FALSE]
  reach <- reach_of(object, level)
  do.call(rbind, lapply(seq_along(task$match), function(k) {
    one <- task$match[[k]]
    by <- model[[k]]$slopes[, free, drop = FALSE]
    fit <- model[[k]]$fitted
    error <- sqrt(rowSums((by %*% covariance) * by))
    wide <- reach * sqrt(error^2 + object$match$error[k]^2)
    table <- data.frame(row = seq_along(fit), match = one$text, fit = fit, error = error,
      lower = fit - wide, upper = fit + wide)
    left <- str2lang(one$text)
    known <- all(all.vars(left) %in% names(newdata))
    table$measured <- if (known) {
      formula_numbers(eval(left, newdata), one$formula, task$words, one$text)
    } else {
      NA_real_
    }
    table
  }))
}

# Returns the new cases with the mean correction of the calibrated cases.
with_mean_correction <- function(cases, others) {
  known <- Filter(Negate(is.null), lapply(others, `[[`, "correction"))
  if (!length(known)) return(cases)
  mean_of <- function(field) Reduce(`+`, lapply(known, `[[`, field)) / length(known)
  lapply(cases, function(case) {
    case$correction <- list(at = known[[1L]]$at, value = mean_of("value"), slope = mean_of("slope"))
    case
  })
}

#' @rdname calibrate
#' @param x A calibration.
#' @param n Largest number of fields and of matches to print. Default 10. `Inf` prints all.
#' @param ... Not used.
#' @export
print.codend_calibration <- function(x, n = 10, ...) {
  check_rows(n)
  cat("Calibration of \"", x$gear$plan$name, "\" to ", nrow(x$task$data), " rows",
    if (length(x$conditions)) paste0(" by ", paste(x$conditions, collapse = ", ")), "\n", sep = "")
  fields <- printed_rows(x$fields)
  cat_rows(list(
    paste0("  ", field_labels(fields$field)), sure_digits(fields$value, fields$error),
    ifelse(is.na(fields$error), "", paste("+-", sensitivity_digits(signif(fields$error, 2)))),
    fields$unit, paste0("(", sensitivity_digits(fields$begun), " before)"),
    end_text(fields$at)
  ), c(1L, 3L, 4L, 6L), n, "field")
  match <- x$match
  cat("  Root mean square of the residuals\n")
  cat_rows(list(
    paste0("  ", match$text), sensitivity_digits(match$rms),
    paste0("(", sensitivity_digits(match$rms_begun), " before)"),
    paste("mean", sensitivity_digits(match$bias)), paste(match$hauls, "hauls")
  ), 1L, n, "match")
  cat("  ", if (x$converged) "converged" else "not converged", ", ", x$n_solves,
    " gears settled, the last with ", mesh_size_text(x$nodes, x$accuracy), "\n", sep = "")
  invisible(x)
}

#' @export
summary.codend_calibration <- function(object, level = 0.95, ...) {
  ends <- confint(object, level = level, method = "normal")
  structure(list(calibration = object, intervals = ends, level = level),
    class = "codend_calibration_summary")
}

#' @export
print.codend_calibration_summary <- function(x, ...) {
  print(x$calibration)
  cat("\nIntervals from the covariance\n")
  print(signif(x$intervals, 5))
  correlation <- tryCatch(suppressWarnings(stats::cov2cor(x$calibration$covariance)),
    error = function(e) NULL)
  if (length(correlation) > 1L) {
    cat("\nCorrelations of the fields\n")
    print(round(correlation, 2))
  }
  worst <- x$calibration$matched
  worst <- utils::head(worst[order(-abs(worst$standardised)), ], 5L)
  cat("\nFurthest off\n")
  worst[3:7] <- lapply(worst[3:7], signif, 4)
  print(worst, row.names = FALSE)
  invisible(x)
}
