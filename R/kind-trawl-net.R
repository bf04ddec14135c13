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
    separators = net_separators(fields, plan, columns, cells))
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

# Returns the net of a trawl: list(panels, seams, points, ropes, pieces, lines, columns, headline,
# fronts).
# `lines`: names of the ropes of each line, by field; `columns`: rows of the panels; `headline`: its
# rope or chain; `fronts`: first pieces of the side panels.
trawl_net <- function(grid, fields, plan) {
  grid <- with_grid_rows(grid, fields)
  net <- joined_grid(grid)
  mouth <- mouth_chains(grid)
  for (line in intersect(c("headline", "footrope", "side_lines", "ground_gear"), names(plan))) {
    fields[[line]]$length <- line_length(fields[[line]], line)
  }
  net$fronts <- lapply(stats::setNames(nm = trawl_sides), function(side) {
    names(column_cells(grid, paste0("side_", side))[1L][[1L]]$pieces)
  })
  fronts <- c(headline = "back", footrope = "belly", side_lines = "side_port")
  for (line in intersect(names(fronts), names(plan))) {
    chain <- mouth[[if (line == "side_lines") "side_line_port" else line]]
    wings <- if (fronts[[line]] %in% names(grid$columns)) panel_front(grid, fronts[[line]])$wings
    plan[[line]] <- hung_line(fields, plan, line, length(chain), wings)
  }
  if (!grid$gathered) net$points <- c(net$points, wing_end_points(grid))
  chains <- line_chains(grid, plan, mouth)
  ropes <- lapply(names(chains), function(name) {
    line_ropes(name, chains[[name]], grid, fields, plan)
  })
  devices <- sorting_grids(grid, fields)
  net$ropes <- c(do.call(c, ropes), devices$ropes)
  net$pieces <- devices$pieces
  line <- vapply(chains, `[[`, "", "line")
  net$lines <- split(unlist(lapply(ropes, names)), factor(rep(line, lengths(ropes)), unique(line)))
  net$columns <- grid$columns
  net$headline <- if (is.null(plan$headline$sections)) "headline" else mouth$headline
  net
}

# Returns the chains of edges of all lines along the mouth, along the seams between panels and
# around the net: list(line (field of the plan), along) each, by name.
line_chains <- function(grid, plan, mouth) {
  chains <- lapply(stats::setNames(nm = names(mouth)), function(name) {
    list(line = if (startsWith(name, "side_line")) "side_lines" else name, along = mouth[[name]])
  })
  if (!is.null(plan$belly_lines)) {
    for (pair in neighbours(grid$columns)) {
      # Sections on the port side follow the mirror image of the edge on the starboard side.
      port <- pair$panel == "belly" || endsWith(pair$panel, "_port")
      mirrored <- port && !is.null(plan$belly_lines$sections)
      panel <- if (mirrored) pair$panel else pair$after
      rows <- pair$columns[[panel]]
      whole <- grid$columns[[panel]]
      until <- first_of(rear_row(whole, plan$belly_lines$until), whole[length(whole)])
      rows <- rows[match(rows, whole) <= match(until, whole)]
      if (!length(rows)) next
      along <- outer_edges(cells_of(grid, panel, rows), if (mirrored) "right" else "left", "joined")
      chains[[paste("belly_line", pair$panel, pair$after, sep = "_")]] <-
        list(line = "belly_lines", along = along)
    }
  }
  for (name in names(plan$cross_ropes)) {
    chains[[name]] <- list(line = "cross_ropes",
      along = rear_edges(grid, plan$cross_ropes[[name]]$behind))
  }
  if (!is.null(plan$ground_gear)) {
    chains$ground_gear <- list(line = "ground_gear", along = mouth$footrope)
  }
  chains
}

# Returns the ropes of a line: one, or one for each section.
line_ropes <- function(name, chain, grid, fields, plan) {
  line <- chain$line
  given <- if (line == "cross_ropes") plan$cross_ropes[[name]] else plan[[line]]
  hung <- if (line == "ground_gear") plan$footrope else given
  # Ground gear is distributed like the footrope.
  if (line == "ground_gear" && hung_by_sections(fields$footrope)) {
    ropes <- line_ropes("footrope", list(line = "footrope", along = chain$along), grid, fields,
      plan)
    hung <- list(lengths = unlist(lapply(ropes, `[[`, "lengths"), use.names = FALSE))
    chain$along <- unlist(lapply(ropes, `[[`, "along"), use.names = FALSE)
  }
  if (!is.null(given$sections)) {
    edges <- chain_edges(grid, chain$along)
    lengths <- first_of(hung$lengths, edges$stretched * first_of(unlist(hung$hanging_ratios), 1))
    return(section_ropes(name, line, fields, given, edges, lengths))
  }
  rope <- if (line == "ground_gear") {
    ground_gear_rope(fields, plan, chain$along, hung$lengths)
  } else {
    c(list(along = chain$along), given[setdiff(names(given), c("until", "behind"))],
      list(role = line_role(line)))
  }
  stats::setNames(list(rope), name)
}

# Returns the role of the ropes of a field.
line_role <- function(line) sub("(line|rope)s$", "\\1", line)

# Returns the rear edges of a row, around the net.
rear_edges <- function(grid, row) {
  cells <- grid$cells[paste(names(grid$columns), lapply(grid$columns, rear_row, row), sep = "_")]
  pieces <- lapply(unname(cells), function(cell) {
    names(cell$pieces)[first_of(cell$across$lower, 1) > 0]
  })
  paste0(unlist(pieces), ".lower")
}

# Throws an error if belly lines, cross ropes or grids name an unknown section, or if the first
# section has a cover, which needs a section in front.
check_section_names <- function(fields) {
  check_section <- function(name, path) {
    sections <- c(names(fields$sections),
      Reduce(intersect, lapply(fields$net[c("upper", "lower")], names)))
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
