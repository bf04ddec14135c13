# What the flume tank's viewer is sent: scenes of the design on screen and the pinned one, in a few
# tens of kilobytes; what joins their points only when it changes.

# Lines and cells that a tank's picture has at most.
flume_lines <- 6000L

# What of a state the tank keeps to draw it: what joins its points (fixed), what moves, and the
# values that colours are scaled by.
flume_drawing <- function(state) {
  shape <- scene_shape(state, flume_lines)
  c(
    list(fixed = scene_fixed(shape), moved = scene_moved(list(shape))),
    shape[c("ropes", "u", "v", "opening", "angle", "drag", "kind")]
  )
}

# The message of a picture. now and pinned: drawings; known: list(now, pinned) of those that the
# page already has, NULL at first. Colours of both have the same scales, so that they compare.
picture_message <- function(state, now, pinned, known) {
  about <- scene_about(state, list(now, pinned))
  part <- function(drawing, before) {
    c(
      list(times = I(0), labels = I("")), about,
      # the kept design seldom moves
      if (!identical(drawing$moved, before$moved)) drawing$moved,
      if (!identical(drawing$fixed, before$fixed)) drawing$fixed
    )
  }
  list(
    now = part(now, known$now), pinned = part(pinned, known$pinned),
    name = about$name, conditions = conditions_text(state$si)
  )
}
