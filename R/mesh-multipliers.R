# Multipliers of force components, for uncertain drag, lift and friction coefficients. Forces are
# linear in each multiplier.

# Description of each multiplier, in schema order.
force_multipliers <- c(
  rope_normal_drag = "drag of ropes across their axis",
  rope_tangential_drag = "drag of ropes along their axis",
  twine_normal_drag = "drag of netting across its twines",
  twine_tangential_drag = "drag of netting along its twines",
  screen_drag = "drag of netting as a screen",
  screen_lift = "lift of netting as a screen",
  knot_drag = "drag of knots",
  mesh_opening = "opening stiffness of meshes",
  float_drag = "drag of floats",
  piece_drag = "drag of weights and other pieces",
  board_lift = "lift of boards, kites and canvas",
  board_drag = "drag of boards, kites and canvas",
  ground_friction = "friction on the sea bed",
  ground_gear_weight = "weight of ground gear in water"
)

# Roles of ropes and pieces that count as ground gear.
ground_roles <- c("ground_gear", "footrope_extension", "tickler", "disc", "bobbin")

# Returns the numbers of a gear, list(gear, model), with multiplied force components. `by`:
# multipliers named as in `force_multipliers`, by default the gear's. Neutral multipliers return the
# numbers unchanged, bit for bit.
multiplied_numbers <- function(numbers, si, by = unlist(si$multipliers)) {
  if (length(by)) by <- by[by != 1]
  if (!length(by)) return(numbers)
  factor <- function(name) if (name %in% names(by)) by[[name]] else 1
  gear <- numbers$gear
  model <- numbers$model
  gear$ropes <- Map(function(rope, from) {
    rope$friction <- factor("ground_friction") * rope$friction
    if (from$role %in% ground_roles) rope$weight_factor <- factor("ground_gear_weight")
    rope
  }, gear$ropes, unname(si$ropes))
  gear$panels$knot_drag <- factor("knot_drag") * gear$panels$knot_drag
  gear$panels$opening_couple <- factor("mesh_opening") * gear$panels$opening_couple
  gear$pieces <- Map(function(piece, from) {
    lifts <- c("lift_area", "upward_lift_area")
    drag <- if (any(unlist(piece[lifts]) != 0)) "board_drag" else
      if (from$role %in% "float") "float_drag" else "piece_drag"
    piece$drag_area <- factor(drag) * piece$drag_area
    piece[lifts] <- lapply(piece[lifts], `*`, factor("board_lift"))
    piece
  }, gear$pieces, unname(si$pieces))

  by_line <- function(ropes, twines) {
    rep(c(factor(ropes), factor(twines), 1),
      c(length(si$ropes), length(si$panels), length(si$otter_boards)))
  }
  model$multipliers <- list(
    normal = by_line("rope_normal_drag", "twine_normal_drag"),
    blended_normal = factor("twine_normal_drag"),
    screen_drag = factor("screen_drag"), screen_lift = factor("screen_lift")
  )
  model$materials$tangential_share <- model$materials$tangential_share *
    by_line("rope_tangential_drag", "twine_tangential_drag")
  model$blended$tangential_share <-
    factor("twine_tangential_drag") * model$blended$tangential_share
  model$plates <- lapply(model$plates, function(plate) {
    for (way in c("lift", "drag")) {
      columns <- paste0(way, c("", "_slope"))
      plate$polar[columns] <- lapply(plate$polar[columns], `*`, factor(paste0("board_", way)))
    }
    rubs <- c("friction_along", "friction_across")
    plate[rubs] <- lapply(plate[rubs], `*`, factor("ground_friction"))
    plate
  })
  if (!is.null(model$ground)) {
    model$ground$friction <- factor("ground_friction") * model$ground$friction
  }
  list(gear = gear, model = model)
}
