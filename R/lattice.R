# The lattice: a gear as numbers. Nodes, bars, netting cells, point pieces and supports, and a
# crude layout to start from.

# Builds the lattice of a gear.
#
# nodes: about how many nodes; netting: "bars" or "cells" for every panel, or NULL for each
# panel's own; from: NULL for a crude start, or list(lattice, position = 3 x points, settled = SI
# numbers of the gear whose settled shape it is, or NULL) of the same parts,
# whose shape is carried over; as many nodes of the same panels are divided as there, so that two
# designs can be compared node by node.
# Returns class codend_lattice: list(engine = what the engine reads (see binding.cpp), start = 3 x
# nodes positions (m), parts = data.frame(name, kind, role), bar_part, cell_part, sphere_part,
# lift_part, board_part = rows of parts per element, ropes = nodes along each rope with their
# fraction of its length, points = node of each point, place = function from a parsed place to a
# node, catch = where the catch may lie (see add_catch()), hung = of a gear that is shot, see
# hang_out(); let_go = TRUE once it is, division = how edges and grids are divided, see divide(),
# held_edges = of every seam held on a line its nodes, their fraction of its length and the names of
# its two points (between), panels = what the views draw of each panel).
build_lattice <- function(si, nodes = 1500, netting = NULL, from = NULL) {
  # 1500L asks for what 1500 does
  nodes <- as.double(nodes)
  filled <- fill_lattice(si, nodes, netting, from)
  if (!is.null(filled)) return(filled)
  bars <- panels_of_bars(si, netting)
  panels <- panel_table(si$panels)
  panels$sheets <- panels$sheets | names(si$panels) %in% si$catch$panels
  # what a shape of the same division needs not
  delayedAssign("chains", gear_chains(si))
  delayedAssign("frame", division_frame(chains, linked = !bars))
  asked <- list(nodes = nodes, bars = bars, meshes = panels[c(side_fields, "orientation")])
  alike <- identical(asked, from$lattice$counts$asked)
  counts <- if (alike) from$lattice$counts else {
    division_counts(resolution_table(si, panels, frame$pieces, bars), asked)
  }
  division <- if (alike) division_again(si, from)
  if (is.null(division)) division <- divide(si, frame, counts$pieces, counts$ropes, bars)

  parts <- list2DF(list(
    name = as.character(c(names(si$ropes), names(si$panels), names(si$pieces),
      names(si$otter_boards), if (!is.null(si$catch)) "catch")),
    kind = rep(
      c("rope", "netting", "piece", "piece", "catch"),
      c(lengths(si[c("ropes", "panels", "pieces", "otter_boards")]), !is.null(si$catch))
    ),
    role = unname(c(
      vapply(si$ropes, `[[`, "", "role"), vapply(si$panels, `[[`, "", "part"),
      vapply(si$pieces, `[[`, "", "role"), vapply(si$otter_boards, `[[`, "", "role"),
      if (!is.null(si$catch)) "catch"
    ))
  ))
  build <- new_collection(division$nodes)
  for (r in seq_along(si$ropes)) add_rope(build, si$ropes[[r]], division$ropes[[r]], r)
  own <- division[c("nodes", "fraction", "edge_node", "count", "before", "grids")]
  # what is large is not kept for a gear that may never be changed
  netting_of <- if (division$nodes > most_remembered_nodes) collect_netting else netting_again
  all_netting <- netting_of(panels, bars, length(si$ropes), own, counts$grouping)
  build$take(all_netting$collected)
  drawn <- setNames(all_netting$drawn, names(si$panels))
  for (k in seq_along(si$pieces)) {
    add_piece(build, si$pieces[[k]], piece_run(si, division, names(si$pieces)[k]), division$places,
      si$water$density, length(si$ropes) + length(bars) + k)
  }
  before_boards <- nrow(parts) - length(si$otter_boards)
  add_otter_boards(build, si, division, before_boards, length(si$ropes) + length(bars))
  collected <- build$collect()
  supports <- gear_supports(si, division)
  density <- si$water$density
  loads <- supports$load
  loads <- cbind(loads, matrix(0, 3L, length(collected$mass) - ncol(loads)))
  loads[3, ] <- loads[3, ] - gear_gravity * (collected$mass - density * collected$volume)
  contacts <- if (!is.null(si$ground)) contact_points(collected$masses) else no_contacts
  volumes <- immersed_volumes(collected$masses, density)

  engine <- list(
    nodes = collected$nodes, held = c(supports$held, rep(FALSE, collected$nodes - division$nodes)),
    ties = collected$ties,
    water = engine_water(si),
    slack_twine = si$slack_twine,
    load = as.vector(loads),
    mass = collected$mass,
    materials = Map(
      c, twine_materials(si$ropes), panel_materials(si$panels),
      twine_materials(lapply(si$otter_boards, strut_line))
    ),
    load_table = load_rows(c(si$ropes, si$panels)),
    bars = engine_elements(collected$bars),
    cells = engine_elements(collected$cells), spheres = engine_elements(collected$spheres),
    lifts = engine_elements(collected$lifts),
    plates = lapply(unname(si$otter_boards), function(board) {
      engine_board(board, unname(division$points[board$points]), density)
    }),
    sliding = sliding_ropes(si, collected$bars$part),
    ground = si$ground, contacts = contacts,
    line_friction = if (!is.null(si$ground)) line_friction(si$ropes, division$ropes),
    volumes = volumes,
    wake_sheets = wake_sheets(collected$wake_sheets), wake = numeric()
  )
  lattice <- structure(
    list(
      engine = engine, parts = parts, nodes = engine$nodes,
      bar_part = collected$bars$part, cell_part = collected$cells$part,
      sphere_part = collected$spheres$part, lift_part = collected$lifts$part,
      board_part = before_boards + seq_along(si$otter_boards),
      division = division[c("nodes", "fraction", "edge_node", "count", "before", "grids", "runs")],
      ropes = division$ropes, points = division$points, place = place_finder(division$places),
      held_edges = division$held_edges, panels = drawn, counts = counts
    ),
    class = "codend_lattice"
  )
  lattice$sheets <- collected$sheets
  lattice$on_cell <- list(
    screens = cells_with_drag(si, lattice, screen_laws()),
    blended = cells_with_drag(si, lattice, "blended")
  )
  lattice$on_sheet <- list(
    screens = parts_with_drag(si, lattice$sheets$part, screen_laws()),
    blended = parts_with_drag(si, lattice$sheets$part, "blended")
  )
  lattice$engine$screens <- screen_elements(si, lattice)
  lattice$engine$blended <- blended_elements(si, lattice)
  lattice$engine$openings <- opening_elements(si, lattice)
  lattice$engine$bends <- bend_elements(si, lattice)
  check_totals(lattice, panels, length(si$ropes))
  lattice$start <- if (is.null(from)) {
    start <- lay_out(si, lattice, panels, chains, if (!any(bars)) frame)
    if (is.null(si$ground)) {
      start
    } else {
      stand_on_ground(si, lattice, lay_on_ground(si$ground, start))
    }
  } else if (alike) {
    # the same sheets of netting in the place of the last shape slow the water as they did
    if (identical(lattice$engine$wake_sheets, from$lattice$engine$wake_sheets)) {
      lattice$engine$wake <- from$lattice$engine$wake
    }
    from$position[, seq_len(lattice$nodes)]
  } else {
    carry_positions(panels, lattice, from$lattice, from$position)
  }
  lattice$start[, which(supports$held)] <- supports$position[, supports$held]
  lattice <- add_catch(si, lattice)
  if (!is.null(si$catch) && is.null(from)) lattice$start <- round_start(si, lattice)
  if (is.null(from) || !alike) lattice$start <- place_inner_nodes(lattice)
  if (!is.null(si$shooting)) lattice$hung <- hang_out(si, lattice, panels, chains)
  lattice
}

# The netting of a gear: list(collected = as new_collection()'s hand_over(), drawn = what the views
# draw of each panel). ropes: how many parts come before it; division: what of divide()'s it takes.
collect_netting <- function(panels, bars, ropes, division, grouping) {
  build <- new_collection(division$nodes)
  drawn <- vector("list", length(bars))
  of_bars <- which(bars)
  of_cells <- which(!bars)
  if (length(of_bars)) {
    drawn[of_bars] <- add_bar_panels(build, pick_panels(panels, of_bars), of_bars,
      ropes + of_bars, division, pick_panels(grouping, of_bars))
  }
  if (length(of_cells)) {
    drawn[of_cells] <- add_cell_panels(build, pick_panels(panels, of_cells), of_cells,
      ropes + of_cells, division)
  }
  list(collected = build$hand_over(), drawn = drawn)
}

# A change of ropes, boards or pieces leaves the netting as it was.
netting_again <- remembered(collect_netting)
most_remembered_nodes <- 5e4

# Which panels are of bars. netting: "bars" or "cells" for all, or NULL.
panels_of_bars <- function(si, netting) {
  vapply(si$panels, function(panel) {
    identical(first_of(netting, panel$netting), "bars") && panel$straight_bar == 0
  }, NA)
}

# The part of every element of a kind that the engine reports forces of (see reported_forces()).
element_part <- function(lattice, kind) {
  switch(kind,
    bars = lattice$bar_part, cells = lattice$cell_part, spheres = lattice$sphere_part,
    lifts = lattice$lift_part, plates = lattice$board_part,
    screens = , blended = c(lattice$cell_part[lattice$on_cell[[kind]]],
      lattice$sheets$part[lattice$on_sheet[[kind]]]),
    pressure = rep(which(lattice$parts$kind == "catch"), length(lattice$engine$pressure$node) / 3)
  )
}

no_contacts <- list(node = integer(), area = numeric(), clearance = numeric())

# Ropes that slide through places: their bars carry weight and drag alone, the whole pulls.
sliding_ropes <- function(si, bar_part) {
  slide <- which(lengths(lapply(si$ropes, `[[`, "through")) > 0L)
  lapply(unname(slide), function(r) {
    list(bar = which(bar_part == r), axial_stiffness = si$ropes[[r]]$axial_stiffness)
  })
}

# Of sheets of netting those that slow the water behind them.
wake_sheets <- function(sheets) {
  some <- sheets$law != "none"
  list(
    node = sheets$node[rep(some, each = 3L)], twine_area = sheets$twine_area[some],
    law = sheets$law[some]
  )
}

# A function(text) that tells the node of a parsed place.
place_finder <- function(places) {
  # Unforced it would keep everything that the lattice was built from.
  force(places)
  function(text) places[[text]]
}

# The nodes of all places of a lattice, by their texts.
lattice_places <- function(lattice) environment(lattice$place)$places

# How finely a gear is divided: list(asked, pieces, ropes = elements of every piece of edge and
# rope, grouping = see bar_grouping()).
division_counts <- function(resolution, asked) {
  h <- element_length(resolution, asked$nodes)
  grouping <- bar_grouping(resolution, h)
  list(
    asked = asked, pieces = piece_counts(resolution, h, grouping),
    ropes = rope_counts(resolution, h), grouping = grouping
  )
}

# What does not depend on how fine the division is: breaks and pieces of all edges.
division_frame <- function(chains, linked) {
  list(chains = chains, pieces = edge_pieces(chains, edge_breaks(chains, linked), linked))
}

# The engine's table of materials: a row per rope and per panel's twine, as columns.
# alone: without what netting as a screen or blended has as whole cells.
twine_materials <- function(lines, alone = TRUE) {
  number <- function(field) vapply(lines, `[[`, 0, field, USE.NAMES = FALSE)
  laws <- lapply(lines, `[[`, "coefficients")
  screens <- alone & vapply(lines, function(line) !is.null(line$netting_drag) &&
    line$netting_drag != "twines", NA)
  coefficient <- function(field) {
    given <- vapply(laws, `[[`, 0, field, USE.NAMES = FALSE)
    given[is.na(given) | screens] <- 0
    given
  }
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
    diameter = vapply(lines, line_diameter, 0, USE.NAMES = FALSE),
    volume_per_length = number("volume_per_length"),
    added_mass_normal = added_mass("normal"), added_mass_tangential = added_mass("tangential"),
    law = law, strut = vapply(lines, function(line) isTRUE(line$strut), NA, USE.NAMES = FALSE),
    normal = coefficient("normal"), tangential = coefficient("tangential"),
    skin = coefficient("skin"), tangential_share = rep(1, length(lines)),
    solidity = vapply(lines, function(line) {
      if (is.null(line$mesh_size)) 0 else panel_solidity(line)
    }, 0, USE.NAMES = FALSE)
  )
}

panel_materials <- remembered(twine_materials)

# Nodes of ropes that rub differently along and across themselves, as the engine reads them, or
# NULL. A node of two such ropes is the first's.
line_friction <- function(ropes, divided) {
  some <- names(ropes)[!vapply(lapply(ropes, `[[`, "friction"), is.null, NA)]
  if (!length(some)) return(NULL)
  rows <- lapply(some, function(name) {
    node <- divided[[name]]$node
    n <- length(node)
    list(
      node = node, between = rbind(node[c(1L, seq_len(n - 1L))], node[c(seq_len(n)[-1L], n)]),
      along = rep(ropes[[name]]$friction[1L], n), across = rep(ropes[[name]]$friction[2L], n)
    )
  })
  pick <- function(field) unlist(lapply(rows, function(row) as.vector(row[[field]])))
  first <- !duplicated(pick("node"))
  list(
    node = pick("node")[first], between = pick("between")[rep(first, each = 2L)],
    along = pick("along")[first], across = pick("across")[first]
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

line_diameter <- function(line) first_of(line$diameter, twine_width(line))

# Solidity Sn of a panel hanging at the nominal ratio: d / (a E1 E2) for diamond netting with bars
# a, and 2 d/a - (d/a)^2 for square.
panel_solidity <- function(panel) {
  # hexagons: as diamonds of the same mesh size
  ratio <- twine_width(panel) / (panel$mesh_size / 2)
  if (panel$orientation == "square") return(2 * ratio - ratio^2)
  min(1, ratio / (nominal_hanging_ratio * nominal_depth_ratio))
}
