# Common parts of trawl short forms: the sections of a net, and the ropes along them.

# Returns a rope or piece with its position (`...`) and its role; NULL if the plan has none.
part_with_role <- function(given, role, ...) {
  if (!is.null(given)) c(list(...), given, list(role = role))
}

rope_between <- function(from, to, given, role) {
  c(list(from = from, to = to), given, list(role = role))
}

# Returns the fields that the assembly copies from a short form, in the designer's units. It always
# has the drag model of netting of its kind (from `fields`).
shared_fields <- function(plan, fields) {
  out <- plan[intersect(
    c(
      "codend", "name", "notes", "sources", "water", "seabed", "method", "netting",
      "coefficients", "netting_drag", "slack_twine", "shielding", "multipliers", "materials",
      "towing", "tow", "vessel"
    ),
    names(plan)
  )]
  if (is.null(out$netting_drag)) out$netting_drag <- fields$netting_drag
  out
}

section_panel_name <- function(panel, section) paste0(panel, "_", section)

# Returns a panel of a section: the fields of the section, overridden by the fields of its side.
section_panel <- function(section, panel) {
  side <- if (panel %in% c("back", "belly")) panel else "side"
  own <- section[setdiff(names(section), c("back", "belly", "side", "take_up", "covers"))]
  other <- section[[side]]
  # Complete counts of a side replace the cutting rate of the section.
  if (all(c("upper", "lower", "deep") %in% names(other$meshes))) own$cutting <- NULL
  own[names(other)] <- other
  own
}

# Returns the covers over one panel of a section, named after the panel.
covers_of <- function(section, panel, name) {
  kind <- if (panel %in% c("back", "belly")) panel else "side"
  covers <- Filter(
    function(cover) is.null(cover$over) || kind %in% unlist(cover$over), section$covers
  )
  covers <- lapply(covers, function(cover) cover[names(cover) != "over"])
  if (length(covers)) names(covers) <- paste(name, names(covers), sep = "_")
  covers
}

# Returns the grid of the sections.
section_grid <- function(fields, plan, around) {
  cells <- list()
  for (section in names(plan$sections)) {
    given <- plan$sections[[section]]
    for (panel in around) {
      name <- section_panel_name(panel, section)
      covers <- covers_of(given, panel, name)
      covers <- Map(function(cover, part) c(cover, list(part = part)), covers,
        sub(paste0(name, "_"), "", names(covers), fixed = TRUE))
      piece <- c(section_panel(given, panel), list(part = section))
      own <- section_panel(fields$sections[[section]], panel)
      cells[[name]] <- new_cell(stats::setNames(list(piece), name), own$meshes, own$mesh_size,
        covers = covers)
    }
  }
  columns <- lapply(stats::setNames(nm = around), function(panel) names(plan$sections))
  list(columns = columns, cells = cells, gathered = FALSE,
    separators = net_separators(fields, plan, columns))
}

# Returns list(upper, lower, deep): the counts of a wing. Throws an error if two wings are wider
# than the `across` meshes behind them. `path`: path of the counts in the plan.
wing_counts <- function(meshes, across, path) {
  if (2 * meshes$base > across) {
    abort_field(paste0(path, ".base"), meshes$base,
      paste("at most half the", format(across), "meshes of the front edge behind"))
  }
  list(upper = meshes$tip, lower = meshes$base, deep = meshes$deep)
}

# Returns list(panels, seams, points, ropes) of the net of a trawl.
trawl_net <- function(grid, fields, plan) {
  net <- joined_grid(grid)
  mouth <- mouth_chains(grid)
  for (line in c("headline", "footrope", "ground_gear")) {
    fields[[line]]$length <- line_length(fields[[line]])
  }
  net$lines <- list(headline = "headline")
  net$fronts <- lapply(stats::setNames(nm = trawl_sides), function(side) {
    names(column_cells(grid, paste0("side_", side))[[1L]]$pieces)
  })
  fronts <- c(headline = "back", footrope = "belly", side_lines = "side_port")
  for (line in intersect(names(fronts), names(plan))) {
    chain <- mouth[[if (line == "side_lines") "side_line_port" else line]]
    wings <- if (fronts[[line]] %in% names(grid$columns)) panel_front(grid, fronts[[line]])$wings
    plan[[line]] <- hung_line(fields, plan, line, length(chain), wings)
  }
  if (!grid$gathered) net$points <- c(wing_end_points(grid), net$points)
  net$ropes <- grid_ropes(grid, plan, mouth)
  if (!is.null(plan$ground_gear) && is.null(plan$ground_gear$sections)) {
    net$ropes$ground_gear <- ground_gear_rope(fields, plan, mouth$footrope, plan$footrope$lengths)
  }
  for (line in c("headline", "footrope", "ground_gear")) {
    if (is.null(fields[[line]]$sections)) next
    of <- if (line == "headline") line else "footrope"
    ropes <- section_ropes(line, fields, plan, chain_edges(grid, mouth[[of]]), plan[[of]])
    at <- match(line, names(net$ropes), nomatch = length(net$ropes) + 1L)
    net$ropes <- append(net$ropes[setdiff(names(net$ropes), line)], ropes, at - 1L)
    net$lines[[line]] <- mouth[[of]]
  }
  net
}

# Returns the ropes along the mouth (chains of edges by name), along the seams between panels and
# around the net.
grid_ropes <- function(grid, plan, mouth) {
  around <- names(grid$columns)
  line <- function(given, role, along) c(list(along = along), given, list(role = role))
  ropes <- list()
  for (name in names(mouth)) {
    role <- sub("_(port|starboard)$", "", name)
    given <- if (role == "side_line") plan$side_lines else plan[[name]]
    ropes[[name]] <- line(given, role, mouth[[name]])
  }
  if (!is.null(plan$belly_lines)) {
    given <- plan$belly_lines[setdiff(names(plan$belly_lines), "until")]
    for (k in seq_along(around)) {
      panel <- panel_after(around)[k]
      rows <- grid$columns[[panel]]
      until <- match(first_of(plan$belly_lines$until, rows[length(rows)]), rows)
      cells <- column_cells(grid, panel)[seq_len(until)]
      ropes[[paste("belly_line", around[k], panel, sep = "_")]] <-
        line(given, "belly_line", outer_edges(cells, "left", "joined"))
    }
  }
  for (name in names(plan$cross_ropes)) {
    given <- plan$cross_ropes[[name]]
    ropes[[name]] <- line(given[setdiff(names(given), "behind")], "cross_rope",
      rear_edges(around, given$behind))
  }
  ropes
}

# Returns the rear edges of a row, around the net.
rear_edges <- function(around, row) paste0(section_panel_name(around, row), ".lower")

# Number of positions around the net that share a grid's weight and drag.
places_of_grid <- 12

trawl_grids <- function(fields, around) {
  lapply(fields$grids, function(grid) {
    along <- rear_edges(around, grid$behind)
    density <- if (is.null(grid$density) && is.null(grid$material) && is.null(grid$volume)) 7850
    own <- grid[names(grid) != "behind"]
    for (field in intersect(c("mass", "volume", "area", "drag_area"), names(own))) {
      own[[field]] <- own[[field]] / places_of_grid
    }
    c(list(along = along, number = places_of_grid), own,
      if (!is.null(density) && !is.null(grid$mass)) list(density = density), list(role = "grid"))
  })
}

# Throws an error if belly lines, cross ropes or grids name an unknown section, or if the first
# section has a cover, which needs a section in front.
check_section_names <- function(fields) {
  check_section <- function(name, path) {
    sections <- c(names(fields$sections), Reduce(intersect, lapply(fields$net, names)))
    if (!is.null(name) && !name %in% sections) {
      abort_reference(name, name, sections, "section", path)
    }
  }
  check_section(fields$belly_lines$until, "belly_lines.until")
  for (name in names(fields$cross_ropes)) {
    check_section(fields$cross_ropes[[name]]$behind, paste0("cross_ropes.", name, ".behind"))
  }
  for (name in names(fields$grids)) {
    check_section(fields$grids[[name]]$behind, paste0("grids.", name, ".behind"))
  }
  if (length(fields$sections) && length(fields$sections[[1L]]$covers)) {
    abort_field(paste0("sections.", names(fields$sections)[1L], ".covers"), "given",
      "omitted in the first section; use it on a later section (cut the first one in two)")
  }
}

# Returns a line of the mouth with its length or hanging ratio along each edge, if the plan gives
# the bosom separately. `edges`: number of edges; `wings`: cells of wings along it, from the front.
hung_line <- function(fields, plan, line, edges, wings) {
  given <- plan[[line]]
  field <- intersect(c("bosom", "bosom_hanging_ratio"), names(fields[[line]]))
  if (!length(field)) return(given)
  path <- paste(line, field, sep = ".")
  if (!length(wings) || edges != 2L * length(wings) + 1L) {
    abort_field(path, given[[field]],
      "omitted if the line does not follow a wing, the front and the other wing")
  }
  along <- function(wing, bosom) c(wing, bosom, rev(wing))
  if (field == "bosom_hanging_ratio") {
    ratios <- along(rep(given$hanging_ratio, length(wings)), given$bosom_hanging_ratio)
    return(c(
      given[setdiff(names(given), c("hanging_ratio", field))], list(hanging_ratios = ratios)
    ))
  }
  bosom <- fields[[line]]$bosom
  whole <- fields[[line]]$length
  if (is.null(whole)) {
    abort_field(path, given$bosom, "used with the `length` of the line, not with a hanging ratio")
  }
  if (bosom >= whole) {
    abort_field(path, given$bosom, paste("less than its whole length,", format_si(whole, "length")))
  }
  long <- vapply(wings, `[[`, 0, "inner_length")
  c(
    given[setdiff(names(given), c("length", "bosom"))],
    list(lengths = along((whole - bosom) / 2 * (long / sum(long)), bosom))
  )
}
