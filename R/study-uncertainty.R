#' Estimate the uncertainty of measures
#'
#' `uncertainty()` estimates the standard uncertainty of every measure of a settled gear, with a 90
#' % interval, its sources, and the best next measurement. It combines the uncertainties of
#' coefficients, plan, conditions and model with the discretisation error of [measures()].
#'
#' @details
#' # Sources of uncertainty
#' - **Coefficients**: the `multipliers` of force components in the plan. Their standard deviations
#'   are the spread of published values. Measurements of whole gears limit the combined effect of
#'   those that are the same in all gears (`validation/conditioning.md`).
#' - **Plan**: numbers with their own uncertainty, `{value: 4 mm, uncertainty: 10 %}` or the uniform
#'   distribution `{range: [3.8 mm, 4.2 mm]}`. Other numbers have the uncertainty of their kind. The
#'   table with sources is `system.file("extdata", "uncertainty.csv", package = "codend")`. Products
#'   of one maker, such as the twine of all panels, have the same relative error.
#' - **Conditions**: speed, current, depth and warp length, in the same manner.
#' - **Discretisation** (`mesh`): the estimated discretisation error of [measures()].
#' - **Model**: effects that no parameter covers, such as stiff twine or an uneven bed. They have
#'   the standard deviation and degrees of freedom of this kind of measure for a net that was not
#'   used in the fit (`validation/conditioning.md`).
#'
#' # Method
#' The method is JCGM 100:2008 (GUM).
#'
#' - A contribution is a sensitivity times a standard uncertainty. Contributions are added in
#'   quadrature, with their correlations. A range that is not
#'   centred on its value shifts the interval.
#' - [sensitivities()] describes the derivatives. Here they have few digits, cover both sides, use a
#'   single factorised matrix, and a mesh of at most 600 nodes per net: a contribution changes by
#'   few percent of itself with more nodes.
#' - Counts of parts, such as slack netting or rope on the seabed, change in steps. Their derivative
#'   counts the lines and contacts that reach zero force within one standard uncertainty.
#' - The limits of the interval are quantiles of the sum of all contributions, for 2,000 draws of
#'   the sources (JCGM 101:2008). Ranges are uniform distributions. The model error has Student's t
#'   distribution. Intervals are asymmetric if a range or a response is.
#'
#' # Nonlinear sources
#' - The gear is settled at both ends of the 90 % interval of these sources: the three largest,
#'   sources with different derivatives on both sides, and relative standard uncertainties above
#'   10 % in the plan. A step is at most 90 % of the value. If an end does not settle, its step is
#'   halved, at most twice; then the other side alone is used.
#' - Each side then has its own contribution. The standard uncertainty uses their mean.
#' - A warning reports the covered part of a range in the plan if it is less than the range.
#' - A measure has `smooth = FALSE` if both sides differ by more than half for sources with more
#'   than 5 % of its variance. `method = "samples"` then settles draws of all sources with [vary()],
#'   on the cores of [future::plan()].
#'
#' @param state A settled state, from [settle()], or a calibration, from [calibrate()].
#' @param of Names of measures, with or without unit. Default `NULL`: all.
#' @param level Probability that the interval contains the true value. Default 0.9.
#' @param method `"linear"` (default) or `"samples"`.
#' @param samples Number of draws for `"samples"`. Default 100. The draws are evenly spread and the
#'   same every time.
#' @return An object of class `codend_uncertainty`, a list:
#'
#'   - `measures`: a data frame, one row per `measure`, in its `unit`. `value` is the measure,
#'     `error` the combined standard uncertainty, and `lower` and `upper` are the interval.
#'     `coefficients`, `plan`, `conditions`, `mesh` and `model` are the parts of the standard
#'     uncertainty. `freedom` is the effective number of degrees of freedom, and `smooth` is
#'     explained in the section on nonlinear sources.
#'   - `sources`: a data frame, one row per measure and source, the largest first. `source` and
#'     `group` name the source. `share` is its standard uncertainty as a fraction of its value, or
#'     of 1 if the value is 0. `contribution` is its effect on the measure (in its unit, with a
#'     sign), and `percent` its percentage of the variance.
#'   - `next_measurement`: a data frame of the three best measurements for each measure.
#'     `measurement` is the measurement, and `remaining_sd` the standard uncertainty that remains
#'     with it.
#'   - `level`, `method`, `gear_name`, `conditions`: settings and labels. `main`: names of the main
#'     measures, which `print()` lists.
#'   - `cost`: a list of the numbers of `factorisations` and settled gears (`n_solves`).
#'
#'   Wrong arguments raise an error of class `codend_error_argument`.
#' @references JCGM 100:2008, Evaluation of measurement data: guide to the expression of uncertainty
#'   in measurement.
#' @seealso [measures()] for discretisation errors, [calibrate()], [codend_charts];
#'   [optimise_gear()] for limits that hold with a given probability;
#'   `vignette("how-sure", package = "codend")`.
#' @export
#' @examples
#' found <- uncertainty(settle("towed_cable"))
#' found
#' found$sources[found$sources$measure == "body_depth_m", ]
uncertainty <- function(state, of = NULL, level = 0.9, method = c("linear", "samples"),
                        samples = 100) {
  check_given("state")
  fit <- if (inherits(state, "codend_calibration")) state
  if (!is.null(fit)) {
    # The calibrated gear is settled in the conditions of its plan.
    state <- settled_state(fit$gear, first_of(fit$task$points$fine, fit$task$points$nodes),
      fit$task$points$netting, NULL)
  }
  check_is_settled(state)
  method <- chosen(method, c("linear", "samples"))
  check_level(level)
  check_count("samples", samples, 20)
  base <- measures(state)
  of <- chosen_measures(of, names(base))
  sources <- uncertainty_sources(state$gear)
  if (!is.null(fit)) sources <- calibrated_sources(sources, fit)
  spread <- source_contributions(coarse_state(state), sources, fit)
  warn_of_uncovered(sources, spread$covered)
  by_measure <- c("spread", "below", "above", "off", "rough")
  found <- c(
    list(base = base[of], sources = sources, correlation = spread$correlation),
    lapply(spread[by_measure], function(part) part[of, , drop = FALSE])
  )
  settled <- method == "samples"
  draws <- if (settled) {
    sample_measures(state, sources, spread$correlation, samples, of)
  } else {
    measure_draws(found)
  }
  made <- budget_of(found, level, draws, settled)
  structure(
    c(made, list(
      level = level, method = method, gear_name = state$gear$plan$name,
      conditions = state_conditions(state),
      cost = list(
        factorisations = spread$factorisations, n_solves = if (settled) samples else 0
      )
    )),
    class = "codend_uncertainty"
  )
}

# The gear is settled on both sides for the largest sources, for those with one-sided derivatives
# that differ by more than `most_turn`, and for those whose plan states a relative standard
# uncertainty of more than `least_wide`. `most_followed` limits the relative step.
followed_sources <- 3L
most_turn <- 0.2
least_wide <- 0.1
most_followed <- 0.9
# The steps are the ends of the 90 % interval of a normal distribution, and of a uniform
# distribution, in standard uncertainties.
side_reach <- c(normal = stats::qnorm(0.95), uniform = sqrt(3))
# A measure is not smooth if its sides differ by more than `most_uneven`.
most_uneven <- 0.5
# Smallest scale for differences of contributions, as a fraction of the measure.
least_contribution <- 0.01

# Contributions need few digits, so meshes have at most this number of nodes per net.
most_budget_nodes <- 600

# Returns the gear of a state, settled from it on a mesh for contributions; the state itself if its
# mesh is not finer or if the gear does not settle on the other mesh.
coarse_state <- function(state) {
  nodes <- most_budget_nodes * net_count(state$gear)
  if (state$mesh$nodes <= least_ratio * nodes) return(state)
  tryCatch(
    settled_state(state$gear, nodes, requested_netting(state), state),
    codend_error_not_converged = function(e) state
  )
}

# Returns list(spread, below, above, off, rough, correlation, factorisations, covered); the first
# five are measures x sources.
#   spread: change of the measure for one standard uncertainty, mean of both sides
#   below, above: the same for the lower and the upper side of the source
#   off: change due to a mean that differs from the value
#   rough: TRUE if not smooth
#   covered: the settled part of the range of each source; NA if not settled on both sides
source_contributions <- function(state, sources, fit = NULL, follow = followed_sources) {
  work <- tangent_work(state)
  n <- length(sources)
  empty <- matrix(0, length(work$values), n, dimnames = list(names(work$values), NULL))
  out <- list(spread = empty, below = empty, above = empty, off = empty, rough = empty != 0)
  covered <- rep(NA_real_, n)
  fields <- lapply(sources, source_field, plan = state$gear$plan)
  add <- function(k, found) {
    known <- function(of, else_of) ifelse(is.finite(of), of, else_of)
    share <- sources[[k]]$share
    slope <- known(found$slope, 0)
    out$spread[, k] <<- slope * share
    out$below[, k] <<- known(first_of(found$below, slope), slope) * share
    out$above[, k] <<- known(first_of(found$above, slope), slope) * share
    out$off[, k] <<- slope * sources[[k]]$off
    out$rough[, k] <<- !first_of(found$smooth, TRUE)
    covered[k] <<- first_of(found$covered, NA_real_)
  }
  for (k in seq_len(n)) {
    source <- sources[[k]]
    wide <- isTRUE(source$given) && source$share > least_wide
    found <- if (!wide) quick_derivatives(work, fields[[k]], source$share)
    add(k, first_of(found, followed_derivatives(work, fields[[k]], source)))
  }
  size <- colMeans(abs(out$spread) / pmax(abs(work$values), 1e-300), na.rm = TRUE)
  for (k in utils::head(order(-size), follow)) {
    if (is.na(covered[k]) && is.finite(size[k]) && size[k] > 0) {
      add(k, followed_derivatives(work, fields[[k]], sources[[k]]))
    }
  }
  c(out, list(correlation = source_correlation(sources, fit),
    factorisations = work$cost$factorisations, covered = covered))
}

contribution_scale <- function(work, spread) {
  pmax(abs(spread), least_contribution * abs(work$values), .Machine$double.xmin)
}

# Returns list(slope) from the tangent; NULL without a tangent or if its two sides differ.
quick_derivatives <- function(work, field, share) {
  found <- tangent_derivatives(work, field, c(quick_tangent, reach = share))
  if (is.null(found)) return(NULL)
  scale <- contribution_scale(work, found$slope * share)
  if (all(found$turn * share <= most_turn * scale, na.rm = TRUE)) found["slope"]
}

# Returns list(slope, below, above, smooth, covered) from gears settled at both ends of the range of
# a source. If an end does not settle, its step is halved, at most twice.
followed_derivatives <- function(work, field, source) {
  range <- source$share * side_reach[[if (isTRUE(source$uniform)) "uniform" else "normal"]]
  side <- function(way) {
    for (step in min(range, most_followed) / c(1, 2, 4)) {
      change <- settled_change(work, field, way * step)
      if (!is.null(change)) return(list(slope = way * change / step, step = step))
    }
    list(slope = NA * work$values, step = 0)
  }
  ends <- list(below = side(-1), above = side(1))
  sides <- lapply(ends, `[[`, "slope")
  step <- mean(c(ends$below$step, ends$above$step))
  found <- derivatives_of_secants(work, sides, 0)
  uneven <- abs(sides$above - sides$below) * step
  # With one side only, the difference is unknown.
  uneven[is.na(uneven)] <- 0
  found$smooth <- !is.na(found$slope) &
    uneven <= 2 * most_uneven * contribution_scale(work, found$slope * step)
  found$covered <- if (range > 0) step / range else 1
  found
}

# Warns if gears did not settle over the ranges that the plan states for sources.
warn_of_uncovered <- function(sources, covered) {
  short <- which(!is.na(covered) & covered < 0.99 & vapply(sources, function(source) {
    isTRUE(source$given)
  }, NA))
  if (!length(short)) return(invisible())
  paths <- vapply(sources[short], function(source) source$paths[1L], "")
  rows <- sprintf("{.field %s}: %.0f %%", paths, 100 * covered[short])
  warn_as("range", c(
    "The gear settles only in a part of the stated uncertainty of {cli::qty(length(rows))}{?a
      field/some fields}. The intervals extrapolate the response of this part.",
    setNames(rows, rep("*", length(rows))),
    "i" = "Give a narrower range, or use {.code method = \"samples\"}."
  ))
}

source_field <- function(source, plan) {
  field <- common_field(plan, source$paths)
  field$multiplier <- source$multiplier
  field
}

# Returns the covariance of sources, in their standard uncertainties.
source_correlation <- function(sources, fit = NULL) {
  correlation <- diag(length(sources))
  # Measurements limit the combined effect of multipliers that are the same in all gears.
  table <- package_table("uncertainty_multipliers.csv")
  shared <- which(vapply(sources, function(source) {
    any(source$multiplier %in% table$multiplier) && is.null(source$given) &&
      is.null(source$calibrated)
  }, NA))
  rows <- match(vapply(sources[shared], `[[`, "", "multiplier"), table$multiplier)
  correlation[shared, shared] <- as.matrix(table[-1L])[rows, rows]
  # Calibrated fields have the correlation of the fit.
  fitted <- which(vapply(sources, function(source) !is.null(source$calibrated), NA))
  if (length(fitted) > 1L) {
    names <- vapply(sources[fitted], `[[`, "", "calibrated")
    found <- suppressWarnings(stats::cov2cor(fit$covariance[names, names, drop = FALSE]))
    found[!is.finite(found)] <- 0
    diag(found) <- 1
    correlation[fitted, fitted] <- found
  }
  correlation
}

# ---- budget --------------------------------------------------------------------------------------

uncertainty_groups <- c("coefficients", "plan", "conditions", "mesh", "model")

# draws: matrix of measures, with a row per draw of all sources; settled: TRUE if gears were settled
# for these draws.
budget_of <- function(found, level, draws, settled = FALSE) {
  base <- found$base
  value <- plain_measures(base)
  group <- vapply(found$sources, `[[`, "", "group")
  covariance_of <- function(rows) {
    s <- found$spread[, rows, drop = FALSE]
    off <- rowSums(found$off[, rows, drop = FALSE])
    s %*% found$correlation[rows, rows, drop = FALSE] %*% t(s) + tcrossprod(off)
  }
  by_group <- vapply(uncertainty_groups[1:3], function(one) {
    sqrt(pmax(0, diag(covariance_of(which(group == one)))))
  }, numeric(length(value)))
  by_group <- matrix(by_group, length(value),
    dimnames = list(names(value), uncertainty_groups[1:3]))
  mesh <- plain(attr(base, "error"))
  mesh[is.na(mesh)] <- 0
  residual <- measure_residuals(base)
  model <- residual$sd * abs(value)
  covariance <- covariance_of(seq_along(group))
  own <- mesh^2 + model^2
  combined <- sqrt(diag(covariance) + own)
  freedom <- function(error) pmax(ifelse(model > 0, residual$freedom * (error / model)^4, Inf), 1)
  ends <- sampled_ends(draws, sqrt(own), freedom(sqrt(own)), level)
  if (settled) combined <- sqrt(ends$sd^2 + own)
  low <- ends$low
  high <- ends$high
  bounded <- value > 0 & uncertainty_kind(base) != "angle"
  low[bounded] <- pmax(low[bounded], 0)
  rough <- rowSums((found$spread * found$rough)^2) > 0.05 * combined^2
  table <- data.frame(
    measure = names(value), value = unname(value), error = combined,
    unit = unname(attr(base, "unit")), lower = low, upper = high, by_group, mesh = mesh,
    model = model, freedom = freedom(combined), smooth = !rough, row.names = NULL
  )
  list(
    measures = table, main = printed_measures(base),
    sources = source_table(found, value, diag(covariance) + own),
    next_measurement = best_measurements(found, base, covariance, own)
  )
}

# variance: of each measure in the linear estimate. The percentages of all sources, the mesh and the
# model add up to 100.
source_table <- function(found, value, variance) {
  sd <- sqrt(diag(found$correlation))
  names <- vapply(found$sources, `[[`, "", "name")
  rows <- lapply(seq_along(value), function(m) {
    one <- found$spread[m, ]
    whole <- sqrt(one^2 * sd^2 + found$off[m, ]^2)
    order <- order(-whole)
    order <- order[whole[order] > 0]
    own <- one * drop(found$correlation %*% one) + found$off[m, ] * sum(found$off[m, ])
    data.frame(
      measure = rep(names(value)[m], length(order)), source = names[order],
      group = vapply(found$sources[order], `[[`, "", "group"),
      share = (vapply(found$sources, `[[`, 0, "share") * sd)[order],
      contribution = sign(one[order]) * whole[order],
      percent = 100 * own[order] / variance[m]
    )
  })
  table_rows(do.call(rbind, rows))
}

# Returns the kind of each measure in the tables of residuals and sensors.
uncertainty_kind <- function(base) {
  kind <- unname(attr(base, "kind"))
  unit <- unname(attr(base, "unit"))
  out <- rep("other", length(kind))
  out[unit %in% c("kN", "N", "kW")] <- "force"
  out[kind %in% c("spread", "swept_area")] <- "spread"
  out[kind %in% c("height", "clearance")] <- "height"
  out[kind %in% c("area", "mouth_blockage", "filtered_volume")] <- "area"
  out[unit == "deg"] <- "angle"
  out[grepl("depth", kind)] <- "depth"
  out[kind %in% c("volume", "volume_fraction", "enclosed_volume")] <- "volume"
  out
}

# Returns list(sd, freedom) of the model error of each measure. `sd`: standard deviation in the
# validation of the same kind, as a fraction. `freedom`: its degrees of freedom.
measure_residuals <- function(base) {
  table <- package_table("uncertainty_residuals.csv")
  kind <- uncertainty_kind(base)
  if (is.null(table)) return(list(sd = 0 * seq_along(kind), freedom = rep(Inf, length(kind))))
  at <- match(kind, table$kind)
  list(sd = ifelse(is.na(at), 0, table$sd[at]), freedom = ifelse(is.na(at), Inf, table$freedom[at]))
}

# Returns the standard uncertainty of a sensor per measure, in its unit; NA without a sensor.
sensor_uncertainty <- function(base) {
  table <- uncertainty_table
  table <- table[table$group == "sensor", ]
  value <- abs(plain_measures(base))
  kind <- uncertainty_kind(base)
  measurable <- unname(attr(base, "kind")) %in%
    c("spread", "height", "clearance", "tension", "angle", "depth", "attitude")
  vapply(seq_along(value), function(m) {
    at <- match(kind[m], table$field)
    if (is.na(at) || !measurable[m] || value[[m]] == 0) return(NA_real_)
    text <- table$uncertainty[at]
    if (grepl("%", text, fixed = TRUE)) return(table_share(text) * value[[m]])
    as.double(split_quantity(text)[1L])
  }, 0)
}

# Returns for each measure the three measurements that would reduce its uncertainty most. A
# measurement is another measure with common sources, or a number of the plan.
best_measurements <- function(found, base, covariance, own) {
  value <- plain_measures(base)
  sensor <- sensor_uncertainty(base)
  total <- diag(covariance) + own
  names <- vapply(found$sources, `[[`, "", "name")
  group <- vapply(found$sources, `[[`, "", "group")
  rows <- lapply(seq_along(value), function(m) {
    by_measure <- covariance[m, ]^2 / (diag(covariance) + own + sensor^2)
    # A direct measurement leaves the uncertainty of the sensor.
    by_measure[m] <- if (is.na(sensor[m])) NA else max(0, total[m] - sensor[m]^2)
    by_field <- ifelse(group == "coefficients", NA, found$spread[m, ]^2)
    fall <- c(by_measure, by_field)
    what <- c(names(value), names)
    order <- utils::head(order(-fall, na.last = NA), 3L)
    data.frame(measure = rep(names(value)[m], length(order)), measurement = what[order],
      remaining_sd = sqrt(pmax(0, total[m] - fall[order])))
  })
  table_rows(do.call(rbind, rows))
}

# ---- samples -------------------------------------------------------------------------------------

# Settles gears with draws of all sources. Returns a matrix of measures: one row per settled draw.
sample_measures <- function(state, sources, correlation, samples, of) {
  use <- which(vapply(sources, `[[`, 0, "share") > 0)
  z <- source_draws(spread_points(samples, length(use)), sources[use],
    correlation[use, use, drop = FALSE])
  columns <- list()
  for (k in seq_along(use)) {
    source <- sources[[use[k]]]
    field <- common_field(state$gear$plan, source$paths)
    share <- pmax(z[, k] * source$share + source$off, -0.9)
    for (p in seq_along(source$paths)) {
      columns[[source$paths[p]]] <- vapply(share, function(one) {
        text <- field_text(changed_number(field$parts[[p]]$value, one), field$parts[[p]])
        as.character(text)
      }, "")
      if (!nzchar(field$parts[[p]]$unit)) {
        columns[[source$paths[p]]] <- as.double(columns[[source$paths[p]]])
      }
    }
  }
  designs <- structure(columns, class = "data.frame", row.names = seq_len(samples))
  found <- vary(state$gear, designs, nodes = state$mesh$counts$asked$nodes)
  as.matrix(as.data.frame(found, wide = TRUE)[found$settled, of, drop = FALSE])
}

# Returns measures for draws of all sources from their contributions (JCGM 101:2008): a matrix with
# a row per draw. Each source has one value in every interval of equal probability. The draws are
# the same every time.
measure_draws <- function(found) {
  sources <- found$sources
  n <- 2000L
  level <- with_seed(1, vapply(seq_along(sources), function(k) sample.int(n), integer(n)))
  z <- source_draws((level - 0.5) / n, sources, found$correlation)
  change <- tcrossprod(pmin(z, 0), found$below) + tcrossprod(pmax(z, 0), found$above)
  sweep(change, 2L, plain_measures(found$base) + rowSums(found$off), `+`)
}

# Returns draws of all sources in standard uncertainties, from independent probabilities: a matrix
# with a column per source.
source_draws <- function(probability, sources, correlation) {
  z <- stats::qnorm(probability) %*% chol(correlation)
  is <- function(of) vapply(sources, function(source) isTRUE(source[[of]]), NA)
  z[, is("uniform")] <- side_reach[["uniform"]] * (2 * stats::pnorm(z[, is("uniform")]) - 1)
  z[, is("upward")] <- abs(z[, is("upward")])
  z
}

# Returns list(sd (of the draws), low, high). The interval includes an independent error with the
# standard deviation `own` and Student's t distribution, at 21 probabilities for every draw.
sampled_ends <- function(draws, own, freedom, level) {
  probability <- (seq_len(21L) - 0.5) / 21
  ends <- vapply(seq_len(ncol(draws)), function(m) {
    x <- draws[, m]
    x <- x[is.finite(x)]
    all <- as.vector(outer(x, stats::qt(probability, freedom[m]) * own[m], `+`))
    c(stats::sd(x), stats::quantile(all, (1 + c(-1, 1) * level) / 2, names = FALSE))
  }, c(0, 0, 0))
  list(sd = ends[1L, ], low = ends[2L, ], high = ends[3L, ])
}

# ---- bounds --------------------------------------------------------------------------------------

# Adds `share` (relative standard uncertainty) and `freedom` of each measure in a state.
text_with_bounds <- function(words, state) {
  found <- uncertainty(state, unique(words$column))$measures
  at <- match(words$column, found$measure)
  size <- abs(found$value[at])
  words$share <- ifelse(size > 0, found$error[at] / size, 0)
  words$freedom <- found$freedom[at]
  words
}
