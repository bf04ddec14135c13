#' Estimate the uncertainty of measures
#'
#' `uncertainty()` estimates the standard uncertainty of every measure of a settled gear, with a 90
#' % interval, its sources, and the best next measurement. It combines the uncertainties of
#' coefficients, plan, conditions and model with the discretisation error of [measures()].
#'
#' @details
#' # Sources of uncertainty
#' - **Coefficients**: the `multipliers` of force components in the plan. Their standard deviations
#'   and correlations come from the validation book (`validation/conditioning.md`). Boards, friction
#'   and ground gear have the spread of published values, because other gears give no information on
#'   them.
#' - **Skin friction of netting**: screen drag models (`blended`, `kristiansen_faltinsen`) have no
#'   friction of netting parallel to the flow. `multipliers.screen_friction` adds it, as a drag
#'   coefficient on the area of the twine. It is 0 by default, with a standard uncertainty of 0.02,
#'   upward only.
#' - **Plan**: numbers with their own uncertainty, `{value: 4 mm, uncertainty: 10 %}` or the uniform
#'   distribution `{range: [3.8 mm, 4.2 mm]}`. Other numbers have the uncertainty of their kind. The
#'   table with sources is `system.file("extdata", "uncertainty.csv", package = "codend")`. Products
#'   of one maker, such as the twine of all panels, have the same relative error.
#' - **Conditions**: speed, current, depth and warp length, in the same manner.
#' - **Discretisation** (`mesh`): the estimated discretisation error of [measures()].
#' - **Model**: effects that no parameter covers, such as stiff twine or an uneven bed. They have
#'   the standard deviation and degrees of freedom of this kind of measure in the validation book.
#'
#' # Why skin friction is 0.02
#' This is Hoerner's friction of twine along the flow; Morison-type models use 0 to 0.1. Nets of
#' fish farms had more: 0.3 of the drag across the flow (Nino et al. 2020). Without any friction,
#' the 90 % intervals still contain \resultIntervalsCovered{} of the measured values
#' (`validation/conditioning.md`).
#'
#' # Method
#' The method is JCGM 100:2008 (GUM).
#'
#' - A contribution is a sensitivity times a standard uncertainty. Contributions are added in
#'   quadrature, with their correlations. A known bias of a coefficient is included (F.2.4.5).
#' - [sensitivities()] describes the derivatives. Here they have few digits, cover both sides, and
#'   use a single factorised matrix.
#' - Counts of parts, such as slack netting or rope on the seabed, change in steps. Their derivative
#'   counts the lines and contacts that reach zero force within one standard uncertainty.
#' - The interval is the measure plus and minus the combined standard uncertainty times Student's t
#'   of the effective degrees of freedom (G.4).
#'
#' # Nonlinear sources
#' - The gear is settled one standard uncertainty to both sides for the three largest sources, and
#'   for sources with different derivatives on both sides. The step is at most half of the value. If
#'   a side does not settle, the step is a quarter; if it fails again, the other side alone is used.
#' - Half of the difference between both sides replaces the linear contribution. For the three
#'   largest sources this requires a difference of more than 20 % from the linear value.
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
  spread <- source_contributions(state, sources, fit)
  found <- list(
    base = base[of], sources = sources, spread = spread$spread[of, , drop = FALSE],
    off = spread$off[of, , drop = FALSE], rough = spread$rough[of, , drop = FALSE],
    correlation = spread$correlation
  )
  draws <- if (method == "samples") sample_measures(state, sources, spread$correlation, samples, of)
  made <- budget_of(found, level, draws)
  structure(
    c(made, list(
      level = level, method = method, gear_name = state$gear$plan$name,
      conditions = state_conditions(state),
      cost = list(
        factorisations = spread$factorisations, n_solves = if (is.null(draws)) 0 else samples
      )
    )),
    class = "codend_uncertainty"
  )
}

# The gear is settled on both sides for the largest sources, and for those with one-sided
# derivatives that differ by more than `most_turn`. `most_followed` limits the relative step.
followed_sources <- 3L
most_turn <- 0.2
most_followed <- 0.5
# Contributions from derivatives are replaced if they are wrong by more than `most_off_slope`. A
# measure is not smooth if its sides differ by more than `most_uneven`.
most_off_slope <- 0.2
most_uneven <- 0.5
# Smallest scale for differences of contributions, as a fraction of the measure.
least_contribution <- 0.01

# Returns list(spread, off, rough, correlation, factorisations); the first three are measures x
# sources. `spread`: change of the measure for one standard uncertainty. `off`: change due to a
# known bias. `rough`: TRUE if not smooth.
source_contributions <- function(state, sources, fit = NULL, follow = followed_sources) {
  work <- tangent_work(state)
  n <- length(sources)
  spread <- off <- matrix(0, length(work$values), n, dimnames = list(names(work$values), NULL))
  rough <- matrix(FALSE, length(work$values), n, dimnames = dimnames(spread))
  fields <- lapply(sources, source_field, plan = state$gear$plan)
  followed <- logical(n)
  for (k in seq_len(n)) {
    share <- sources[[k]]$share
    found <- quick_derivatives(work, fields[[k]], share)
    if (is.null(found)) found <- followed_derivatives(work, fields[[k]], share)
    followed[k] <- !is.null(found$smooth)
    spread[, k] <- known_derivative(found) * share
    off[, k] <- known_derivative(found) * sources[[k]]$off
    if (followed[k]) rough[, k] <- !found$smooth
  }
  size <- colMeans(abs(spread) / pmax(abs(work$values), 1e-300), na.rm = TRUE)
  for (k in utils::head(order(-size), follow)) {
    if (followed[k] || !is.finite(size[k]) || size[k] == 0) next
    found <- followed_derivatives(work, fields[[k]], sources[[k]]$share)
    half <- known_derivative(found) * sources[[k]]$share
    scale <- contribution_scale(work, spread[, k])
    wrong <- is.finite(found$slope) & abs(half - spread[, k]) > most_off_slope * scale
    spread[wrong, k] <- half[wrong]
    rough[, k] <- !found$smooth
  }
  list(
    spread = spread, off = off, rough = rough, correlation = source_correlation(sources, fit),
    factorisations = work$cost$factorisations
  )
}

known_derivative <- function(found) ifelse(is.finite(found$slope), found$slope, 0)

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

# Returns list(slope, smooth) from gears settled one standard uncertainty to both sides. If a side
# does not settle, the step is four times smaller.
followed_derivatives <- function(work, field, share) {
  step <- min(share, most_followed)
  sides <- secant_derivatives(work, field, step, both = TRUE)
  if (anyNA(sides$below) || anyNA(sides$above)) {
    step <- step / 4
    sides <- secant_derivatives(work, field, step)
  }
  found <- derivatives_of_secants(work, sides, 0)
  uneven <- abs(sides$above - sides$below) * step
  # With one side only, the difference is unknown.
  uneven[is.na(uneven)] <- 0
  found$smooth <- !is.na(found$slope) &
    uneven <= 2 * most_uneven * contribution_scale(work, found$slope * step)
  found
}

source_field <- function(source, plan) {
  field <- common_field(plan, source$paths)
  field$multiplier <- source$multiplier
  field
}

source_correlation <- function(sources, fit = NULL) {
  correlation <- diag(length(sources))
  known <- multiplier_knowledge()$covariance
  some <- which(vapply(sources, function(source) isTRUE(source$correlated), NA))
  if (length(some) > 1L) {
    names <- vapply(sources[some], `[[`, "", "multiplier")
    correlation[some, some] <- stats::cov2cor(known[names, names, drop = FALSE])
  }
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

# draws: measures of the samples, or NULL.
budget_of <- function(found, level, draws = NULL) {
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
  freedom <- ifelse(model > 0, residual$freedom * (combined / model)^4, Inf)
  reach <- stats::qt((1 + level) / 2, pmax(freedom, 1))
  low <- value - reach * combined
  high <- value + reach * combined
  if (!is.null(draws)) {
    ends <- sampled_ends(draws, sqrt(own), level)
    combined <- sqrt(ends$sd^2 + own)
    low <- ends$low
    high <- ends$high
  }
  bounded <- value > 0 & uncertainty_kind(base) != "angle"
  low[bounded] <- pmax(low[bounded], 0)
  rough <- rowSums((found$spread * found$rough)^2) > 0.05 * combined^2
  table <- data.frame(
    measure = names(value), value = unname(value), error = combined,
    unit = unname(attr(base, "unit")), lower = low, upper = high, by_group, mesh = mesh,
    model = model, freedom = freedom, smooth = !rough, row.names = NULL
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
  names <- vapply(found$sources, `[[`, "", "name")
  rows <- lapply(seq_along(value), function(m) {
    one <- found$spread[m, ]
    whole <- sqrt(one^2 + found$off[m, ]^2)
    order <- order(-whole)
    order <- order[whole[order] > 0]
    own <- one * drop(found$correlation %*% one) + found$off[m, ] * sum(found$off[m, ])
    data.frame(
      measure = rep(names(value)[m], length(order)), source = names[order],
      group = vapply(found$sources[order], `[[`, "", "group"),
      share = vapply(found$sources[order], `[[`, 0, "share"),
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
  table <- uncertainty_table()
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
  z <- stats::qnorm(spread_points(samples, length(use)))
  root <- chol(correlation[use, use, drop = FALSE])
  z <- z %*% root
  columns <- list()
  for (k in seq_along(use)) {
    source <- sources[[use[k]]]
    field <- common_field(state$gear$plan, source$paths)
    share <- pmax(z[, k] * source$share + source$off, -0.9)
    # A value of 0 can only increase.
    if (any(vapply(field$parts, `[[`, 0, "value") == 0)) share <- abs(share)
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

# Returns list(sd (of the draws), low, high). The interval includes an independent normal error with
# standard deviation `own`, sampled at 21 probabilities for every draw.
sampled_ends <- function(draws, own, level) {
  points <- stats::qnorm((seq_len(21L) - 0.5) / 21)
  ends <- vapply(seq_len(ncol(draws)), function(m) {
    x <- draws[, m]
    x <- x[is.finite(x)]
    all <- as.vector(outer(x, points * own[m], `+`))
    c(stats::sd(x), stats::quantile(all, (1 + c(-1, 1) * level) / 2))
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
