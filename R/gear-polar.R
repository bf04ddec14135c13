# Lift and drag of otter boards, kites and depressors by angle of attack: published tests,
# interpolation and extrapolation.

published_values <- package_table("published-coefficients.csv")

# Polars of tested boards and kites by name: data frames of force, attack (deg), and lift and drag
# on the area. Boards without published drag are omitted.
published_polars <- local({
  rows <- published_values[published_values$force %in% c("otter_board", "kite"), ]
  polars <- lapply(split(rows, factor(rows$law, unique(rows$law))), function(own) {
    lift <- own[own$coefficient == "lift", ]
    drag <- own[own$coefficient == "drag", ]
    data.frame(force = lift$force, attack = lift$angle_deg, lift = lift$value,
      drag = drag$value[match(lift$angle_deg, drag$angle_deg)])
  })
  Filter(function(polar) !anyNA(polar$drag), polars)
})

#' Lift and drag coefficients of an otter board or kite
#'
#' Returns the polar of a free otter board, kite or depressor over the full circle of angles.
#'
#' Tests of boards publish few angles. The remaining angles follow from these rules:
#'
#' - Between the given angles: a monotone cubic through the given values ([stats::splinefun()],
#'   `"monoH.FC"`).
#' - Below the lowest angle, down to zero lift: lift is on the straight line through the two lowest
#'   values. Drag is `a + b attack^2` through the same values.
#' - Beyond the highest angle, up to 90 deg: the stalled plate of Viterna and Corrigan (1982, NASA
#'   CP-2230). It starts at the last given values and ends with a drag coefficient of `1.11 + 0.018
#'   span/chord`.
#' - Flow on the outer face, or from behind: the same curve with 0.7 times the lift (same source).
#'
#' Published polars by name, each on its own area:
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
#' The values of the plates were read from diagrams, at a Reynolds number of 140,000. The drag of
#' the kite at 40 deg is on a straight line between published values at 20 and 90 deg.
#'
#' The otter boards have only two published angles. The higher one has the largest lift, and the
#' boards count as stalled beyond it. No test of a trawl kite with published angles was found: the
#' fabric kite was tested in air.
#'
#' @param polar Character: a name from the table. Or: a data frame with columns `attack` (deg),
#'   `lift` and `drag` (coefficients on the board's area) and at least two angles between 0 and 90
#'   deg.
#' @param aspect_ratio Number: span over chord. Default 2.
#' @return A data frame with columns `attack` (deg, from -180 to 180), `lift`, `drag` (coefficients)
#'   and `published` (TRUE for given rows, FALSE for computed rows).
#' @seealso [force_coefficients()] for all published and computed values;
#'   [as.data.frame()][as.data.frame.codend_state] for the stability of a board.
#' @export
#' @examples
#' board_polar("krill_cambered")
board_polar <- function(polar, aspect_ratio = 2) {
  check_given("polar")
  aspect_ratio <- quantity_number(aspect_ratio, "number", "aspect_ratio", positive = TRUE)
  if (is.character(polar) && length(polar) == 1L && polar %in% names(published_polars)) {
    given <- published_polars[[polar]]
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
      "{.arg polar} must have at least two different angles, from 0 to below 90 deg. Every drag
      must be positive, and so must the lift at the smallest angle."
    )
  }
  n <- nrow(given)
  steps <- function(from, to) {
    inner <- seq(ceiling(from / 5) * 5, floor(to / 5) * 5, by = 5)
    inner[inner > from + 1 & inner < to - 1]
  }

  rise <- (given$lift[2] - given$lift[1]) / (given$attack[2] - given$attack[1])
  # If lift decreases or hardly increases between the two angles, use the lift line of a flat plate.
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
  # Flow from behind and on the outer face.
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

# Returns coefficients beyond stall (attack in deg), up to a plate normal to the flow. L. Viterna
# and R. Corrigan, Fixed pitch rotor performance of large horizontal axis wind turbines, NASA
# CP-2230 (1982).
viterna <- function(attack, stall, across) {
  a <- from_unit(attack, "deg")
  s <- from_unit(stall$attack, "deg")
  lift <- across / 2 * sin(2 * a) +
    (stall$lift - across * sin(s) * cos(s)) * sin(s) / cos(s)^2 * cos(a)^2 / sin(a)
  drag <- across * sin(a)^2 + (stall$drag - across * sin(s)^2) / cos(s) * cos(a)
  data.frame(attack = attack, lift = lift, drag = drag)
}

# Returns knots (rad), values and slopes in the engine's form.
engine_polar <- function(table) {
  angle <- from_unit(table$attack, "deg")
  slope <- function(value) {
    # Add a turn before and after, so that the curve is smooth and periodic.
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

# Returns the polar of a plan, which is a name or a list of rows with attack in rad.
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
        "at least two different angles from 0 to below 90 deg, all with positive drag and the",
        "smallest with positive lift"
      ))
    }
  )
}
