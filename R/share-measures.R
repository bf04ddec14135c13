# Measures as a shared page computes them (inst/share/measures.js): each kind of measure with what
# of the lattice it is taken from. A kind without an entry is left off the page, which says so by
# name.
#
# Numbers of nodes, points and elements count from 0. Numbers that sliders change are among
# filled_arrays(). What is long is an array of its own: shared_measures() collects these.

# Programs by kind: functions(state, measure, keep) that give list(op = the computation, ...);
# keep(x) keeps a long array and gives its name.
shared_kinds <- list(
  spread = function(state, measure, keep) list(pairs = pair_nodes_of(state, measure)),
  height = function(state, measure, keep) list(pairs = pair_nodes_of(state, measure)),
  length = function(state, measure, keep) list(pairs = pair_nodes_of(state, measure)),
  depth = function(state, measure, keep) list(nodes = nodes_of_places(state, measure$place)),
  sinking_speed = function(state, measure, keep) list(),
  clearance = function(state, measure, keep) list(nodes = nodes_of_places(state, measure$place)),
  area = function(state, measure, keep) list(outline = I(outline_nodes(state, measure$ropes))),
  angle = function(state, measure, keep) {
    bar <- rope_bar(state$lattice, measure$rope, measure$place)
    list(nodes = I(state$lattice$engine$bars$node[2L * bar + c(-1L, 0L)] - 1L), way = measure$angle)
  },
  attitude = function(state, measure, keep) {
    angles <- c("attack", "heel", "trim")
    list(board = match(measure$board, names(state$si$otter_boards)) - 1L,
      angle = match(measure$angle, angles) - 1L)
  },
  tension = function(state, measure, keep) {
    lattice <- state$lattice
    bar <- if (measure$place == "max") {
      rope_bars(lattice, measure$rope)
    } else {
      rope_bar(lattice, measure$rope, measure$place)
    }
    list(bars = I(bar - 1L), place = measure$place)
  },
  drag = function(state, measure, keep) list(parts = parts_by_name(state, measure$parts)),
  lift = function(state, measure, keep) list(parts = parts_by_name(state, measure$parts)),
  mesh_opening = function(state, measure, keep) {
    list(panels = I(match(measure$panels, names(state$si$panels)) - 1L))
  },
  mesh_angle = function(state, measure, keep) {
    list(panels = I(match(measure$panels, names(state$si$panels)) - 1L))
  },
  volume = function(state, measure, keep) volume_program(state, measure, keep),
  volume_share = function(state, measure, keep) {
    asked <- Filter(function(one) one$kind == "volume_share", state$si$measures)
    c(volume_program(state, measure, keep),
      list(share = which(vapply(asked, identical, NA, measure))[1L] - 1L))
  },
  enclosed_volume = function(state, measure, keep) {
    lattice <- state$lattice
    corners <- cell_corners(lattice)
    triangles <- cell_triangles(has_three_corners(corners))
    node <- matrix(corners[triangles$corner + 4L * rep(triangles$cell - 1L, each = 3L)], 3L)
    rope <- lattice$ropes[[measure$rope]]$node
    rope <- rope[c(TRUE, diff(rope) != 0)]
    list(
      triangles = keep(as.integer(node) - 1L),
      weights = keep(triangles$weight * lattice$engine$cells$multiplicity[triangles$cell]),
      rope = I(rope - 1L), way = if (runs_along(node, rope)) -1 else 1
    )
  }
)

# Standard measures, which the page takes from what it holds of the whole gear.
shared_standard <- c(
  "total_drag", "tow_power", "filtered_volume", "swept_area", "mouth_blockage", "engine_power",
  "pull_used", "fuel_rate", "fuel_per_swept_area", "fuel_per_filtered_volume", "fuel_per_catch",
  "catch_volume", "catch_surface", "catch_front", "largest_rope_tension",
  "largest_panel_twine_tension", "most_loaded_twine_tension", "slack_netting",
  "rope_on_ground", "ground_load", "ground_friction", "least_depth", "greatest_depth"
)

nodes_of_places <- function(state, places) {
  I(vapply(places, state$lattice$place, 0L, USE.NAMES = FALSE) - 1L)
}

pair_nodes_of <- function(state, measure) lapply(measure$pairs, nodes_of_places, state = state)

parts_by_name <- function(state, names) I(which(state$lattice$parts$name %in% names) - 1L)

# Nodes along ropes put end to end, as rope_outline() has them.
outline_nodes <- function(state, ropes) {
  all <- unlist(lapply(ropes, function(rope) state$lattice$ropes[[rope]]$node))
  found <- rope_outline(state, ropes)
  # a place may have several nodes: those of these ropes are told by their place
  key <- function(x) paste(x[1L, ], x[2L, ], x[3L, ])
  all[match(key(found), key(state$position[, all, drop = FALSE]))] - 1L
}

# What volume_within() takes: facets between places of panels, and lids over their openings.
volume_program <- function(state, measure, keep) {
  facets <- panel_facets(state, measure$panels)
  rows <- panel_rows(panel_table(state$si$panels), state$lattice, state_points(state))
  on <- row_places(panel_table(state$si$panels), state$lattice[c("nodes", "division", "panels")])
  kept <- which(rows$panel[rows$row] %in% match(measure$panels, names(state$si$panels)))
  lids <- panel_lid_nodes(state, measure$panels)
  list(
    from = keep(on$from[kept] - 1L), to = keep(on$to[kept] - 1L), between = keep(on$share[kept]),
    facets = keep(as.integer(facets$node) - 1L), lid_from = keep(lids$from - 1L),
    lid_to = keep(lids$to - 1L), lid = keep(lids$opening)
  )
}

# What of a state its measures are taken from: list(programs = by measure list(kind, op, unit,
# words, value, error (as a share), definition, ...), arrays, whole = what standard measures take,
# missing = names of measures that the page cannot compute).
shared_measures <- function(state) {
  found <- measures(state)
  kind <- attr(found, "kind")
  unit <- attr(found, "unit")
  error <- attr(found, "error")
  arrays <- list()
  keep <- function(x) {
    name <- paste0("measure/", length(arrays))
    arrays[[name]] <<- x
    name
  }
  asked <- state$si$measures
  columns <- vapply(asked, `[[`, "", "column")
  words <- words_of(names(found), unname(unit))
  definition <- definitions_of(found)
  programs <- list()
  missing <- character()
  for (k in seq_along(found)) {
    name <- names(found)[k]
    at <- match(name, columns)
    program <- if (!is.na(at)) {
      make <- shared_kinds[[asked[[at]]$kind]]
      if (!is.null(make)) make(state, asked[[at]], keep)
    } else if (kind[[k]] %in% shared_standard) {
      list()
    }
    if (is.null(program)) {
      missing <- c(missing, words[k])
      next
    }
    value <- plain_measures(found)[[k]]
    programs[[name]] <- c(list(
      kind = kind[[k]], asked = !is.na(at), unit = unit[[k]], size = unit_size(unit[[k]]),
      words = words[k], value = value, definition = definition[[k]],
      error = if (is.finite(error[[k]]) && value != 0) error[[k]] / abs(value)
    ), program)
  }
  whole <- shared_whole(state, keep)
  list(programs = programs, arrays = arrays, whole = whole, missing = missing)
}

# What measures of the whole gear take.
shared_whole <- function(state, keep) {
  lattice <- state$lattice
  si <- state$si
  engine <- lattice$engine
  by_flow <- reported_forces("flow")
  kinds <- unique(by_flow$kind)
  netting <- which(lattice$parts$kind[lattice$bar_part] == "netting")
  ropes <- which(lattice$parts$kind[lattice$bar_part] == "rope")
  struts <- names(Filter(function(rope) rope$strut, si$ropes))
  held <- names(Filter(function(point) !is.na(point$held), si$points))
  supports <- vapply(held, function(name) lattice$points[[name]], 0L, USE.NAMES = FALSE)
  on_edges <- unlist(lapply(lattice$held_edges, function(edge) {
    edge$node[-c(1L, length(edge$node))]
  }))
  mouth <- si$measures$mouth_area
  wings <- si$measures$wing_end_spread
  list(
    parts = nrow(lattice$parts), gravity = gear_gravity, loaded_most = loaded_most,
    flow = lapply(seq_len(nrow(by_flow)), function(k) as.list(by_flow[k, c("name", "kind")])),
    element_part = lapply(setNames(nm = kinds), function(kind) {
      keep(as.integer(element_part(lattice, kind)) - 1L)
    }),
    bar_part = keep(lattice$bar_part - 1L), cell_part = keep(lattice$cell_part - 1L),
    cell_bars = if (length(engine$cells$rest)) keep(cell_bars(engine$cells)),
    netting = keep(netting - 1L), ropes = keep(ropes - 1L),
    ground_ropes = keep(ropes[!lattice$parts$name[lattice$bar_part[ropes]] %in% struts] - 1L),
    supports = I(c(supports, on_edges) - 1L),
    mouth = if (identical(mouth$kind, "area")) list(
      outline = I(outline_nodes(state, mouth$ropes)),
      nodes = I(unique(unlist(lapply(mouth$ropes, function(r) lattice$ropes[[r]]$node))) - 1L)
    ),
    wings = if (identical(wings$kind, "spread")) pair_nodes_of(state, wings),
    contacts = keep(as.integer(unlist(engine$contacts$node)) - 1L),
    catch = if (!is.null(si$catch)) list(
      node = keep(as.integer(lattice$catch$node) - 1L), blocked = lattice$catch$blocked,
      given = if (is.na(si$catch$volume)) "front" else "volume"
    )
  )
}
