# Data for the viewer of the flume tank, some tens of kilobytes. Connectivity is sent only if it has
# changed.

# Largest number of lines and cells in a picture.
flume_lines <- 6000L

# Returns the shape of a state without the data for mesh colours.
flume_shape <- function(state) scene_shape(state, flume_lines)

# Returns the connectivity (`fixed`), moving data (`moved`) and values that determine colour scales.
# shape: from flume_shape().
flume_drawing <- function(state, shape = flume_shape(state)) {
  shape <- with_meshes(shape)
  c(
    list(fixed = scene_fixed(shape), moved = scene_moved(list(shape))),
    shape[c("ropes", "rope_part", "u", "v", "opening", "angle", "drag", "kind")]
  )
}

# Returns the scene of a state. drawing: its drawing; known: connectivity that the page has; passed:
# TRUE if the page has the shape from moved_message().
picture_scene <- function(state, drawing, known = NULL, passed = FALSE) {
  moved <- drawing$moved
  if (passed) moved <- moved[setdiff(names(moved), moved_arrays)]
  c(
    list(times = I(0), labels = I("")), scene_about(state, list(drawing)), moved,
    if (!identical(drawing$fixed, known)) drawing$fixed
  )
}

# Arrays that change while a slider moves, in the order of moved_message().
moved_arrays <- c("points", "rope_tension", "u", "v", "drag", "places", "boards")

# Returns the shape of a design while a slider moves. The page draws it before it has other data.
# shape: from flume_shape(); fixed: connectivity that the page has; number: of the page's question.
# Returns list(moved, fixed, anew). `moved` (raw) has a header, then single floats, little-endian.
# `anew` is TRUE if the connectivity has changed.
moved_message <- function(state, shape, fixed, number) {
  shape$rope_tension <- shape$ropes
  arrays <- lapply(shape[moved_arrays], as.double)
  now_fixed <- scene_fixed(shape)
  changed <- names(now_fixed)[!mapply(identical, now_fixed, fixed[names(now_fixed)])]
  # if only sizes of marks differ, the page updates them; otherwise it needs the full layout
  same_marks <- identical(now_fixed$marks[c("role", "fill")], fixed$marks[c("role", "fill")])
  if (!same_marks || "vessels" %in% changed) changed <- names(now_fixed)
  bed <- drawn_bed(state)
  header <- list(
    answers = first_of(number, 0), counts = lapply(arrays, length),
    part = c(
      list(conditions = state_conditions(state), flow = I(flow_past(state))),
      if (!is.null(bed)) list(bed = list(normal = I(bed$normal), height = bed$height)),
      now_fixed[changed]
    )
  )
  list(moved = with_header(header, single_bytes(arrays)), fixed = now_fixed,
    anew = length(changed) > 0)
}
