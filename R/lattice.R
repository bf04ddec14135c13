# The lattice: a gear as numbers. Nodes, bars, netting triangles, point pieces and supports, and a
# crude layout to start from.

law_numbers <- c(constant = 0L, takagi = 1L, choo_casarella = 2L, cifuentes_kim = 3L)

# Builds the lattice of a gear.
#
# nodes: about how many nodes; netting: "bars" or "triangles" for every panel, or NULL for each
# panel's own.
# Returns class codend_lattice: list(engine = what the engine reads (see binding.cpp), start = 3 x
# nodes positions (m), parts = data.frame(name, kind, role), bar_part, triangle_part, sphere_part,
# lift_part = rows of parts per element, ropes = nodes along each rope with their fraction of its
# length, points = node of each point, place = function from a parsed place to a node,
# held_edges = of every seam held on a line its nodes, their fraction of its length and the names of
# its two points (between), panels = what the views draw of each panel).
build_lattice <- function(si, nodes = 1500, netting = NULL) {
  panels <- si$panels
  bars <- vapply(panels, function(p) identical(first_of(netting, p$netting), "bars"), NA)
  frame <- division_frame(si, linked = !bars)
  h <- element_length(panels, si$ropes, frame$pieces, bars, nodes)
  division <- divide_at(si, frame, bars, h)

  parts <- data.frame(
    name = c(names(si$ropes), names(panels), names(si$pieces)),
    kind = rep(c("rope", "netting", "piece"), c(length(si$ropes), length(panels), length(si$pieces))),
    role = c(
      vapply(si$ropes, function(r) r$role, ""), vapply(panels, function(p) p$part, ""),
      vapply(si$pieces, function(p) p$role, "")
    ),
    row.names = NULL
  )
  materials <- lapply(c(si$ropes, panels), twine_material)
  materials <- as.list(do.call(rbind.data.frame, unname(materials)))

  build <- new_collection(division$nodes)
  for (r in seq_along(si$ropes)) add_rope(build, si$ropes[[r]], division$ropes[[r]], r)
  drawn <- lapply(seq_along(panels), function(p) {
    part <- length(si$ropes) + p
    if (bars[p]) {
      add_bar_panel(build, panels[[p]], division, p, part, bar_grouping(panels[[p]], h))
    } else {
      add_triangle_panel(build, panels[[p]], division, p, part)
    }
  })
  names(drawn) <- names(panels)
  for (k in seq_along(si$pieces)) {
    along <- si$pieces[[k]]$along
    run <- if (identical(along$kind, "rope")) division$ropes[[along$name]]
    if (identical(along$kind, "chain")) {
      run <- division$laced(frame$chains$run[[names(si$pieces)[k]]])
    }
    add_piece(build, si$pieces[[k]], run, division$place, si$water$density,
      length(si$ropes) + length(panels) + k)
  }
  collected <- build$collect()
  supports <- gear_supports(si, division)
  density <- si$water$density
  loads <- supports$load
  loads <- cbind(loads, matrix(0, 3L, length(collected$mass) - ncol(loads)))
  loads[3, ] <- loads[3, ] - gear_gravity * (collected$mass - density * collected$volume)

  engine <- list(
    nodes = collected$nodes, held = c(supports$held, rep(FALSE, collected$nodes - division$nodes)),
    ties = collected$ties,
    water = list(
      density = density, viscosity = si$water$viscosity, depth = si$water$current$depth,
      x = si$water$current$x + si$towing$speed, y = si$water$current$y
    ),
    slack_twine = si$slack_twine,
    load = as.vector(loads), mass = collected$mass, materials = materials,
    bars = collected$bars[c("node", "rest", "multiplicity", "material")],
    triangles = collected$triangles[c("node", "twine", "rest", "multiplicity", "material")],
    spheres = collected$spheres[c("node", "drag_area", "diameter", "added_mass")],
    lifts = collected$lifts[c("node", "lift_area", "direction")]
  )
  lattice <- structure(
    list(
      engine = engine, parts = parts,
      bar_part = collected$bars$part, triangle_part = collected$triangles$part,
      sphere_part = collected$spheres$part, lift_part = collected$lifts$part,
      ropes = division$ropes, points = division$points, place = division$place,
      held_edges = division$held_edges, panels = drawn, h = h
    ),
    class = "codend_lattice"
  )
  check_totals(lattice, si)
  lattice$start <- lay_out(si, division, lattice, if (!any(bars)) frame)
  lattice$start[, which(supports$held)] <- supports$position[, supports$held]
  lattice
}

# What does not depend on how fine the division is: chains, breaks and pieces of all edges.
division_frame <- function(si, linked) {
  lengths <- edge_lengths(si$panels)
  chains <- lapply(si$seams, function(s) lapply(s$edges, chain_table, si$panels, lengths))
  gathered <- vapply(si$seams, function(s) !is.null(s$gathered_at), NA)
  laced <- Filter(Negate(is.null), lapply(si$ropes, function(r) {
    if (!is.null(r$along)) chain_table(r$along, si$panels, lengths)
  }))
  run <- Filter(Negate(is.null), lapply(si$pieces, function(p) {
    if (identical(p$along$kind, "chain")) chain_table(p$along$edges, si$panels, lengths)
  }))
  joined <- unname(chains[!gathered])
  gathered_chains <- unname(chains[gathered])
  breaks <- edge_breaks(
    si$panels, joined, unname(c(laced, run, unlist(gathered_chains, recursive = FALSE))), linked
  )
  list(
    pieces = edge_pieces(si$panels, joined, breaks, linked),
    chains = list(
      joined = joined, laced = laced, run = run,
      held = Filter(Negate(is.null), Map(
        function(chains, seam) {
          if (!is.null(seam$held_between)) list(chain = chains[[1]], between = seam$held_between)
        },
        chains, si$seams
      )),
      gathered = Map(
        function(chains, seam) list(chains = chains, at = seam$gathered_at),
        gathered_chains, unname(si$seams[gathered])
      )
    )
  )
}

divide_at <- function(si, frame, bars, h) {
  counts <- piece_counts(si$panels, frame$pieces, bars, h, bar_groupings(si$panels, bars, h))
  divide(si, frame$pieces, counts, rope_counts(si$ropes, h), bars, frame$chains)
}

# One row of the engine's table of materials, of a rope or a panel's twine.
twine_material <- function(line) {
  k <- line$coefficients
  given <- function(x) if (is.na(x)) 0 else x
  list(
    axial_stiffness = line$axial_stiffness,
    diameter = first_of(line$diameter, line$twine_diameter * line$twine_count),
    volume_per_length = line$volume_per_length,
    added_mass_normal = line$added_mass[["normal"]],
    added_mass_tangential = line$added_mass[["tangential"]],
    law = law_numbers[[k$law]],
    normal = given(k$normal), tangential = given(k$tangential), skin = given(k$skin),
    solidity = if (is.null(line$mesh_size)) 0 else panel_solidity(line)
  )
}

# Solidity Sn of a panel hanging at the nominal ratio: d / (a E1 E2) for diamond netting with bars
# a, and 2 d/a - (d/a)^2 for square.
panel_solidity <- function(panel) {
  ratio <- panel$twine_diameter * panel$twine_count / (panel$mesh_size / 2)
  if (panel$orientation == "square") return(2 * ratio - ratio^2)
  min(1, ratio / (nominal_hanging_ratio * nominal_depth_ratio))
}
