# The tables of a report that a summary lacks, see table-columns.R.

# Returns numbers with four digits and separated thousands.
single_numbers <- function(x) {
  text <- figures(x)
  large <- !is.na(x) & abs(x) >= 1e4
  text[large] <- big_number(as.double(text[large]))
  text
}

big_number <- function(x) format(x, big.mark = ",", trim = TRUE, scientific = FALSE)

# Largest number of groups in the table of drag by part.
reported_parts <- 15L

measures_columns <- function(measures) {
  said <- measure_labels(measures)
  measures <- plain_measures(measures)
  force <- ifelse(said$unit == "kN", figures(measures / 9.80665), "")
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
    list(`depth m` = column_figures(current$depth), `speed m/s` = column_figures(speed),
      `toward deg` = column_figures(toward)),
    "Current by depth, flowing toward 0 deg aft and 90 deg to starboard."
  )
}
