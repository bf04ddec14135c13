#' Look at a state or a trajectory in three dimensions
#'
#' Makes a page with the gear as it is in the water: netting with the twines of its meshes,
#' ropes as tubes of their thickness, chains with their links, boards, floats and weights in their
#' shapes, a catch in its codend, the vessel, the sea bed with the gear's shadow, and water that
#' darkens with depth. In an interactive session it opens in the viewer or the browser.
#'
#' Turn the gear with the left mouse button, one finger or the arrow keys; zoom with the wheel, two
#' fingers, plus and minus; move it with the right button. The pointer over a rope, a panel or a
#' piece reports its name and values. Buttons look at the net or the whole gear, from the bow, from
#' above, the side or astern; a list changes what colours show: tension, slack lines alone, the
#' opening or angle of meshes, or drag. Slack lines have a quiet colour, and a bright one where the
#' colours show slack alone. Slack ropes are dashed; slack netting is dashed where the colours show
#' slack alone. The key `h` lists all keys. Where meshes are too small to be seen, a panel is drawn
#' with fewer, larger meshes. The drawn twines then meet on seams across the net. Pieces are drawn
#' large enough to be seen. The page prints on white.
#'
#' The button *Save* saves the picture as PNG, 3,840 pixels along its longer side, or a video as
#' WebM: of a turn around the gear in 12 s, or of a tow that the page plays, in at most 20 s. Both
#' are with or without title and legend. A video has as many frames as the browser draws in that
#' time.
#'
#' The page of a trajectory plays it, as seen from the vessel, with a button, a slider of time and a
#' graph of any measure; the space bar plays and stops, comma and full stop step from kept time to
#' kept time. Of a long tow it shows some of the kept times, evenly spread, so that the page stays
#' below 2 MB; between them the gear moves straight on.
#'
#' Drag is reported over the size of its part: of ropes N per metre, of netting N per square metre
#' of netting with square meshes. Mesh opening and angle are not given for a trajectory.
#'
#' @param state A state, from [settle()], or a trajectory, from [tow()].
#' @param file `NULL`, or an HTML file to write: one file that holds everything it needs and
#'   uses no network. It is written whole or not at all.
#' @param colour What the colours show at first: `"tension"`, `"slack"`, `"mesh_opening"`,
#'   `"mesh_angle"` or `"drag"`.
#' @return An HTML widget, which prints in the viewer or browser, invisibly where `file` is given.
#'   A wrong argument is an error of class `codend_error_argument`.
#' @examples
#' page <- view_3d(settle("towed_cable"))
#' class(page)
#' @export
view_3d <- function(state, file = NULL, colour = "tension") {
  check_given("state")
  if (!inherits(state, "codend_trajectory")) check_is_state(state)
  check_colour(colour, viewer_colours)
  if (!is.null(file)) check_file_path(file, ".html")
  # In a file a fixed name, so that every new session writes the same page of the same state.
  element <- if (!is.null(file)) "gear"
  page <- viewer_widget(viewed_scene(state, colour), element)
  if (is.null(file)) return(page)
  write_file(file, function(path) {
    body <- htmltools::tags$main(with_plain_numbers(htmltools::as.tags(page, standalone = TRUE)))
    write_single_page(path, state$gear$plan$name, body,
      style = "html, body { margin: 0; height: 100%; background: white; }")
  })
  invisible(page)
}

viewer_colours <- c("tension", "slack", "mesh_opening", "mesh_angle", "drag")

# The scene of a state or a trajectory.
viewed_scene <- function(of, colour = "tension") {
  with_plain_numbers(
    if (inherits(of, "codend_trajectory")) motion_scene(of, colour) else state_scene(of, colour)
  )
}

# JSON as htmlwidgets asks for it.
embedded_json <- function(x, ...) {
  text <- jsonlite::toJSON(
    I(x), dataframe = "columns", null = "null", na = "null", auto_unbox = TRUE, digits = 16,
    use_signif = TRUE, force = TRUE, rownames = FALSE, keep_vec_names = TRUE, json_verbatim = TRUE
  )
  structure(escape_json(text), class = "json")
}

# A scene as a widget that fills its place; element: its name in HTML, or NULL for a random one.
viewer_widget <- function(scene, element = NULL, title = TRUE) {
  htmlwidgets::createWidget(
    "codend", structure(list(scene = scene, title = title), TOJSON_FUNC = embedded_json),
    package = "codend", elementId = element,
    sizingPolicy = htmlwidgets::sizingPolicy(
      defaultWidth = "100%", defaultHeight = 640, padding = 0, browser.fill = TRUE,
      viewer.fill = TRUE, viewer.padding = 0, browser.padding = 0, knitr.figure = FALSE,
      knitr.defaultWidth = "100%", knitr.defaultHeight = 520
    )
  )
}
