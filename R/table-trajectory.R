#' Tables of a trajectory
#'
#' Returns the results of a tow as tables with a first column `time_s`. Column names end in their
#' unit.
#'
#' @section Fields of a trajectory:
#' A trajectory is a list of class `codend_trajectory`. Positions are over the ground, n is the
#' number of saved times:
#'
#' - `gear`, `si`, `mesh`, `given` (the schedules) and `method` (scheme, accuracy, step);
#' - `time` (s), `position` (3 x nodes x n, m) and `velocity` (m/s);
#' - `bar_tension` (bars x n, N, of one line), `u_tension` and `v_tension` (netting cells x n) and
#'   `straight_tension` (straight bars of hexagonal cells x n);
#' - with `shielding`, `wake` (points x n): fraction of the free flow speed;
#' - `conditions`: one row per time, see below;
#' - `energy`: 8 x n, J since the start. Rows: gains of kinetic, elastic and potential energy; work
#'   of supports, winches, water and damping; energy put through;
#' - `end`: `"reached"`, or `"interrupted"` by the user;
#' - `report` of the last time integration, see below;
#' - `memory`: internal data with which [tow()] continues.
#'
#' @section Conditions:
#' - `x`, `y` (m): position of the vessel over the ground; `speed` (m/s), `course` (rad), `heave`
#'   (m);
#' - length (m) of each warp that the schedule changes;
#' - `energy_imbalance` (J since the start): energy that the scheme added (positive) or removed;
#' - `energy_put_through` (J since the start).
#'
#' @section Report:
#' - `steps`: accepted steps; `shortest_step`, `longest_step` (s);
#' - `largest_error` (m): largest estimated position error of one step;
#' - `repeated`, `not_found`, `unbalanced`: steps repeated because of their error, a failed solution
#'   or their energy;
#' - `iterations`, `factorisations`, `force_evaluations`;
#' - `factor_entries`: stored entries of the matrix factorisation.
#'
#' @param x A trajectory, from [tow()].
#' @param row.names `NULL` (default) or names for the rows.
#' @param optional Not used.
#' @param what Name of the table, by default `"measures"`. Give it by name, as `what = "nodes"`:
#'
#'   - `"measures"`: `measure`, `value`, `error` and `unit` ([measures()] at every time), and the
#'     parts `time_error` and `mesh_error` of the error ([tow()]).
#'   - `"conditions"`: the motion of the vessel and the warp lengths from the schedule.
#'   - `"tensions"`: `part`, `kind`, `role`, `max_kN` and `mean_kN`, the largest and mean tension of
#'     one line.
#'   - `"nodes"`: `node` and its position over the ground, `x_m`, `y_m`, `z_m`.
#'   - `"swept"`: `distance_m`, `swept_volume_m3` and `swept_area_m2` since the start, see below.
#' @param wide `TRUE` returns the table `"measures"` with one row per time and a column for each
#'   measure. Default `FALSE`.
#' @param ... Not used.
#'
#' @section Swept volume and area:
#' - `distance_m`: path of the vessel over the ground;
#' - `swept_volume_m3`: water that flowed through the mouth, the integral of `filtered_volume`;
#' - `swept_area_m2`: ground between the wing ends, the integral of `swept_area`.
#'
#' The integrals of both measures ([measures()]) use the trapezoid rule between saved times. They
#' are `NA` if the gear has no such measure. Selection models need this table and the mesh
#' openings of [as.data.frame()][as.data.frame.codend_state].
#'
#' @return A data frame, one row per time and, except for `"conditions"` and `"swept"`, per measure,
#'   part or node.
#' @seealso [tow()], [state_at()], [summary()][summary.codend_trajectory]; the guide
#'   `vignette("motion", "codend")`.
#' @examples
#' faster <- tow("towed_cable", until = 40, every = 20,
#'   schedule = tow_schedule(speed = data.frame(time = c(0, 30), value = c("4 knot", "5 knot"))))
#' as.data.frame(faster, what = "measures")
#' @export
as.data.frame.codend_trajectory <- function(x, row.names = NULL, optional = FALSE,
                                            what = c("measures", "conditions", "tensions", "nodes",
                                              "swept"), wide = FALSE, ...) {
  table <- switch(chosen(what, eval(formals()$what)),
    measures = measures_by_time(x, wide),
    conditions = condition_units(x$conditions),
    swept = swept_table(x),
    tensions = by_time(x, function(time) {
      tension_table(state_at(x, time))[c("part", "kind", "role", "max_kN", "mean_kN")]
    }),
    nodes = by_time(x, function(time) {
      place <- x$position[, , match(time, x$time)]
      data.frame(
        node = seq_len(ncol(place)), x_m = place[1, ], y_m = place[2, ], z_m = place[3, ]
      )
    })
  )
  with_row_names(table, row.names, what = TRUE)
}

measures_by_time <- function(trajectory, wide) {
  table <- by_time(trajectory, function(time) {
    state <- state_at(trajectory, time)
    table <- as.data.frame(measures(state))
    in_time <- state$compared$time_error[table$measure]
    if (is.null(in_time)) in_time <- NA * table$value
    table$time_error <- unname(numbers_in_display_units(in_time, table$unit))
    table$mesh_error <- sqrt(pmax(table$error^2 - table$time_error^2, 0))
    table
  })
  if (!wide) return(table)
  columns <- lapply(split(table, factor(table$measure, unique(table$measure))), function(of) {
    of$value[match(trajectory$time, of$time_s)]
  })
  data.frame(time_s = trajectory$time, columns, check.names = FALSE)
}

by_time <- function(trajectory, table_at) {
  do.call(rbind, lapply(trajectory$time, function(time) {
    table <- table_at(time)
    cbind(time_s = rep(time, nrow(table)), table)
  }))
}

# Adds units to the column names of conditions.
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
  invisible(x)
}

# Returns a text about the accuracy criteria for the steps of a tow.
judged_text <- function(method) {
  scheme <- gsub("_", " ", method$scheme)
  if (is.null(method$accuracy) || method$accuracy == 0) {
    return(sprintf("%s, fixed steps without error control", scheme))
  }
  tension <- if (is.finite(method$tension_accuracy)) {
    sprintf(" and %s of the largest tension", percent_text(method$tension_accuracy))
  } else {
    "; no error control of tensions"
  }
  accuracy <- if (isTRUE(method$relative)) {
    paste("relative accuracy", percent_text(method$accuracy))
  } else {
    sprintf("error per step at most %s m of position", format(method$accuracy))
  }
  paste0(scheme, ", ", accuracy, tension)
}

#' Summarise a trajectory
#'
#' Lists start, end, mean, minimum and maximum of every measure of a tow, with errors.
#'
#' @param object A trajectory, from [tow()].
#' @param ... Not used.
#' @section Errors:
#' An extreme has the error of the value at its time ([tow()]). The error of its time follows from
#' the times at which the value differs by less than its error.
#'
#' @return A data frame of class `codend_trajectory_summary`, one row per measure. Columns:
#'   `measure`, `unit`, `start`, `end`, `mean`, `least`, `least_at_s`, `greatest`, `greatest_at_s`
#'   and errors: `mean_error`, `least_error`, `least_at_s_error`, `greatest_error` and
#'   `greatest_at_s_error`. Extremes between saved times are missed. The attribute `energy` (J)
#'   contains `imbalance`, `put_through`, and the energy removed by the time `scheme` and by
#'   `physical` causes (water, ground and dampers) at the end. The attribute `findings` contains the
#'   warnings ([findings()]).
#' @seealso [as.data.frame()][as.data.frame.codend_trajectory], [tow()].
#' @examples
#' faster <- tow("towed_cable", until = 40, every = 20,
#'   schedule = tow_schedule(speed = data.frame(time = c(0, 30), value = c("4 knot", "5 knot"))))
#' summary(faster)
#' @export
summary.codend_trajectory <- function(object, ...) {
  n <- length(object$time)
  last <- state_values(state_at(object, object$time[n]))
  table <- extremes_table(as.data.frame(object, what = "measures"))
  structure(table, class = c("codend_trajectory_summary", "data.frame"),
    findings = findings(object), main = printed_names(last),
    energy = c(imbalance = object$conditions$energy_imbalance[n],
      put_through = object$conditions$energy_put_through[n],
      energy_lost(object$energy)[c("scheme", "physical"), n]))
}

# Returns the first and last value, the mean and the extremes of each measure, with errors. `table`:
# measures by time.
extremes_table <- function(table) {
  rows <- lapply(split(table, factor(table$measure, unique(table$measure))), function(of) {
    n <- nrow(of)
    extreme <- function(sign) {
      k <- which.max(sign * of$value)
      # times at which the value differs by less than its error
      near <- which(abs(of$value - of$value[k]) <= of$error[k])
      shift <- range(of$time_s[pmax(1L, pmin(n, range(k, near) + c(-1L, 1L)))]) - of$time_s[k]
      list(value = of$value[k], error = of$error[k], at_s = of$time_s[k],
        at_s_error = if (is.na(of$error[k])) NA_real_ else max(abs(shift)) / 2)
    }
    # errors of neighbouring times are similar and do not average out
    data.frame(measure = of$measure[1L], unit = of$unit[1L], start = of$value[1L],
      end = of$value[n], mean = mean(of$value), mean_error = sqrt(mean(of$error^2)),
      least = extreme(-1), greatest = extreme(1))
  })
  rows <- do.call(rbind, unname(rows))
  names(rows) <- sub("[.]value$", "", sub("[.](error|at_s)", "_\\1", names(rows)))
  rows
}

#' @rdname summary.codend_trajectory
#' @param x A summary.
#' @param n Largest number of printed lines. `Inf` prints all measures.
#' @export
print.codend_trajectory_summary <- function(x, n = 30, ...) {
  main <- attr(x, "main")
  energy <- attr(x, "energy")
  warnings <- finding_lines(attr(x, "findings"))
  if (length(warnings)) warnings <- c("", bold("Warnings"), limited_lines(warnings, 9))
  table <- rows_in_units(x[order(!x$measure %in% main), ], units_option())
  number <- c("start", "end", "least", "least_error", "least_at_s", "greatest", "greatest_error",
    "greatest_at_s")
  columns <- c(
    list(c("", label_of(table$measure, table$unit))), list(c("", table$unit)),
    lapply(number, function(name) {
      c(sub(".*_at_s$", "at s", sub(".*_error$", "error", name)), figures(table[[name]]))
    })
  )
  lines <- align_columns(columns, left = 1:2)
  # of n lines, the heading and the energy take three
  cat(lines[1L], limited_lines(lines[-1L], n - 3 - length(warnings)), sep = "\n")
  if (!is.null(energy)) {
    figure <- function(name) format(signif(energy[[name]], 3))
    with_plain_numbers(cat(
      sprintf("Energy removed by water, ground and dampers: %s J\n", figure("physical")),
      sprintf("Energy removed by the time scheme: %s J\n", figure("scheme")), sep = ""
    ))
  }
  if (length(warnings)) cat(warnings, sep = "\n")
  invisible(x)
}
