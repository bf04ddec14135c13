# Returns positions (2 x n, m) on the course of a vessel that shoots a gear, straight or an arc.
# `length`: length of the rope that is shot; `reach`: distances (m) along it.
vessel_path <- function(shooting, length, reach) {
  turn <- shooting$arc / length
  if (turn == 0) return(rbind(shooting$from[1] - reach, shooting$from[2] + 0 * reach))
  rbind(
    shooting$from[1] - sin(turn * reach) / turn,
    shooting$from[2] + (1 - cos(turn * reach)) / turn
  )
}
