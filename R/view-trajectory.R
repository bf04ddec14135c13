#' Plot a trajectory against time
#'
#' Small figures next to one another: what the schedule changes (speed, course, warps), then the
#' measures of the gear, each against time with its unit. Tensions and forces have the colour of
#' taut ropes; depths grow downwards. Bands are twice the estimated error of [measures()] wide to
#' both sides, by discretisation and time steps; some are no wider than their line.
#'
#' @param x A trajectory, from [tow()].
#' @param measures Names of measures, as [measures()] has them; all, and what the schedule changes,
#'   when `NULL`.
#' @inherit plot.codend_sensitivities params return
#' @examples
#' plot(tow("towed_cable", until = 30, every = 1, speed = data.frame(
#'   time = c(0, 10), value = c("4 knot", "5 knot")
#' )))
#' @export
plot.codend_trajectory <- function(x, measures = NULL, file = NULL, width = 10, height = NULL,
                                   ...) {
  figures <- lapply(trajectory_series(x, measures), time_figure)
  plot_series(x, figures, tow_title(x), NULL, file, width, height)
}

tow_title <- function(x) paste("Tow of", x$gear$plan$name)

# A series against time, in minutes where it is long.
time_figure <- function(series) {
  minutes <- max(series$time) > 180
  list(
    words = series$words, unit = series$unit,
    across = if (minutes) "time (min)" else "time (s)",
    lines = list(list(
      x = series$time / if (minutes) 60 else 1, y = series$value, group = 1L, dashed = FALSE,
      symbols = FALSE, low = series$value - 2 * series$error,
      high = series$value + 2 * series$error
    ))
  )
}

# What is drawn against time: a list of list(words, unit, time (s), value).
trajectory_series <- function(trajectory, wanted) {
  table <- as.data.frame(trajectory, what = "measures")
  known <- unique(table$measure)
  shown <- chosen_some(wanted, known, "measures")
  of_measures <- lapply(shown, function(measure) {
    of <- table[table$measure == measure, ]
    list(
      words = words_of(measure, of$unit[1L]), unit = of$unit[1L], time = of$time_s,
      value = of$value, error = of$error
    )
  })
  c(if (is.null(wanted)) condition_series(trajectory), of_measures)
}

# What of the schedule changes, the vessel's place apart.
condition_series <- function(trajectory) {
  table <- condition_units(trajectory$conditions)
  table <- table[setdiff(names(table), c("x_m", "y_m"))]
  known <- c(
    speed_m_per_s = "vessel speed", course_deg = "vessel course", heave_m = "heave",
    elevation_m = "elevation of the water"
  )
  unit <- c(speed_m_per_s = "m/s", course_deg = "deg", heave_m = "m", elevation_m = "m")
  table <- table[setdiff(names(table), c("energy_imbalance_J", "energy_put_through_J"))]
  changed <- names(table)[-1L][vapply(table[-1L], function(v) any(v != v[1L]), NA)]
  lapply(changed, function(name) {
    own <- name %in% names(known)
    list(
      words = if (own) known[[name]] else paste(gsub("_", " ", name), "out"),
      unit = if (own) {
        unit[[name]]
      } else if (is.null(trajectory$si$ropes[[name]])) {
        "share"
      } else {
        "m"
      },
      time = table$time_s, value = table[[name]]
    )
  })
}
