# The tables of a report: columns of strings by heading. Headings of text columns begin with a
# space.

tonnes_force <- function(kilonewtons) kilonewtons / 9.80665

# The largest number of the column determines its decimals.
column_numbers <- function(x) trimws(column_figures(x))

# Returns numbers with four digits and separated thousands.
single_numbers <- function(x) {
  text <- figures(x)
  large <- !is.na(x) & abs(x) >= 1e4
  text[large] <- big_number(as.double(text[large]))
  text
}

big_number <- function(x) format(x, big.mark = ",", trim = TRUE, scientific = FALSE)

one_decimal <- function(x) ifelse(is.finite(x), formatC(x, format = "f", digits = 1), "")

# Groups parts of one role, in the order of the plan.
groups_in_order <- function(table) {
  groups <- by_role(table)
  groups[order(vapply(groups, function(g) match(g$part[1L], table$part), 0L))]
}

measures_columns <- function(measures) {
  said <- measure_labels(measures)
  measures <- plain_measures(measures)
  force <- ifelse(said$unit == "kN", figures(tonnes_force(measures)), "")
  columns <- list(` measure` = said$words, value = single_numbers(measures), ` unit` = said$unit,
    ` computed to` = said$error, tonnes = force)
  columns[c(TRUE, TRUE, TRUE, any(nzchar(said$error)), any(nzchar(force)))]
}

# Largest number of measures in the table of sensitivities.
reported_slopes <- 6L

# A row per field and a column per measure: the change for 10 % more of a field, or for ten more.
sensitivity_columns <- function(slopes) {
  fields <- unique(slopes$field)
  first <- slopes[match(fields, slopes$field), ]
  counted <- grepl("[.]number$", fields)
  more <- ifelse(counted, 10, 0.1 * first$value)
  names <- unique(slopes$measure)
  names <- unique(c(utils::head(names, reported_slopes - 1L), intersect("total_drag_kN", names)))
  unit <- attr(slopes, "measure_unit")[names]
  columns <- lapply(names, function(name) {
    rows <- slopes[slopes$measure == name, ]
    change <- figures(rows$derivative[match(fields, rows$field)] * more)
    smooth <- rows$smooth[match(fields, rows$field)]
    ifelse(smooth | !nzchar(change), change, paste0("(", change, ")"))
  })
  c(
    list(` field` = fields, ` more` = trimws(paste0("+", figures(more), " ", first$unit))),
    stats::setNames(columns, paste(label_of(names, unit), unit))
  )
}

uncertainty_columns <- function(uncertainty) {
  table <- uncertainty$measures
  table <- table[table$error > 0, ]
  ends <- lapply(table[c("lower", "upper")], interval_ends, table$error)
  interval <- paste(ends$lower, "to", ends$upper)
  c(
    list(` measure` = label_of(table$measure, table$unit), value = figures(table$value),
      ` unit` = table$unit),
    setNames(list(interval), sprintf("%g %% interval", 100 * uncertainty$level)),
    list("standard uncer\u00adtainty" = vapply(signif(table$error, 2), format, "",
      scientific = FALSE))
  )
}

# Returns the contribution of each group of sources to the variance of a measure [%].
budget_columns <- function(uncertainty) {
  table <- uncertainty$measures
  table <- table[table$error > 0, ]
  percent <- round(group_percent(table))
  columns <- lapply(names(group_words), function(group) {
    ifelse(percent[, group] > 0, percent[, group], "")
  })
  # soft hyphens: headings break on a narrow page
  heads <- c("coeffi\u00adcients", "plan", "condi\u00adtions", "discreti\u00adsation", "model")
  c(list(` measure` = label_of(table$measure, table$unit)), setNames(columns, heads))
}

trajectory_columns <- function(table) {
  at <- function(value, time) paste0(figures(value), " at ", vapply(time, time_text, "",
    last = max(table$greatest_at_s, table$least_at_s)))
  list(
    ` measure` = label_of(table$measure, table$unit), ` unit` = table$unit,
    start = figures(table$start), end = figures(table$end),
    least = at(table$least, table$least_at_s), greatest = at(table$greatest, table$greatest_at_s)
  )
}

# A row per role of ropes: the rope with the largest tension.
rope_columns <- function(ropes) {
  groups <- by_role(ropes)
  highest <- do.call(rbind, lapply(groups, function(g) g[which.max(g$max_kN), ]))
  order <- order(-highest$max_kN)
  highest <- highest[order, ]
  margin <- highest$strength_kN / highest$max_kN
  list(
    ` rope` = names(groups)[order], ` highest in` = gsub("_", " ", highest$part),
    `largest kN` = column_numbers(highest$max_kN),
    `largest tonnes` = column_numbers(tonnes_force(highest$max_kN)),
    `mean kN` = column_numbers(highest$mean_kN),
    `breaking load kN` = column_numbers(highest$strength_kN),
    `used %` = one_decimal(highest$strength_percent),
    `safety factor` = one_decimal(margin)
  )
}

netting_columns <- function(netting, slack) {
  groups <- groups_in_order(netting)
  slack <- slack[match(netting$part, slack$part), ]
  share <- vapply(groups, function(g) {
    mine <- match(g$part, netting$part)
    stats::weighted.mean(slack$slack_percent[mine], slack$twine_m[mine])
  }, 0)
  list(
    ` part` = names(groups),
    `mean N` = figures(vapply(groups, function(g) from_unit(mean(g$mean_kN), "kN"), 0)),
    `most loaded N` = single_numbers(
      vapply(groups, function(g) from_unit(max(g$most_loaded_kN), "kN"), 0)
    ),
    `slack %` = one_decimal(share)
  )
}

drag_columns <- function(totals, names) {
  list(
    ` group` = names, `drag kN` = column_numbers(totals$drag_kN),
    `share %` = share_text(totals$drag_kN, totals$drag_kN[nrow(totals)]),
    `side kN` = column_numbers(totals$side_kN), `lift kN` = column_numbers(totals$lift_kN),
    `weight in water kN` = column_numbers(totals$weight_in_water_kN)
  )
}

# Largest number of groups in the table of drag by part.
reported_parts <- 15L

drag_part_columns <- function(drag, totals) {
  groups <- by_role(drag)
  forces <- c("drag_kN", "side_kN", "lift_kN", "weight_in_water_kN")
  sums <- list2DF(lapply(setNames(nm = forces), function(force) {
    vapply(groups, function(group) sum(group[[force]]), 0)
  }))
  first <- utils::head(order(-sums$drag_kN), reported_parts)
  first <- first[sums$drag_kN[first] > 0]
  if (length(first) < 2L) return(list(character()))
  others <- colSums(sums[-first, , drop = FALSE])
  rows <- rbind(sums[first, ], if (any(others != 0)) as.list(others), totals[nrow(totals), forces])
  names <- c(gsub("_", " ", names(groups)[first]), if (any(others != 0)) "other parts", "total")
  columns <- drag_columns(rows, names)
  names(columns)[1L] <- " part"
  columns
}

board_columns <- function(boards) {
  list(
    ` board` = gsub("_", " ", boards$board), `attack deg` = column_numbers(boards$attack_deg),
    `largest lift at deg` = column_numbers(boards$stall_deg),
    `heel deg` = column_numbers(boards$heel_deg),
    `trim deg` = column_numbers(boards$trim_deg), `lift kN` = column_numbers(boards$lift_kN),
    `drag kN` = column_numbers(boards$drag_kN),
    `load on the sea bed kN` = column_numbers(boards$ground_load_kN),
    ` condition` = boards$condition
  )
}

axis_columns <- function(table, name) {
  list(
    ` ` = gsub("_", " ", table[[name]]), `x (aft) kN` = column_numbers(table$x_kN),
    `y (starboard) kN` = column_numbers(table$y_kN), `z (up) kN` = column_numbers(table$z_kN)
  )
}

# The remainder is much smaller than the forces, so it has scientific notation.
balance_columns <- function(balance) {
  columns <- axis_columns(balance, "force")
  names(columns)[1L] <- " force"
  last <- balance$force == "remainder"
  for (k in 1:3) {
    columns[[k + 1L]][last] <- formatC(balance[[k + 1L]][last], format = "e", digits = 1)
  }
  columns
}

reaction_columns <- function(reactions) {
  columns <- axis_columns(reactions, "point")
  names(columns)[1L] <- " support"
  columns
}

# ---- conditions ----------------------------------------------------------------------------------

conditions_section <- function(state) {
  fields <- gear_fields(state$gear)
  si <- state$si
  knots <- si$towing$speed / plan_units$speed[["knot"]]
  law <- function(x) {
    if (is.list(x)) sprintf("the plan's own, %s across the axis", x$normal) else gsub("_", " ", x)
  }
  ground <- fields$seabed
  terms <- list(
    "Towing speed" = if (si$towing$speed > 0) {
      sprintf("%s knot (%s m/s)", short_number(knots), short_number(si$towing$speed))
    } else {
      "none: the gear is held"
    },
    "Water" = if (si$water$density > 0) {
      paste0(short_number(si$water$density), " kg/m3",
        if (si$water$free_surface) ", with a free surface")
    } else {
      "none"
    },
    "Waves" = if (!is.null(si$water$waves)) {
      paste0(wave_text(si$water$waves),
        if (is.null(state$time)) "; the results are the mean, in still water")
    },
    "Sea bed" = if (!is.null(ground)) {
      sprintf("at a depth of %s m, coefficient of friction %s", short_number(ground$depth),
        short_number(ground$friction))
    },
    "Drag coefficients" = law(fields$coefficients),
    "Drag of netting" = gsub("_", " ", fields$netting_drag),
    "Shielding behind netting" = fields$shielding
  )
  terms <- Filter(Negate(is.null), terms)
  rows <- lapply(names(terms), function(name) list(tag$dt(name), tag$dd(terms[[name]])))
  report_section("Conditions", tag$dl(rows), current_table(si))
}

current_table <- function(si) {
  current <- si$water$current
  speed <- current_speeds(si)
  if (all(speed == 0)) return(NULL)
  toward <- in_unit(atan2(current$y, current$x), "deg") %% 360
  report_table(
    list(`depth m` = column_numbers(current$depth), `speed m/s` = column_numbers(speed),
      `toward deg` = column_numbers(toward)),
    "Current by depth, flowing toward 0 deg aft and 90 deg to starboard."
  )
}
