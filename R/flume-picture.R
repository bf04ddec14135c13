# What the flume tank's viewer is sent: scenes of the design on screen and of kept ones, in a few
# tens of kilobytes; what joins their points only when it changes.

# Lines and cells that a tank's picture has at most.
flume_lines <- 6000L

# The lines, netting and marks of a state without what colours of meshes take.
flume_shape <- function(state) scene_shape(state, flume_lines)

# What of a state the tank keeps to draw it: what joins its points (fixed), what moves, and the
# values that colours are scaled by. shape: as flume_shape() gives it.
flume_drawing <- function(state, shape = flume_shape(state)) {
  shape <- with_meshes(shape)
  c(
    list(fixed = scene_fixed(shape), moved = scene_moved(list(shape))),
    shape[c("ropes", "rope_part", "u", "v", "opening", "angle", "drag", "kind")]
  )
}

# The message of a picture. now: a drawing; seen: kept designs that are drawn with it; known: what
# the page already has, list(now = a drawing, kept = ids), NULL at first; passed: whether the page
# has the present shape from moved_message(). Colours of all have the same scales, so that they
# compare.
picture_message <- function(state, now, seen, known, passed = FALSE) {
  moved <- if (passed) now$moved[setdiff(names(now$moved), moved_arrays)] else now$moved
  about <- scene_about(state, c(list(now), lapply(seen, `[[`, "drawing")))
  list(
    now = c(moved, if (!identical(now$fixed, known$now$fixed)) now$fixed),
    kept = lapply(seen, function(one) {
      new <- !one$id %in% known$kept
      list(
        id = one$id, name = one$name, scene = if (new) c(one$drawing$moved, one$drawing$fixed)
      )
    }),
    of_all = c(list(times = I(0), labels = I("")), about),
    name = about$name, conditions = conditions_text(state$si)
  )
}

# What moves as a slider does, in the order in which moved_message() has it.
moved_arrays <- c("points", "rope_tension", "u", "v", "drag", "places", "boards")

# A design that a slider passes through, for the page to draw before anything else of it is known.
# shape: as flume_shape() gives it; fixed: what the page has of what joins points. Returns
# list(moved (raw): the bytes of a header of JSON (4), the header, then single floats,
# little-endian; fixed: that of this state; anew: whether it is another).
moved_message <- function(state, shape, fixed, number) {
  shape$rope_tension <- shape$ropes
  arrays <- lapply(shape[moved_arrays], as.double)
  now_fixed <- scene_fixed(shape)
  changed <- names(now_fixed)[!mapply(identical, now_fixed, fixed[names(now_fixed)])]
  # of the same marks the page takes their sizes; others are laid out with all
  same_marks <- identical(now_fixed$marks[c("role", "fill")], fixed$marks[c("role", "fill")])
  if (!same_marks || "vessels" %in% changed) changed <- names(now_fixed)
  bed <- drawn_bed(state)
  header <- list(
    answers = first_of(number, 0), counts = lapply(arrays, length),
    conditions = conditions_text(state$si),
    part = c(
      list(conditions = state_conditions(state), flow = I(flow_past(state))),
      if (!is.null(bed)) list(bed = list(normal = I(bed$normal), height = bed$height)),
      now_fixed[changed]
    )
  )
  text <- charToRaw(enc2utf8(as.character(
    jsonlite::toJSON(header, auto_unbox = TRUE, digits = I(7), null = "null", na = "null")
  )))
  # floats begin at a multiple of their size
  text <- c(text, rep(charToRaw(" "), -length(text) %% 4L))
  bytes <- function(x, size) writeBin(x, raw(), size = size, endian = "little")
  list(
    moved = c(bytes(length(text), 4L), text, bytes(unlist(arrays, use.names = FALSE), 4L)),
    fixed = now_fixed, anew = length(changed) > 0
  )
}
