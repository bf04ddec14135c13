#' Tables of a state
#'
#' A state is the result of [settle()]: a gear in balance. These tables hold all its numbers;
#' columns end in their unit. x points aft (with the flow past a towed gear), y to starboard, z up
#' from the water surface.
#'
#' @details
#' A state is a list of class `codend_state` with these fields:
#'
#' - `gear`: the gear; `si`: its plan in SI units with every default filled in.
#' - `lattice`: the gear as nodes and elements, class `codend_lattice`.
#' - `report`: the solver's report: `converged`, `iterations`, `factorisations`,
#'   `force_evaluations`, `factor_entries` (numbers that the matrix factors store), `residual`
#'   (largest net force on a free node as a share of the largest tension), `largest_tension` (N),
#'   `worst_node`, `worst_force` (N), `part_residual` (largest net force beyond rounding as a share
#'   of the largest force on a line of its part) and `worst_part` (which that is),
#'   `part_rounding` and `rounding_part` (the same of what rounding of places makes),
#'   `cpu_seconds` and seconds by step.
#' - `position` (3 x nodes, m) and `force` (3 x nodes, N): the net force on each node; on a held
#'   node the reaction of its support is the opposite.
#' - `bar_tension` (N, of one line), `bar_length` (m), and of the two families of twine in every
#'   netting cell `u_tension`, `u_length`, `v_tension`, `v_length` (of one mesh bar).
#' - `straight_tension`, `straight_length`: the same of the straight bars of hexagonal meshes, 0 in
#'   other cells.
#' - `forces`: force on every element (3 x elements, N) by name: from the flow `bar_drag`,
#'   `cell_drag`, `screen_force`, `blended_force`, `sphere_drag`, `lift_force`, `plate_force`
#'   (free otter boards and kites) and `pressure_force` (of the catch); from the sea bed
#'   `contact_force` and `plate_ground_force`; buoyancy lost above the surface `volume_force`
#'   and `plate_lost_buoyancy`.
#'
#' @param x A state.
#' @param row.names `NULL` or names for the rows.
#' @param optional Not used.
#' @param what Which table (give it by name, as `what = "drag"`):
#'
#'   - `"tensions"`: a row per bar and per family of twine in every netting cell: `part`, `kind`
#'     (rope or netting), `role`, `element` (number of the bar or cell), `family` (bar, u or v;
#'     straight in hexagonal meshes),
#'     its middle `x_m`, `y_m`, `z_m`, `length_m` and `tension_kN` of one line, `lines` (how many
#'     run in parallel) and `slack` (no tension).
#'   - `"nodes"`: `node`, `x_m`, `y_m`, `z_m`, `parts` (names of the ropes and panels that meet
#'     there) and `held`.
#'   - `"measures"`: `measure`, `value`, `unit` and `error` of discretisation ([measures()]).
#'   - `"drag"`: a row per rope, panel and piece, and for the catch in netting: `part`, `kind`,
#'     `role`, hydrodynamic force as `drag_kN` (along the flow), `side_kN` (to starboard of it) and
#'     `lift_kN` (up), and `weight_in_water_kN` (weight less buoyancy).
#'   - `"pieces"`: a row per piece at a place, such as every hook of a longline: `part`, `role`,
#'     `number` (how many sit there), `x_m`, `y_m`, `z_m` and `depth_m`.
#'   - `"boards"`: a row per otter board whose attitude is free, and per kite or depressor: `board`,
#'     `attack_deg`, `stall_deg` (angle of attack of its polar's largest lift), `heel_deg` (positive
#'     where its upper edge leans outward; of a kite where its starboard end is high), `trim_deg`
#'     (positive where its leading edge is high), `lift_kN` (across the flow), `drag_kN`,
#'     `ground_load_kN` (upward force of the sea bed) and `condition`: `"flying"`, `"stalled"`
#'     (attack beyond that of the largest lift), `"back-winded"` (flow on the outer face) or
#'     `"fallen over"` (heel beyond 45 deg).
#'   - `"reactions"`: force of every support on the gear: `point`, `x_kN`, `y_kN`, `z_kN`. The two
#'     points of an edge held between them share what pulls at it, as the supports of a beam do.
#' @param ... Not used.
#' @return A data frame.
#' @examples
#' state <- settle("crossing_cables")
#' as.data.frame(state, what = "reactions")
#' head(as.data.frame(state, what = "tensions"))
#'
#' # a kite of 1 m by 2 m on two front lines and one behind
#' on_lines <- function(from, to, length) {
#'   rope(from, to, length = length, diameter = "5 mm", material = "hmpe", segments = 1)
#' }
#' flown <- gear("A kite on three lines", towing = list(speed = "2 m/s"),
#'   block_port = gear_point(position = c(0, -0.6, -100), held = "moved"),
#'   block_starboard = gear_point(position = c(0, 0.6, -100), held = "moved"),
#'   port = gear_point(), starboard = gear_point(), tail = gear_point(),
#'   front_port = on_lines("block_port", "port", "0.99 m"),
#'   front_starboard = on_lines("block_starboard", "starboard", "0.99 m"),
#'   rear_port = on_lines("block_port", "tail", "1.293 m"),
#'   rear_starboard = on_lines("block_starboard", "tail", "1.293 m"),
#'   kite = kite(pushes = "up", chord = "1 m", span = "2 m", mass = "20 kg", volume = "0.03 m3",
#'     polar = "flat_plate", attachments = list(port = list(aft = "0.1 m", starboard = "-0.6 m"),
#'       starboard = list(aft = "0.1 m", starboard = "0.6 m"), tail = list(aft = "0.8 m"))))
#' as.data.frame(settle(flown), what = "boards")
#' @export
as.data.frame.codend_state <- function(x, row.names = NULL, optional = FALSE,
                                       what = c("tensions", "nodes", "measures", "drag",
                                                "pieces", "boards", "reactions"), ...) {
  tables <- c("tensions", "nodes", "measures", "drag", "pieces", "boards", "reactions")
  table <- switch(chosen(what, tables),
    tensions = line_table(x),
    nodes = node_table(x),
    measures = measure_table(x),
    drag = drag_table(x),
    pieces = piece_table(x),
    boards = board_table(x),
    reactions = reaction_table(x)
  )
  if (!is.null(row.names)) row.names(table) <- row.names
  table
}

line_table <- function(state) {
  mesh <- state$lattice$mesh
  parts <- state$lattice$parts
  lines <- state_lines(state)
  points <- state_points(state)
  in_cells <- cell_middles(state$lattice, points)
  in_bars <- element_middles(points, mesh$bars$node, 2L)
  in_bars <- in_bars[, lines$element[lines$family == "bar"], drop = FALSE]
  middle <- cbind(in_bars, in_cells, in_cells,
    in_cells[, mesh$cells$straight > 0, drop = FALSE])
  data.frame(
    part = parts$name[lines$part], kind = parts$kind[lines$part], role = parts$role[lines$part],
    element = lines$element, family = lines$family,
    x_m = middle[1, ], y_m = middle[2, ], z_m = middle[3, ],
    length_m = lines$length, tension_kN = in_unit(lines$tension, "kN"), lines = lines$lines,
    slack = lines$tension == 0
  )
}

node_table <- function(state) {
  x <- state$position
  data.frame(
    node = seq_len(ncol(x)), x_m = x[1, ], y_m = x[2, ], z_m = x[3, ],
    parts = node_parts(state$lattice), held = state$lattice$mesh$held
  )
}

# Names of the ropes and panels that meet at every node, in the order of the plan.
node_parts <- function(lattice) {
  e <- lattice$mesh
  hexagon <- which(e$cells$inner > 0L)
  point <- c(e$bars$node, e$cells$node, e$cells$inner[hexagon])
  part <- c(rep(lattice$bar_part, each = 2L), rep(lattice$cell_part, each = 4L),
    lattice$cell_part[hexagon])
  # What stands on a tied point meets both nodes that carry it.
  tied <- point > e$nodes
  tie <- point[tied] - e$nodes
  node <- c(point[!tied], e$ties$first[tie], e$ties$second[tie])
  part <- c(part[!tied], part[tied], part[tied])
  # Few nodes belong to several parts: of the others any element tells the one.
  last <- integer(e$nodes)
  last[node] <- part
  out <- c("", lattice$parts$name)[last + 1L]
  shared <- unique(node[part != last[node]])
  met <- which(node %in% shared)
  met <- met[order(node[met], part[met])]
  met <- met[!duplicated(data.frame(node[met], part[met]))]
  out[shared[order(shared)]] <- vapply(
    split(lattice$parts$name[part[met]], node[met]), paste, "", collapse = ", "
  )
  out
}

measure_table <- function(state) {
  found <- measures(state)
  data.frame(
    measure = names(found), value = as.double(found), unit = unname(attr(found, "unit")),
    error = unname(attr(found, "error"))
  )
}
