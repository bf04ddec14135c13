#' Compute force coefficients of the drag models
#'
#' Computes the coefficients of every drag model by angle or Reynolds number and lists published
#' values next to them. The values come from the code that settles a gear, applied to single twines,
#' pieces of netting, otter boards, kites and spheres.
#'
#' @section Computed values:
#' Drag is along the flow. Lift is across the flow, in the plane of the flow and the axis or normal.
#'
#' | force | angle | reference area |
#' |---|---|---|
#' | `twine` | between the axis and the flow | diameter times length |
#' | `netting` | between the normal and the flow | area of the netting |
#' | `otter_board`, `kite` | of attack, between the chord and the flow | its area |
#' | `sphere` | none | projected area |
#' | `wake` | between the normal and the flow | `speed`: flow speed behind over speed ahead |
#'
#' - Twines across the flow (90 deg) and spheres are also listed by Reynolds number.
#' - Netting is square and knotless, with twine of 2 mm.
#' - `morison` and `blended` use the coefficients `bessonneau_marichal`.
#'
#' @section Published values:
#' - Formulas: H. Cheng's program (github.com/hui-aqua/hydromodel) evaluates the same formulas and
#'   shares no code with codend. The published `takagi` jumps at a Reynolds number of 200, and
#'   `choo_casarella` has small jumps at 1, 30 and 2.33e5. codend's versions are continuous.
#' - Otter boards and kites: see [board_polar()]. For some polars only the largest lift is
#'   published.
#' - Spheres: measured values, whose drag falls beyond a Reynolds number of 2e5. codend's knots stay
#'   below that number.
#'
#' @param reynolds Reynolds number of twines and netting listed by angle, one number above 0. It
#'   refers to the twine diameter and the free flow. Default 1000.
#' @param solidity Solidity of the netting: one or more numbers from 0.01 to 0.5. Default 0.2.
#' @return A data frame of class `codend_coefficients`, one row per value. [plot()][codend_charts]
#'   draws it. Its columns are
#'
#'   - `force`, `law` (the drag model) and `by` (`"angle"` or `"reynolds"`);
#'   - `angle_deg`, `reynolds` and `solidity`, `NA` if irrelevant;
#'   - `coefficient` (`"drag"`, `"lift"` or `"speed"`) and `value`;
#'   - `source`, `NA` if the engine computed the value.
#' @seealso [board_polar()], [netting], [codend_charts]; the guide
#'   `vignette("drag-models", "codend")`.
#' @export
#' @examples
#' found <- force_coefficients()
#' subset(found, law == "hoerner" & angle_deg == 45)
force_coefficients <- function(reynolds = 1000, solidity = 0.2) {
  check_coefficient_arguments(reynolds, solidity)
  degree <- seq(0, 90, by = 2.5)
  radian <- function(x) from_unit(x, "deg")
  table <- c(
    lapply(drag_model_names("twine"), function(law) {
      found <- twine_specimens(law, radian(degree), reynolds, solidity[1])
      coefficient_rows("twine", law, "angle", degree, reynolds,
        if (law == "cifuentes_kim") solidity[1] else NA, found)
    }),
    lapply(drag_model_names("twine"), function(law) twine_by_reynolds(law, solidity[1])),
    unlist(lapply(solidity, function(sn) {
      lapply(drag_model_names("netting"), function(law) {
        found <- netting_specimens(law, radian(degree), reynolds, sn)
        coefficient_rows("netting", law, "angle", degree, reynolds, sn, found)
      })
    }), recursive = FALSE),
    Map(function(polar, name) {
      attack <- sort(unique(c(degree, polar$attack)))
      found <- board_specimens(name, radian(attack), 2)
      coefficient_rows(polar$force[1L], name, "angle", attack, NA, NA, found)
    }, published_polars, names(published_polars)),
    list(coefficient_rows("sphere", "knot", "reynolds", NA, reynolds_range(-1, 5), NA,
      sphere_specimens(reynolds_range(-1, 5))["drag"]),
    coefficient_rows("sphere", "smooth_sphere", "reynolds", NA, reynolds_range(-1, 6), NA,
      sphere_specimens(reynolds_range(-1, 6), smooth = TRUE)["drag"])),
    unlist(lapply(solidity, function(sn) {
      lapply(drag_model_names("wake"), function(law) {
        speed <- engine_speed_reduction(
          law, rep(sn, length(degree)), cos(radian(degree))
        )
        coefficient_rows("wake", law, "angle", degree, NA, sn, list(speed = speed))
      })
    }), recursive = FALSE)
  )
  table <- rbind(do.call(rbind, table), published_coefficients(solidity))
  structure(table, class = c("codend_coefficients", "data.frame"))
}

#' @rdname force_coefficients
#' @param x Coefficients.
#' @param n Largest number of printed lines. `Inf` prints all models.
#' @param ... Not used.
#' @export
print.codend_coefficients <- function(x, n = 30, ...) {
  by <- unique(x[c("force", "law", "coefficient")])
  rows <- match(do.call(paste, x[names(by)]), do.call(paste, by))
  count <- function(which) format(tabulate(rows[which], nrow(by)))
  range <- function(end) figures(as.double(tapply(x$value, rows, end)))
  lines <- align_columns(Map(c, c(names(by), "computed", "published", "least", "largest"),
    c(by, list(count(is.na(x$source)), count(!is.na(x$source)), range(min), range(max)))),
    left = 1:3)
  cat(nrow(x), " values of force coefficients\n", sep = "")
  cat(lines[1L], limited_lines(lines[-1L], n - 2), sep = "\n")
  invisible(x)
}

# Returns a logarithmic series between two powers of ten, ten values per decade.
reynolds_range <- function(from, to) 10^seq(from, to, by = 0.1)

twine_by_reynolds <- function(law, solidity) {
  reynolds <- reynolds_range(0, 6)
  found <- twine_specimens(law, rep(pi / 2, length(reynolds)), reynolds, solidity)
  coefficient_rows("twine", law, "reynolds", 90, reynolds,
    if (law == "cifuentes_kim") solidity else NA, found["drag"])
}

# found: list of values, named by coefficient.
coefficient_rows <- function(force, law, by, angle, reynolds, solidity, found) {
  do.call(rbind, lapply(names(found), function(coefficient) {
    data.frame(
      force = force, law = law, by = by, angle_deg = as.double(angle),
      reynolds = as.double(reynolds), solidity = as.double(solidity), coefficient = coefficient,
      value = found[[coefficient]], source = NA_character_
    )
  }))
}

# Returns the published values, for netting only at the given solidities.
published_coefficients <- function(solidity) {
  printed <- published_values
  printed <- printed[printed$force != "netting" | printed$solidity %in% solidity, ]
  by_reynolds <- printed$force == "sphere" | printed$law %in% c("takagi", "choo_casarella")
  printed$by <- ifelse(by_reynolds, "reynolds", "angle")
  printed$angle_deg[printed$force == "sphere"] <- NA
  printed[c("force", "law", "by", "angle_deg", "reynolds", "solidity", "coefficient", "value",
    "source")]
}

check_coefficient_arguments <- function(reynolds, solidity) {
  one <- is.numeric(reynolds) && length(reynolds) == 1L && is.finite(reynolds) && reynolds > 0
  if (!one) {
    abort_argument("{.arg reynolds} is {describe_value(reynolds)}; it must be one number above 0.")
  }
  good <- is.numeric(solidity) && length(solidity) >= 1L && all(is.finite(solidity)) &&
    all(solidity >= 0.01 & solidity <= 0.5)
  if (!good) {
    abort_argument("{.arg solidity} is {describe_value(solidity)}; it must be numbers from 0.01 to
      0.5.")
  }
}
