# A tow that starts at rest with ropes lying on the sea bed along their ways, and what they pull as
# it is when it has settled.

# state: the settled gear's.
laid_trajectory <- function(state, given, until) {
  what <- tow_start(state$gear, state$si, state$lattice, given, until)
  add_start(what, laid_position(state), c(0, 0, 0))
}

# Over this times the depth a rope leads down from its held start to the sea bed.
laid_scope <- 3

# Positions (3 x nodes, m) of the gear as it is laid, from its settled state.
laid_position <- function(state) {
  laid <- state$si$laid
  ground <- state$si$ground
  position <- state$position
  ropes <- names(laid$ropes)
  ends <- vapply(ropes, function(rope) {
    position[, state$lattice$places[[paste0(rope, ".end")]]]
  }, numeric(3))
  held <- state$lattice$mesh$held
  moved <- c(laid$net - rowMeans(ends)[1:2], 0)
  # as high above the sea bed as before
  above <- height_above_ground(ground, position)
  position <- on_ground(ground, position + moved, above)
  position[, held] <- state$position[, held]
  for (rope in ropes) {
    nodes <- state$lattice$ropes[[rope]]
    start <- state$position[, nodes$node[1L]]
    end <- position[, nodes$node[length(nodes$node)]]
    way <- cbind(start[1:2], laid$ropes[[rope]], end[1:2])
    along <- laid_along(
      way, height_above_ground(ground, cbind(start)), nodes$at
    )
    length <- state$si$ropes[[rope]]$length
    if (along$length > length * (1 + laid_stretch)) {
      abort_schedule("gear", sprintf(
        "has a rope %s of %s that is laid along a way of %s.", rope, format_si(length, "length"),
        format_si(along$length, "length")
      ))
    }
    inner <- -c(1L, length(nodes$node))
    position[, nodes$node[inner]] <- on_ground(
      ground, rbind(along$place, 0), pmax(along$above, state$si$ropes[[rope]]$diameter / 2)
    )[, inner]
  }
  position
}

# How much longer than a rope the way may be along which it is laid.
laid_stretch <- 0.001

# Places (2 x n, m) and heights (m) above the ground at shares of a way (2 x corners, m) that begins
# so high above it: list(place, above, length).
laid_along <- function(way, above, share) {
  leg <- sqrt(colSums((way[, -1L, drop = FALSE] - way[, -ncol(way), drop = FALSE])^2))
  far <- c(0, cumsum(leg))
  level <- far[length(far)]
  down <- min(sqrt(laid_scope^2 - 1) * above, level)
  slant <- sqrt(down^2 + above^2)
  length <- slant + level - down
  reach <- share * length
  at <- ifelse(reach < slant, reach * down / slant, reach - slant + down)
  list(
    place = rbind(stats::approx(far, way[1L, ], at)$y, stats::approx(far, way[2L, ], at)$y),
    above = above * pmax(0, 1 - at / down), length = length
  )
}

# Places of the same x and y so far (m) above the ground.
on_ground <- function(ground, position, above) {
  lift <- (above - height_above_ground(ground, position)) / ground$normal[3L]
  position[3L, ] <- position[3L, ] + lift
  position
}
