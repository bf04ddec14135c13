# Returns the engine's table of materials, as columns: one row per rope and per panel's twine.
# `alone`: the lines of netting with a screen or blended model carry only its friction, because its
# cells carry the other drag. FALSE: the twines of its cells, without this friction.
twine_materials <- function(lines, alone = TRUE) {
  number <- function(field) vapply(lines, `[[`, 0, field, USE.NAMES = FALSE)
  laws <- lapply(lines, `[[`, "coefficients")
  drag <- vapply(lines, function(line) first_of(line$netting_drag, "morison"), "")
  screens <- alone & drag != "morison"
  coefficient <- function(field) {
    given <- vapply(laws, `[[`, 0, field, USE.NAMES = FALSE)
    replace(given, is.na(given), 0)
  }
  skin <- coefficient("skin")
  # Friction along the flow that the drag model of the netting lacks.
  friction <- as.numeric(drag_model_column("skin", "netting")[drag])
  own <- !is.na(friction) & skin > 0
  friction[own] <- skin[own]
  friction[is.na(friction)] <- 0
  law <- vapply(laws, `[[`, "", "law", USE.NAMES = FALSE)
  law[screens] <- "constant"
  added_mass <- function(way) {
    vapply(lines, function(line) line$added_mass[[way]], 0, USE.NAMES = FALSE)
  }
  slides <- lengths(lapply(lines, `[[`, "through")) > 0L
  stiffness <- number("axial_stiffness")
  stiffness[slides] <- 0
  damping <- vapply(lines, function(line) first_of(line$damping, 0), 0, USE.NAMES = FALSE)
  damping[slides] <- 0
  list(
    axial_stiffness = stiffness, damping = damping,
    diameter = vapply(lines, function(line) first_of(line$diameter, twine_width(line)), 0,
      USE.NAMES = FALSE),
    volume_per_length = number("volume_per_length"),
    added_mass_normal = added_mass("normal"), added_mass_tangential = added_mass("tangential"),
    law = law, strut = vapply(lines, function(line) isTRUE(line$strut), NA, USE.NAMES = FALSE),
    normal = replace(coefficient("normal"), screens, 0),
    tangential = replace(coefficient("tangential"), screens, 0),
    skin = if (alone) replace(skin, screens, friction[screens]) else skin - friction,
    tangential_share = rep(1, length(lines)),
    solidity = vapply(lines, function(line) {
      if (is.null(line$mesh_size)) 0 else panel_solidity(line)
    }, 0, USE.NAMES = FALSE)
  )
}

# Returns the solidity Sn of a panel at the nominal hanging ratio: d / (a E1 E2) for diamond netting
# with bars a, and 2 d/a - (d/a)^2 for square netting.
panel_solidity <- function(panel) {
  # Hexagonal netting counts as diamonds of the same mesh size.
  ratio <- twine_width(panel) / (panel$mesh_size / 2)
  if (panel$orientation == "square") return(2 * ratio - ratio^2)
  min(1, ratio / (nominal_hanging_ratio * nominal_depth_ratio))
}
