# Lift and drag of otter boards, kites and depressors by angle of attack: published tests, and what
# lies between and beyond their angles.

# Tested boards and kites. Only values that are printed in public; attack in deg, coefficients on
# the area.
tested_polar <- function(source, attack, lift, drag) {
  list(source = source, values = data.frame(attack = attack, lift = lift, drag = drag))
}
published_polars <- list(
  # largest C_L/C_D at 15 deg, largest C_L at 30 deg
  low_aspect_cambered = tested_polar(
    "low-aspect vertical cambered otter board, no heel: doi 10.3724/SP.J.1231.2013.38768",
    c(15, 30), c(1.120, 1.699), c(0.463, 1.140)
  ),
  # largest C_L/C_D at 10 deg, largest C_L at 30 deg
  krill_cambered = tested_polar(
    "hollow vertical cambered otter board of a krill trawl: DRDS journal database, abstract",
    c(10, 30), c(0.981, 1.436), c(0.210, 0.649)
  ),
  # largest C_L/C_D at 10 deg, largest C_L at 27.5 deg
  high_lift = tested_polar(
    "Effect of aspect ratio on hydrodynamic performance of high lift otter board: abstract, H2",
    c(10, 27.5), c(1.660, 2.535), c(0.473, 1.424)
  ),
  # read from diagrams; Reynolds number 140,000
  flat_plate = tested_polar(
    "A. Pelletier and T. J. Mueller, Journal of Aircraft 37, 2000: flat plate, aspect ratio 2",
    c(3, 6, 8, 10, 15, 20, 25), c(0.15, 0.30, 0.40, 0.50, 0.70, 0.75, 0.67),
    c(0.020, 0.035, 0.060, 0.080, 0.180, 0.280, 0.330)
  ),
  square_plate = tested_polar(
    "A. Pelletier and T. J. Mueller, Journal of Aircraft 37, 2000: flat plate, aspect ratio 1",
    c(3, 6, 8, 10, 15, 20, 25, 28), c(0.075, 0.15, 0.20, 0.25, 0.50, 0.70, 0.80, 0.80),
    c(0.020, 0.030, 0.040, 0.060, 0.150, 0.280, 0.420, 0.480)
  ),
  # printed at 0, 20 and 40 deg, drag also at 90: 40 deg lies on their straight line
  fabric_kite = tested_polar(
    "U. Fechner et al., Renewable Energy 83, 2015, in KiteModels: soft kite with inflated edges",
    c(0, 20, 40), c(0.2, 1.0, 1.0), c(0.1, 0.2, 0.429)
  )
)

#' Lift and drag coefficients of an otter board or kite
#'
#' The polar that a free otter board, kite or depressor is computed with, over the full circle.
#'
#' Tests of boards print few angles, so most of a polar is filled in, always in the same way:
#'
#' - between and up to the given angles a monotone cubic through the given values
#'   ([stats::splinefun()], `"monoH.FC"`);
#' - below the lowest angle, down to where lift is zero, lift on the straight line through the two
#'   lowest values, and drag by `a + b attack^2` through the same;
#' - beyond the highest angle, up to 90 deg, the stalled plate of Viterna and Corrigan (1982, NASA
#'   CP-2230), which starts from the last given values and ends with a drag coefficient of
#'   `1.11 + 0.018 span/chord`;
#' - flow on the outer face, or from behind: the same with 0.7 of the lift, as the same source
#'   takes it.
#'
#' By name, each on its own area:
#'
#' | name | tested | at (deg) |
#' |---|---|---|
#' | `low_aspect_cambered` | low, cambered (doi 10.3724/SP.J.1231.2013.38768) | 15, 30 |
#' | `krill_cambered` | high, hollow and cambered, of a krill trawl | 10, 30 |
#' | `high_lift` | high lift otter board H2, aspect ratio 1.4 | 10, 27.5 |
#' | `flat_plate` | flat plate, aspect ratio 2 (Pelletier and Mueller, 2000) | 3 to 25 |
#' | `square_plate` | flat plate, aspect ratio 1 (the same) | 3 to 28 |
#' | `fabric_kite` | soft kite with inflated edges (Fechner et al., 2015) | 0, 20, 40 |
#'
#' A. Pelletier and T. J. Mueller: Journal of Aircraft 37. U. Fechner et al.: Renewable Energy 83.
#' The otter boards are printed at two angles only, the higher that of the largest lift, beyond
#' which they count as stalled. The plates' values were read from diagrams. No test of a trawl's own
#' kite with printed angles was found: the fabric kite is one for the air. [force_coefficients()]
#' has all of these values, computed and published.
#'
#' @param polar One of these names, or a data frame with columns `attack` (deg), `lift` and
#'   `drag` (coefficients on the board's area) of at least two angles between 0 and 90 deg.
#' @param aspect_ratio Span over chord.
#' @return A data frame with columns `attack` (deg, from -180 to 180), `lift`, `drag` and
#'   `published` (whether the row is given rather than filled in).
#' @export
#' @examples
#' board_polar("krill_cambered")
board_polar <- function(polar, aspect_ratio = 2) {
  check_given("polar")
  if (is.character(polar) && length(polar) == 1L && polar %in% names(published_polars)) {
    given <- published_polars[[polar]]$values
  } else if (is.data.frame(polar) && all(c("attack", "lift", "drag") %in% names(polar))) {
    given <- polar
  } else {
    abort_argument(
      "{.arg polar} must be a data frame with columns {.val attack}, {.val lift} and {.val drag},
      or one of {.val {names(published_polars)}}."
    )
  }
  given <- given[order(given$attack), ]
  good <- nrow(given) >= 2L && all(is.finite(as.matrix(given[c("attack", "lift", "drag")]))) &&
    all(diff(given$attack) > 0) && given$attack[1] >= 0 && max(given$attack) < 90 &&
    given$lift[1] > 0 && max(given$lift) > 0 && all(given$drag > 0)
  if (!good) {
    abort_argument(
      "{.arg polar} must have two angles or more, each once, from 0 to below 90 deg, with positive
      drag and, at the lowest, positive lift."
    )
  }
  n <- nrow(given)
  steps <- function(from, to) {
    inner <- seq(ceiling(from / 5) * 5, floor(to / 5) * 5, by = 5)
    inner[inner > from + 1 & inner < to - 1]
  }

  rise <- (given$lift[2] - given$lift[1]) / (given$attack[2] - given$attack[1])
  # Where lift falls or hardly rises between the two, the way down to zero is that of a flat plate.
  if (rise < 0.5 * given$lift[1] / 30) rise <- given$lift[1] / max(given$attack[1], 10)
  no_lift <- max(given$attack[1] - given$lift[1] / rise, -30)
  bend <- max(0, (given$drag[2] - given$drag[1]) / (given$attack[2]^2 - given$attack[1]^2))
  least <- given$drag[1] - bend * given$attack[1]^2
  if (least < 0.2 * given$drag[1]) {
    least <- 0.2 * given$drag[1]
    bend <- if (given$attack[1] > 0) 0.8 * given$drag[1] / given$attack[1]^2 else 0
  }
  low <- c(no_lift, steps(no_lift, given$attack[1]))
  below <- data.frame(
    attack = low, lift = given$lift[1] - rise * (given$attack[1] - low), drag = least + bend * low^2
  )
  below$lift[1] <- if (no_lift > -30) 0 else below$lift[1]
  between <- steps(given$attack[1], given$attack[n])
  between <- between[vapply(between, function(x) min(abs(x - given$attack)) > 1, NA)]
  through <- function(column) {
    stats::splinefun(given$attack, given[[column]], method = "monoH.FC")(between)
  }
  between <- data.frame(attack = between, lift = through("lift"), drag = through("drag"))
  stalled <- function(attack) viterna(attack, given[n, ], 1.11 + 0.018 * aspect_ratio)
  beyond <- stalled(c(steps(given$attack[n], 90), 90))
  front <- rbind(
    cbind(below, published = FALSE), cbind(given[c("attack", "lift", "drag")], published = TRUE),
    cbind(between, published = rep(FALSE, nrow(between))), cbind(beyond, published = FALSE)
  )
  front <- front[order(front$attack), ]
  # Flow from behind, and on the outer face.
  turned <- beyond[beyond$attack < 90, ]
  behind <- data.frame(attack = 180 - turned$attack, lift = -0.7 * turned$lift, drag = turned$drag)
  most <- max(behind$attack)
  flat <- function(attack) data.frame(attack = attack, lift = 0, drag = max(least, min(given$drag)))
  behind <- rbind(behind, flat(180))
  outer <- data.frame(
    attack = -c(beyond$attack, 180 - turned$attack),
    lift = c(-0.7 * beyond$lift, 0.7 * turned$lift), drag = c(beyond$drag, turned$drag)
  )
  outer <- rbind(outer[outer$attack < no_lift - 5, ], flat(-180))
  out <- rbind(cbind(rbind(outer, behind), published = FALSE), front)
  table_rows(out, order(out$attack))
}

# Beyond stall, from the coefficients at the stall angle to those of a plate across the flow, after
# L. Viterna and R. Corrigan, Fixed pitch rotor performance of large horizontal axis wind turbines,
# NASA CP-2230 (1982). attack in deg.
viterna <- function(attack, stall, across) {
  a <- from_unit(attack, "deg")
  s <- from_unit(stall$attack, "deg")
  lift <- across / 2 * sin(2 * a) +
    (stall$lift - across * sin(s) * cos(s)) * sin(s) / cos(s)^2 * cos(a)^2 / sin(a)
  drag <- across * sin(a)^2 + (stall$drag - across * sin(s)^2) / cos(s) * cos(a)
  data.frame(attack = attack, lift = lift, drag = drag)
}

# Knots, values and slopes as the engine reads them (rad).
engine_polar <- function(table) {
  angle <- from_unit(table$attack, "deg")
  slope <- function(value) {
    # A turn before and after, so that the circle closes smoothly.
    n <- length(angle)
    around <- c(angle[-n] - 2 * pi, angle, angle[-1L] + 2 * pi)
    found <- stats::splinefun(around, c(value[-n], value, value[-1L]), method = "monoH.FC")
    found(angle, deriv = 1)
  }
  list(
    angle = c(-pi, angle[-c(1L, length(angle))], pi), lift = table$lift, drag = table$drag,
    lift_slope = slope(table$lift), drag_slope = slope(table$drag)
  )
}

# The polar of a plan: a name, or a list of rows with attack in rad.
si_polar <- function(polar, path, aspect_ratio) {
  if (is.list(polar)) {
    polar <- data.frame(
      attack = in_unit(vapply(polar, `[[`, 0, "attack"), "deg"),
      lift = vapply(polar, `[[`, 0, "lift"), drag = vapply(polar, `[[`, 0, "drag")
    )
  }
  tryCatch(
    board_polar(polar, aspect_ratio),
    codend_error_argument = function(e) {
      abort_field(path, polar$attack, paste(
        "two angles or more, each once, from 0 to below 90 deg, with positive drag and, at the",
        "lowest, positive lift"
      ))
    }
  )
}
