# What the flume tank's canvas is sent: positions, colours and marks as packed numbers, in a few
# tens of kilobytes, and what joins them only when it changes.

# At most about as many lines of netting, and of ropes, as a canvas draws within a frame.
flume_lines <- 6000L

flume_drawing <- function(state) {
  drawing <- state_drawing(state, flume_lines)
  # Of a fine net only some of the points are ends of lines.
  drawing$drawn <- unique(c(drawing$ropes$ends, drawing$netting$ends))
  drawing$points <- state_points(state)[, drawing$drawn, drop = FALSE]
  drawing
}

# One scale for each kind of line over several drawings, so that their colours compare.
common_scales <- function(drawings) {
  tension <- function(kind) unlist(lapply(drawings, function(d) d[[kind]]$tension))
  list(
    ropes = tension_scale(tension("ropes"), "rope"),
    netting = tension_scale(tension("netting"), "netting")
  )
}

# The numbers of one drawing: points (3 x points, m), colours (places in the palettes, 0: slack),
# marks (3 x marks, m) and the corners of free otter boards (3 x 4 per board, m).
moved_numbers <- function(drawing, scales) {
  list(
    points = packed(as.double(drawing$points), 4L),
    netting = packed(colour_numbers(scales$netting, drawing$netting$tension), 1L),
    ropes = packed(colour_numbers(scales$ropes, drawing$ropes$tension), 1L),
    marks = packed(as.double(t(as.matrix(drawing$marks[c("x", "y", "z")]))), 4L),
    boards = packed(as.double(drawing$boards), 4L)
  )
}

# What joins them: ends of the lines (places in points, from 0) and what the marks are.
fixed_numbers <- function(drawing) {
  marks <- drawing$marks
  symbol <- symbol_of(marks$role)
  ends <- function(lines) packed(match(lines$ends, drawing$drawn) - 1L, 4L)
  list(
    netting = ends(drawing$netting), ropes = ends(drawing$ropes),
    marks = list(
      role = I(as.character(marks$role)), label = I(as.character(symbol$label)),
      fill = I(as.character(symbol$fill)), plate = I(symbol$plate),
      size = I(ifelse(is.na(marks$size), 0, marks$size)), symbol = I(as.double(symbol$size)),
      direction = I(ifelse(is.na(marks$direction), "", marks$direction)),
      board = I(marks$board - 1L)
    )
  )
}

# Whether two drawings differ in where they are alone.
same_lines <- function(one, other) {
  about <- c("role", "size", "direction", "board")
  !is.null(other) && identical(one$netting$ends, other$netting$ends) &&
    identical(one$ropes$ends, other$ropes$ends) && identical(one$marks[about], other$marks[about])
}

# The message of a picture. now and pinned: drawings; known: list(now, pinned) of those that the
# canvas already has, NULL at first.
picture_message <- function(state, now, pinned, known) {
  scales <- common_scales(list(now, pinned))
  part <- function(drawing, before) {
    c(list(moved = moved_numbers(drawing, scales)),
      if (!same_lines(drawing, before)) list(fixed = fixed_numbers(drawing)))
  }
  list(
    now = part(now, known$now), pinned = part(pinned, known$pinned),
    legend = list(
      ropes = legend_numbers(scales$ropes, "rope"),
      netting = legend_numbers(scales$netting, "netting")
    ),
    flow = I(flow_past(state)), water = state$si$water$density > 0,
    bed = if (!is.null(state$si$ground)) {
      list(normal = I(state$si$ground$normal), height = state$si$ground$height)
    },
    name = state$gear$plan$name, conditions = conditions_text(state$si)
  )
}

# Heading, ticks and their places (0..1) of a colour bar, or NULL where nothing carries tension.
legend_numbers <- function(scale, kind) {
  if (is.null(scale)) return(NULL)
  list(
    heading = scale_heading(scale, kind), ticks = I(trimws(tick_labels(scale))),
    at = I(scale_share(scale, scale$ticks * scale$per_unit))
  )
}

# The colours that the numbers stand for, sent once: the first is that of slack lines.
flume_palettes <- function() {
  list(
    ropes = c(slack_colour, tension_palette("rope")),
    netting = c(slack_colour, tension_palette("netting"))
  )
}
