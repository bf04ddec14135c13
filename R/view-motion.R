# A trajectory as a page that plays: one scene, whose lines and marks move from kept time to kept
# time, in the vessel's axes.

# The page of a trajectory as a widget; element as in gear_page().
motion_page <- function(trajectory, element) {
  motion <- gear_motion(trajectory)
  drawing <- motion$drawing
  scales <- list(
    rope = tension_scale(motion$tension$ropes, "rope"),
    netting = tension_scale(motion$tension$netting, "netting")
  )
  whole <- page_ranges(motion$extent, motion$state)
  net <- net_to_enlarge(motion$extent, whole)
  # The flow changes: the label beside the slider tells it.
  scene <- gear_scene(motion$state, drawing, scales, whole, net, flow = c(0, 0))
  # Slack lines have their key where any is slack at any time.
  for (kind in c("ropes", "netting")) drawing[[kind]]$tension <- motion$tension[[kind]]
  legend <- page_legend(motion$state, drawing, scales, motion_words(trajectory), bottom = 58)
  widget <- gear_widget(scene, legend, whole, net, element)
  run_script(widget, "motion.js", motion_data(motion, scales, scene$drawn, trajectory))
}

# Everything of a trajectory that is drawn: list(state, drawing (at the start), points (3 x points x
# times, m), ends = (2 x lines, places in points) and tension = (lines x times, N) of ropes and
# netting, marks (3 x marks x times, m), boards (corners of free boards at every time), extent (all
# times as one drawing of the same ranges)).
gear_motion <- function(trajectory) {
  start <- state_at(trajectory, trajectory$time[1L])
  drawing <- state_drawing(start)
  moments <- lapply(trajectory$time, function(time) {
    state <- state_at(trajectory, time)
    drawing <- state_drawing(state)
    list(
      points = state_points(state), ropes = drawing$ropes$tension,
      netting = drawing$netting$tension, marks = t(as.matrix(drawing$marks[c("x", "y", "z")])),
      boards = drawing$boards, box = lapply(drawing[c("ropes", "netting")], line_box)
    )
  })
  drawn <- unique(c(drawing$ropes$ends, drawing$netting$ends))
  n <- length(moments)
  numbers <- function(pick) unlist(lapply(moments, pick), use.names = FALSE)
  marks <- array(numbers(function(m) m$marks), c(3L, NROW(drawing$marks), n))
  place <- function(kind) matrix(match(drawing[[kind]]$ends, drawn), 2L)
  extent <- lapply(c(ropes = "ropes", netting = "netting"), function(kind) {
    join_lines(lapply(moments, function(m) m$box[[kind]]))
  })
  extent$marks <- as.data.frame(t(matrix(marks, 3L, dimnames = list(c("x", "y", "z"), NULL))))
  list(
    state = start, drawing = drawing, marks = marks, boards = lapply(moments, `[[`, "boards"),
    extent = extent,
    points = array(numbers(function(m) m$points[, drawn]), c(3L, length(drawn), n)),
    ends = list(ropes = place("ropes"), netting = place("netting")),
    tension = list(
      ropes = matrix(numbers(function(m) m$ropes), ncol = n),
      netting = matrix(numbers(function(m) m$netting), ncol = n)
    )
  )
}

# One line across the box around lines.
line_box <- function(lines) {
  if (!length(lines$tension)) return(NULL)
  corners <- apply(cbind(lines$from, lines$to), 1L, range)
  list(from = cbind(corners[1L, ]), to = cbind(corners[2L, ]), tension = 0, part = lines$part[1L])
}

motion_words <- function(trajectory) {
  last <- max(trajectory$time)
  paste(if (is_towed(trajectory)) "towed for" else "after", time_words(last, last))
}

is_towed <- function(trajectory) any(trajectory$conditions$speed > 0)

# What the page says beside its slider, at every time.
motion_labels <- function(trajectory) {
  time <- vapply(trajectory$time, time_words, "", last = max(trajectory$time))
  if (!is_towed(trajectory)) return(paste("after", time))
  conditions <- trajectory$conditions
  sprintf("%s, %.1f knot, course %.0f\u00b0", time, in_unit(conditions$speed, "knot"),
    in_unit(conditions$course, "deg"))
}

# A time (s) in the unit that suits the last of its times.
time_words <- function(time, last) {
  if (last <= 180) return(sprintf("%.1f s", time))
  sprintf("%.0f:%02.0f min", floor(round(time) / 60), round(time) %% 60)
}

# What the script needs: numbers as base64 of little-endian single floats, whole numbers or bytes.
motion_data <- function(motion, scales, drawn, trajectory) {
  lines <- function(kind, scale) {
    list(
      id = drawn[[kind]], ends = packed(motion$ends[[kind]] - 1L, 4L),
      colour = packed(colour_numbers(scale, motion$tension[[kind]]), 1L),
      palette = unname(grDevices::col2rgb(c(slack_colour, scale$colours))) / 255
    )
  }
  seen <- Filter(function(l) !is.null(l$id), list(
    lines("netting", scales$netting), lines("ropes", scales$rope)
  ))
  list(
    time = I(trajectory$time),
    label = I(motion_labels(trajectory)),
    points = packed(as.double(motion$points), 4L), lines = seen,
    marks = packed(as.double(motion$marks), 4L),
    plates = lapply(drawn$plates, moving_plate, motion, drawn$size), balls = drawn$balls
  )
}

# A plate with its corners (3 x 4 x times) where it is a free board; others keep their attitude.
moving_plate <- function(plate, motion, size) {
  mark <- motion$drawing$marks[plate$mark, ]
  if (mark$board > 0L) {
    corners <- vapply(motion$boards, free_plate, matrix(0, 3L, 4L), mark, size)
    plate$corners <- packed(as.double(corners), 4L)
  }
  plate
}

packed <- function(numbers, size) {
  jsonlite::base64_enc(writeBin(as.vector(numbers), raw(), size = size, endian = "little"))
}
