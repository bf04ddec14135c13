# Fits the model error of uncertainty() to the measurements of all settled trawls of the book.
# Checks the intervals of uncertainty() on nets that were left out.
#
#   Rscript validation/condition.R          computes everything (about three minutes of CPU time)
#   Rscript validation/condition.R --fit    uses the derivatives of the last run (temporary file)
#
# Writes inst/extdata/uncertainty_residuals.csv and uncertainty_multipliers.csv,
# validation/conditioning.csv, conditioning.md and figures/conditioning.png.
#
# Relative sensitivities are computed at the middle of each series of hauls or tests and apply to
# the whole series.
#
# Model of every value y = ln(measured / computed), with sensitivities s to one standard uncertainty
# of each source: y = s_t t + s_b b + s_p p + s_c c + l + n + g + q + e.
#
# Effects with known standard uncertainties, from the tables of uncertainty():
#
#   t  multipliers of force models, the same in all gears
#   b  multipliers specific to a gear or a ground, separate for each rig, because boards of another
#      make have other coefficients
#   p  differences of the net of a rig from its plan
#   c  unknown conditions of a rig
#   l  mesh error of this value, and its scatter in measurements
#
# Model errors, of unknown size, the same in all values of:
#
#   n  a kind of a net
#   g  a kind of a rig (a net on one ship or in one tank)
#   q  a quantity of a rig
#   e  this value only
#
# The size of e comes from the variation of values about the mean of their quantity in a rig. The
# sizes of n, g and q come from these means. The standard deviation of n + g + q depends on the
# kind, and the fractions of n, g and q in its variance are the same for all kinds.
#
# The multipliers t are the same in all gears, so the measurements limit their combined effect. They
# keep their published values, because a fit to some nets does not improve the prediction of others.
# Their covariance about these values is that of the posterior distribution plus the product of its
# means.

suppressPackageStartupMessages(library(codend))
room <- new.env(parent = asNamespace("codend"))
for (file in c("validation/manifest.R", "validation/cases/flume.R", "validation/cases/hauls.R",
  "validation/cases/particulars.R")) {
  sys.source(file, room)
}
attach(room, name = "cases of the book")

slopes_file <- file.path(dirname(tempdir()), "codend-conditioning.rds")

# ---- measurements --------------------------------------------------------------------------------

# A value: measured, the compared measure and its factor, TRUE if it was used to tune an input, and
# its scatter (relative standard deviation of repeated measurements).
value_of <- function(name, measure, measured, factor = 1, tuned = FALSE, scatter = 0) {
  data.frame(quantity = name, measure = measure, measured = measured, factor = factor,
    tuned = tuned, scatter = scatter)
}

# Scatter of tests of one rig about a power law of speed (16 series, 46 degrees of freedom). Wing
# heights and angles: between trials 52 and 55, which are identical. Hauls: one ship and year with
# equal warp at a depth (20 groups, 1,140 hauls).
flume_scatter <- c(spread = 0.004, opening = 0.043, tension = 0.016, wing_height = 0.14,
  angle = 0.004)
haul_scatter <- c(door_spread = 0.081, wing_spread = 0.058, opening = 0.125)

# States along conditions with their values. at: as in settled_along(); values: function of a row.
states_along <- function(net, group, gear, at, values, series = paste(group, names(at)[1])) {
  state <- NULL
  lapply(seq_along(at[[1]]), function(k) {
    state <<- settle(do.call(update, c(list(gear), lapply(at, `[[`, k))), nodes = 1500,
      from = state)
    list(net = net, group = group, series = series, state = state, values = values(k), fixed = NULL)
  })
}

poly_hauls <- function() {
  hauls <- survey_hauls("PNE")
  hauls <- hauls[hauls$wire_m < 1000, ]
  tuned <- round(hauls$wire_m) %in% c(183, 689)
  wide <- tuned | round(hauls$wire_m) == 340
  states_along("Poly Nor'Eastern", "hauls, Gulf of Alaska", read_gear("poly_noreastern_trawl"),
    list(warps.length = hauls$wire_m, seabed.depth = hauls$depth_m,
      towing.speed = paste(hauls$speed_knot, "knot")),
    function(k) rbind(
      value_of("wing_spread", "upper_wing_spread_m", hauls$width_m[k], tuned = wide[k],
        scatter = hauls$width_sd_m[k] / hauls$width_m[k] / sqrt(hauls$hauls[k])),
      value_of("opening", "headline_height_m", hauls$height_m[k], tuned = tuned[k],
        scatter = hauls$height_sd_m[k] / hauls$height_m[k] / sqrt(hauls$hauls[k]))
    ))
}

# Hauls of the 83-112 Eastern trawl; its boards' lift and its cut are tuned at 229 m of wire.
eastern_hauls <- function() {
  hauls <- survey_hauls("83-112")
  tuned <- round(hauls$wire_m) == 229
  states_along("83-112 Eastern", "hauls, Bering Sea",
    read_gear(system.file("extdata", "eastern_trawl.yaml", package = "codend")),
    list(warps.length = hauls$wire_m, seabed.depth = hauls$depth_m,
      towing.speed = paste(hauls$speed_knot, "knot")),
    function(k) rbind(
      value_of("wing_spread", "upper_wing_spread_m", hauls$width_m[k], tuned = tuned[k],
        scatter = hauls$width_sd_m[k] / hauls$width_m[k] / sqrt(hauls$hauls[k])),
      value_of("opening", "headline_height_m", hauls$height_m[k], tuned = tuned[k],
        scatter = hauls$height_sd_m[k] / hauls$height_m[k] / sqrt(hauls$hauls[k]))
    ))
}

gov_values <- function(ship, sweep) {
  hauls <- hauls_by_warp(ship, sweep)
  wings <- is.finite(hauls$WingSpread)
  states_along("GOV", paste("hauls,", ship), gov_of(hauls, sweep),
    list(ropes.warp_port.length = hauls$Warplngt, ropes.warp_starboard.length = hauls$Warplngt,
      seabed.depth = hauls$Depth, towing.speed = paste(hauls$speed, "knot")),
    function(k) {
      of <- function(name, measure, measured) {
        value_of(name, measure, measured, scatter = haul_scatter[[name]] / sqrt(hauls$hauls[k]))
      }
      rbind(
        of("door_spread", "door_spread_m", hauls$DoorSpread[k]),
        if (wings[k]) of("wing_spread", "upper_wing_spread_m", hauls$WingSpread[k]),
        of("opening", "headline_height_m", hauls$Netopening[k])
      )
    }, paste(ship, sweep))
}

midwater_values <- function() {
  gear <- read_gear("small_midwater_trawl")
  speeds <- c(1.1, 1.45, 1.8)
  warps <- c(100, 150, 200)
  printed <- 2.15 * speeds^1.12
  spread <- c(44, 54, 56.5)
  c(
    states_along("small midwater", "trials, small midwater trawl", gear,
      list(towing.speed = speeds), function(k) {
        value_of("drag", "total_drag_kN", printed[k] * 9.80665, tuned = speeds[k] == 1.45)
      }),
    states_along("small midwater", "trials, small midwater trawl", gear, list(warps.length = warps),
      function(k) value_of("door_spread", "door_spread_m", spread[k], tuned = warps[k] == 150))
  )
}

# In the flume the wing spread is set; derivatives of other measures are at constant spread.
flume_values <- function(net, name) {
  tests <- flume_tests(net)
  # Trials 1 to 10 of the Eastern were repeated with tensions, trial 52 of the other net as 55.
  tests <- tests[!tests$trial %in% if (net == "eastern") 1:10 else 52, ]
  tuned <- net == "poly_noreastern" & tuned_tests(tests)
  series <- split(seq_len(nrow(tests)), paste(tests$rigging, tests$spread_treatment_m))
  unlist(lapply(series, function(set) {
    rigging <- tests$rigging[set[1]]
    usual <- paste(usual_pull(rigging, net) * 8 / 1000, "m")
    rig <- survey_rig(rigging, usual, net)
    spread <- set_spread(rig, tests$spread_treatment_m[set[1]])
    wide <- update(rig, towing_points.spread = spread)
    at <- list(towing_points.height = paste(tests$pulling_point_mm[set] * 8 / 1000, "m"),
      towing.speed = paste(tests$speed_knot[set], "knot"))
    states <- states_along(name, paste("flume of 2025,", name), wide, at, function(k) {
      row <- tests[set[k], ]
      of <- function(quantity, measure, measured, scatter, factor = 1) {
        if (is.null(measured)) return(NULL)
        value_of(quantity, measure, measured, factor, tuned[set[k]], flume_scatter[[scatter]])
      }
      rbind(
        of("bridle_tension", "total_drag_kN", row$bridle_tension_t, "tension", NA),
        of("opening", "net_mouth_height_m", row$headline_height_m, "opening"),
        of("middle_wing_spread", "middle_wing_spread_m", row$middle_wing_spread_m, "spread"),
        of("lower_wing_spread", "lower_wing_spread_m", row$lower_wing_spread_m, "spread"),
        of("wing_height", "wing_end_height_m", row$upper_wing_height_m, "wing_height"),
        of("bridle_angle", "bridle_angle_deg", row$bridle_angle_deg, "angle")
      )
    }, paste("flume", name, rigging, tests$spread_treatment_m[set[1]]))
    lapply(states, function(one) {
      one$fixed <- c("upper_wing_spread_m", "towing_points.spread")
      one
    })
  }), recursive = FALSE)
}

# The published drag of the lantern fish trawl.
lantern_fish_drag <- function() {
  states_along("lantern fish", "particulars, lantern fish", particular_net("myctophid"),
    list(towing.speed = c("2 knot", "3 knot")), function(k) {
      value_of("drag", "total_drag_kN", c(4.9, 7.3)[k] * 9.80665)
    })
}

# ---- derivatives ---------------------------------------------------------------------------------

# Relative contributions of one standard uncertainty of each source to the measures of a state:
# list(by, sources).
share_slopes <- function(one) {
  state <- one$state
  sources <- codend:::uncertainty_sources(state$gear)
  if (!is.null(one$fixed)) {
    sources <- Filter(function(source) !any(grepl("towing_points", source$paths)), sources)
    sources <- c(sources, list(list(name = "spread set", group = "set",
      paths = one$fixed[2], share = 0.01, off = 0)))
  }
  by <- codend:::source_contributions(state, sources, follow = 0L)$spread
  if (!is.null(one$fixed)) {
    last <- ncol(by)
    set <- one$fixed[1]
    by <- by[, -last] - outer(by[, last] / by[set, last], by[set, -last])
    sources <- sources[-last]
  }
  m <- codend:::plain_measures(measures(state))
  list(by = by / ifelse(m == 0, 1, m), sources = sources)
}

# The values of a state, with the derivatives from the middle of its series.
row_slopes <- function(one, slopes) {
  state <- one$state
  sources <- slopes$sources
  m <- measures(state)
  values <- one$values[is.finite(one$values$measured) & one$values$measure %in% names(m), ]
  at <- match(values$measure, names(m))
  computed <- as.numeric(m)[at]
  # the flume's bridle tensions, tonnes, apply at the towing points
  tension <- is.na(values$factor)
  if (any(tension)) {
    pull <- summary(state)$reactions
    values$measured[tension] <- values$measured[tension] *
      computed[tension] / (sum(sqrt(pull$x_kN^2 + pull$y_kN^2 + pull$z_kN^2)) / 9.81)
  }
  multiplier <- vapply(sources, function(s) if (is.null(s$multiplier)) "" else s$multiplier, "")
  list(
    values = data.frame(net = one$net, group = one$group,
      values[c("quantity", "tuned", "scatter")],
      kind = codend:::uncertainty_kind(m)[at], measured = values$measured, computed = computed,
      y = log(values$measured / computed),
      mesh = attr(m, "error")[at] / abs(computed), row.names = NULL),
    slopes = slopes$by[at, , drop = FALSE],
    source = vapply(sources, `[[`, "", "name"), group = vapply(sources, `[[`, "", "group"),
    share = vapply(sources, `[[`, 0, "share"), multiplier = multiplier
  )
}

all_slopes <- function() {
  ships <- list(c("SCO3", 60), c("SCO2", 60), c("ARG", 60), c("ARG", 110), c("DAN2", 60),
    c("DAN2", 120), c("THA2", 50), c("TRI2", 50))
  states <- c(poly_hauls(), eastern_hauls(), midwater_values(), lantern_fish_drag(),
    flume_values("poly_noreastern", "Poly Nor'Eastern"), flume_values("eastern", "83-112 Eastern"))
  for (ship in ships) states <- c(states, gov_values(ship[1], as.numeric(ship[2])))
  series <- vapply(states, `[[`, "", "series")
  rows <- lapply(unique(series), function(one) {
    message(one)
    set <- states[series == one]
    slopes <- share_slopes(set[[(length(set) + 1L) %/% 2L]])
    found <- lapply(set, row_slopes, slopes)
    saveRDS(found, paste0(slopes_file, ".", match(one, unique(series))))
    found
  })
  unlist(rows, recursive = FALSE)
}

# ---- the fit -------------------------------------------------------------------------------------

kinds <- c("spread", "height", "force", "angle")

# Multipliers specific to a gear or a ground.
own_multipliers <- c("board_lift", "board_drag", "ground_friction", "ground_gear_weight")

# All rows together, with the covariance of each type of source.
stacked <- function(rows) {
  values <- do.call(rbind, lapply(rows, `[[`, "values"))
  multipliers <- setdiff(names(codend:::force_multipliers), own_multipliers)
  t <- do.call(rbind, lapply(rows, function(one) {
    one$slopes[, match(multipliers, one$multiplier), drop = FALSE]
  }))
  # separate for each ship or tank
  columns <- function(keep) {
    all <- unique(unlist(lapply(rows, function(one) {
      paste(one$values$group[1], one$source[keep(one)])
    })))
    do.call(rbind, lapply(rows, function(one) {
      out <- matrix(0, nrow(one$values), length(all))
      some <- which(keep(one))
      out[, match(paste(one$values$group[1], one$source[some]), all)] <- one$slopes[, some]
      out
    }))
  }
  list(
    values = values, t = structure(t, dimnames = list(NULL, multipliers)),
    b = columns(function(one) one$multiplier %in% own_multipliers),
    p = columns(function(one) one$group == "plan"),
    c = columns(function(one) one$group == "conditions")
  )
}

same <- function(x) outer(x, x, `==`) + 0

some_of <- function(data, keep) {
  c(list(values = data$values[keep, ]),
    lapply(data[c("t", "b", "p", "c")], function(part) part[keep, , drop = FALSE]))
}

known_variance <- function(data) Reduce(`+`, lapply(data[c("t", "b", "p", "c")], tcrossprod))

# Returns the mean of each quantity of a rig, in the form of `data`, with the sum of squares about
# the mean (without known scatter) and its degrees of freedom.
quantity_means <- function(data) {
  v <- data$values
  key <- paste(v$group, v$quantity)
  key <- factor(key, unique(key))
  n <- tabulate(key)
  average <- t(outer(as.integer(key), seq_along(n), `==`)) / n
  mean_y <- drop(average %*% v$y)
  values <- v[!duplicated(key), c("net", "group", "quantity", "kind")]
  values$y <- mean_y
  values$scatter <- sqrt(drop(average^2 %*% v$scatter^2))
  values$mesh <- drop(average %*% v$mesh)
  squares <- tapply((v$y - mean_y[key])^2, key, sum) - (n - 1) * tapply(v$scatter^2, key, mean)
  values$squares <- pmax(0, squares)
  values$freedom <- n - 1
  c(list(values = values), lapply(data[c("t", "b", "p", "c")], function(part) average %*% part))
}

# Returns the parts of a model error from parameters: list(size, by kind, and fraction of the
# variance of net, rig and quantity).
model_error <- function(of) {
  weight <- exp(c(of[length(kinds) + 1:2], 0))
  list(size = stats::setNames(of[seq_along(kinds)], kinds),
    fraction = stats::setNames(weight / sum(weight), c("net", "rig", "quantity")))
}

# Returns the covariance of the means of quantities with a model error.
covariance_of_means <- function(means, error) {
  v <- means$values
  size <- error$size[v$kind]
  part <- error$fraction
  same_error <- part[["net"]] * same(paste(v$net, v$kind)) +
    part[["rig"]] * same(paste(v$group, v$kind)) + diag(part[["quantity"]], nrow(v))
  known_variance(means) + diag(v$mesh^2 + v$scatter^2) + same_error * outer(size, size)
}

# Priors of a model error: half-normal with this standard deviation for its size (few published
# comparisons of trawls differ by more than 40 %), standard normal for the logarithms of the ratios
# of variances.
size_prior <- 0.2

# The prior of a size counts as this number of nets, rigs or quantities.
least_freedom <- 4

# Returns list(residuals, multipliers).
#   residuals: the model error of a new net by kind, from the posterior mode of n, g and q, and e.
#     The degrees of freedom combine those of the variances (Welch-Satterthwaite).
#   multipliers: covariance of the multipliers t about their published values, in published standard
#     uncertainties
fit_model_error <- function(data) {
  means <- quantity_means(data)
  v <- means$values
  minus_log_posterior <- function(of) {
    error <- model_error(of)
    root <- chol(covariance_of_means(means, error))
    sum(log(diag(root))) + sum(backsolve(root, v$y, transpose = TRUE)^2) / 2 +
      sum(error$size^2) / 2 / size_prior^2 + sum(of[length(kinds) + 1:2]^2) / 2
  }
  start <- rep(c(0.1, 0), c(length(kinds), 2))
  least <- rep(c(0, -Inf), c(length(kinds), 2))
  error <- model_error(stats::nlminb(start, minus_log_posterior, lower = least)$par)
  by_kind <- function(of) unname(vapply(kinds, function(kind) of(v[v$kind == kind, ]), 0))
  count <- function(name) by_kind(function(rows) length(unique(rows[[name]])))
  freedom <- by_kind(function(rows) max(1, sum(rows$freedom)))
  value <- sqrt(by_kind(function(rows) sum(rows$squares)) / freedom)
  parts <- outer(unname(error$size), sqrt(error$fraction))
  counts <- cbind(count("net"), count("group"), by_kind(nrow))
  variance <- cbind(parts, value)^2
  residuals <- data.frame(
    kind = kinds, sd = sqrt(rowSums(variance)), parts, value = value,
    freedom = rowSums(variance)^2 /
      rowSums(variance^2 / cbind(pmax(counts - 1, least_freedom), freedom)),
    nets = counts[, 1], rigs = counts[, 2], values = freedom + counts[, 3]
  )
  gain <- t(solve(covariance_of_means(means, error), means$t))
  list(residuals = residuals,
    multipliers = diag(ncol(means$t)) - gain %*% means$t + tcrossprod(gain %*% v$y))
}

# Relative standard uncertainties of values, and the half width of the interval, as in budget_of().
interval_of <- function(data, fit, level = 0.9) {
  residuals <- fit$residuals
  data$t <- data$t %*% t(chol(fit$multipliers))
  at <- match(data$values$kind, residuals$kind)
  model <- residuals$sd[at]
  u <- sqrt(diag(known_variance(data)) + data$values$mesh^2 + model^2)
  list(u = u, reach = stats::qt((1 + level) / 2, residuals$freedom[at] * (u / model)^4))
}

# Cross-validation: leaves out every net once, with all its ships and tanks. `covered`: TRUE for
# values within the interval, including their scatter. `drawn`: TRUE if no such quantity was used to
# tune an input of the net.
left_out <- function(data) {
  untuned <- !data$values$tuned
  of_net <- paste(data$values$net, data$values$quantity)
  do.call(rbind, lapply(unique(data$values$net), function(net) {
    fit <- fit_model_error(some_of(data, which(data$values$net != net & untuned)))
    one <- some_of(data, which(data$values$net == net & untuned))
    found <- interval_of(one, fit)
    v <- one$values
    reach <- found$reach * sqrt(found$u^2 + v$scatter^2)
    data.frame(v[c("net", "group", "quantity", "kind", "measured", "computed")],
      drawn = !paste(v$net, v$quantity) %in% of_net[!untuned],
      low = v$computed * (1 - found$reach * found$u),
      high = v$computed * (1 + found$reach * found$u),
      width = 2 * found$reach * found$u, covered = abs(v$measured / v$computed - 1) <= reach)
  }))
}

# ---- files ---------------------------------------------------------------------------------------

write_table <- function(table, file, head) {
  lines <- utils::capture.output(utils::write.csv(table, row.names = FALSE, quote = FALSE))
  writeLines(c(paste("#", head), lines), file)
}

md_table <- function(columns) {
  head <- names(columns)
  cells <- do.call(cbind, lapply(columns, as.character))
  c(paste0("| ", paste(head, collapse = " | "), " |"),
    paste0("|", strrep("---|", length(head))),
    apply(cells, 1, function(row) paste0("| ", paste(row, collapse = " | "), " |")))
}

percent <- function(x, digits = 0) formatC(100 * x, format = "f", digits = digits)

# The target of coverage is checked for kinds with values of at least this number of nets.
least_nets <- 3L

# Returns the coverage of intervals by a column of `out`. `oracle`: width of the narrowest interval
# of constant relative width that contains 90 % of the measured values.
coverage_by <- function(out, by) {
  groups <- split(out, factor(out[[by]], unique(out[[by]])))
  each <- function(of, as = 0) unname(vapply(groups, of, as))
  data.frame(
    of = names(groups), values = each(nrow, 0L),
    nets = each(function(g) length(unique(g$net)), 0L),
    covered = each(function(g) mean(g$covered)),
    drawn = each(function(g) sum(g$drawn), 0L),
    covered_drawn = each(function(g) mean(g$covered[g$drawn])),
    error = each(function(g) mean(abs(g$measured / g$computed - 1))),
    width = each(function(g) stats::median(g$width)),
    oracle = each(function(g) {
      2 * stats::quantile(abs(g$measured / g$computed - 1), 0.9, names = FALSE)
    })
  )
}

coverage_table <- function(by, first) {
  known <- function(x) ifelse(is.finite(x), percent(x), "")
  columns <- list(by$of, by$values, by$nets, percent(by$covered), by$drawn,
    known(by$covered_drawn), percent(by$error, 1), percent(by$width), percent(by$oracle),
    formatC(by$width / by$oracle, format = "f", digits = 1))
  names(columns) <- c(first, "values", "nets", "inside, %", "values of nets as drawn",
    "inside, %", "mean error, %", "median width, %", "oracle width, %", "ratio")
  if (first == "net") columns <- columns[-3L]
  md_table(columns)
}

write_conditioning <- function(fit, names, out) {
  residuals <- fit$residuals
  by_kind <- coverage_by(out, "kind")
  few <- by_kind$of[by_kind$nets < least_nets]
  writeLines(c(
    "# Model error from measurements", "",
    paste("`make condition` writes this page. It fits the model error of `uncertainty()` to all",
      "trawls of the validation book with measured values. [condition.R](condition.R) documents",
      "the model."),
    "",
    "These data are not used:", "",
    "- the purse seine, because its speeds of shooting and pursing are not published;",
    "- smooth spheres, because knots are not smooth spheres;",
    "- simulations by other programs;",
    "- the four-seam trawl, because its height is a design value and not a measurement;",
    "- the midwater trawl of the paper, because its plan is fitted to the published values.", "",
    paste("The data contain no depth or volume of a settled gear. Intervals of depths and volumes",
      "therefore contain no model error."), "",
    "![Intervals of omitted nets and measured values](figures/conditioning.png)", "",
    "## Model error", "",
    paste("The model error covers the effects without a parameter. One part is the same in all",
      "values of a net. Other parts belong to a rig (a net on one ship or in one tank), to a",
      "quantity of a rig, and to the single value."), "",
    md_table(list(kind = residuals$kind, `sd, %` = percent(residuals$sd, 1),
      `of the net, %` = percent(residuals$net, 1), `of the rig, %` = percent(residuals$rig, 1),
      `of the quantity, %` = percent(residuals$quantity, 1),
      `of the value, %` = percent(residuals$value, 1),
      `degrees of freedom` = formatC(residuals$freedom, format = "f", digits = 1),
      nets = residuals$nets, rigs = residuals$rigs, values = residuals$values)), "",
    "## Multipliers of force", "",
    paste("The multipliers are the same in all gears, so the measurements of all nets limit their",
      "combined effect. They keep their published values. The table lists their posterior standard",
      "deviations about these values, as fractions of the published ones. `uncertainty()` also",
      "uses their correlations ([table](../inst/extdata/uncertainty_multipliers.csv))."), "",
    md_table(list(multiplier = codend:::force_multipliers[names],
      `posterior over published sd` = formatC(sqrt(diag(fit$multipliers)), format = "f",
        digits = 2))), "",
    "## Leave-one-net-out validation", "",
    paste("Each net is omitted with all its ships and tanks, and the model error is fitted to the",
      "other nets. The tables compare the measured values with the 90 % intervals. Both",
      "include the scatter of repeated hauls or tests. Values that were used to choose an input",
      "do not count. A net is as drawn if no value of this quantity was used to choose an input",
      "of the net."), "",
    paste("The oracle width is the width of the narrowest interval of constant relative width that",
      "contains 90 % of the measured values. It needs the measurements. The ratio divides the",
      "median width by the oracle width."), "",
    coverage_table(by_kind, "kind"), "", coverage_table(coverage_by(out, "net"), "net"), "",
    sprintf("In total, %s %% of %d values are inside their intervals. The target is 85 to 95 %%.",
      percent(mean(out$covered)), nrow(out)),
    if (length(few)) {
      c("", sprintf("The target is not checked for kinds with fewer than %d nets: %s.", least_nets,
        toString(few)))
    }
  ), "validation/conditioning.md")
  write_table(data.frame(lapply(out, function(x) if (is.numeric(x)) signif(x, 5) else
    gsub(",", "", x))), "validation/conditioning.csv",
    "90 % intervals of omitted nets, and measured values (condition.R)")
}

draw_conditioning <- function(out) {
  grDevices::png("validation/figures/conditioning.png", 1000, 900, res = 110)
  on.exit(grDevices::dev.off())
  graphics::par(las = 1, cex = 0.8, mar = c(4, 15, 2.5, 1))
  out <- out[order(match(out$kind, kinds), out$net, out$group), ]
  n <- nrow(out)
  at <- n:1
  graphics::plot(NA, xlim = c(0.2, 2), ylim = c(0, n + 1), yaxt = "n", ylab = "",
    xlab = "measured / computed; bars: interval", main = "Measured values of omitted nets")
  graphics::segments(out$low / out$computed, at, out$high / out$computed, at, col = "grey80",
    lwd = 2)
  graphics::points(out$measured / out$computed, at, pch = 19, cex = 0.45,
    col = ifelse(out$covered, "#2a6f97", "#c1121f"))
  graphics::abline(v = 1, col = "grey60")
  first <- !duplicated(paste(out$kind, out$group))
  graphics::abline(h = at[first] + 0.5, col = "grey90")
  graphics::axis(2, at[first], paste(out$kind, sub("hauls, ", "", out$group), sep = ", ")[first],
    tick = FALSE, cex.axis = 0.6)
}

condition <- function(rows) {
  data <- stacked(rows)
  fit <- fit_model_error(some_of(data, which(!data$values$tuned)))
  residuals <- fit$residuals
  out <- left_out(data)
  multipliers <- structure(fit$multipliers, dimnames = rep(list(colnames(data$t)), 2))
  numbers <- function(x) data.frame(lapply(x, function(y) if (is.numeric(y)) signif(y, 4) else y))
  write_table(numbers(residuals), "inst/extdata/uncertainty_residuals.csv", paste(
    "Standard deviations of the model error of a new net, as fractions, by kind of measure",
    "(validation/condition.R)"))
  write_table(numbers(data.frame(multiplier = colnames(data$t), multipliers)),
    "inst/extdata/uncertainty_multipliers.csv", paste(
      "Covariance of multipliers of force about their published values, in published standard",
      "uncertainties (validation/condition.R)"))
  write_conditioning(fit, colnames(data$t), out)
  draw_conditioning(out)
  print(numbers(residuals))
  print(coverage_by(out, "kind"))
  print(coverage_by(out, "net"))
}

if (!interactive() && sys.nframe() == 0L) {
  if (!"--fit" %in% commandArgs(TRUE)) saveRDS(all_slopes(), slopes_file)
  condition(readRDS(slopes_file))
}
