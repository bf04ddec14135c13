#' Tables of a state
#'
#' Returns tables with all numbers of a state, the static equilibrium of a gear from [settle()].
#' Column names end in their unit. x points aft (along the flow past a towed gear), y to starboard
#' and z up from the water surface.
#'
#' @section Fields of a state:
#' A state is a list of class `codend_state`:
#'
#' - `gear`: the gear; `si`: its plan in SI units with all defaults;
#' - `mesh`: nodes and elements of the gear, class `codend_mesh`;
#' - `report`: the solver's report, see below;
#' - `position` (3 x nodes, m) and `force` (3 x nodes, N). The force is the net force on each node.
#'   On a fixed node it is the opposite of the support's reaction;
#' - `bar_tension` (N, of one line) and `bar_length` (m);
#' - `u_tension`, `u_length`, `v_tension`, `v_length`: the same for both twine families of every
#'   netting cell, per mesh bar;
#' - `straight_tension`, `straight_length`: the same for the straight bars of hexagonal meshes, 0 in
#'   other cells;
#' - `forces`: forces on elements, see below.
#'
#' @section Solver report:
#' - `converged`, `iterations`, `factorisations`, `force_evaluations`;
#' - `factor_entries`: stored entries of the matrix factorisation;
#' - `residual`: largest net force on a free node divided by the largest tension;
#' - `largest_tension` (N), `worst_node`, `worst_force` (N);
#' - `part_residual`: largest net force beyond rounding, divided by the largest force on a line of
#'   the same part; `worst_part`: that part;
#' - `part_rounding`, `rounding_part`: the same for the rounding error of node positions;
#' - `cpu_seconds`, and seconds by step.
#'
#' @section Forces on elements:
#' `forces` is a named list of matrices (3 x elements, N):
#'
#' - from the flow: `bar_drag`, `cell_drag`, `screen_force`, `blended_force`, `sphere_drag`,
#'   `lift_force`, `plate_force` (free otter boards and kites) and `pressure_force` (catch);
#' - from the sea bed: `contact_force` and `plate_ground_force`;
#' - buoyancy lost above the surface: `volume_force` and `plate_lost_buoyancy`.
#'
#' @param x A state.
#' @param row.names `NULL` (default) or names for the rows.
#' @param optional Not used.
#' @param what Name of the table, by default `"measures"`. Give it by name, as `what = "drag"`. The
#'   section "Tables" describes them.
#' @param parts For `"rope_tensions"`: names of ropes or roles (`"warp"` for all warps). For
#'   `"mesh_openings"`: names of panels or of parts of the net (`"codend"`, `"section_3"`). Default
#'   `NULL`: all. An unknown name is an error of class `codend_error_argument`.
#' @param ... Not used.
#'
#' @section Tables:
#' - `"measures"`: `measure`, `value`, discretisation `error` and `unit` ([measures()]).
#' - `"tensions"`: one row per bar and per twine family in every netting cell. Columns: `part`,
#'   `kind` (rope or netting), `role`, `element` (number of the bar or cell), `family` (bar, u or v;
#'   straight in hexagonal meshes). Then follow the middle `x_m`, `y_m`, `z_m`, `length_m` and
#'   `tension_kN` of one line, `lines` (number of parallel lines) and `slack` (no tension).
#' - `"nodes"`: `node`, `x_m`, `y_m`, `z_m`, `parts` (ropes and panels that meet there) and `held`
#'   (fixed nodes).
#' - `"drag"`: one row per rope, panel and piece, and for catch in netting, with the hydrodynamic
#'   force on it. Further rows are listed below. Columns: `part`, `kind`, `role`, `drag_kN` (along
#'   the flow), `side_kN` (to starboard), `lift_kN` (up) and `weight_in_water_kN` (weight minus
#'   buoyancy). `drag_kN` adds up to the measure `total_drag_kN`.
#' - `"pieces"`: one row per piece and position, such as every hook of a longline. Columns: `part`,
#'   `role`, `number` (of pieces there), `x_m`, `y_m`, `z_m` and `depth_m`.
#' - `"boards"`: one row per free otter board and per kite or depressor, see below.
#' - `"rope_tensions"`: one row per bar of a rope, from the start of the line. [codend_charts] plots
#'   it. Columns: `rope`, `role`, `line` (a rope, or consecutive ropes of one role, such as the
#'   parts of a main line between its branch lines), `along_m` (distance of the bar's middle from
#'   the start of the line), `length_m`, `tension_kN`, `x_m`, `y_m` and `z_m`.
#' - `"mesh_openings"`: one row per row of meshes across a panel, from its front to its rear edge,
#'   see below. [codend_charts] plots it.
#' - `"board_modes"`: the small motions in which a free otter board, kite or depressor takes part,
#'   fastest growing first, see below.
#' - `"reactions"`: force of every support on the gear: `point`, `x_kN`, `y_kN`, `z_kN`. Two points
#'   at the ends of a fixed edge share its load like the supports of a beam.
#'
#' @section Rows of the table of drag without a part:
#' The table has these rows if their forces are not zero:
#' - `sea bed`: friction and support from the sea bed;
#' - `loads`: loads on points of the plan;
#' - `out of water`: buoyancy lost above the surface, as a negative lift;
#' - `inertia`: minus mass times acceleration, in a state of a tow.
#'
#' @section Columns of the table of boards:
#' - `board`, `attack_deg`, and `stall_deg`, the angle of attack at the largest lift of its polar;
#' - `heel_deg`: positive if the upper edge leans outward (kite: if the starboard end is high);
#' - `trim_deg`: positive if the leading edge is high;
#' - `lift_kN` (across the flow), `drag_kN` and `ground_load_kN` (upward force of the sea bed);
#' - `condition`: `"flying"`, `"stalled"` (angle of attack above `stall_deg`), `"back-winded"` (flow
#'   on the outer face) or `"fallen over"` (heel above 45 deg).
#'
#' @section Columns of the table of mesh openings:
#' - `panel`, `part`: names;
#' - `meshes_from_front`, `from_front_m`, `from_rear_m`: position along the netting;
#' - `x_m`, `depth_m`: middle of the row; `meshes_across`: number of its meshes;
#' - `mesh_size_mm`: mesh size in the plan;
#' - `mesh_opening_mm`, `least_opening_mm`, `greatest_opening_mm`: mean, smallest and largest
#'   opening. The opening of a diamond mesh is the distance between its knots across the panel, with
#'   taut twine the mesh size times sin(angle / 2). The opening of a square mesh is the distance
#'   between its bars. Hexagonal meshes are treated as diamond meshes of their cells. The gathered
#'   edge of a codend has an opening of 0;
#' - `opening_percent`: mean opening over mesh size; for square meshes over the bar length;
#' - `mesh_angle_deg`: mean angle between two bars.
#'
#' @section Columns of the table of board modes:
#' - `board`: the board that moves most;
#' - `period_s`: period; `NA` if the motion does not oscillate;
#' - `growth_per_s`: growth rate, negative if the motion decays; `decay_s`: time in which it falls
#'   to 1/e, `NA` if it grows; `damping`: fraction of the critical damping;
#' - `condition`: `"swings"` (oscillates and decays), `"creeps"` (decays without oscillation),
#'   `"flutters"` (oscillates and grows) or `"diverges"` (grows without oscillation). A growing
#'   motion whose residual in the gear's equations exceeds 2 % gets `NA`; check it with [tow()].
#'
#' The modes are eigenmodes of the gear's linearised equations of motion, with mass, added mass,
#' drag and lift of all parts as in [tow()]; the wake of the netting stays fixed. A board is one
#' rigid body. Its mass acts at its centre of gravity, as in a plate of uniform thickness with 12 %
#' camber. Its added mass is that of a flat plate, at mid-chord and normal to its face
#' (DNV-RP-C205), and for its rotation. Moments resist the rotation as on a thin plate in steady
#' flow. Lift and drag follow the angle of attack without delay, so flutter due to such a delay is
#' not detected.
#'
#' Motions faster than 10 rad/s are missing, and those in which the board moves less than a tenth as
#' far as the node that moves most; in a whole trawl also some swings with more than half of the
#' critical damping.
#'
#' @return A data frame. The sections below list the columns of each table. The tables
#'   `"rope_tensions"` and `"mesh_openings"` have a class of their own for charts.
#' @seealso [settle()], [measures()], [summary()][summary.codend_state]; [glossary] for the terms.
#' @examples
#' state <- settle("crossing_cables")
#' as.data.frame(state, what = "reactions")
#' head(as.data.frame(state, what = "tensions"))
#' trawl <- settle("midwater_trawl", nodes = 300)
#' head(as.data.frame(trawl, what = "rope_tensions", parts = "warp"))
#' head(as.data.frame(trawl, what = "mesh_openings", parts = "codend"))
#' @export
as.data.frame.codend_state <- function(x, row.names = NULL, optional = FALSE,
                                       what = c("measures", "tensions", "nodes", "drag",
                                                "pieces", "boards", "reactions", "rope_tensions",
                                                "mesh_openings", "board_modes"),
                                       parts = NULL, ...) {
  what <- chosen(what, eval(formals()$what))
  if (!is.null(parts) && !what %in% c("rope_tensions", "mesh_openings")) {
    abort_argument("{.arg parts} applies only to {.code what = \"rope_tensions\"} and
      {.code what = \"mesh_openings\"}.")
  }
  table <- switch(what,
    measures = as.data.frame(measures(x)),
    tensions = line_table(x),
    nodes = node_table(x),
    drag = drag_table(x),
    pieces = piece_table(x),
    boards = board_table(x),
    reactions = reaction_table(x),
    rope_tensions = rope_tension_table(x, parts),
    mesh_openings = mesh_opening_table(x, parts),
    board_modes = board_mode_table(x)
  )
  with_row_names(table, row.names, what = TRUE)
}

line_table <- function(state) {
  model <- state$mesh$model
  parts <- state$mesh$parts
  lines <- state_lines(state)
  points <- state_points(state)
  in_cells <- cell_middles(state$mesh, points)
  in_bars <- element_middles(points, model$bars$node, 2L)
  in_bars <- in_bars[, lines$element[lines$family == "bar"], drop = FALSE]
  middle <- cbind(in_bars, in_cells, in_cells,
    in_cells[, model$cells$straight > 0, drop = FALSE])
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
    parts = node_parts(state$mesh), held = state$mesh$model$held
  )
}

# Returns the names of the ropes and panels that meet at every node, in the order of the plan.
node_parts <- function(mesh) {
  e <- mesh$model
  hexagon <- which(e$cells$inner > 0L)
  point <- c(e$bars$node, e$cells$node, e$cells$inner[hexagon])
  part <- c(rep(mesh$bar_part, each = 2L), rep(mesh$cell_part, each = 4L),
    mesh$cell_part[hexagon])
  # Parts at a tied point meet both nodes that carry it.
  tied <- point > e$nodes
  tie <- point[tied] - e$nodes
  node <- c(point[!tied], e$ties$first[tie], e$ties$second[tie])
  part <- c(part[!tied], part[tied], part[tied])
  # Only a few nodes belong to several parts; for the others any element identifies the part.
  last <- integer(e$nodes)
  last[node] <- part
  out <- c("", mesh$parts$name)[last + 1L]
  shared <- unique(node[part != last[node]])
  met <- which(node %in% shared)
  met <- met[order(node[met], part[met])]
  met <- met[!duplicated(data.frame(node[met], part[met]))]
  out[shared[order(shared)]] <- vapply(
    split(mesh$parts$name[part[met]], node[met]), paste, "", collapse = ", "
  )
  out
}
