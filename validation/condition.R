# Fits the multipliers of force components to measurements: all settled gears of the book and the
# 83-112 trawl's hauls together. Checks the intervals of uncertainty() on gears that were left out.
#
#   Rscript validation/condition.R          computes everything (about ten minutes of CPU time)
#   Rscript validation/condition.R --fit    uses the derivatives of the last run (temporary file)
#
# Writes inst/extdata/uncertainty_multipliers.csv, inst/extdata/uncertainty_residuals.csv,
# validation/conditioning.csv, conditioning.md and figures/conditioning.png.
#
# Relative sensitivities are computed at the middle of each series of hauls or tests and apply to
# the whole series.
#
# Model of every value y = ln(measured / computed), with sensitivities s to one standard uncertainty
# of each source: y = s_m t + s_p p + s_c c + l + g + e.
#
# The sources are:
#
#   t  multipliers of force models, the same in all gears
#   b  multipliers specific to a gear or a ground, separate for each ship or tank: boards of
#      another make have other coefficients
#   p  differences of the net of a ship or tank from its plan: nets of one plan differ
#   c  unknown conditions of a ship or tank
#   l  mesh error of this value, and its scatter in measurements
#   g  model error, the same in all values of a kind of a ship or tank
#   e  model error and variation between tests, of this value
#
# t, b, p and c are normal with the standard uncertainties of the tables. The sizes of g and e by
# kind maximise the probability of the values, with a wide prior.

suppressPackageStartupMessages(library(codend))
room <- new.env(parent = asNamespace("codend"))
for (file in c("validation/manifest.R", "validation/cases/flume.R", "validation/cases/hauls.R")) {
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
flume_values <- function() {
  tests <- flume_tests()
  tests <- tests[tests$trial != 52, ]
  series <- split(seq_len(nrow(tests)), paste(tests$rigging, tests$spread_treatment_m))
  unlist(lapply(series, function(set) {
    rigging <- tests$rigging[set[1]]
    usual <- paste(usual_pull(rigging) * 8 / 1000, "m")
    spread <- set_spread(survey_rig(rigging, usual), tests$spread_treatment_m[set[1]])
    state <- NULL
    lapply(set, function(k) {
      rig <- survey_rig(rigging, paste(tests$pulling_point_mm[k] * 8 / 1000, "m"))
      state <<- settle(update(rig, towing_points.spread = spread,
        towing.speed = paste(tests$speed_knot[k], "knot")), nodes = 1500, from = state)
      tuned <- rigging == "standard" & tests$pulling_point_mm[k] == 200 &
        (if (tests$spread_treatment_m[k] == 16) {
          tests$speed_knot[k] %in% c(2, 3, 4)
        } else {
          tests$speed_knot[k] == 3
        })
      row <- tests[k, ]
      of <- function(name, measure, measured, scatter, factor = 1) {
        value_of(name, measure, measured, factor, tuned, flume_scatter[[scatter]])
      }
      list(net = "Poly Nor'Eastern", group = "flume of 2025", state = state,
        series = paste("flume", rigging, tests$spread_treatment_m[k]),
        fixed = c("upper_wing_spread_m", "towing_points.spread"), values = rbind(
          of("bridle_tension", "total_drag_kN", row$bridle_tension_t, "tension", NA),
          of("opening", "net_mouth_height_m", row$headline_height_m, "opening"),
          of("middle_wing_spread", "middle_wing_spread_m", row$middle_wing_spread_m, "spread"),
          of("lower_wing_spread", "lower_wing_spread_m", row$lower_wing_spread_m, "spread"),
          of("wing_height", "wing_end_height_m", row$upper_wing_height_m, "wing_height"),
          of("bridle_angle", "bridle_angle_deg", row$bridle_angle_deg, "angle")
        ))
    })
  }), recursive = FALSE)
}

# ---- derivatives ---------------------------------------------------------------------------------

# Relative contributions of one standard uncertainty of each source to the measures of a state:
# list(by, sources).
share_slopes <- function(one) {
  state <- one$state
  sources <- codend:::uncertainty_sources(state$gear)
  # before conditioning on measurements
  table <- codend:::uncertainty_table()
  for (k in seq_along(sources)) {
    name <- sources[[k]]$multiplier
    if (!is.null(name)) {
      sources[[k]]$share <- codend:::table_share(table$uncertainty[table$field == name])
    }
    sources[[k]]$off <- 0
  }
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
  values <- one$values[is.finite(one$values$measured), ]
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
    multiplier = multiplier
  )
}

all_slopes <- function() {
  ships <- list(c("SCO3", 60), c("SCO2", 60), c("ARG", 60), c("ARG", 110), c("DAN2", 60),
    c("DAN2", 120), c("THA2", 50), c("TRI2", 50))
  states <- c(poly_hauls(), eastern_hauls(), midwater_values(), flume_values())
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

# Multipliers specific to a gear or a ground, and `screen_friction`, which is not a factor.
own_multipliers <- c("board_lift", "board_drag", "ground_friction", "ground_gear_weight",
  "screen_friction")

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

# Covariance of values, with residual standard deviations exp(of) of g and e by kind.
covariance_of <- function(data, of) {
  v <- data$values
  k <- match(v$kind, kinds)
  g <- exp(of)[seq_along(kinds)][k]
  e <- exp(of)[length(kinds) + seq_along(kinds)][k]
  alone <- v$mesh^2 + v$scatter^2 + e^2
  tcrossprod(data$t) + tcrossprod(data$b) + tcrossprod(data$p) + tcrossprod(data$c) + diag(alone) +
    same(paste(v$group, v$kind)) * outer(g, g)
}

# Half-normal prior of the standard deviations of g and e.
residual_prior <- 0.1

fit_conditioned <- function(data, begun = rep(log(0.05), 2 * length(kinds))) {
  y <- data$values$y
  unlikely <- function(of) {
    if (any(of < log(1e-3)) || any(of > log(1))) return(1e6 + sum(of^2))
    root <- tryCatch(chol(covariance_of(data, of)), error = function(e) NULL)
    if (is.null(root)) return(1e6)
    sum(log(diag(root))) + sum(backsolve(root, y, transpose = TRUE)^2) / 2 +
      sum(exp(2 * of)) / 2 / residual_prior^2
  }
  of <- stats::nlminb(begun, unlikely)$par
  inverse <- chol2inv(chol(covariance_of(data, of)))
  list(
    of = of, g = exp(of)[seq_along(kinds)], e = exp(of)[-seq_along(kinds)],
    mean = drop(crossprod(data$t, inverse %*% y)),
    covariance = diag(ncol(data$t)) - crossprod(data$t, inverse %*% data$t)
  )
}

some_of <- function(data, keep) {
  c(list(values = data$values[keep, ]),
    lapply(data[c("t", "b", "p", "c")], function(part) part[keep, , drop = FALSE]))
}

# The prior of residuals counts as this number of ships and tanks.
least_freedom <- 4

# Residuals of a fit by kind, with degrees of freedom by the number of ships and tanks.
residual_table <- function(data, fit) {
  v <- data$values
  groups <- vapply(kinds, function(kind) length(unique(v$group[v$kind == kind])), 0L)
  values <- vapply(kinds, function(kind) sum(v$kind == kind), 0L)
  data.frame(kind = kinds, sd = sqrt(fit$g^2 + fit$e^2), shared = fit$g, own = fit$e,
    freedom = pmax(least_freedom, groups - 1), values = values, groups = groups, row.names = NULL)
}

# Relative standard uncertainties of values, and the half width of the interval, as in budget_of().
interval_of <- function(data, fit, residuals, level = 0.9) {
  at <- match(data$values$kind, residuals$kind)
  model <- residuals$sd[at]
  u <- sqrt(rowSums((data$t %*% fit$covariance) * data$t) + drop(data$t %*% fit$mean)^2 +
    rowSums(data$b^2) + rowSums(data$p^2) + rowSums(data$c^2) + data$values$mesh^2 + model^2)
  list(u = u, reach = stats::qt((1 + level) / 2, residuals$freedom[at] * (u / model)^4))
}

# Cross-validation: leaves out every ship and tank once. TRUE for values within the interval,
# including their scatter. `drawn`: TRUE if no such quantity was used to tune an input of the net.
left_out <- function(data) {
  untuned <- !data$values$tuned
  of_net <- paste(data$values$net, data$values$quantity)
  do.call(rbind, lapply(unique(data$values$group), function(group) {
    out <- which(data$values$group == group & untuned)
    rest <- some_of(data, which(data$values$group != group & untuned))
    fit <- fit_conditioned(rest)
    residuals <- residual_table(rest, fit)
    # sources of this group alone have the uncertainty of the prior of residuals
    lost <- residuals$values == 0
    residuals$sd[lost] <- residual_prior
    one <- some_of(data, out)
    found <- interval_of(one, fit, residuals)
    v <- one$values
    baseline <- vapply(seq_len(nrow(v)), function(k) {
      others <- rest$values$measured[rest$values$quantity == v$quantity[k]]
      if (length(others) < 3L) NA_real_ else 2 * 1.645 * stats::sd(others) / mean(others)
    }, 0)
    reach <- found$reach * sqrt(found$u^2 + v$scatter^2)
    data.frame(v[c("net", "group", "quantity", "kind", "measured", "computed")],
      drawn = !paste(v$net, v$quantity) %in% of_net[!untuned],
      low = v$computed * (1 - found$reach * found$u),
      high = v$computed * (1 + found$reach * found$u),
      width = 2 * found$reach * found$u, baseline = baseline,
      covered = abs(v$measured / v$computed - 1) <= reach)
  }))
}

# ---- files ---------------------------------------------------------------------------------------

write_table <- function(table, file, head) {
  lines <- utils::capture.output(utils::write.csv(table, row.names = FALSE, quote = FALSE))
  writeLines(c(paste("#", head), lines), file)
}

multiplier_table <- function(data, fit) {
  table <- codend:::uncertainty_table()
  share <- vapply(colnames(data$t), function(name) {
    codend:::table_share(table$uncertainty[table$field == name])
  }, 0)
  sd <- share * sqrt(diag(fit$covariance))
  correlation <- stats::cov2cor(fit$covariance)
  colnames(correlation) <- colnames(data$t)
  data.frame(multiplier = colnames(data$t), prior = unname(share), mean = 1 + share * fit$mean,
    sd = sd, round(correlation, 4), row.names = NULL)
}

md_table <- function(columns) {
  head <- names(columns)
  cells <- do.call(cbind, lapply(columns, as.character))
  c(paste0("| ", paste(head, collapse = " | "), " |"),
    paste0("|", strrep("---|", length(head))),
    apply(cells, 1, function(row) paste0("| ", paste(row, collapse = " | "), " |")))
}

percent <- function(x, digits = 0) formatC(100 * x, format = "f", digits = digits)

# Minimum number of ships and tanks to judge a kind. With fewer, leaving one out leaves at most one,
# which does not show their differences.
least_judged <- 3L

coverage_by <- function(out, by) {
  groups <- split(out, factor(out[[by]], unique(out[[by]])))
  data.frame(
    of = names(groups), values = vapply(groups, nrow, 0L),
    groups = vapply(groups, function(g) length(unique(g$group)), 0L),
    covered = vapply(groups, function(g) mean(g$covered), 0),
    drawn = vapply(groups, function(g) sum(g$drawn), 0L),
    covered_drawn = vapply(groups, function(g) mean(g$covered[g$drawn]), 0),
    width = vapply(groups, function(g) stats::median(g$width), 0),
    baseline = vapply(groups, function(g) stats::median(g$baseline, na.rm = TRUE), 0)
  )
}

write_conditioning <- function(data, fit, residuals, table, out) {
  words <- codend:::force_multipliers[table$multiplier]
  far <- abs(table$mean - 1) > 2 * table$sd | abs(table$mean - 1) > table$prior
  by_kind <- coverage_by(out, "kind")
  by_group <- coverage_by(out, "group")
  shown <- function(by, first) {
    known <- function(x) ifelse(is.finite(x), percent(x), "")
    columns <- list(by$of, by$values, percent(by$covered), by$drawn, known(by$covered_drawn),
      percent(by$width), known(by$baseline))
    names(columns) <- c(first, "values", "held by 90 %, %", "of nets as drawn", "held, %",
      "median width, %",
      "width of 'mean of the others and their spread', %")
    if (first == "kind") {
      judged <- by$groups >= least_judged
      columns <- append(columns, list(`ships and tanks` = by$groups), 2L)
      columns$judged <- ifelse(judged, "yes", sprintf("no: needs %d ships and tanks", least_judged))
    }
    md_table(columns)
  }
  writeLines(c(
    "# Coefficients conditioned on the book", "",
    paste("Written by `make condition`. All settled gears of the validation book with values that",
      "were measured, and the hauls of the 83-112 Eastern trawl, together say how well the laws",
      "of force are known; `uncertainty()` begins from this. The script [condition.R](condition.R)",
      "has the model. Coefficients of boards, friction on the bed and the weight of ground gear",
      "belong to a gear and its ground: one gear says nothing of the next; they keep their prior."),
    "",
    paste("Not used: the purse seine, a motion whose speeds of shooting and pursing nobody printed",
      "(uncertainties are of settled gears); smooth spheres, which knots are not; figures of",
      "simulations by others; and the paper's trawl, which is fitted to its figures. No measured",
      "depth or volume of a settled gear was at hand: of these the model's part is not known and",
      "not in the interval."), "",
    "![Prior and posterior, and intervals of what was left out](figures/conditioning.png)", "",
    "## Multipliers: prior against posterior", "",
    md_table(list(`multiplies` = words, `prior sd, %` = percent(table$prior),
      `posterior mean` = formatC(table$mean, format = "f", digits = 2),
      `posterior sd, %` = percent(table$sd))), "",
    if (any(far)) {
      paste0("Far from 1 (by two posterior or one prior standard deviation): ",
        paste(words[far], collapse = "; "), ".")
    } else {
      "None is far from 1 (by two posterior standard deviations or one of the prior)."
    }, "",
    "## What no parameter covers", "",
    md_table(list(kind = residuals$kind, `sd, %` = percent(residuals$sd, 1),
      `the same in a ship or tank, %` = percent(residuals$shared, 1),
      `of a value, %` = percent(residuals$own, 1), values = residuals$values,
      `ships and tanks` = residuals$groups)), "",
    "## Checked by leaving out", "",
    paste("Each ship and tank is left out whole, the rest conditioned, and what was measured there",
      "is compared with the interval of 90 %, both with the scatter of repeated hauls or tests.",
      "Values that an input was chosen by do not count. Nets as drawn are those no input of which",
      "was chosen by any value of that quantity: the others' intervals are met too easily."),
    "",
    shown(by_kind, "kind"), "", shown(by_group, "ship or tank"), "",
    sprintf("All: %d values, %s %% held.", nrow(out), percent(mean(out$covered))), "",
    paste(sprintf("The target is 85 to 95 %% by kind, of at least %d ships and tanks:",
      least_judged), "where one of fewer is left out, too few are left to say how far ships and",
      "tanks differ, and",
      "what is held then says nothing of the interval.",
      if (any(by_kind$groups < least_judged)) {
        paste0("Not judged: ",
          paste(by_kind$of[by_kind$groups < least_judged], collapse = ", "), ".")
      })
  ), "validation/conditioning.md")
  write_table(data.frame(lapply(out, function(x) if (is.numeric(x)) signif(x, 5) else
    gsub(",", "", x))), "validation/conditioning.csv",
    "Ships and tanks left out whole: intervals of 90 % and what was measured (condition.R)")
}

draw_conditioning <- function(table, out) {
  grDevices::png("validation/figures/conditioning.png", 1500, 800, res = 110)
  on.exit(grDevices::dev.off())
  graphics::layout(t(1:2), widths = c(1, 1.25))
  graphics::par(mar = c(4, 18, 2.5, 1), las = 1, cex = 0.8)
  n <- nrow(table)
  at <- n:1
  graphics::plot(NA, xlim = c(0.2, 2.3), ylim = c(0.5, n + 0.5), yaxt = "n", ylab = "",
    xlab = "multiplier", main = "Prior (grey), posterior (blue), 90 %")
  graphics::axis(2, at, codend:::force_multipliers[table$multiplier], tick = FALSE)
  graphics::abline(v = 1, col = "grey70")
  ends <- function(mean, sd, up, ...) {
    graphics::segments(mean - 1.645 * sd, at + up, mean + 1.645 * sd, at + up, lwd = 5, lend = 1,
      ...)
  }
  ends(1, table$prior, 0.15, col = "grey75")
  ends(table$mean, table$sd, -0.15, col = "#2a6f97")
  graphics::points(table$mean, at - 0.15, pch = 19, col = "black", cex = 0.6)
  graphics::par(mar = c(4, 11, 2.5, 1))
  out <- out[order(match(out$kind, kinds), out$group), ]
  n <- nrow(out)
  at <- n:1
  graphics::plot(NA, xlim = c(0.3, 1.8), ylim = c(0, n + 1), yaxt = "n", ylab = "",
    xlab = "measured / computed; bars: interval", main = "Left out whole: what was measured")
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
  used <- some_of(data, which(!data$values$tuned))
  fit <- fit_conditioned(used)
  residuals <- residual_table(used, fit)
  table <- multiplier_table(used, fit)
  out <- left_out(data)
  numbers <- function(x) data.frame(lapply(x, function(y) if (is.numeric(y)) signif(y, 4) else y))
  write_table(numbers(table), "inst/extdata/uncertainty_multipliers.csv",
    paste("Multipliers of force, conditioned on the validation book by validation/condition.R",
      "(make condition)"))
  write_table(numbers(residuals), "inst/extdata/uncertainty_residuals.csv", paste(
    "Standard deviations, as shares, that no parameter covers, by kind of measure",
    "(validation/condition.R); freedom: of ships and tanks"))
  write_conditioning(used, fit, residuals, table, out)
  draw_conditioning(table, out)
  print(numbers(table[1:4]))
  print(numbers(residuals))
  print(coverage_by(out, "kind"))
  print(coverage_by(out, "group"))
  cat(sprintf("%d values, %.0f %% held\n", nrow(out), 100 * mean(out$covered)))
}

if (!interactive() && sys.nframe() == 0L) {
  if (!"--fit" %in% commandArgs(TRUE)) saveRDS(all_slopes(), slopes_file)
  condition(readRDS(slopes_file))
}
