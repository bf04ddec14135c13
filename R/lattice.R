# The lattice: a gear as numbers. Nodes, bars, netting cells, point pieces and supports, and a
# crude layout to start from.

# Builds the lattice of a gear, see src/engine/gear/lattice.hpp.
#
# nodes: about how many nodes; netting: "bars" or "cells" for every panel, or NULL for each
# panel's own; from: NULL for a crude start, or list(lattice, position = 3 x points) of the same
# parts, whose shape is carried over; as many nodes of the same panels are divided as there, so that
# two designs can be compared node by node.
# Returns class codend_lattice: list(mesh = handle to what the engine holds (see mesh.R), start =
# 3 x nodes positions (m), parts = data.frame(name, kind, role), bar_part, cell_part, sphere_part,
# lift_part, board_part = rows of parts per element, ropes = nodes along each rope with their
# fraction of its length, points = node of each point, places = node of each place by its text,
# catch = of a gear with one list(cell = cells of the triangles that it may lie against (NA: of a
# sheet), blocked = meshes behind its front), hung = of a gear that is shot, positions before it is
# in the water; let_go = TRUE once it is, division = how edges and grids are divided, see
# gear_division(), held_edges = of every seam held on a line its nodes, their fraction of its length
# and the names of its two points (between), panels = what the views draw of each panel; changes,
# built_lengths: see mesh_recipe()).
build_lattice <- function(si, nodes = 1500, netting = NULL, from = NULL) {
  asked <- asked_division(si, nodes, netting)
  alike <- identical(asked, from$lattice$counts$asked)
  if (alike && differ_in_conditions(si, from$settled)) return(lattice_in(si, from))
  numbers <- lattice_numbers(si, netting)
  found <- engine_lattice(
    numbers$gear, numbers$model, planned_front(si), asked$nodes,
    if (alike) from$lattice$counts[lattice_counts],
    if (!is.null(from) && !alike) part_map(si, from$lattice), as.double(from$position), alike
  )
  check_lattice(si, found$twine, found$encloses, found$division)
  lattice <- new_lattice(si, asked, planned_front(si), found)
  # the same sheets of netting in the place of the last shape slow the water as they did
  if (alike && identical(lattice$mesh$wake_sheets, from$lattice$mesh$wake_sheets)) {
    lattice$mesh <- changed_mesh(lattice$mesh, list(wake = from$lattice$mesh$wake))
  }
  lattice
}

# How a lattice is to be divided: about so many nodes, which panels are of bars, and their meshes.
asked_division <- function(si, nodes, netting) {
  # 1500L asks for what 1500 does
  list(
    nodes = as.double(nodes), bars = panels_of_bars(si, netting),
    meshes = panel_table(si$panels)[c(side_fields, "orientation")]
  )
}

# A lattice by names, from what the engine found of it; blocked: meshes behind its catch's front.
new_lattice <- function(si, asked, blocked, found) {
  lattice <- c(
    list(parts = part_table(si)),
    found[c("mesh", "nodes", "bar_part", "cell_part", "sphere_part", "lift_part")],
    list(
      board_part = length(si$ropes) + length(si$panels) + length(si$pieces) +
        seq_along(si$otter_boards)
    ),
    gear_division(si, found$division),
    list(
      panels = drawn_panels(si, found),
      counts = c(list(asked = asked), found$counts[lattice_counts])
    ),
    found[c("sheets", "on_cell", "on_sheet")],
    list(start = matrix(found$start, 3L))
  )
  class(lattice) <- "codend_lattice"
  if (!is.null(si$catch)) {
    lattice$catch <- list(
      cell = replace(found$bag_cell, found$bag_cell == 0L, NA), blocked = blocked
    )
  }
  if (!is.null(si$shooting)) lattice$hung <- matrix(found$hung, 3L)
  lattice
}

# Stops where a lattice is not its gear's. twine: m of every panel's; encloses: whether a bag does;
# division: see division.hpp.
check_lattice <- function(si, twine, encloses, division) {
  check_totals(si, panel_table(si$panels), twine)
  check_held_edges(si, division)
  if (!is.null(si$catch) && !encloses) {
    abort_plan(
      "The netting around the catch encloses nothing; all panels in `catch.panels` must be joined.",
      "catch.panels", si$catch$panels
    )
  }
}

# What of a lattice's counts divides it.
lattice_counts <- c("pieces", "ropes", "grouping")

# Whether two gears are the same but for the water's motion and how they are towed. shot: what is
# let go hangs by that too.
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

# The lattice of a settled shape in a gear's conditions. wake: of every point, or empty.
lattice_in <- function(si, from, wake = from$lattice$mesh$wake) {
  lattice <- from$lattice
  lattice$mesh <- engine_changed_mesh(lattice$mesh, c(
    list(water = engine_water(si), wake = wake),
    if (!is.null(si$ground)) {
      list(ground = utils::modifyList(lattice$mesh$ground, si$ground["velocity"]))
    }
  ))
  lattice$start <- matrix(from$position, 3L)[, seq_len(lattice$nodes), drop = FALSE]
  lattice
}

# The table of a gear's parts.
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

# How a gear is divided, by names: list(division = list(nodes, fraction, edge_node = fractions of an
# edge at its nodes, and these nodes, one edge after the other, count, before = of every edge, how
# many are its own and before them, grids = per panel of cells, runs), ropes, points, place,
# held_edges), see build_lattice(). found: see division.hpp.
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

# What the views draw of each panel: list(netting, grid, cell) of cells, or list(netting, node, i,
# j, lambda, segments) of bars.
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

# A lattice as what shapes are carried from and to, see carry.hpp.
part_map <- function(si, lattice) {
  division <- lattice$division
  list(
    nodes = as.integer(lattice$nodes), divided_nodes = as.integer(division$nodes),
    edges = division[c("fraction", "edge_node", "count", "before")],
    grids = lapply(division$grids, function(grid) {
      list(columns = NROW(grid), node = as.integer(grid))
    }),
    ropes = lapply(unname(lattice$ropes), `[`, c("node", "at")),
    points = as.integer(lattice$points[names(si$points)]),
    panels = lapply(unname(lattice$panels), function(panel) {
      list(
        bars = panel$netting == "bars", cell = as.integer(panel$cell),
        node = as.integer(panel$node), i = as.double(panel$i), j = as.double(panel$j),
        lambda = first_of(panel$lambda, 0), segments = first_of(panel$segments, 0L)
      )
    })
  )
}

# Stops where a seam is held on a line through a place that is held already.
check_held_edges <- function(si, division) {
  of_points <- division$places[seq_along(si$points)]
  held <- of_points[!is.na(vapply(si$points, `[[`, "", "held"))]
  for (edge in division$held_edges) {
    name <- names(si$seams)[edge$seam + 1L]
    node <- edge$node[-c(1L, length(edge$node))]
    if (any(node %in% held)) {
      path <- paste0("seams.", name, ".held_between")
      abort_plan(
        sprintf(
          paste(
            "Plan field `%s` runs through a place that is held already: end the seam there and",
            "hold the rest by another seam."
          ),
          path
        ),
        path, si$seams[[name]]$held_between
      )
    }
    held <- c(held, node)
  }
}

# The lattice must hold the plan's twine: an error names the panel where it does not.
# panels: the table; held: m of every panel's twine.
check_totals <- function(si, panels, held) {
  planned <- panel_bars(panels) * cell_twine(panels)
  wrong <- which(abs(held - planned) > 1e-6 * planned)[1L]
  if (is.na(wrong)) return(invisible())
  abort_lattice(
    "Panel {.field {names(si$panels)[wrong]}} has {signif(planned[wrong], 6)} m of twine
    in the plan and {signif(held[wrong], 6)} m in the model."
  )
}

# Loads by strain of the lines that have them, a row each: columns as the engine reads them, or
# NULL.
load_rows <- function(lines) {
  tables <- lapply(unname(lines), `[[`, "load_table")
  rows <- lengths(lapply(tables, `[[`, "load"))
  if (!any(rows)) return(NULL)
  list(
    material = rep(seq_along(tables), rows), strain = unlist(lapply(tables, `[[`, "strain")),
    load = unlist(lapply(tables, `[[`, "load"))
  )
}

# Which panels are of bars. netting: "bars" or "cells" for all, or NULL.
panels_of_bars <- function(si, netting) {
  vapply(si$panels, function(panel) {
    identical(first_of(netting, panel$netting), "bars") && panel$straight_bar == 0
  }, NA)
}
