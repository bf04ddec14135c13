#' View a state or a trajectory in three dimensions
#'
#' Makes a page that shows the gear in the water, and plays a trajectory. In an interactive session
#' it opens in the viewer or the browser.
#'
#' @section Picture:
#' - Netting has the twines of its meshes. If meshes are too small to be visible, a panel is drawn
#'   with fewer, larger meshes, and the drawn twines meet on seams across the net.
#' - Ropes are drawn with their diameter, chains with their links, and boards, floats and weights
#'   with their shapes. Pieces are drawn large enough to be visible.
#' - A catch is drawn in its codend. The vessel, the sea bed with the gear's shadow, and water that
#'   darkens with depth surround the gear.
#' - Slack lines have a muted colour, and a bright colour if the colours show slack alone. Slack
#'   ropes are dashed; slack netting is dashed if the colours show slack alone.
#' - Drag is displayed relative to the size of its part: N per metre of rope, and N per square metre
#'   of netting with square meshes.
#' - The page prints on white.
#'
#' @section Controls:
#' - The left mouse button, one finger or the arrow keys turn the gear. The wheel, two fingers, plus
#'   and minus zoom. The right mouse button moves the gear.
#' - The pointer over a rope, a panel or a piece displays its name and values.
#' - Buttons select the net or the whole gear, and the view from the bow, from above, from the side
#'   or from astern.
#' - A list selects the colours: tension, slack alone, mesh opening, mesh angle or drag.
#' - *Save* writes a PNG picture with 3,840 pixels along its longer side, or a WebM video. The video
#'   shows a turn around the gear in 12 s, or the tow in at most 20 s. Title and legend are
#'   optional. The number of video frames depends on the browser's speed.
#' - The key `h` lists all keys.
#'
#' @section Trajectories:
#' - The page plays the tow as seen from the vessel, with a button, a time slider and a graph of any
#'   measure.
#' - The space bar plays and stops; comma and full stop step through the stored times.
#' - For a long tow, evenly spread stored times are selected, so that the page stays below 2 MB. The
#'   gear moves linearly between them.
#' - Mesh opening and mesh angle are not available.
#'
#' @param state A state from [settle()], or a trajectory from [tow()].
#' @param file `NULL` (default), or an HTML file to write. The file contains all that it needs, uses
#'   no network, and is written atomically.
#' @param colour The quantity that the colours show first: `"tension"` (default), `"slack"`,
#'   `"mesh_opening"`, `"mesh_angle"` or `"drag"`.
#' @return An HTML widget (class `htmlwidget`), which opens when printed. It is invisible if `file`
#'   is given. An invalid argument is an error of class `codend_error_argument`.
#' @seealso [plot.codend_state()] for plane views, [report()] for a page with numbers, [share()] for
#'   a page with sliders.
#' @examples
#' page <- view_3d(settle("small_midwater_trawl", nodes = 300))
#' class(page)
#' @export
view_3d <- function(state, file = NULL, colour = "tension") {
  check_given("state")
  if (!inherits(state, "codend_trajectory")) check_is_state(state)
  colour <- chosen(colour, viewer_colours)
  if (!is.null(file)) check_file_path(file, ".html")
  # a fixed name, so that every new session writes the same file for the same state
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

viewed_scene <- function(of, colour = "tension") {
  with_plain_numbers(
    if (inherits(of, "codend_trajectory")) motion_scene(of, colour) else state_scene(of, colour)
  )
}

# JSON in the form that htmlwidgets requires.
embedded_json <- function(x, ...) {
  text <- jsonlite::toJSON(
    I(x), dataframe = "columns", null = "null", na = "null", auto_unbox = TRUE, digits = 16,
    use_signif = TRUE, force = TRUE, rownames = FALSE, keep_vec_names = TRUE, json_verbatim = TRUE
  )
  structure(escape_json(text), class = "json")
}

# element: name of the widget in HTML, or NULL for a random name.
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
