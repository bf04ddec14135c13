# Measures as the plan asks for them: what each kind is, and how a plan's question is checked.

# Every kind of measure that a plan may ask for: lists as define_measure() makes them, by kind. The
# files of measures fill it while the package is built, so that the gear knows what to check and
# need not know how it is computed.
measure_kinds <- new.env(parent = emptyenv())

# kind: as in the plan; unit: in which it is shown, in_unit() knows it; definition: what it is, in
# the field's words; asks(asked, path, known): what the plan asks for, checked and taken apart, as a
# named list (an unknown place, rope, panel or piece is an error of class `codend_error_plan`);
# sensor: what tells it on a vessel or a model, and what that sees otherwise, or NA. The engine
# computes it (src/engine/measure).
define_measure <- function(kind, unit, definition, asks, sensor = NA_character_) {
  measure_kinds[[kind]] <- list(
    kind = kind, unit = unit, definition = one_line(definition), sensor = one_line(sensor),
    asks = asks
  )
}

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

# A text over several lines of code as one line.
one_line <- function(text) gsub("[[:space:]]+", " ", text)
