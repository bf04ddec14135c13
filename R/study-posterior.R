#' Draw from the posterior of a calibration
#'
#' `sample_posterior()` draws values of the fields of [calibrate()] in proportion to their posterior
#' probability. Unlike the covariance and [confint()][stats::confint], it does not assume a nearly
#' linear response of the gear.
#'
#' @details
#' - Priors: a range is a uniform prior, [normal_value()] a normal one. An estimated error has the
#'   prior 1 / error and is integrated out.
#' - Method: a random-walk Metropolis chain (`mcmc::metrop()`) starts at the best values. Its steps
#'   follow the covariance, scaled by 2.38 / sqrt(number of fields) (Gelman, Roberts and Gilks
#'   1996).
#' - Cost: every draw settles the gear once for each distinct setting in the data.
#'
#' @param calibration A calibration, from [calibrate()].
#' @param draws Number of draws to return. Default 1000.
#' @param burn_in Number of initial draws to discard. Default 100.
#' @param seed A whole number. Equal seeds give equal draws.
#' @return A data frame of class `codend_posterior`: one row per draw, one column per field, in the
#'   units of `calibration$fields`. It has two attributes:
#'
#'   - `chain`: a data frame, one row per field. Columns: `field`, `unit`, `mean`, `sd`,
#'     `effective`, and the quantiles `q5`, `q50` and `q95`. `effective` is the number of equivalent
#'     independent draws (Geyer's initial sequence).
#'   - `accepted`: the fraction of accepted steps.
#'
#'   Fewer than 50 effective draws raise a warning of class `codend_warning_few_draws`. Wrong
#'   arguments raise an error of class `codend_error_argument`.
#' @references Gelman, A., Roberts, G. O. and Gilks, W. R. (1996): Efficient Metropolis jumping
#'   rules. Bayesian Statistics 5, 599-607. Geyer, C. J. (1992): Practical Markov chain Monte Carlo.
#'   Statistical Science 7, 473-483.
#' @seealso [calibrate()], [calibration_methods].
#' @export
#' @examplesIf requireNamespace("mcmc", quietly = TRUE)
#' runs <- data.frame(towing.speed = 2:6 / 2, Drag = c(1.9, 3.2, 5, 7.4, 10.2))
#' fit <- calibrate("towed_cable", runs, nodes = 20,
#'   change = list(ropes.cable.diameter = c("10 mm", "30 mm")), match = Drag ~ total_drag_kN)
#' \donttest{
#' sample_posterior(fit, draws = 40, burn_in = 20)
#' }
sample_posterior <- function(calibration, draws = 1000, burn_in = 100, seed = 1) {
  check_given("calibration")
  check_is_calibration(calibration)
  check_count("draws", draws)
  check_count("burn_in", burn_in)
  check_count("seed", seed)
  check_package("mcmc", "A posterior")
  task <- calibration$task
  width <- task$points$width
  # A copy leaves the memory of the fit unchanged.
  near <- task$memory$near
  task$memory <- list2env(list(tried = list(), near = near))
  likely <- function(scaled) {
    if (any(scaled < 0 | scaled > 1)) return(-Inf)
    # `+ 0` makes a copy, because the chain overwrites `scaled` and the task stores it.
    -misfit_at(task, scaled + 0)$value
  }
  run <- with_seed(seed, mcmc::metrop(
    likely, calibration$scaled, nbatch = burn_in + draws, scale = chain_scale(calibration, width)
  ))
  kept <- run$batch[burn_in + seq_len(draws), , drop = FALSE]
  values <- sweep(sweep(kept, 2L, width, "*"), 2L, task$points$lower, "+")
  found <- as.data.frame(values)
  names(found) <- calibration$fields$field
  chain <- chain_figures(found, calibration$fields$unit)
  poor <- chain$field[chain$effective < least_effective]
  if (length(poor)) {
    warn_as("few_draws", "The effective sample size of {.field {poor}} is below
      {least_effective}: increase {.arg draws}.")
  }
  structure(found, class = c("codend_posterior", "data.frame"), chain = chain,
    accepted = run$accept)
}

least_effective <- 50

# The standard deviation is a tenth of the range for a field without a covariance (at a range end).
chain_scale <- function(calibration, width) {
  covariance <- calibration$covariance / outer(width, width)
  known <- is.finite(diag(covariance))
  shape <- diag(0.1^2, length(width))
  shape[known, known] <- covariance[known, known]
  root <- tryCatch(chol(shape), error = function(e) diag(sqrt(diag(shape)), length(width)))
  2.38 / sqrt(length(width)) * t(root)
}

chain_figures <- function(draws, unit) {
  effective <- vapply(draws, function(x) {
    if (stats::var(x) == 0) return(1)
    min(length(x), length(x) * stats::var(x) / mcmc::initseq(x)$var.con)
  }, 0)
  ends <- t(vapply(draws, stats::quantile, c(0, 0, 0), probs = c(0.05, 0.5, 0.95)))
  data.frame(
    field = names(draws), unit = unit, mean = colMeans(draws),
    sd = vapply(draws, stats::sd, 0), effective = effective,
    q5 = ends[, 1L], q50 = ends[, 2L], q95 = ends[, 3L], row.names = NULL
  )
}

#' @rdname sample_posterior
#' @param x A posterior.
#' @param n Largest number of fields to print. Default 20. `Inf` prints all.
#' @param ... Not used.
#' @export
print.codend_posterior <- function(x, n = most_rows, ...) {
  check_rows(n)
  chain <- printed_rows(attr(x, "chain"))
  cat(nrow(x), " draws, ", format(round(100 * attr(x, "accepted"))), " % of proposals accepted\n",
    sep = "")
  rows <- utils::head(chain, n)
  quantiles <- lapply(rows[c("q5", "q50", "q95")], sure_digits, rows$sd)
  cat_headed(c(
    list(
      headed("field", NULL, field_labels(rows$field)),
      headed("mean", NULL, sure_digits(rows$mean, rows$sd)),
      headed("standard deviation", NULL, sensitivity_digits(signif(rows$sd, 2))),
      headed("unit", NULL, rows$unit)
    ),
    Map(headed, c("5 %", "50 %", "95 %"), list(NULL), quantiles),
    list(headed("effective draws", NULL, format(round(rows$effective))))
  ), 1L, all = TRUE)
  cat_more(c(field = nrow(chain) - n))
  invisible(x)
}
