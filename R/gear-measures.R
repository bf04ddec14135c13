# Returns list(kind, column, ...) for one measure of a plan. `column`: its name among the measures
# of a state; `...`: the checked request.
si_measure <- function(measure, path, known) {
  kind <- measure_kinds[[names(measure)]]
  name <- sub("^measures[.]", "", path)
  asked <- kind$requires(measure[[1]], paste0(path, ".", kind$kind), known)
  c(list(kind = kind$kind, column = with_unit(name, kind$unit)), asked)
}

# Returns list(kind, mouth, wing_ends) of a net: the ropes around its mouth, and pairs of locations.
si_net <- function(net, path, known) {
  list(
    kind = first_of(net$kind, "assembly"),
    mouth = unlist(requires_ropes(net$mouth, paste0(path, ".mouth"), known)),
    wing_ends = if (!is.null(net$wing_ends)) {
      requires_pairs(net$wing_ends, paste0(path, ".wing_ends"), known)$pairs
    }
  )
}

# Returns the net of a rig that each part or measure belongs to by its name, or "". It is "" in a
# gear of one net.
net_of_names <- function(names, si) {
  net <- rep("", length(names))
  nets <- if (length(si$nets) > 1L) names(si$nets)
  for (one in nets[order(nchar(nets))]) net[startsWith(names, paste0(one, "_"))] <- one
  net
}

# Returns the SI numbers of each net, by name: the parts of other nets are left out. Measures have
# their names without the name of the net. A gear of one net or none has one element.
si_by_net <- function(si) {
  names <- names(si$nets)
  if (length(names) < 2L) return(list(si))
  lapply(stats::setNames(nm = names), function(name) {
    for (group in c("ropes", "panels", "pieces", "otter_boards", "measures")) {
      net <- net_of_names(as.character(names(si[[group]])), si)
      si[[group]] <- si[[group]][net %in% c("", name)]
    }
    names(si$measures) <- sub(paste0("^", name, "_"), "", as.character(names(si$measures)))
    si$nets <- si$nets[name]
    si
  })
}

# ---- requests of measures ------------------------------------------------------------------------

requires_place <- function(asked, path, known) list(place = find_place(asked, path, known))

requires_places <- function(asked, path, known) {
  list(place = vapply(unlist(asked), find_place, "", path = path, known = known, USE.NAMES = FALSE))
}

requires_pair <- function(asked, path, known) {
  list(pairs = list(lapply(as.list(asked), find_place, path, known)))
}

# Two positions, or a list of pairs of positions.
requires_pairs <- function(asked, path, known) {
  single <- vapply(asked, is.character, NA) & lengths(asked) == 1
  if (all(single) && length(asked) == 2) return(requires_pair(unlist(asked), path, known))
  if (any(single)) abort_field(path, asked, "two positions, or a list of pairs of positions")
  list(pairs = lapply(asked, function(pair) requires_pair(pair, path, known)$pairs[[1]]))
}

requires_place_over_ground <- function(asked, path, known) {
  place <- find_place(asked, path, known)
  if (!known$ground) abort_field(path, place, "used only in a plan with `seabed`")
  list(place = place)
}

requires_rope <- function(asked, path, known) list(rope = find_rope(asked, path, known))

requires_ropes <- function(asked, path, known) {
  list(ropes = vapply(asked, find_rope, "", path = path, known = known, USE.NAMES = FALSE))
}

# Start, middle or end of a rope, or `max` for a tension. Returns list(rope, place).
requires_rope_place <- function(asked, path, known) {
  at <- parse_place(find_place(asked, path, known))
  list(rope = at$name, place = at$place)
}

# One angle at the same end of one or several ropes.
requires_rope_angle <- function(asked, path, known) {
  at <- lapply(names(asked), requires_rope_place, path, known)
  place <- unique(vapply(at, `[[`, "", "place"))
  angle <- unique(unlist(asked))
  if (length(place) > 1L || length(angle) > 1L) {
    abort_field(path, names(asked), "one angle at the same end of every rope")
  }
  list(rope = vapply(at, `[[`, "", "rope"), place = place, angle = angle)
}

requires_board_angle <- function(asked, path, known) {
  name <- names(asked)
  if (!name %in% known$otter_boards) {
    abort_reference(name, name, known$otter_boards, "free otter board", path)
  }
  list(board = name, angle = asked[[1]])
}

requires_panels <- function(asked, path, known) list(panels = find_panels(asked, path, known))

# Panels, and the volume (m3) whose fraction is requested.
requires_fraction <- function(asked, path, known) {
  list(panels = find_panels(asked$panels, paste0(path, ".panels"), known), of = asked$of)
}

requires_parts <- function(asked, path, known) list(parts = find_parts(asked, path, known))

find_panels <- function(names, path, known) {
  for (name in names) {
    if (!name %in% names(known$panels)) {
      abort_reference(name, name, names(known$panels), "panel", path)
    }
  }
  names
}

find_parts <- function(names, path, known) {
  parts <- c(known$ropes, names(known$panels), known$pieces, known$otter_boards)
  for (name in names) {
    if (!name %in% parts) abort_reference(name, name, parts, "rope, panel or piece", path)
  }
  names
}

# ---- kinds of measures ---------------------------------------------------------------------------

# Kinds of measures. `inst/schema/measures.csv` defines their names, units, definitions and classes.
# `tools/schema.R` also generates the engine's enumeration and the schema's strings from this file.
# The engine computes the measures (src/engine/measure).
#
# Columns, one row per kind:
# `kind`: name in the plan and in the engine.
# `unit`: display unit, known to `in_unit()`.
# `class`: class of measures with similar errors. `quantity`: physical quantity
# (src/engine/measure/measure_errors.hpp).
# `requires`: suffix of the `requires_*()` function above; empty for a measure of every gear.
# `definition`: definition for users.
# `sensor`: sensor that measures it on a vessel or a model, and the differences to the definition.
#
# Measures of every gear are printed in the order of this file.
measure_rows <- utils::read.csv(
  system.file("schema", "measures.csv", package = "codend", mustWork = TRUE),
  na.strings = ""
)

measure_entries <- function(rows) {
  setNames(lapply(rows, function(k) {
    requires <- measure_rows$requires[k]
    c(as.list(measure_rows[k, c("kind", "unit", "definition", "sensor")]),
      if (!is.na(requires)) list(requires = get(paste0("requires_", requires))))
  }), measure_rows$kind[rows])
}

# Named lists of kinds: requestable kinds (`measure_kinds`) and kinds of every gear
# (`standard_measures`). Each has kind, unit, definition and sensor (NA if unknown). A requestable
# kind also has `asks(asked, path, known)`, which returns the checked request as a named list. An
# unknown position, rope, panel or piece is an error of class `codend_error_plan`.
measure_kinds <- measure_entries(which(!is.na(measure_rows$requires)))
standard_measures <- measure_entries(which(is.na(measure_rows$requires)))
