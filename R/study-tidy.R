#' @rdname codend_tidy
#' @exportS3Method generics::tidy
tidy.codend_calibration <- function(x, conf.int = FALSE, conf.level = 0.95, ...) {
  fields <- x$fields
  table <- data.frame(
    term = fields$field, estimate = fields$value, unit = fields$unit, std.error = fields$error
  )
  if (conf.int) {
    ends <- confint(x, level = conf.level, method = "normal")
    table[c("conf.low", "conf.high")] <- list(unname(ends[, 1L]), unname(ends[, 2L]))
  }
  cbind(table, at = fields$at)
}

#' @rdname codend_tidy
#' @exportS3Method generics::glance
glance.codend_calibration <- function(x, ...) {
  likely <- logLik(x)
  data.frame(
    name = x$gear$plan$name, nobs = nobs(x), df.residual = nobs(x) - attr(likely, "df"),
    logLik = as.double(likely), AIC = stats::AIC(likely), BIC = stats::BIC(likely),
    converged = x$converged, n_solves = x$n_solves
  )
}

#' @rdname codend_tidy
#' @exportS3Method generics::augment
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
    .match = found$match, .fitted = found$fit, .se.fit = found$error, .lower = found$low,
    .upper = found$high
  ))
}

#' @rdname codend_tidy
#' @exportS3Method generics::tidy
tidy.codend_posterior <- function(x, conf.level = 0.95, ...) {
  check_level(conf.level)
  chain <- attr(x, "chain")
  draws <- as.list(x)[chain$field]
  end <- function(share) unname(vapply(draws, stats::quantile, 0, probs = share))
  data.frame(
    term = chain$field, estimate = chain$mean, unit = chain$unit, std.error = chain$sd,
    conf.low = end((1 - conf.level) / 2), conf.high = end((1 + conf.level) / 2),
    effective = chain$effective
  )
}

#' @rdname codend_tidy
#' @exportS3Method generics::glance
glance.codend_posterior <- function(x, ...) {
  data.frame(
    draws = nrow(x), accepted = attr(x, "accepted"), effective = min(attr(x, "chain")$effective)
  )
}

#' @rdname codend_tidy
#' @exportS3Method generics::tidy
tidy.codend_optimum <- function(x, ...) {
  fields <- x$fields
  data.frame(
    term = fields$field, estimate = fields$value, unit = fields$unit, begun = fields$begun,
    low = fields$lower, high = fields$upper, at = fields$at
  )
}

#' @rdname codend_tidy
#' @exportS3Method generics::glance
glance.codend_optimum <- function(x, ...) {
  data.frame(
    name = x$gear$plan$name, objective = x$objective$text, begun = x$objective$begun,
      value = x$objective$value,
    kept = all(x$keep$holds), optimality = x$optimality, converged = x$optimal,
    n_solves = x$n_solves
  )
}

#' @rdname codend_tidy
#' @exportS3Method generics::tidy
tidy.codend_variations <- function(x, ...) {
  table <- unclass(x)
  fields <- as.data.frame(table[variations_fields(x)], optional = TRUE)
  known <- variations_measures(x)
  row <- rep(seq_len(nrow(x)), length(known))
  data.frame(
    design = attr(x, "study")$design[row], fields[row, , drop = FALSE],
    term = rep(known, each = nrow(x)), estimate = as.double(unlist(table[known])),
    unit = rep(vapply(known, function(name) variations_unit(x, name), ""), each = nrow(x)),
    error = as.double(unlist(table[error_columns(known)])), row.names = NULL, check.names = FALSE
  )
}

#' @rdname codend_tidy
#' @exportS3Method generics::glance
glance.codend_variations <- function(x, ...) {
  found <- summary(x)
  as.data.frame(found[c("name", "designs", "done", "settled", "warned")])
}

#' @rdname codend_tidy
#' @exportS3Method generics::tidy
tidy.codend_found <- function(x, ...) as.data.frame(x)

#' @rdname codend_tidy
#' @exportS3Method generics::glance
glance.codend_found <- function(x, ...) {
  data.frame(
    name = x$gear$plan$name, reached = all(x$targets$reached), n_solves = x$n_solves,
    nodes = x$state$mesh$nodes
  )
}
