#' Convert a vessel's track to a tow schedule
#'
#' Turns logged positions into the speed and course of a [tow_schedule()], and logged depths into a
#' seabed.
#'
#' Positions scatter by metres. Speed and course therefore follow from the chord between `every`
#' seconds before and `every` seconds after; shorter turns are smoothed. The seabed is the plane
#' along the track with the least squared distance from the depths.
#'
#' @param log A data frame with `time` (s), `longitude` and `latitude` (rad) and, for a seabed,
#'   `depth` (m). A unit may follow the name: `longitude_deg`. [read_sensor_log()] returns such a
#'   table if positions have the unit `deg`.
#' @param from,to Start and end of the tow on the clock of `log`, s or string.
#' @param every Time step of the schedule, s or string. Default 60.
#' @return A list. Wrong arguments are an error of class `codend_error_argument`. Elements:
#' - `schedule`: a schedule ([tow_schedule()]) of `speed` (over ground) and `course` (to starboard
#'   of the initial course), with times in s from `from`;
#' - `bearing`: initial bearing (rad clockwise from north, for [current_profile()]);
#' - `until`: duration (s);
#' - `distance`: length of the track (m);
#' - `seabed`: the `seabed` field of a plan, if there are depths;
#' - `bed_misfit`: largest distance of a depth from the seabed (m).
#' @seealso [tow()] to use the schedule, [read_sensor_log()] for the log, [current_profile()] for
#'   the current.
#' @export
#' @examples
#' time <- seq(0, 1200, 10)
#' log <- data.frame(time = time, longitude = 0.08, latitude = 1.05 + 2 * time / 6371008.8,
#'   depth = 100 + time / 100)
#' haul <- track_schedule(log, from = 0, to = 1200)
#' haul$schedule
#' haul$seabed
#' \donttest{
#' trawl <- update(read_gear("midwater_trawl"), towing.speed = haul$schedule$speed$value[1])
#' tow(trawl, until = 60, nodes = 200, schedule = haul$schedule)
#' }
track_schedule <- function(log, from, to, every = 60) {
  check_given("log", "from", "to")
  wanted <- c(time = "time", longitude = "angle", latitude = "angle")
  if (is.data.frame(log)) log <- si_columns(log, c(wanted, depth = "length"), "log")
  wanted <- names(wanted)
  if (!is.data.frame(log) || !all(vapply(wanted, function(name) is.numeric(log[[name]]), NA))) {
    abort_argument("{.arg log} must be a data frame with the numeric columns {.field {wanted}}, in s
      and rad.")
  }
  from <- quantity_number(from, "time", "from")
  to <- quantity_number(to, "time", "to")
  every <- quantity_number(every, "time", "every", positive = TRUE)
  log <- log[order(log$time), ]
  log <- log[!duplicated(log$time) & is.finite(log$longitude) & is.finite(log$latitude), ]
  rows <- sum(log$time >= from & log$time <= to)
  if (rows < 3L || to - from < every) {
    abort_argument("{.arg log} has {rows} position{?s} between {.arg from} and {.arg to}; a track
      needs at least 3 positions over at least {.arg every} seconds.")
  }
  if (max(abs(log$latitude)) > pi / 2) {
    abort_argument("{.arg log} has an impossible latitude: bare numbers must be in rad. Name the
      columns {.field longitude_deg} and {.field latitude_deg} if they are in degrees.")
  }
  middle <- log$latitude[log$time >= from][1L]
  # Plane (m) tangential to the globe at the start of the tow, without a jump at the date line.
  turned <- (log$longitude - log$longitude[1L] + pi) %% (2 * pi) - pi
  east <- earth_radius * cos(middle) * turned
  north <- earth_radius * (log$latitude - middle)
  at <- seq(from, to, length.out = max(2L, 1L + round((to - from) / every)))
  behind <- chord_ends(log$time, at - every, from, to)
  ahead <- chord_ends(log$time, at + every, from, to)
  step <- function(values) {
    stats::approx(log$time, values, ahead, rule = 2)$y -
      stats::approx(log$time, values, behind, rule = 2)$y
  }
  chord <- cbind(step(east), step(north))
  speed <- sqrt(rowSums(chord^2)) / (ahead - behind)
  bearing <- unwrapped(atan2(chord[, 1L], chord[, 2L]))
  found <- list(
    schedule = tow_schedule(
      speed = data.frame(time = at - from, value = speed),
      course = data.frame(time = at - from, value_rad = bearing - bearing[1L])
    ),
    bearing = bearing[1L] %% (2 * pi), until = to - from,
    distance = sum((speed[-1L] + speed[-length(speed)]) / 2 * diff(at))
  )
  c(found, bed_along(log, from, to, found$schedule$speed))
}

# Returns the ends of chords, limited to the tow and the log.
chord_ends <- function(time, at, from, to) {
  pmin(pmax(at, max(from, min(time))), min(to, max(time)))
}

unwrapped <- function(angle) {
  step <- diff(angle)
  angle + 2 * pi * c(0, cumsum((step < -pi) - (step > pi)))
}

# Returns the seabed, a plane fitted to the depths. Its depth is at the start of the tow.
bed_along <- function(log, from, to, speed) {
  if (!is.numeric(log$depth)) return(NULL)
  log <- log[log$time >= from & log$time <= to & is.finite(log$depth), ]
  if (nrow(log) < 3L) return(NULL)
  way <- stats::approx(speed$time, cumulated(speed), log$time - from, rule = 2)$y
  fit <- stats::lm.fit(cbind(1, way), log$depth)
  fall <- fit$coefficients[[2L]]
  depth <- fit$coefficients[[1L]]
  if (!is.finite(fall) || depth <= 0) return(NULL)
  bed <- list(depth = paste(plain_number(round(depth, 2)), "m"))
  angle <- round(in_unit(atan(abs(fall)), "deg"), 3)
  if (angle > 0) {
    # A seabed that deepens ahead falls towards 180 deg.
    bed$slope <- list(angle = paste(plain_number(angle), "deg"),
      toward = if (fall > 0) "180 deg" else "0 deg")
  }
  list(seabed = bed, bed_misfit = max(abs(fit$residuals)))
}

cumulated <- function(speed) {
  value <- speed$value
  c(0, cumsum((value[-1L] + value[-length(value)]) / 2 * diff(speed$time)))
}
