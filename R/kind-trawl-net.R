# Common parts of trawl short forms: the net behind its mouth, wings, and the ropes along them.
#
# Panels are in clockwise order as seen from the vessel's deck looking aft: back, starboard sides
# from top to bottom, belly, port sides from bottom to top. Seen from outside with its front edge
# up, each panel's left edge is joined to the previous panel.

nothing <- stats::setNames(list(), character())

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

panel_after <- function(around) c(around[-1L], around[1L])

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

# Returns list(panels, seams, points): the panels of all sections, joined around the net and end to
# end, and gathered at the point `codline`. Every edge of a cover is joined to its panel.
trawl_sections <- function(plan, around) joined_sections(plan$sections, around)

joined_sections <- remembered(join_sections)

join_sections <- function(given, around) {
  panels <- seams <- list()
  n <- length(around)
  after <- panel_after(around)
  sections <- names(given)
  id <- section_panel_name
  # Returns an edge of a panel and of its covers.
  edges <- function(panel, section, edge) {
    name <- id(panel, section)
    paste0(c(name, names(covers_of(given[[section]], panel, name))), ".", edge)
  }
  for (section in sections) {
    for (panel in around) {
      name <- id(panel, section)
      panels[[name]] <- c(section_panel(given[[section]], panel), list(part = section))
      covers <- covers_of(given[[section]], panel, name)
      panels[names(covers)] <- Map(function(cover, part) c(cover, list(part = part)),
        covers, sub(paste0(name, "_"), "", names(covers), fixed = TRUE))
    }
    for (k in seq_len(n)) {
      seams[[paste(section, around[k], after[k], sep = "_")]] <- list(edges = c(
        edges(around[k], section, "right"), edges(after[k], section, "left")
      ))
    }
  }
  for (k in seq_along(sections)[-1L]) {
    for (panel in around) {
      seams[[paste(panel, sections[k - 1L], sections[k], sep = "_")]] <- list(edges = c(
        edges(panel, sections[k - 1L], "lower"), edges(panel, sections[k], "upper")
      ))
    }
  }
  last <- sections[length(sections)]
  seams$codline_gathered <- list(
    edges = unlist(lapply(around, edges, section = last, edge = "lower")), gathered_at = "codline"
  )
  list(panels = panels, seams = seams, points = list(codline = nothing))
}

# Returns two wings ahead of the front edge of a panel, one at each end.
#
# `panel`: prefix of their names; `behind`: the panel behind them; `across`: meshes of its front
# edge. `given`: fields of the wings as in the plan; `meshes`: their counts (tip, base, deep);
# `path`: path of the counts in the plan.
#
# Returns list(panels, seams, inner, left, right). `inner` is the chain of front edges from the left
# to the right wing tip; `left` and `right` are the names of the wings.
wing_pair <- function(panel, behind, across, given, meshes, path) {
  if (2 * meshes$base > across) {
    abort_field(paste0(path, ".base"), meshes$base,
      paste("at most half the", format(across), "meshes of the front edge behind"))
  }
  wing <- paste0(panel, "_wing_", c(left = "left", right = "right"))
  own <- given[setdiff(names(given), "meshes")]
  counts <- list(upper = meshes$tip, lower = meshes$base, deep = meshes$deep)
  panels <- lapply(c(left = "right", right = "left"), function(inner) {
    c(own, list(meshes = counts, tapered = inner, part = "wings"))
  })
  names(panels) <- wing
  edge <- paste0(behind, ".upper")
  base <- format(meshes$base)
  from <- format(across - meshes$base)
  seams <- list(
    list(edges = c(paste0(wing[1L], ".lower"), paste0(edge, "[0:", base, "]"))),
    list(edges = c(
      paste0(wing[2L], ".lower"), paste0(edge, "[", from, ":", format(across), "]")
    ))
  )
  names(seams) <- wing
  list(
    panels = panels, seams = seams, left = wing[1L], right = wing[2L],
    inner = c(
      paste0(wing[1L], ".right"),
      if (2 * meshes$base < across) paste0(edge, "[", base, ":", from, "]"),
      paste0("-", wing[2L], ".left")
    )
  )
}

# Returns ropes along the mouth, along the seams between panels and around the net.
#
# `mouth`: chain of edges for each line of the mouth; `outer`: for each panel, the edges of its left
# seam ahead of the first section.
trawl_lines <- function(plan, around, mouth, outer) {
  sections <- names(plan$sections)
  id <- section_panel_name
  after <- panel_after(around)
  ropes <- list()
  line <- function(given, role, along) c(list(along = along), given, list(role = role))
  for (name in names(mouth)) {
    role <- sub("_(port|starboard)$", "", name)
    given <- if (role == "side_line") plan$side_lines else plan[[name]]
    ropes[[name]] <- line(given, role, unlist(mouth[[name]], use.names = FALSE))
  }
  if (!is.null(plan$belly_lines)) {
    until <- first_of(plan$belly_lines$until, sections[length(sections)])
    covered <- sections[seq_len(match(until, sections))]
    given <- plan$belly_lines[setdiff(names(plan$belly_lines), "until")]
    for (k in seq_along(around)) {
      panel <- after[k]
      along <- c(outer[[panel]], paste0(vapply(covered, id, "", panel = panel), ".left"))
      ropes[[paste("belly_line", around[k], panel, sep = "_")]] <-
        line(given, "belly_line", unname(along))
    }
  }
  for (name in names(plan$cross_ropes)) {
    given <- plan$cross_ropes[[name]]
    along <- paste0(vapply(around, id, "", section = given$behind), ".lower")
    ropes[[name]] <- line(given[setdiff(names(given), "behind")], "cross_rope", along)
  }
  ropes
}

# Number of positions around the net that share a grid's weight and drag.
places_of_grid <- 12

trawl_grids <- function(fields, around) {
  lapply(fields$grids, function(grid) {
    along <- paste0(vapply(around, section_panel_name, "", section = grid$behind), ".lower")
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
    sections <- names(fields$sections)
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
  if (length(fields$sections[[1L]]$covers)) {
    abort_field(paste0("sections.", names(fields$sections)[1L], ".covers"), "given",
      "omitted in the first section; use it on a later section (cut the first one in two)")
  }
}

# Returns a line of the mouth with its length or hanging ratio along each edge, if the plan gives
# the bosom separately. `edges`: number of edges.
hung_line <- function(fields, plan, line, edges) {
  given <- plan[[line]]
  field <- intersect(c("bosom", "bosom_hanging_ratio"), names(fields[[line]]))
  if (!length(field)) return(given)
  path <- paste(line, field, sep = ".")
  if (edges != 3L) {
    abort_field(path, given[[field]],
      "omitted if the line does not follow a wing, the front and the other wing")
  }
  if (field == "bosom_hanging_ratio") {
    wing <- given$hanging_ratio
    ratios <- list(wing, given$bosom_hanging_ratio, wing)
    return(c(
      given[setdiff(names(given), c("hanging_ratio", field))], list(hanging_ratios = ratios)
    ))
  }
  bosom <- fields[[line]]$bosom
  whole <- fields[[line]]$length
  if (bosom >= whole) {
    abort_field(path, given$bosom, paste("less than its whole length,", format_si(whole, "length")))
  }
  c(
    given[setdiff(names(given), c("length", "bosom"))],
    list(lengths = c((whole - bosom) / 2, bosom, (whole - bosom) / 2))
  )
}
