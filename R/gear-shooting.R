si_shooting <- function(shooting, path, known) {
  find_rope(shooting$rope, paste0(path, ".rope"), known)
  list(
    rope = shooting$rope, speed = shooting$speed, arc = shooting$arc,
    from = first_of(shooting$from, c(0, 0))
  )
}
