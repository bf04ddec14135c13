#' Measures of a state
#'
#' What the plan asks to be measured, and the measures that every gear has.
#'
#' Measures of the plan come first, under the plan's names with their unit added (`door_spread`
#' becomes `door_spread_m`):
#'
#' - `spread` (m): horizontal distance between two places, as an acoustic sensor tells it, or the mean
#'   over several pairs. In a straight tow that is the distance across it; in a turn, where one door
#'   runs ahead of the other, it stays that of the doors from each other.
#' - `height` (m): of the first place above the second. The height of a net's mouth is that of the
#'   head line's centre above the footrope's.
#' - `length` (m): straight distance between two places.
#' - `depth` (m): below the water surface.
#' - `clearance` (m): height above the sea bed, across it.
#' - `tension` (kN): of a rope at a place, or the largest along it. At its start or end it is that
#'   of its outermost bar.
#' - `area` (m2): enclosed by ropes end to end, seen level and from right ahead of them: along x in a
#'   straight tow, along the net's own heading in a turn. A gap between two ropes is closed by a
#'   straight line.
#' - `angle` (deg): of a rope's bar at a place, in its direction from start to end: below the
#'   horizontal (declination) or, in plan view, out of the vessel's centre line (divergence), in a
#'   turn too.
#' - `volume` (m3): within panels that follow each other around an opening, such as a cage's walls and
#'   bottom, closed by a lid from the rim of the opening to its middle; `volume_share` (percent): the
#'   same as a share of a volume `of`.
#' - `drag`, `lift` (kN): hydrodynamic force on ropes, panels and pieces together, along the flow and
#'   upwards.
#' - `attitude` (deg): of a free otter board, its angle of attack, heel (positive where its upper edge
#'   leans outward, so that its lift points down) or trim (positive where its leading edge is high).
#' - `sinking_speed` (m/s): downward speed of a place; 0 in a settled state.
#' - `enclosed_volume` (m3): of water that netting hanging from the surface encloses, down to a
#'   surface from a rope, such as the lead line, to that rope's middle. A gap between the two ends of
#'   the net is closed by an upright wall.
#'
#' Then follow, unless the plan has a measure of the same name:
#'
#' - `total_drag_kN`: pull of all supports on the gear against the flow. The flow runs along x past
#'   a towed gear, which is along the vessel's course, in a turn too; else along the fastest current,
#'   else along x.
#' - `tow_power_kW`, when towed: total drag times towing speed.
#' - `filtered_volume_m3_per_h`, when towed with a measure `mouth_area`: the water that flows through
#'   the ropes around it, which is that area times the water's speed, past the ropes as they move and
#'   at their mean depth, across it.
#' - `swept_area_km2_per_h`, when towed with a measure `wing_end_spread`: the ground that the lines
#'   between the wing ends pass over, which is that spread times their speed over the ground across
#'   them, the mean over its pairs.
#' - `catch_volume_m3` and `catch_front_meshes`, with a catch in netting ([catch]): the volume that
#'   the netting behind its front encloses, and how many meshes deep that is.
#' - `largest_rope_tension_kN`.
#' - `twine_tension_exceeded_by_1_percent_N`: tension of one twine (of both when double) that 1 % of
#'   the netting's length of twine exceeds. The very largest, where a rope pulls at the tip of a
#'   wing, depends on how finely the netting is divided.
#' - `slack_netting_percent`: share of the netting's length of twine that carries no tension.
#' - with a sea bed: `rope_on_ground_m` (length of rope, not of poles, that lies on it),
#'   `ground_load_kN` (what the gear presses on it with) and `ground_friction_percent` (share of
#'   friction in the total drag).
#' - `least_depth_m` and `greatest_depth_m`: depth of the highest and the lowest node of the gear.
#'
#' @param state A state, from [settle()].
#' @return Named numbers; every name ends in its unit.
#' @examples
#' measures(settle("crossing_cables"))
#' @export
measures <- function(state) {
  check_is_state(state)
  own <- plan_measures(state)
  general <- c(
    towing_measures(state, own), catch_measures(state), tension_measures(state),
    ground_measures(state),
    depth_measures(state)
  )
  c(own, general[setdiff(names(general), names(own))])
}

plan_measures <- function(state) {
  asked <- state$si$measures
  values <- vapply(asked, function(measure) {
    switch(measure$kind,
      spread = measure_spread(state, measure),
      height = measure_height(state, measure),
      length = measure_length(state, measure),
      depth = measure_depth(state, measure),
      clearance = measure_clearance(state, measure),
      tension = measure_tension(state, measure),
      area = measure_area(state, measure),
      angle = measure_angle(state, measure),
      attitude = measure_attitude(state, measure),
      volume = , volume_share = measure_volume(state, measure),
      drag = , lift = measure_part_force(state, measure),
      sinking_speed = measure_sinking_speed(state, measure),
      enclosed_volume = measure_enclosed_volume(state, measure)
    )
  }, 0)
  setNames(values, vapply(asked, `[[`, "", "column"))
}

catch_measures <- function(state) {
  if (is.null(state$si$catch)) return(NULL)
  c(
    catch_volume_m3 = catch_volume(state$lattice, state$position),
    catch_front_meshes = state$lattice$catch$blocked
  )
}

towing_measures <- function(state, own) {
  speed <- state$si$towing$speed
  pull <- colSums(reaction_table(state)[c("x_kN", "y_kN", "z_kN")])
  drag <- -sum(pull * flow_axes(state$si)[, "flow"])
  found <- c(total_drag_kN = drag)
  if (speed == 0) return(found)
  found[["tow_power_kW"]] <- drag * speed
  if ("mouth_area_m2" %in% names(own)) {
    found[["filtered_volume_m3_per_h"]] <-
      filtered_volume(state, state$si$measures$mouth_area$ropes) * 3600
  }
  if (identical(state$si$measures$wing_end_spread$kind, "spread")) {
    found[["swept_area_km2_per_h"]] <-
      swept_area(state, state$si$measures$wing_end_spread$pairs) * 3600 / 1e6
  }
  found
}

# Water (m3/s) that flows horizontally through ropes, end to end, as they move.
filtered_volume <- function(state, ropes) {
  node <- unique(unlist(lapply(ropes, function(rope) state$lattice$ropes[[rope]]$node)))
  outline <- rope_outline(state, ropes)
  past <- water_velocity(state, -mean(outline[3, ])) -
    rowMeans(state$velocity[1:2, node, drop = FALSE])
  abs(sum(outline_area(outline) * past))
}

# Velocity (m/s, along x and y) of the water past the vessel at a depth (m).
water_velocity <- function(state, depth) {
  water <- state$lattice$engine$water
  if (length(water$depth) == 1L) return(c(water$x, water$y))
  vapply(water[c("x", "y")], function(speed) {
    stats::approx(water$depth, speed, depth, rule = 2)$y
  }, 0, USE.NAMES = FALSE)
}

# Ground (m2/s) that the straight line between two places passes over, the mean over pairs.
swept_area <- function(state, pairs) {
  # the vessel goes towards -x
  over_ground <- state$velocity - c(state$si$towing$speed, 0, 0)
  mean(vapply(pairs, function(pair) {
    across <- apart(state, pair)
    ends <- vapply(pair, state$lattice$place, 0L)
    v <- rowMeans(over_ground[, ends])
    abs(across[1] * v[2] - across[2] * v[1])
  }, 0))
}

tension_measures <- function(state) {
  lines <- state_lines(state)
  netting <- state$lattice$parts$kind[lines$part] == "netting"
  found <- numeric()
  if (any(!netting)) found[["largest_rope_tension_kN"]] <- max(lines$tension[!netting]) / 1000
  if (any(netting)) {
    twine <- lines[netting, ]
    long <- twine$lines * twine$rest
    found[["twine_tension_exceeded_by_1_percent_N"]] <- exceeded_tension(twine$tension, long)
    found[["slack_netting_percent"]] <- 100 * sum(long[twine$tension == 0]) / sum(long)
  }
  found
}

ground_measures <- function(state) {
  if (is.null(state$si$ground)) return(numeric())
  forces <- ground_forces(state)
  pull <- colSums(reaction_table(state)[c("x_kN", "y_kN", "z_kN")])
  drag <- -1000 * sum(pull * flow_axes(state$si)[, "flow"])
  c(
    rope_on_ground_m = forces$length, ground_load_kN = forces$normal / 1000,
    ground_friction_percent = 100 * forces$along_flow / drag
  )
}

depth_measures <- function(state) {
  depth <- -range(state$position[3, ])
  # adding 0 turns the -0 of a node at the surface into 0
  c(least_depth_m = depth[2], greatest_depth_m = depth[1]) + 0
}

# Units of measures as their names spell them, longest first, with the units as printed.
measure_suffixes <- c(
  m_per_s = "m/s", km2_per_h = "km2/h", m3_per_h = "m3/h", percent = "%", deg = "deg", kN = "kN", kW = "kW",
  m2 = "m2", m3 = "m3", meshes = "meshes", m = "m", N = "N"
)

# Splits names such as "door_spread_m" into words ("door spread") and unit ("m").
measure_words <- function(names) {
  pattern <- paste0("_(", paste(names(measure_suffixes), collapse = "|"), ")$")
  suffix <- regmatches(names, regexpr(pattern, names))
  list(
    words = gsub("_", " ", sub(pattern, "", names)),
    unit = unname(measure_suffixes[substring(suffix, 2)])
  )
}

# What the command line writes as JSON: whether and how the gear settled, the lattice's size, and
# the measures by name.
state_record <- function(state) {
  engine <- state$lattice$engine
  list(
    converged = state$report$converged, iterations = state$report$iterations,
    residual = state$report$residual,
    nodes = engine$nodes, bars = length(engine$bars$rest),
    triangles = length(engine$triangles$rest),
    cpu_seconds = state$report$cpu_seconds,
    measures = as.list(measures(state))
  )
}
