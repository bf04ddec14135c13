#' Tables of a trajectory
#'
#' @details
#' A trajectory is a list of class `codend_trajectory`. Over the ground, with n kept times:
#'
#' - `gear`, `si`, `lattice`, `given` (the schedules as given) and `method` (scheme, accuracy,
#' step);
#' - `time` (s), `position` (3 x nodes x n, m), `velocity` (m/s), `bar_tension` (bars x n, N, of one
#'   line), `u_tension` and `v_tension` (netting cells x n) and `straight_tension` (cells of
#'   hexagonal meshes x n, of their straight bars), with `shielding` also `wake` (points x n, share
#'   of the free flow's speed);
#' - `conditions`: a row per time, with the vessel's place over the ground `x`, `y` (m), its `speed`
#'   (m/s), `course` (rad) and `heave` (m), the length of each warp that the schedule moves (m), and
#'   since the start `energy_imbalance`, J that the scheme made (positive) or removed, and
#'   `energy_put_through` (J);
#' - `energy`: 8 x n, J since the start: gains of kinetic, elastic and potential energy; work of
#'   supports, winches, water and damping; energy put through;
#' - `end`: `"reached"`, or `"interrupted"` by the user;
#' - `report` of the last march: `steps` taken, `repeated` for their error, `not_found`,
#'   `unbalanced` (repeated for their energy), `iterations`, `factorisations`,
#'   `force_evaluations`, `factor_entries` (numbers that the matrix factors store),
#'   `shortest_step` and `longest_step` (s);
#' - `memory`: what [tow()] needs to go on.
#'
#' @param x A trajectory, from [tow()].
#' @param row.names `NULL` or names for the rows.
#' @param optional Not used.
#' @param what Which table (give it by name, as `what = "nodes"`), with a first column `time_s`:
#'
#'   - `"measures"`: `measure`, `value`, `unit` ([measures()] of the state at every time).
#'   - `"conditions"`: what the schedule made of the vessel and its warps.
#'   - `"tensions"`: `part`, `kind`, `role`, the largest and the mean tension of one line, `max_kN`,
#'     `mean_kN`.
#'   - `"nodes"`: `node` and its place over the ground, `x_m`, `y_m`, `z_m`.
#'   - `"swept"`: a row per time: `distance_m` (the vessel's way over the ground) and, summed up
#'     since the start, `swept_volume_m3` (water that flowed through the mouth) and `swept_area_m2`
#'     (ground that the lines between the wing ends passed over): the integrals of
#'     `filtered_volume` and `swept_area` ([measures()]) by the trapezoid rule between kept times,
#'     `NA` where the gear has no such measure. With [mesh_openings()] this is what a model of
#'     selection takes.
#' @param ... Not used.
#' @return A data frame.
#' @examples
#' faster <- tow("towed_cable", until = 40, every = 20,
#'   schedule = tow_schedule(speed = data.frame(time = c(0, 30), value = c("4 knot", "5 knot"))))
#' as.data.frame(faster, what = "measures")
#' @export
as.data.frame.codend_trajectory <- function(x, row.names = NULL, optional = FALSE,
                                            what = c("measures", "conditions", "tensions", "nodes",
                                              "swept"), ...) {
  what <- chosen(what, c("measures", "conditions", "tensions", "nodes", "swept"))
  table <- switch(what,
    measures = by_time(x, function(k) measure_table(state_at(x, x$time[k]))),
    conditions = condition_units(x$conditions),
    swept = swept_table(x),
    tensions = by_time(x, function(k) part_tensions(x, k)),
    nodes = by_time(x, function(k) {
      place <- x$position[, , k]
      data.frame(
        node = seq_len(ncol(place)), x_m = place[1, ], y_m = place[2, ], z_m = place[3, ]
      )
    })
  )
  if (!is.null(row.names)) row.names(table) <- row.names
  table
}

by_time <- function(trajectory, table_at) {
  tables <- lapply(seq_along(trajectory$time), function(k) {
    table <- table_at(k)
    cbind(time_s = rep(trajectory$time[k], nrow(table)), table)
  })
  do.call(rbind, tables)
}

# Conditions with units in the names of their columns.
condition_units <- function(conditions) {
  known <- c(
    time = "time_s", x = "x_m", y = "y_m", speed = "speed_m_per_s", course = "course_deg",
    heave = "heave_m", elevation = "elevation_m", energy_imbalance = "energy_imbalance_J",
    energy_put_through = "energy_put_through_J"
  )
  known <- known[names(known) %in% names(conditions)]
  parts <- setdiff(names(conditions), c(names(known), "x_rate", "y_rate"))
  out <- conditions[c(names(known), parts)]
  out$course <- in_unit(out$course, "deg")
  setNames(out, c(known, parts))
}

# Largest and mean tension of every rope and panel at one of the kept times.
part_tensions <- function(trajectory, k) {
  lattice <- trajectory$lattice
  parts <- lattice$parts
  of <- c(
    lattice$bar_part, lattice$cell_part, lattice$cell_part,
    lattice$cell_part[has_straight_bars(lattice)]
  )
  tension <- c(
    trajectory$bar_tension[, k], trajectory$u_tension[, k], trajectory$v_tension[, k],
    trajectory$straight_tension[, k]
  )
  here <- sort(unique(of))
  group <- factor(of, levels = here)
  data.frame(
    part = parts$name[here], kind = parts$kind[here], role = parts$role[here],
    max_kN = in_unit(as.double(tapply(tension, group, max)), "kN"),
    mean_kN = in_unit(as.double(tapply(tension, group, mean)), "kN")
  )
}

#' @export
print.codend_trajectory <- function(x, ...) {
  last <- x$time[length(x$time)]
  ended <- if (x$end == "interrupted") ", interrupted" else ""
  with_plain_numbers(cat(
    sprintf("Tow of \"%s\": %s s, %d states%s", x$si$name, format(signif(last, 6)),
      length(x$time), ended),
    paste0("  ", size_text(x)),
    sprintf("  %.0f steps of %s to %s s, %.0f repeated", first_of(x$report$steps, 0),
      format(signif(first_of(x$report$shortest_step, 0), 3)),
      format(signif(first_of(x$report$longest_step, 0), 3)),
      first_of(x$report$repeated, 0) + first_of(x$report$not_found, 0)),
    paste0("  ", judged_text(x$method)),
    "  More: summary(), as.data.frame(), state_at(), measures(state_at())",
    sep = "\n"
  ))
  cat("\n")
  invisible(x)
}

# What the steps of a tow were held to.
judged_text <- function(method) {
  scheme <- gsub("_", " ", method$scheme)
  if (is.null(method$accuracy) || method$accuracy == 0) {
    return(sprintf("%s, steps of one length, whose error is not judged", scheme))
  }
  tension <- if (is.finite(method$tension_accuracy)) {
    sprintf(" and %s of the largest tension", percent_text(method$tension_accuracy))
  } else {
    "; tensions are not judged"
  }
  sprintf("%s, each step to %s m of position%s", scheme, format(method$accuracy), tension)
}

#' Summary of a trajectory
#'
#' @param object A trajectory, from [tow()].
#' @param ... Not used.
#' @return A data frame of class `codend_trajectory_summary`: a row per measure with its value at
#'   the start and at the end, the least and the greatest, and the times of these (s). Its attribute
#'   `energy` holds the `imbalance` at the end and what was `put_through`, J.
#' @examples
#' faster <- tow("towed_cable", until = 40, every = 20,
#'   schedule = tow_schedule(speed = data.frame(time = c(0, 30), value = c("4 knot", "5 knot"))))
#' summary(faster)
#' @export
summary.codend_trajectory <- function(object, ...) {
  table <- as.data.frame(object, what = "measures")
  rows <- lapply(unique(table$measure), function(measure) {
    of <- table[table$measure == measure, ]
    data.frame(
      measure = measure, unit = of$unit[1], start = of$value[1], end = of$value[nrow(of)],
      least = min(of$value), least_at_s = of$time_s[which.min(of$value)],
      greatest = max(of$value), greatest_at_s = of$time_s[which.max(of$value)]
    )
  })
  n <- length(object$time)
  structure(do.call(rbind, rows), class = c("codend_trajectory_summary", "data.frame"),
    energy = c(imbalance = object$conditions$energy_imbalance[n],
      put_through = object$conditions$energy_put_through[n]))
}

#' @export
print.codend_trajectory_summary <- function(x, ...) {
    number <- c("start", "end", "least", "least_at_s", "greatest", "greatest_at_s")
  columns <- c(
    list(c("", words_of(x$measure, x$unit))), list(c("", x$unit)),
    lapply(number, function(name) c(gsub("_at_s", " at s", name), figures(x[[name]])))
  )
  cat(align_columns(columns, left = 1:2), sep = "\n")
  cat("\n")
  energy <- attr(x, "energy")
  if (!is.null(energy)) {
    with_plain_numbers(cat(sprintf("Energy: %s J %s by the scheme, of %s J put through\n",
      format(signif(abs(energy[["imbalance"]]), 3)),
      if (energy[["imbalance"]] > 0) "made" else "removed",
      format(signif(energy[["put_through"]], 3)))))
  }
  invisible(x)
}
