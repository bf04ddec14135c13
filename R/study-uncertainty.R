#' How far measures may be from the truth
#'
#' The standard uncertainty of every measure of a settled gear, an interval that holds the truth
#' nine times out of ten, where it comes from, and what to measure next. `measures()` reports the
#' discretisation error alone; this adds what is not known of coefficients, of the plan and of the
#' conditions, and what no parameter covers.
#'
#' @details
#' # What is uncertain
#' - coefficients: the plan's `multipliers` of components of force, with the standard deviations and
#'   correlations that the validation book leaves (`validation/conditioning.md`); those of boards,
#'   friction and ground gear, of which another gear says nothing, with the spread of published
#'   values. Netting that lies along the flow has friction, of which laws of whole sheets
#'   (`blended`, `kristiansen_faltinsen`) have none. `multipliers.screen_friction` adds it, as a
#'   drag coefficient on the twine's area: 0 by default, with a standard uncertainty of 0.02, upward
#'   alone: Hoerner's friction of twine along the flow, of 0 to 0.1 that laws of twines have. Nets
#'   of farms had more (0.3 of the drag across the flow, Nino et al. 2020), but without any friction
#'   the intervals of 90 % hold \resultIntervalsCovered{} of the measured values
#'   (`validation/conditioning.md`);
#' - plan: numbers with an uncertainty of their own, `{value: 4 mm, uncertainty: 10 %}` or
#'   `{range: [3.8 mm, 4.2 mm]}`, which is evenly distributed; others have that of their kind, from
#'   a table with sources (`system.file("extdata", "uncertainty.csv", package = "codend")`). What
#'   one maker makes, such as the twine of all panels, errs together, by the same share;
#' - conditions: speed, current, depth and warp, likewise;
#' - discretisation (`lattice`): the estimated discretisation error of [measures()];
#' - model: what no parameter covers (stiff twine, an uneven bed), as the standard deviation that is
#'   left in the validation book of measures of that kind, with its degrees of freedom.
#'
#' # How it is found
#' As JCGM 100:2008 (GUM) has it: contributions are sensitivities times standard uncertainties,
#' added in quadrature with their correlations; a coefficient whose mean is known to be off counts
#' with that as well (F.2.4.5). Sensitivities are those of [sensitivities()], to both sides and a
#' few figures, with one factorised matrix. What counts parts of the gear, slack netting and rope
#' on the bed, grows by the lines and contacts that one standard uncertainty takes to zero force.
#' The interval is the measure plus and minus the combined standard uncertainty times Student's t
#' of the effective degrees of freedom (G.4). Of the three largest sources, and of those whose
#' slopes on both sides of the state are not the same, the gear is settled one standard uncertainty
#' to both sides (half of the value at most; to one side where the other does not settle in a few
#' steps). Half of that difference counts: of the three largest where it is more than a fifth off
#' the slope's, of the others throughout. Where the two sides differ by more than half the measure
#' is `smooth = FALSE`: `method = "samples"` then follows the gear through draws of all sources (by
#' [vary()], on as many cores as [future::plan()] says).
#'
#' @param state A settled state, from [settle()], or a gear calibrated by [calibrate()].
#' @param of Names of measures; all when `NULL`.
#' @param level Probability that the interval holds the truth.
#' @param method `"linear"`, or `"samples"`.
#' @param samples Draws of `"samples"`. They are spread evenly, the same every time.
#' @return An object of class `codend_uncertainty`, a list of
#'
#'   - `measures`: a data frame with a row per measure: `measure`, `value`, `unit`, `uncertainty`
#'     (combined standard uncertainty), `low` and `high` (the interval), the standard uncertainties
#'     from `coefficients`, `plan`, `conditions`, `lattice` and `model`, the effective degrees of
#'     `freedom`, and `smooth`;
#'   - `sources`: a data frame with a row per measure and source, the largest first: `measure`,
#'     `source`, `group`, `share` (standard uncertainty of the source, as a share of its value, or
#'     of 1 where that is 0), `contribution`
#'     (to the measure, in its unit, with its sign) and `percent` of the measure's variance;
#'   - `narrow`: a data frame with a row per measure: the single measurement (`by`) that would
#'     narrow it most and the standard uncertainty `left` with it, and the next two;
#'   - `level`, `method`, `gear_name`, `conditions`, and `cost` (factorisations and gears settled).
#'
#'   Wrong arguments are an error of class `codend_error_argument`.
#' @references JCGM 100:2008, Evaluation of measurement data: guide to the expression of uncertainty
#' in
#'   measurement.
#' @seealso [codend_charts]; [optimise_gear()] for limits that hold with a given
#' probability.
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
    # in the conditions of its plan
    state <- settled_state(fit$gear, fit$task$points$nodes, fit$task$points$netting, NULL)
  }
  check_is_settled(state)
  method <- chosen(method, c("linear", "samples"))
  check_level(level)
  check_count("samples", samples, 20)
  base <- measures(state)
  of <- chosen_some(of, names(base))
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
        factorisations = spread$factorisations, settles = if (is.null(draws)) 0 else samples
      )
    )),
    class = "codend_uncertainty"
  )
}

# Of the largest sources, and of those whose slopes to both sides differ by more than this, the gear
# is settled one standard uncertainty to both sides, or this share.
followed_sources <- 3L
most_turn <- 0.2
most_followed <- 0.5
# Contributions by slopes that are off by more than this count as they are followed, and sides that
# differ by more than this are not smooth.
most_off_slope <- 0.2
most_uneven <- 0.5
# Of a measure, what differences of its contributions are told as a share of, at least.
least_contribution <- 0.01

# A measure's change for one standard uncertainty of every source: list(spread and off (what a known
# bias of the source makes), rough: measures x sources; correlation of the sources; factorisations).
source_contributions <- function(state, sources, fit = NULL, follow = followed_sources) {
  work <- tangent_work(state)
  n <- length(sources)
  spread <- off <- matrix(0, length(work$values), n, dimnames = list(names(work$values), NULL))
  rough <- matrix(FALSE, length(work$values), n, dimnames = dimnames(spread))
  fields <- lapply(sources, source_field, plan = state$gear$plan)
  followed <- logical(n)
  for (k in seq_len(n)) {
    share <- sources[[k]]$share
    found <- quick_slopes(work, fields[[k]], share)
    if (is.null(found)) found <- followed_slopes(work, fields[[k]], share)
    followed[k] <- !is.null(found$smooth)
    spread[, k] <- known_slope(found) * share
    off[, k] <- known_slope(found) * sources[[k]]$off
    if (followed[k]) rough[, k] <- !found$smooth
  }
  size <- colMeans(abs(spread) / pmax(abs(work$values), 1e-300), na.rm = TRUE)
  for (k in utils::head(order(-size), follow)) {
    if (followed[k] || !is.finite(size[k]) || size[k] == 0) next
    found <- followed_slopes(work, fields[[k]], sources[[k]]$share)
    half <- known_slope(found) * sources[[k]]$share
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

known_slope <- function(found) ifelse(is.finite(found$slope), found$slope, 0)

contribution_scale <- function(work, spread) {
  pmax(abs(spread), least_contribution * abs(work$values), .Machine$double.xmin)
}

# A source's slopes by its share, list(slope); NULL where there is no tangent, or where the slopes
# to both sides differ.
quick_slopes <- function(work, field, share) {
  found <- tangent_slopes(work, field, c(quick_tangent, reach = share))
  if (is.null(found)) return(NULL)
  scale <- contribution_scale(work, found$slope * share)
  if (all(found$turn * share <= most_turn * scale, na.rm = TRUE)) found["slope"]
}

# The same by gears settled so far to both sides as the source is uncertain, or a quarter of that
# where one of them does not settle: list(slope, smooth).
followed_slopes <- function(work, field, share) {
  step <- min(share, most_followed)
  sides <- secant_slopes(work, field, step, both = TRUE)
  if (anyNA(sides$below) || anyNA(sides$above)) {
    step <- step / 4
    sides <- secant_slopes(work, field, step)
  }
  found <- slopes_of_secants(work, sides, 0)
  uneven <- abs(sides$above - sides$below) * step
  # of one side alone nothing is known against it
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
  # what a calibration found
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

uncertainty_groups <- c("coefficients", "plan", "conditions", "lattice", "model")

# From contributions to the tables; draws: measures of samples of all sources, or NULL.
budget_of <- function(found, level, draws = NULL) {
  base <- found$base
  value <- plain_measures(base)
  group <- vapply(found$sources, `[[`, "", "group")
  covariance_of <- function(rows) {
    s <- found$spread[, rows, drop = FALSE]
    # what known biases make together
    off <- rowSums(found$off[, rows, drop = FALSE])
    s %*% found$correlation[rows, rows, drop = FALSE] %*% t(s) + tcrossprod(off)
  }
  by_group <- vapply(uncertainty_groups[1:3], function(one) {
    sqrt(pmax(0, diag(covariance_of(which(group == one)))))
  }, numeric(length(value)))
  by_group <- matrix(by_group, length(value),
    dimnames = list(names(value), uncertainty_groups[1:3]))
  lattice <- plain(attr(base, "error"))
  lattice[is.na(lattice)] <- 0
  residual <- measure_residuals(base)
  model <- residual$sd * abs(value)
  covariance <- covariance_of(seq_along(group))
  own <- lattice^2 + model^2
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
  # what cannot be less than nothing
  bounded <- value > 0 & uncertainty_kind(base) != "angle"
  low[bounded] <- pmax(low[bounded], 0)
  rough <- rowSums((found$spread * found$rough)^2) > 0.05 * combined^2
  table <- data.frame(
    measure = names(value), value = unname(value), unit = unname(attr(base, "unit")),
    uncertainty = combined, low = low, high = high, by_group, lattice = lattice, model = model,
    freedom = freedom, smooth = !rough, row.names = NULL
  )
  list(
    measures = table, sources = source_table(found, value, combined),
    narrow = narrowing(found, base, covariance, own)
  )
}

source_table <- function(found, value, combined) {
  names <- vapply(found$sources, `[[`, "", "name")
  rows <- lapply(seq_along(value), function(m) {
    one <- found$spread[m, ]
    whole <- sqrt(one^2 + found$off[m, ]^2)
    order <- order(-whole)
    order <- order[whole[order] > 0]
    data.frame(
      measure = rep(names(value)[m], length(order)), source = names[order],
      group = vapply(found$sources[order], `[[`, "", "group"),
      share = vapply(found$sources[order], `[[`, 0, "share"),
      contribution = sign(one[order]) * whole[order],
      percent = 100 * whole[order]^2 / combined[m]^2
    )
  })
  table_rows(do.call(rbind, rows))
}

# The kind of a measure as residuals and sensors have it.
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
  out[kind %in% c("volume", "volume_share", "enclosed_volume")] <- "volume"
  out
}

# What no parameter covers: of every measure the standard deviation, as a share, that validation
# leaves in its kind, and its degrees of freedom.
measure_residuals <- function(base) {
  table <- package_table("uncertainty_residuals.csv")
  kind <- uncertainty_kind(base)
  if (is.null(table)) return(list(sd = 0 * seq_along(kind), freedom = rep(Inf, length(kind))))
  at <- match(kind, table$kind)
  list(sd = ifelse(is.na(at), 0, table$sd[at]), freedom = ifelse(is.na(at), Inf, table$freedom[at]))
}

# Standard uncertainties of sensors of measures, in their units; NA where nobody measures such.
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

# Of every measure the three measurements that would narrow it most: of another measure, which says
# something of the sources that both have, or of a number of the plan.
narrowing <- function(found, base, covariance, own) {
  value <- plain_measures(base)
  sensor <- sensor_uncertainty(base)
  total <- diag(covariance) + own
  names <- vapply(found$sources, `[[`, "", "name")
  group <- vapply(found$sources, `[[`, "", "group")
  rows <- lapply(seq_along(value), function(m) {
    by_measure <- covariance[m, ]^2 / (diag(covariance) + own + sensor^2)
    # measured itself, it is known as well as the sensor
    by_measure[m] <- if (is.na(sensor[m])) NA else max(0, total[m] - sensor[m]^2)
    by_field <- ifelse(group == "coefficients", NA, found$spread[m, ]^2)
    fall <- c(by_measure, by_field)
    what <- c(names(value), names)
    order <- utils::head(order(-fall, na.last = NA), 3L)
    data.frame(measure = rep(names(value)[m], length(order)), by = what[order],
      left = sqrt(pmax(0, total[m] - fall[order])))
  })
  table_rows(do.call(rbind, rows))
}

# ---- samples -------------------------------------------------------------------------------------

# Measures of gears with all sources drawn: a matrix with a row per draw that settled.
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
    # what is 0 is never less
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
  found <- vary(state$gear, designs, nodes = state$lattice$counts$asked$nodes)
  as.matrix(as.data.frame(found)[found$settled, of, drop = FALSE])
}

# Ends of intervals of draws with an independent normal part of standard deviation `own`: quantiles
# of all draws, each spread over evenly placed points of that part.
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

# Words of formulas with the relative standard uncertainty and degrees of freedom of each measure,
# as they are in a state.
words_with_bounds <- function(words, state) {
  found <- uncertainty(state, unique(words$column))$measures
  at <- match(words$column, found$measure)
  size <- abs(found$value[at])
  words$share <- ifelse(size > 0, found$uncertainty[at] / size, 0)
  words$freedom <- found$freedom[at]
  words
}
