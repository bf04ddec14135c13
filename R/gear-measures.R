# Measures as the plan asks for them, taken apart.

measure_units <- c(
  spread = "m", height = "m", length = "m", depth = "m", clearance = "m", tension = "kN",
  area = "m2", angle = "deg", attitude = "deg"
)

# Returns list(kind, column, unit) and, by kind: pairs (list of two places each) for spread, height
# and length; place for depth and clearance; rope and place (start, middle, end or max) for tension; ropes for
# area; rope, place and angle (declination or divergence) for angle; board and angle (attack, heel
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
    depth = list(place = place(asked)),
    clearance = list(place = place_over_ground(place(asked), path, known)),
    tension = parse_place(place(asked))[c("name", "place")],
    area = list(ropes = vapply(asked, find_rope, "", path = path, known = known,
      USE.NAMES = FALSE)),
    attitude = list(board = find_board(names(asked), path, known), angle = asked[[1]]),
    angle = c(parse_place(place(names(asked)))[c("name", "place")], angle = asked[[1]])
  )
  names(asks)[names(asks) == "name"] <- "rope"
  c(list(kind = kind, column = paste0(name, "_", unit), unit = unit), asks)
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
