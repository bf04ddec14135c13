# Tables of results of studies, and `tidy()` of all results.

#' @rdname codend_tidy
#' @export
#' @rawNamespace
#' S3method(tidy,codend_measures,tidy.codend_state)
#' S3method(tidy,codend_trajectory,tidy.codend_state)
#' S3method(tidy,codend_variations,tidy.codend_state)
#' S3method(tidy,codend_sensitivities,tidy.codend_state)
#' S3method(tidy,codend_effects,tidy.codend_state)
#' S3method(tidy,codend_pair_effects,tidy.codend_state)
#' S3method(tidy,codend_sobol_indices,tidy.codend_state)
#' S3method(tidy,codend_uncertainty,tidy.codend_state)
#' S3method(tidy,codend_calibration,tidy.codend_state)
#' S3method(tidy,codend_posterior,tidy.codend_state)
#' S3method(tidy,codend_optimum,tidy.codend_state)
#' S3method(tidy,codend_found,tidy.codend_state)
#' S3method(tidy,codend_trade_off,tidy.codend_state)
tidy.codend_state <- function(x, ...) as.data.frame(x, ...)

# ---- calibrations and optima ---------------------------------------------------------------------

#' @rdname codend_tidy
#' @export
as.data.frame.codend_calibration <- function(x, row.names = NULL, optional = FALSE, level = 0.95,
                                             ...) {
  ends <- confint(x, level = level, method = "normal")
  fields <- x$fields
  with_row_names(data.frame(
    fields[c("field", "value", "error", "unit")], lower = unname(ends[, 1L]),
    upper = unname(ends[, 2L]), fields[c("begun", "at")]
  ), row.names)
}

#' @rdname codend_tidy
#' @export
glance.codend_calibration <- function(x, ...) {
  likely <- logLik(x)
  data.frame(
    name = x$gear$plan$name, nobs = nobs(x), df.residual = nobs(x) - attr(likely, "df"),
    logLik = as.double(likely), AIC = stats::AIC(likely), BIC = stats::BIC(likely),
    converged = x$converged, n_solves = x$n_solves
  )
}

#' @rdname codend_tidy
#' @export
augment.codend_calibration <- function(x, newdata = NULL, ...) {
  with_data <- function(data, rows, columns) {
    data.frame(as.data.frame(data)[rows, , drop = FALSE], columns, row.names = NULL,
      check.names = FALSE)
  }
  if (is.null(newdata)) {
    matched <- x$matched
    return(with_data(x$task$data, matched$row, data.frame(
      .match = matched$match, .measured = matched$measured, .fitted = matched$fitted,
      .resid = matched$residual, .std.resid = matched$standardised
    )))
  }
  found <- predict(x, newdata)
  with_data(newdata, found$row, data.frame(
    .match = found$match, .fitted = found$fit, .se.fit = found$error, .lower = found$lower,
    .upper = found$upper
  ))
}

#' @rdname codend_tidy
#' @export
as.data.frame.codend_posterior <- function(x, row.names = NULL, optional = FALSE, level = 0.95,
                                           wide = optional, ...) {
  if (wide) return(with_row_names(plain_table(x), row.names))
  check_level(level)
  chain <- attr(x, "chain")
  draws <- unclass(x)[chain$field]
  end <- function(share) unname(vapply(draws, stats::quantile, 0, probs = share))
  with_row_names(data.frame(
    field = chain$field, value = chain$mean, error = chain$sd, unit = chain$unit,
    lower = end((1 - level) / 2), upper = end((1 + level) / 2), effective = chain$effective
  ), row.names)
}

#' @rdname codend_tidy
#' @export
glance.codend_posterior <- function(x, ...) {
  data.frame(
    draws = nrow(x), accepted = attr(x, "accepted"), effective = min(attr(x, "chain")$effective)
  )
}

#' @rdname codend_tidy
#' @export
as.data.frame.codend_optimum <- function(x, row.names = NULL, optional = FALSE, ...) {
  columns <- c("field", "value", "error", "unit", "lower", "upper", "begun", "at")
  with_row_names(cbind(x$fields, error = NA_real_)[columns], row.names)
}

#' @rdname codend_tidy
#' @export
glance.codend_optimum <- function(x, ...) {
  data.frame(
    name = x$gear$plan$name, objective = x$objective$text, begun = x$objective$begun,
      value = x$objective$value,
    kept = all(x$keep$holds), optimality = x$optimality, converged = x$optimal,
    n_solves = x$n_solves
  )
}

# ---- variations ----------------------------------------------------------------------------------

#' @rdname codend_tidy
#' @export
as.data.frame.codend_variations <- function(x, row.names = NULL, optional = FALSE,
                                            wide = optional, ...) {
  if (wide) return(with_row_names(plain_table(x), row.names))
  error <- errors_by_design(x)
  known <- variations_measures(x)
  unit <- vapply(known, function(name) variations_unit(x, name), "")
  with_row_names(long_table(x, variations_fields(x), known, error[known], unit), row.names)
}

# Returns a table like variations with the error of each measure instead of its value. Rows are
# found by their fields, because other packages sort and select rows without the errors.
errors_by_design <- function(x) {
  known <- attr(x, "errors")
  fields <- attr(x, "fields")
  if (is.null(known) || !all(fields %in% names(x))) {
    abort_argument("{.arg x} lacks the fields or errors of its designs; use the result of
      {.fn vary}.")
  }
  key <- function(table) do.call(paste, c(unname(unclass(table)[fields]), sep = "\r"))
  found <- table_rows(known, match(key(x), key(known)))
  derived <- setdiff(variations_measures(x), names(known))
  found[derived] <- rep(list(rep(NA_real_, nrow(x))), length(derived))
  found[c(fields, variations_measures(x))]
}

#' @export
`[.codend_variations` <- function(x, ...) {
  some <- NextMethod()
  if (!is.data.frame(some)) return(some)
  kept <- c("gear_name", "unit", "fields", "main", "errors", "study")
  attributes(some)[kept] <- attributes(x)[kept]
  some
}

# Merges the columns of the results, as cbind() and data.frame() combine them.
#' @export
#' @rawNamespace
#' S3method(merge,codend_posterior,merge.codend_variations)
#' S3method(merge,codend_trade_off,merge.codend_variations)
merge.codend_variations <- function(x, y, ...) {
  merge(as.data.frame(x, optional = TRUE), as.data.frame(y, optional = TRUE), ...)
}

#' @rdname codend_tidy
#' @export
glance.codend_variations <- function(x, ...) {
  found <- summary(x)
  as.data.frame(found[c("name", "designs", "done", "settled", "warned")])
}

#' @rdname codend_tidy
#' @export
as.data.frame.codend_found <- function(x, row.names = NULL, optional = FALSE, ...) {
  with_row_names(x$fields, row.names)
}

#' @rdname codend_tidy
#' @export
glance.codend_found <- function(x, ...) {
  data.frame(
    name = x$gear$plan$name, reached = all(x$targets$reached), n_solves = x$n_solves,
    nodes = x$state$mesh$nodes
  )
}

# ---- other studies -------------------------------------------------------------------------------

#' @rdname codend_tidy
#' @export
#' @rawNamespace
#' S3method(as.data.frame,codend_effects,as.data.frame.codend_sensitivities)
#' S3method(as.data.frame,codend_pair_effects,as.data.frame.codend_sensitivities)
#' S3method(as.data.frame,codend_sobol_indices,as.data.frame.codend_sensitivities)
as.data.frame.codend_sensitivities <- function(x, row.names = NULL, optional = FALSE, ...) {
  with_row_names(plain_table(x), row.names)
}

#' @rdname codend_tidy
#' @export
as.data.frame.codend_uncertainty <- function(x, row.names = NULL, optional = FALSE, ...) {
  with_row_names(x$measures, row.names)
}

#' @rdname codend_tidy
#' @export
as.data.frame.codend_trade_off <- function(x, row.names = NULL, optional = FALSE, wide = optional,
                                           ...) {
  if (wide) return(with_row_names(plain_table(x), row.names))
  objectives <- names(attr(x, "objectives"))
  fields <- setdiff(names(x), c(objectives, "kept", "optimal"))
  table <- long_table(x, fields, objectives, NA_real_, rep("", length(objectives)))
  table[c("kept", "optimal")] <- list(x$kept, x$optimal)
  with_row_names(table, row.names)
}

#' @rdname codend_tidy
#' @export
glance.codend_sensitivities <- function(x, ...) {
  data.frame(
    name = attr(x, "gear_name"), conditions = attr(x, "conditions"),
    fields = length(unique(x$field)), measures = length(unique(x$measure)), smooth = all(x$smooth)
  )
}

#' @rdname codend_tidy
#' @export
glance.codend_uncertainty <- function(x, ...) {
  data.frame(
    name = x$gear_name, conditions = x$conditions, measures = nrow(x$measures),
    sources = length(unique(x$sources$source)), level = x$level, method = x$method
  )
}

#' @rdname codend_tidy
#' @export
glance.codend_trade_off <- function(x, ...) {
  data.frame(
    name = attr(x, "gear_name"), points = nrow(x), kept = sum(x$kept), optimal = sum(x$optimal)
  )
}
