# Measures as the plan asks for them, taken apart.

measure_units <- c(
  spread = "m", height = "m", length = "m", depth = "m", clearance = "m", tension = "kN",
  area = "m2", angle = "deg", attitude = "deg", volume = "m3", volume_share = "percent",
  drag = "kN", lift = "kN", sinking_speed = "m_per_s", enclosed_volume = "m3"
)

# Returns list(kind, column, unit) and, by kind: pairs (list of two places each) for spread, height
# and length; place for depth, clearance and sinking_speed; rope for enclosed_volume; rope and place
# (start, middle, end or max) for tension; ropes for area; panels, and of (m3) for volume_share;
# parts for drag and lift; rope, place and angle (declination or divergence) for angle; board and
# angle (attack, heel
# or trim) for attitude.
si_measure <- function(measure, path, known) {
  kind <- names(measure)
  asked <- measure[[1]]
  path <- paste0(path, ".", kind)
  name <- sub("^measures[.](.+)[.][^.]+$", "\\1", path)
  unit <- measure_units[[kind]]
  place <- function(text) find_place(text, path, known)
  pair <- function(texts) lapply(as.list(texts), place)
  asks <- switch(kind,
    spread = list(pairs = lapply(spread_pairs(asked, path), pair)),
    height = , length = list(pairs = list(pair(asked))),
    depth = , sinking_speed = list(place = place(asked)),
    enclosed_volume = list(rope = find_rope(asked, path, known)),
    clearance = list(place = place_over_ground(place(asked), path, known)),
    tension = parse_place(place(asked))[c("name", "place")],
    area = list(ropes = vapply(asked, find_rope, "", path = path, known = known,
      USE.NAMES = FALSE)),
    volume = list(panels = find_panels(asked, path, known)),
    volume_share = list(
      panels = find_panels(asked$panels, paste0(path, ".panels"), known), of = asked$of
    ),
    drag = , lift = list(parts = find_parts(asked, path, known)),
    attitude = list(board = find_board(names(asked), path, known), angle = asked[[1]]),
    angle = c(parse_place(place(names(asked)))[c("name", "place")], angle = asked[[1]])
  )
  names(asks)[names(asks) == "name"] <- "rope"
  c(list(kind = kind, column = paste0(name, "_", unit), unit = unit), asks)
}

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

place_over_ground <- function(place, path, known) {
  if (!known$ground) abort_field(path, place, "asked for where the plan has a `seabed`")
  place
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
