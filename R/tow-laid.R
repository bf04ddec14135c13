# Start of a tow from rest with ropes laid on the sea bed. Rope ends and the net start from the
# settled state.

# Length over depth of the part of a rope that leads from its support down to the sea bed.
laid_scope <- 3

# Returns positions of the laid gear (3 x nodes, m) from its settled state.
laid_position <- function(state) {
  laid <- state$si$laid
  ground <- state$si$ground
  position <- state$position
  ropes <- names(laid$ropes)
  ends <- vapply(ropes, function(rope) {
    position[, state$mesh$places[[paste0(rope, ".end")]]]
  }, numeric(3))
  held <- state$mesh$model$held
  moved <- c(laid$net - rowMeans(ends)[1:2], 0)
  # keep the height above the sea bed
  above <- height_above_ground(ground, position)
  position <- on_ground(ground, position + moved, above)
  position[, held] <- state$position[, held]
  for (rope in ropes) {
    nodes <- state$mesh$ropes[[rope]]
    start <- state$position[, nodes$node[1L]]
    end <- position[, nodes$node[length(nodes$node)]]
    way <- cbind(start[1:2], laid$ropes[[rope]], end[1:2])
    along <- laid_along(
      way, height_above_ground(ground, cbind(start)), nodes$at
    )
    length <- state$si$ropes[[rope]]$length
    if (along$length > length * (1 + laid_stretch)) {
      abort_schedule("gear", sprintf(
        "has a rope %s of %s, shorter than its laid path of %s.", rope, format_si(length, "length"),
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

# Largest relative excess of the track length over the rope length.
laid_stretch <- 0.001

# Returns list(place (2 x n), above (heights above ground), length) in m at fractions of a track.
# `way`: corners of the track (2 x corners, m); `above`: height of its start (m).
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

# Moves positions vertically to the given heights above the ground (m).
on_ground <- function(ground, position, above) {
  lift <- (above - height_above_ground(ground, position)) / ground$normal[3L]
  position[3L, ] <- position[3L, ] + lift
  position
}
