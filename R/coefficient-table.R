# The coefficients that forces are computed with, as the engine returns them.

#' Coefficients of the forces
#'
#' Every named law's coefficients by angle or by Reynolds number, found by putting single twines,
#' pieces of netting, otter boards, kites and spheres into the same code that settles a gear, next
#' to what is published for them.
#'
#' @section What is computed:
#' Drag is along the flow, lift across it in the plane of the flow and the axis or the normal.
#'
#' | force | angle | coefficients on |
#' |---|---|---|
#' | `twine` | between the axis and the flow | diameter times length |
#' | `netting` | between the normal and the flow | area of the netting |
#' | `otter_board`, `kite` | of attack, between the chord and the flow | its area |
#' | `sphere` | none | projected area |
#' | `wake` | between the normal and the flow | `speed`: of the flow behind over that before it |
#'
#' Twines across the flow (90 deg) and spheres are also given by their Reynolds number. Netting is
#' square and knotless, of twine of 2 mm; `twines` and `blended` sum over twines of the set
#' `bessonneau_marichal`.
#'
#' @section What is published:
#' Formulas: the values of the same formulas in H. Cheng's program (github.com/hui-aqua/hydromodel),
#' which share no code with codend. `takagi` is printed with a jump at a Reynolds number of 200 and
#' `choo_casarella` with small ones at 1, 30 and 2.33e5, which codend does without. Otter boards and
#' kites: see [board_polar()]; of some only the largest lift is printed. Spheres: measured ones,
#' whose drag falls beyond a Reynolds number of 2e5; codend's knots never reach that.
#'
#' @param reynolds Reynolds number of twines and netting by angle, on the twine's diameter and the
#'   free flow.
#' @param solidity Of netting, 0.01 to 0.5: any number of values.
#' @return A data frame of class `codend_coefficients`, a row per value: `force`, `law`, `by`
#'   (`"angle"` or `"reynolds"`), `angle_deg`, `reynolds`, `solidity` (NA where they do not matter),
#'   `coefficient` (`"drag"`, `"lift"` or `"speed"`), `value`, and `source`: NA where the engine
#'   computed it. [plot()][codend_charts] draws it.
#' @export
#' @examples
#' found <- force_coefficients()
#' subset(found, law == "hoerner" & angle_deg == 45)
force_coefficients <- function(reynolds = 1000, solidity = 0.2) {
  check_coefficient_arguments(reynolds, solidity)
  degree <- seq(0, 90, by = 2.5)
  radian <- function(x) from_unit(x, "deg")
  table <- c(
    lapply(law_names("twine"), function(law) {
      found <- twine_specimens(law, radian(degree), reynolds, solidity[1])
      coefficient_rows("twine", law, "angle", degree, reynolds,
        if (law == "cifuentes_kim") solidity[1] else NA, found)
    }),
    lapply(law_names("twine"), function(law) twine_by_reynolds(law, solidity[1])),
    unlist(lapply(solidity, function(sn) {
      lapply(law_names("netting"), function(law) {
        found <- netting_specimens(law, radian(degree), reynolds, sn)
        coefficient_rows("netting", law, "angle", degree, reynolds, sn, found)
      })
    }), recursive = FALSE),
    lapply(names(published_polars), function(name) {
      attack <- sort(unique(c(degree, published_polars[[name]]$values$attack)))
      found <- board_specimens(name, radian(attack), 2)
      coefficient_rows(polar_force(name), name, "angle", attack, NA, NA, found)
    }),
    list(coefficient_rows("sphere", "knot", "reynolds", NA, reynolds_range(-1, 5), NA,
      sphere_specimens(reynolds_range(-1, 5))["drag"]),
    coefficient_rows("sphere", "smooth_sphere", "reynolds", NA, reynolds_range(-1, 6), NA,
      sphere_specimens(reynolds_range(-1, 6), smooth = TRUE)["drag"])),
    unlist(lapply(solidity, function(sn) {
      lapply(law_names("wake"), function(law) {
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

# Ten a decade, between powers of ten.
reynolds_range <- function(from, to) 10^seq(from, to, by = 0.1)

polar_force <- function(name) if (name == "fabric_kite") "kite" else "otter_board"

twine_by_reynolds <- function(law, solidity) {
  reynolds <- reynolds_range(0, 6)
  found <- twine_specimens(law, rep(pi / 2, length(reynolds)), reynolds, solidity)
  coefficient_rows("twine", law, "reynolds", 90, reynolds,
    if (law == "cifuentes_kim") solidity else NA, found["drag"])
}

# found: list(coefficient = values).
coefficient_rows <- function(force, law, by, angle, reynolds, solidity, found) {
  do.call(rbind, lapply(names(found), function(coefficient) {
    data.frame(
      force = force, law = law, by = by, angle_deg = as.double(angle),
      reynolds = as.double(reynolds), solidity = as.double(solidity), coefficient = coefficient,
      value = found[[coefficient]], source = NA_character_
    )
  }))
}

# What is printed, of netting at these solidities.
published_coefficients <- function(solidity) {
  file <- system.file("extdata", "published-coefficients.csv", package = "codend")
  printed <- utils::read.csv(file)
  of_netting <- printed$force == "netting"
  printed <- printed[!of_netting | printed$solidity %in% solidity, ]
  along_reynolds <- printed$force == "sphere" |
    printed$law %in% c("takagi", "choo_casarella")
  printed$by <- ifelse(along_reynolds, "reynolds", "angle")
  printed$angle_deg[printed$force == "sphere"] <- NA
  boards <- do.call(rbind, lapply(names(published_polars), function(name) {
    polar <- published_polars[[name]]
    rows <- coefficient_rows(polar_force(name), name, "angle", polar$values$attack, NA, NA,
      polar$values[c("drag", "lift")])
    rows$source <- polar$source
    rows
  }))
  rbind(boards, printed[names(boards)])
}

check_coefficient_arguments <- function(reynolds, solidity) {
  one <- is.numeric(reynolds) && length(reynolds) == 1L && is.finite(reynolds) && reynolds > 0
  if (!one) {
    abort_argument("{.arg reynolds} is {.val {reynolds}}; it must be one number above 0.")
  }
  good <- is.numeric(solidity) && length(solidity) >= 1L && all(is.finite(solidity)) &&
    all(solidity >= 0.01 & solidity <= 0.5)
  if (!good) {
    abort_argument("{.arg solidity} is {said_value(solidity)}; it must be numbers from 0.01 to
      0.5.")
  }
}
