# The mesh of a gear: nodes, bars, netting cells, pieces, supports, and a crude initial layout.

# Builds the mesh of a gear, see src/engine/gear/mesh.hpp.
# `nodes`: target number of nodes.
# `netting`: "bars" or "cells" for every panel, or NULL for each panel's own.
# `from`: NULL for a crude start, or list(mesh, position = 3 x points) of the same parts. The
# shape is mapped to the new mesh. For an identical request the counts of this mesh are reused, so
# two designs can be compared node by node.
#
# Returns an object of class codend_mesh, a list:
# `model`: handle of the engine's data (see model.R).
# `start`: 3 x nodes initial positions (m).
# `parts`: data.frame(name, kind, role).
# `bar_part`, `cell_part`, `sphere_part`, `lift_part`, `board_part`: row of `parts` per element.
# `ropes`: nodes along each rope with their fraction of its length.
# `points`, `places`: node of each point and of each named position.
# `catch`: list(cell = cells of the triangles around the catch (NA for a sheet), blocked = meshes
# behind its front).
# `hung`: positions of a gear before shooting. `let_go`: TRUE after shooting.
# `division`: see gear_division().
# `held_edges`: for every seam held on a line, its nodes, their fraction of its length and the
# names of its two points (`between`).
# `panels`: data for drawing each panel.
# `changes`, `built_lengths`: see mesh_recipe().
build_mesh <- function(si, nodes = 1500, netting = NULL, from = NULL) {
  asked <- requested_mesh_size(si, nodes, netting)
  alike <- identical(asked, from$mesh$counts$asked)
  if (alike && differ_in_conditions(si, from$settled)) return(mesh_in(si, from))
  numbers <- mesh_numbers(si, netting)
  found <- engine_mesh(
    numbers$gear, numbers$model, planned_front(si), asked$nodes,
    if (alike) from$mesh$counts[mesh_counts],
    if (!is.null(from) && !alike) part_map(si, from$mesh), as.double(from$position), alike
  )
  check_mesh(si, found$twine, found$encloses, found$division)
  mesh <- new_mesh(si, asked, planned_front(si), found)
  # Identical netting sheets have the same wake as in the last shape.
  if (alike && identical(mesh$model$wake_sheets, from$mesh$model$wake_sheets)) {
    mesh$model <- changed_model(mesh$model, list(wake = from$mesh$model$wake))
  }
  mesh
}

# Returns a request for a mesh: target number of nodes, panels of bars, meshes of panels.
requested_mesh_size <- function(si, nodes, netting) {
  # 1500L and 1500 request the same mesh.
  list(
    nodes = as.double(nodes), bars = panels_of_bars(si, netting),
    meshes = panel_table(si$panels)[c(side_fields, "orientation")]
  )
}

# Returns a named mesh from the engine's result. `blocked`: meshes behind the catch's front.
new_mesh <- function(si, asked, blocked, found) {
  mesh <- c(
    list(parts = part_table(si)),
    found[c("model", "nodes", "bar_part", "cell_part", "sphere_part", "lift_part")],
    list(
      board_part = length(si$ropes) + length(si$panels) + length(si$pieces) +
        seq_along(si$otter_boards)
    ),
    gear_division(si, found$division),
    list(
      panels = drawn_panels(si, found),
      counts = c(list(asked = asked), found$counts[mesh_counts])
    ),
    found[c("sheets", "on_cell", "on_sheet")],
    list(start = matrix(found$start, 3L))
  )
  class(mesh) <- "codend_mesh"
  if (!is.null(si$catch)) {
    mesh$catch <- list(
      cell = replace(found$bag_cell, found$bag_cell == 0L, NA), blocked = blocked
    )
  }
  if (!is.null(si$shooting)) mesh$hung <- matrix(found$hung, 3L)
  mesh
}

# Throws an error if a mesh does not match its gear. `twine`: length in each panel, m; `encloses`:
# TRUE if the catch's netting encloses a volume; `division`: see division.hpp.
check_mesh <- function(si, twine, encloses, division) {
  check_totals(si, panel_table(si$panels), twine)
  check_held_edges(si, division)
  if (!is.null(si$catch) && !encloses) {
    abort_plan(
      "The netting around the catch is not closed; all panels in `catch.panels` must be joined.",
      "catch.panels", si$catch$panels
    )
  }
}

# Counts that define the division of a mesh.
mesh_counts <- c("pieces", "ropes", "grouping")

# TRUE if two gears differ only in the motion of water and towing. FALSE for a shot gear, whose
# initial position also depends on these.
differ_in_conditions <- function(si, other) {
  if (is.null(other) || !is.null(si$shooting)) return(FALSE)
  still <- function(si) {
    si$water <- si$water[c("density", "free_surface")]
    si[c("towing", "vessel", "measures")] <- NULL
    if (!is.null(si$ground)) si$ground$velocity <- NULL
    si
  }
  identical(still(si), still(other))
}

# Returns the mesh of a settled shape in a gear's conditions. `wake`: wake of every point, or empty.
mesh_in <- function(si, from, wake = from$mesh$model$wake) {
  mesh <- from$mesh
  mesh$model <- engine_changed_model(mesh$model, c(
    list(water = engine_water(si), wake = wake),
    if (!is.null(si$ground)) {
      list(ground = utils::modifyList(mesh$model$ground, si$ground["velocity"]))
    }
  ))
  mesh$start <- matrix(from$position, 3L)[, seq_len(mesh$nodes), drop = FALSE]
  mesh
}

part_table <- function(si) {
  groups <- c("ropes", "panels", "pieces", "otter_boards")
  has_catch <- !is.null(si$catch)
  list2DF(list(
    name = as.character(c(unlist(lapply(si[groups], names), use.names = FALSE),
      if (has_catch) "catch")),
    kind = rep(
      c("rope", "netting", "piece", "piece", "catch"), c(lengths(si[groups]), has_catch)
    ),
    role = unname(c(
      vapply(si$ropes, `[[`, "", "role"), vapply(si$panels, `[[`, "", "part"),
      vapply(si$pieces, `[[`, "", "role"), vapply(si$otter_boards, `[[`, "", "role"),
      if (has_catch) "catch"
    ))
  ))
}

# Returns the named division of a gear: list(division, ropes, points, places, held_edges), see
# build_mesh(). `found`: see division.hpp. `division` is a list:
# `nodes`: number of nodes.
# `fraction`, `edge_node`: fractions of an edge at its nodes, and these nodes, edge by edge.
# `count`, `before`: number of nodes of every edge, and of all edges before it.
# `grids`: nodes of every panel of cells.
# `runs`: nodes of pieces along chains.
gear_division <- function(si, found) {
  named <- function(runs, names) setNames(lapply(runs, `[`, c("node", "at")), names)
  spread <- vapply(si$pieces, function(piece) identical(piece$along$kind, "chain"), NA)
  held <- names(si$seams)[vapply(found$held_edges, `[[`, 0L, "seam") + 1L]
  list(
    division = c(
      list(nodes = found$nodes), found$edges,
      list(
        grids = lapply(found$grids, function(grid) {
          if (length(grid$node)) matrix(grid$node, grid$columns)
        }),
        runs = named(found$runs[spread], names(si$pieces)[spread])
      )
    ),
    ropes = named(found$ropes, names(si$ropes)),
    points = setNames(found$places[seq_along(si$points)], names(si$points)),
    places = setNames(found$places, place_names(si)),
    held_edges = setNames(Map(
      function(run, seam) c(run[c("node", "at")], list(between = seam$held_between)),
      found$held_edges, si$seams[held]
    ), held)
  )
}

# Returns the data for drawing each panel: list(netting, grid, cell) for cells, or list(netting,
# node, i, j, lambda, segments) for bars.
drawn_panels <- function(si, found) {
  drawn <- lapply(seq_along(found$panels), function(p) {
    panel <- found$panels[[p]]
    if (panel$bars) {
      return(c(list(netting = "bars"), panel[c("node", "i", "j", "lambda", "segments")]))
    }
    grid <- found$division$grids[[p]]
    list(netting = "cells", grid = matrix(grid$node, grid$columns), cell = panel$cell)
  })
  setNames(drawn, names(si$panels))
}

# Returns a mesh as the source or target of mapping shapes, see carry.hpp.
part_map <- function(si, mesh) {
  division <- mesh$division
  list(
    nodes = as.integer(mesh$nodes), divided_nodes = as.integer(division$nodes),
    edges = division[c("fraction", "edge_node", "count", "before")],
    grids = lapply(division$grids, function(grid) {
      list(columns = NROW(grid), node = as.integer(grid))
    }),
    ropes = lapply(unname(mesh$ropes), `[`, c("node", "at")),
    points = as.integer(mesh$points[names(si$points)]),
    panels = lapply(unname(mesh$panels), function(panel) {
      list(
        bars = panel$netting == "bars", cell = as.integer(panel$cell),
        node = as.integer(panel$node), i = as.double(panel$i), j = as.double(panel$j),
        lambda = first_of(panel$lambda, 0), segments = first_of(panel$segments, 0L)
      )
    })
  )
}

# Throws an error if a seam held on a line passes through a held node.
check_held_edges <- function(si, division) {
  of_points <- division$places[seq_along(si$points)]
  held <- of_points[!is.na(vapply(si$points, `[[`, "", "held"))]
  for (edge in division$held_edges) {
    name <- names(si$seams)[edge$seam + 1L]
    node <- edge$node[-c(1L, length(edge$node))]
    if (any(node %in% held)) {
      path <- paste0("seams.", name, ".held_between")
      abort_field(path, si$seams[[name]]$held_between, NULL, paste(
        "runs through a point that is held already: end the seam there and hold the rest by",
        "another seam"
      ))
    }
    held <- c(held, node)
  }
}

# Checks that the mesh has the twine of the plan. `held`: twine per panel (m).
check_totals <- function(si, panels, held) {
  planned <- panel_bars(panels) * cell_twine(panels)
  wrong <- which(abs(held - planned) > 1e-6 * planned)[1L]
  if (is.na(wrong)) return(invisible())
  abort_mesh(
    "Panel {.field {names(si$panels)[wrong]}} has {signif(planned[wrong], 6)} m of twine
    in the plan and {signif(held[wrong], 6)} m in the model."
  )
}

# Returns the load curves of lines, one row per point, as the engine's columns; or NULL.
load_rows <- function(lines) {
  tables <- lapply(unname(lines), `[[`, "load_table")
  rows <- lengths(lapply(tables, `[[`, "load"))
  if (!any(rows)) return(NULL)
  list(
    material = rep(seq_along(tables), rows), strain = unlist(lapply(tables, `[[`, "strain")),
    load = unlist(lapply(tables, `[[`, "load"))
  )
}

# TRUE for panels of bars. `netting`: "bars" or "cells" for all, or NULL.
panels_of_bars <- function(si, netting) {
  vapply(si$panels, function(panel) {
    identical(first_of(netting, panel$netting), "bars") && panel$straight_bar == 0
  }, NA)
}
