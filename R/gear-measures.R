# Measures as the plan asks for them: what each kind is, and how a plan's question is checked.

# A measure of a plan: list(kind, column (its name among the measures of a state)) and what its kind
# asks for.
si_measure <- function(measure, path, known) {
  kind <- measure_kinds[[names(measure)]]
  name <- sub("^measures[.]", "", path)
  asked <- kind$asks(measure[[1]], paste0(path, ".", kind$kind), known)
  c(list(kind = kind$kind, column = with_unit(name, kind$unit)), asked)
}

# ---- what kinds of measures ask for --------------------------------------------------------------

asks_place <- function(asked, path, known) list(place = find_place(asked, path, known))

# A place, or several.
asks_places <- function(asked, path, known) {
  list(place = vapply(unlist(asked), find_place, "", path = path, known = known, USE.NAMES = FALSE))
}

# Two places.
asks_pair <- function(asked, path, known) {
  list(pairs = list(lapply(as.list(asked), find_place, path, known)))
}

# Two places, or a list of pairs of places.
asks_pairs <- function(asked, path, known) {
  pairs <- lapply(spread_pairs(asked, path), function(pair) {
    asks_pair(pair, path, known)$pairs[[1]]
  })
  list(pairs = pairs)
}

asks_place_over_ground <- function(asked, path, known) {
  place <- find_place(asked, path, known)
  if (!known$ground) abort_field(path, place, "used only where the plan has a `seabed`")
  list(place = place)
}

asks_rope <- function(asked, path, known) list(rope = find_rope(asked, path, known))

asks_ropes <- function(asked, path, known) {
  list(ropes = vapply(asked, find_rope, "", path = path, known = known, USE.NAMES = FALSE))
}

# A rope's start, middle or end: list(rope, place). Of a tension also `max`.
asks_rope_place <- function(asked, path, known) {
  at <- parse_place(find_place(asked, path, known))
  list(rope = at$name, place = at$place)
}

asks_rope_angle <- function(asked, path, known) {
  c(asks_rope_place(names(asked), path, known), angle = asked[[1]])
}

asks_board_angle <- function(asked, path, known) {
  list(board = find_board(names(asked), path, known), angle = asked[[1]])
}

asks_panels <- function(asked, path, known) list(panels = find_panels(asked, path, known))

# Panels, and the volume (m3) whose share is asked for.
asks_share <- function(asked, path, known) {
  list(panels = find_panels(asked$panels, paste0(path, ".panels"), known), of = asked$of)
}

asks_parts <- function(asked, path, known) list(parts = find_parts(asked, path, known))

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

find_board <- function(name, path, known) {
  if (!name %in% known$otter_boards) {
    abort_reference(name, name, known$otter_boards, "free otter board", path)
  }
  name
}

spread_pairs <- function(asked, path) {
  single <- vapply(asked, is.character, logical(1)) & lengths(asked) == 1
  if (all(single) && length(asked) == 2) return(list(unlist(asked)))
  if (any(single)) abort_field(path, asked, "two places, or a list of pairs of places")
  asked
}

# ---- kinds of measures ---------------------------------------------------------------------------

# The kinds of measures: their names, units, definitions and classes stand once, in
# inst/schema/measures.csv, from which the engine's enumeration and the schema's words are made too
# (tools/schema.R). The engine computes them (src/engine/measure).
#
# A row a kind: `kind`, as in the plan and in the engine; `unit` in which it is shown, in_unit()
# knows it; `class` of measures whose errors are alike, and the `quantity` that it is a number of
# (src/engine/measure/measure_errors.hpp); `asks`, what a plan has to give, as the end of a name of
# the functions above, nothing for a measure of every gear; `definition`; and `sensor`, what tells
# it on a vessel or a model, and what that sees otherwise. Measures of every gear stand in the order
# in which they are told.
measure_rows <- utils::read.csv(
  system.file("schema", "measures.csv", package = "codend", mustWork = TRUE),
  na.strings = ""
)

measure_entries <- function(rows) {
  setNames(lapply(rows, function(k) {
    asks <- measure_rows$asks[k]
    c(as.list(measure_rows[k, c("kind", "unit", "definition", "sensor")]),
      if (!is.na(asks)) list(asks = get(paste0("asks_", asks))))
  }), measure_rows$kind[rows])
}

# Kinds that a plan may ask for, and those of every gear, by name: lists of kind, unit, definition,
# sensor (NA where none is known) and, of the former, asks(asked, path, known): what the plan asks
# for, checked and taken apart, as a named list (an unknown place, rope, panel or piece is an error
# of class `codend_error_plan`).
measure_kinds <- measure_entries(which(!is.na(measure_rows$asks)))
standard_measures <- measure_entries(which(is.na(measure_rows$asks)))
