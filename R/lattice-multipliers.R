# Multipliers of components of force: what of the laws of drag, lift and friction is uncertain as a
# whole. Forces are linear in each, so that a component is the difference of two evaluations.

# What each multiplies, in words; in the order of the schema.
force_multipliers <- c(
  rope_normal_drag = "drag of ropes across their axis",
  rope_tangential_drag = "drag of ropes along their axis",
  twine_normal_drag = "drag of netting across its twines",
  twine_tangential_drag = "drag of netting along its twines",
  screen_drag = "drag of netting as a screen",
  screen_lift = "lift of netting as a screen",
  knot_drag = "drag of knots",
  mesh_opening = "stiffness of meshes against opening",
  float_drag = "drag of floats",
  piece_drag = "drag of weights and other pieces",
  board_lift = "lift of boards, kites and canvas",
  board_drag = "drag of boards, kites and canvas",
  ground_friction = "friction on the sea bed",
  ground_gear_weight = "weight of ground gear in water"
)

# Roles of ropes and pieces that are ground gear.
ground_roles <- c("ground_gear", "footrope_extension", "tickler", "disc", "bobbin")

# The engine's numbers of a lattice with components of force multiplied, on top of what they are.
# by: named factors, as force_multipliers; none or all 1: as it is, to the bit. weight: of ground
# gear, by which it is multiplied already.
multiplied_engine <- function(lattice, si, by, weight = 1) {
  engine <- lattice$engine
  by <- by[by != 1]
  if (!length(by)) return(engine)
  factor <- function(name) if (name %in% names(by)) by[[name]] else 1
  ropes <- seq_along(si$ropes)
  panels <- length(si$ropes) + seq_along(si$panels)
  set <- function(values, at, by) {
    values[at] <- by * values[at]
    values
  }
  of_engine <- c("rope_normal_drag", "twine_normal_drag", "screen_drag", "screen_lift")
  if (any(of_engine %in% names(by))) {
    own <- engine$multipliers
    if (is.null(own)) {
      own <- list(normal = rep(1, length(engine$materials$normal)), blended_normal = 1,
        screen_drag = 1, screen_lift = 1)
    }
    own$normal <- set(own$normal, ropes, factor("rope_normal_drag"))
    own$normal <- set(own$normal, panels, factor("twine_normal_drag"))
    own$blended_normal <- own$blended_normal * factor("twine_normal_drag")
    own$screen_drag <- own$screen_drag * factor("screen_drag")
    own$screen_lift <- own$screen_lift * factor("screen_lift")
    engine$multipliers <- own
  }
  along <- engine$materials$tangential_share
  along <- set(along, ropes, factor("rope_tangential_drag"))
  engine$materials$tangential_share <- set(along, panels, factor("twine_tangential_drag"))
  engine$blended$materials$tangential_share <-
    factor("twine_tangential_drag") * engine$blended$materials$tangential_share

  kind <- sphere_kinds(lattice)
  engine$spheres$drag_area <- engine$spheres$drag_area *
    vapply(c("knot_drag", "float_drag", "piece_drag", "board_drag"), factor, 0)[kind]
  engine$openings$couple <- factor("mesh_opening") * engine$openings$couple
  engine$lifts$lift_area <- factor("board_lift") * engine$lifts$lift_area
  engine$plates <- lapply(engine$plates, function(plate) {
    for (way in c("lift", "drag")) {
      columns <- paste0(way, c("", "_slope"))
      plate$polar[columns] <- lapply(plate$polar[columns], `*`, factor(paste0("board_", way)))
    }
    rubs <- c("friction_along", "friction_across")
    plate[rubs] <- lapply(plate[rubs], `*`, factor("ground_friction"))
    plate
  })
  if (!is.null(engine$line_friction)) {
    rubs <- c("along", "across")
    engine$line_friction[rubs] <-
      lapply(engine$line_friction[rubs], `*`, factor("ground_friction"))
  }
  engine["ground"] <- list(multiplied_ground(engine$ground, by))
  more <- weight * (factor("ground_gear_weight") - 1)
  if (more != 0) {
    z <- seq(3L, length(engine$load), by = 3L)
    engine$load[z] <- engine$load[z] + more * ground_gear_load(lattice, si)
  }
  engine
}

multiplied_ground <- function(ground, by) {
  if (is.null(ground) || !"ground_friction" %in% names(by)) return(ground)
  ground$friction <- by[["ground_friction"]] * ground$friction
  ground
}

# Of every body without lift of its own: 1 a knot, 2 a float, 3 another piece, 4 of a board.
sphere_kinds <- function(lattice) {
  part <- lattice$sphere_part
  kind <- ifelse(lattice$parts$kind[part] == "netting", 1L, 3L)
  kind[lattice$parts$role[part] %in% "float"] <- 2L
  kind[part %in% lattice$lift_part] <- 4L
  kind
}

# Upward loads (N, per point) of the weight in water of ropes that are ground gear.
ground_gear_load <- function(lattice, si) {
  bars <- lattice$engine$bars
  some <- which(lattice$parts$role[lattice$bar_part] %in% ground_roles &
    lattice$parts$kind[lattice$bar_part] == "rope")
  rope <- lattice$bar_part[some]
  line <- function(field) vapply(si$ropes, `[[`, 0, field)[rope]
  per_metre <- line("mass_per_length") - si$water$density * line("volume_per_length")
  half <- -gear_gravity * per_metre * bars$rest[some] * bars$multiplicity[some] / 2
  node <- matrix(bars$node, 2L)[, some, drop = FALSE]
  sum_by(rep(half, each = 2L), as.vector(node), length(lattice$engine$load) / 3)
}
