# Forces of a state: tensions, drag by component, support reactions and their sum.

# Returns tensions at both ends of rope bars [N], 2 x bars.
end_tensions <- function(state, bars) {
  mesh <- state$mesh
  matrix(engine_end_tensions(mesh$model, shape_of(state), as.integer(bars)), 2L)
}

# Returns the hydrodynamic force on each part [N], 3 x parts. Knots belong to their panel.
part_drag <- function(state) matrix(engine_part_forces(state$mesh$model, shape_of(state)), 3L)

# Returns unit vectors as columns: along the flow, across it to starboard, and up. Towed gears: the
# flow is along x. Fixed gears: along the fastest current of the profile, or along x in still water.
flow_axes <- function(si) {
  flow <- c(1, 0)
  current <- si$water$current
  speed <- current_speeds(si)
  if (si$towing$speed == 0 && max(speed) > 0) {
    k <- which.max(speed)
    flow <- c(current$x[k], current$y[k]) / speed[k]
  }
  cbind(flow = c(flow, 0), across = c(-flow[2], flow[1], 0), up = c(0, 0, 1))
}

# Sums columns by part: 3 x parts.
sum_by_part <- function(force, part, parts) {
  total <- matrix(0, 3L, parts)
  if (length(part)) {
    sums <- rowsum(t(force), part)
    total[, as.integer(rownames(sums))] <- t(sums)
  }
  total
}

# Returns the weight in water of each part [N]: weight less buoyancy, negative for floating parts.
# Ropes and panels (with knots) use their length in the mesh, which is shorter for gathered ropes.
part_weight <- function(state) {
  si <- state$si
  lines <- state_lines(state)
  length <- numeric(nrow(state$mesh$parts))
  sums <- rowsum(lines$lines * lines$rest, lines$part)
  length[as.integer(rownames(sums))] <- sums
  for (p in seq_along(si$panels)) {
    panel <- si$panels[[p]]
    length[length(si$ropes) + p] <- panel_bars(panel) * cell_twine_with_knots(panel)
  }
  excess <- function(mass, volume) mass - si$water$density * volume
  each <- c(
    vapply(c(si$ropes, si$panels), function(x) excess(x$mass_per_length, x$volume_per_length), 0),
    vapply(c(si$pieces, si$otter_boards), function(x) excess(x$mass, x$volume), 0),
    if (!is.null(si$catch)) 0
  )
  pieces <- c(
    vapply(si$pieces, function(x) as.double(x$number), 0), rep(1, length(si$otter_boards))
  )
  length[seq_along(pieces) + length(si$ropes) + length(si$panels)] <- pieces
  gear_gravity * unname(each) * length
}

# Returns the forces that belong to no part [N]: a row per cause, without rows of zeros. In motion,
# the supports also pull the free nodes' inertia.
outer_forces <- function(state) {
  loads <- vapply(state$si$points, function(point) as.double(point$load), numeric(3))
  free <- !state$mesh$model$held
  forces <- rbind(
    loads = rowSums(loads), sea_bed = total_force(state, "ground"),
    out_of_water = total_force(state, "surface"),
    inertia = if (!is.null(state$time)) -rowSums(state$force[, free, drop = FALSE])
  )
  forces[rowSums(forces != 0) > 0, , drop = FALSE]
}

# Returns a data frame: one row per rope, panel and piece, and for the catch in netting. Columns:
# part, kind (rope, netting, piece, catch), role, and forces in kN. drag: along the flow; side: to
# starboard; lift: up; weight in water.
part_force_table <- function(state) {
  force <- in_unit(t(flow_axes(state$si)) %*% part_drag(state), "kN")
  data.frame(
    part = state$mesh$parts$name, kind = state$mesh$parts$kind,
    role = state$mesh$parts$role,
    drag_kN = force[1, ], side_kN = force[2, ], lift_kN = force[3, ],
    weight_in_water_kN = in_unit(part_weight(state), "kN")
  )
}

# Returns the same with a row per outer force. The sum of `drag_kN` is the total drag.
drag_table <- function(state) {
  outer <- outer_forces(state)
  force <- in_unit(outer %*% flow_axes(state$si), "kN")
  cause <- gsub("_", " ", rownames(outer))
  rbind(part_force_table(state), data.frame(
    part = cause, kind = cause, role = rep(NA_character_, length(cause)), drag_kN = force[, 1],
    side_kN = force[, 2], lift_kN = force[, 3], weight_in_water_kN = rep(0, length(cause)),
    row.names = NULL
  ))
}

# Returns totals of a drag table by group and overall. Pieces other than otter boards and catch are
# "fittings".
drag_totals <- function(drag) {
  of_kind <- c(netting = "netting", rope = "ropes", piece = "fittings")
  group <- ifelse(drag$kind %in% names(of_kind), of_kind[drag$kind], drag$kind)
  group[drag$role %in% "otter_board"] <- "otter boards"
  group[drag$role %in% "catch"] <- "catch"
  forces <- c("drag_kN", "side_kN", "lift_kN", "weight_in_water_kN")
  groups <- intersect(c("netting", "ropes", "otter boards", "catch", "fittings", group), group)
  sums <- rowsum(as.matrix(drag[forces]), factor(group, levels = groups))
  total <- rbind(sums, total = colSums(sums))
  data.frame(group = rownames(total), total, row.names = NULL)
}

# Returns the force of each support on the gear [N], 3 x supports. The vessel pulls a warp forward
# (negative x). A load on an edge between two supports is split between them as on a simply
# supported beam.
support_forces <- function(state) {
  held <- names(Filter(function(point) !is.na(point$held), state$si$points))
  node <- vapply(held, function(name) state$mesh$points[[name]], 0L)
  force <- -state$force[, node, drop = FALSE]
  for (edge in state$mesh$held_edges) {
    inner <- -c(1L, length(edge$node))
    on_edge <- -state$force[, edge$node[inner], drop = FALSE]
    share <- rbind(1 - edge$at[inner], edge$at[inner])
    at <- match(edge$between, held)
    force[, at] <- force[, at] + on_edge %*% t(share)
  }
  colnames(force) <- held
  force
}

# Returns a data frame: one row per support, force in kN along x (aft), y (starboard) and z (up).
reaction_table <- function(state) {
  force <- in_unit(support_forces(state), "kN")
  data.frame(point = colnames(force), x_kN = force[1, ], y_kN = force[2, ], z_kN = force[3, ],
    row.names = NULL)
}

# Returns a data frame of all forces on the gear [kN] and their sum, `remainder`. The remainder is
# zero within the solver's tolerance.
balance_table <- function(state) {
  forces <- rbind(
    reactions = rowSums(support_forces(state)),
    hydrodynamic = rowSums(part_drag(state)),
    weight_in_water = c(0, 0, -sum(part_weight(state))),
    outer_forces(state)
  )
  forces <- in_unit(forces, "kN")
  forces <- rbind(forces, remainder = colSums(forces))
  colnames(forces) <- c("x_kN", "y_kN", "z_kN")
  data.frame(force = rownames(forces), forces, row.names = NULL)
}

# Returns a data frame: one row per rope and panel, tensions of one line [kN]. `max`: largest value;
# `most_loaded`: mean over the most loaded tenth of the length; `mean`: mean over the length.
# `strength`: breaking load, NA if unknown; `strength_percent`: largest tension over strength. At a
# point load on netting, `max` grows with each mesh refinement; the means converge.
tension_table <- function(state) {
  parts <- state$mesh$parts
  lines <- state_lines(state)
  part <- sort(unique(lines$part))
  strength <- vapply(state$si$ropes, function(rope) as.double(rope$strength), 0)
  strength <- c(strength, rep(NA_real_, length(state$si$panels)))[part]
  long <- lines$lines * lines$rest
  largest <- lines$tension
  rope <- parts$kind[lines$part] == "rope"
  ends <- end_tensions(state, lines$element[rope])
  largest[rope] <- pmax(ends[1L, ], ends[2L, ])
  largest <- vapply(split(largest, lines$part), max, 0)
  most_loaded <- mapply(most_loaded_tension, split(lines$tension, lines$part),
    split(long, lines$part))
  sums <- rowsum(cbind(lines$tension * long, long), lines$part)
  mean <- sums[, 1L] / sums[, 2L]
  data.frame(
    part = parts$name[part], kind = parts$kind[part], role = parts$role[part],
    max_kN = in_unit(unname(largest), "kN"), most_loaded_kN = in_unit(unname(most_loaded), "kN"),
    mean_kN = in_unit(unname(mean), "kN"), strength_kN = in_unit(unname(strength), "kN"),
    strength_percent = in_unit(unname(largest / strength), "%"), row.names = NULL
  )
}

# Fraction of the length in most_loaded_tension().
loaded_most <- 0.1

# Returns the mean tension over the most loaded fraction of the length.
most_loaded_tension <- function(tension, long) {
  falling <- order(tension, decreasing = TRUE)
  whole <- loaded_most * sum(long)
  before <- cumsum(long[falling]) - long[falling]
  sum(tension[falling] * pmin(long[falling], pmax(whole - before, 0))) / whole
}

# Returns a data frame: one row per panel, length of twine [m] and slack fraction [percent].
slack_table <- function(state) {
  lines <- state_lines(state)
  parts <- state$mesh$parts
  lines <- lines[parts$kind[lines$part] == "netting", ]
  twine <- lines$lines * lines$rest
  sums <- rowsum(cbind(twine, twine * (lines$tension == 0)), lines$part)
  part <- as.integer(rownames(sums))
  data.frame(
    part = parts$name[part], role = parts$role[part], twine_m = sums[, 1],
    slack_percent = in_unit(sums[, 2] / sums[, 1], "%"), row.names = NULL
  )
}
