# The way of a vessel that shoots a gear, straight or an arc.

# Places (2 x n, m) at distances (m) along the way that a rope of this length is laid.
vessel_way <- function(shooting, length, reach) {
  turn <- shooting$arc / length
  if (turn == 0) return(rbind(shooting$from[1] - reach, shooting$from[2] + 0 * reach))
  rbind(
    shooting$from[1] - sin(turn * reach) / turn,
    shooting$from[2] + (1 - cos(turn * reach)) / turn
  )
}
