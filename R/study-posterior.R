#' Draw from the posterior of a calibration
#'
#' Values of the fields of [calibrate()] in proportion to how probable the data make them: what the
#' covariance and the profiles of [confint()][stats::confint] approach, without the assumption that
#' the gear answers in straight lines. Ranges are even priors, [normal_value()] is a normal one,
#' and an
#' estimated error has the prior 1 / error, over which it is integrated.
#'
#' A random-walk Metropolis chain (`mcmc::metrop()`) begins at the best values, its steps shaped by
#' the covariance and 2.38 / sqrt(fields) times as wide (Gelman, Roberts and Gilks 1996). Every draw
#' settles the gear once for each different row of the data.
#'
#' @param calibration From [calibrate()].
#' @param draws Draws to keep.
#' @param begin Draws before, which are not kept.
#' @param seed A whole number: equal seeds give equal draws.
#' @return A data frame of class `codend_posterior` with a column per field, in the units of
#'   `calibration$fields`, and a row per draw. The attribute `chain` is a data frame with `field`,
#'   `unit`, `mean`, `sd`, `effective` (independent draws that these are worth, by Geyer's initial
#'   sequence) and the quantiles `q5`, `q50` and `q95`; the attribute `accepted` the share of steps
#'   taken. Fewer than 50 effective draws are warned of (`codend_warning_few_draws`). Wrong
#'   arguments are an error of class `codend_error_argument`.
#' @references Gelman, A., Roberts, G. O. and Gilks, W. R. (1996): Efficient Metropolis jumping
#'   rules. Bayesian Statistics 5, 599-607. Geyer, C. J. (1992): Practical Markov chain Monte Carlo.
#'   Statistical Science 7, 473-483.
#' @export
#' @examplesIf requireNamespace("mcmc", quietly = TRUE)
#' runs <- data.frame(towing.speed = 2:6 / 2, Drag = c(1.9, 3.2, 5, 7.4, 10.2))
#' fit <- calibrate("towed_cable", runs, nodes = 20,
#'   change = list(ropes.cable.diameter = c("10 mm", "30 mm")), match = Drag ~ total_drag_kN)
#' \donttest{
#' sample_posterior(fit, draws = 60, begin = 30)
#' }
sample_posterior <- function(calibration, draws = 1000, begin = 100, seed = 1) {
  check_given("calibration")
  if (!inherits(calibration, "codend_calibration")) {
    abort_argument("{.arg calibration} must come from {.fn calibrate}.")
  }
  check_count("draws", draws)
  check_count("begin", begin)
  check_count("seed", seed)
  check_package("mcmc", "A posterior")
  task <- calibration$task
  width <- task$points$width
  # the fit's own memory stays as it is
  near <- task$memory$near
  task$memory <- list2env(list(tried = list(), near = near))
  likely <- function(scaled) {
    if (any(scaled < 0 | scaled > 1)) return(-Inf)
    # a copy: the chain writes the next place over this one, which the task remembers
    -misfit_at(task, scaled + 0)$value
  }
  run <- with_seed(seed, mcmc::metrop(
    likely, calibration$scaled, nbatch = begin + draws, scale = chain_scale(calibration, width)
  ))
  kept <- run$batch[begin + seq_len(draws), , drop = FALSE]
  values <- sweep(sweep(kept, 2L, width, "*"), 2L, task$points$lower, "+")
  found <- as.data.frame(values)
  names(found) <- calibration$fields$field
  chain <- chain_figures(found, calibration$fields$unit)
  poor <- chain$field[chain$effective < least_effective]
  if (length(poor)) {
    cli::cli_warn(
      "The draws of {.field {poor}} are worth fewer than {least_effective} independent ones: take
      more {.arg draws}.", class = c("codend_warning_few_draws", "codend_warning"), call = NULL
    )
  }
  structure(found, class = c("codend_posterior", "data.frame"), chain = chain,
    accepted = run$accept)
}

least_effective <- 50

# Steps of the chain; of fields without a covariance, as at the end of a range, a tenth of it.
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

#' @export
print.codend_posterior <- function(x, ...) {
  chain <- attr(x, "chain")
  cat(nrow(x), " draws, ", format(round(100 * attr(x, "accepted"))), " % of steps taken\n",
    sep = "")
  chain[-(1:2)] <- lapply(chain[-(1:2)], signif, 4)
  chain$effective <- round(chain$effective)
  print(chain, row.names = FALSE)
  invisible(x)
}
