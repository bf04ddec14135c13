# The net drawing of what is on screen. The clerk draws it: that takes longer than a settle.

# The SVG of a state's gear, as text.
drawing_text <- function(state) {
  file <- tempfile(fileext = ".svg")
  on.exit(unlink(file))
  plot(state$gear, file = file, page = "A3")
  paste(readLines(file, warn = FALSE, encoding = "UTF-8"), collapse = "\n")
}

# Answers a page that wants its drawing.
flume_draws <- function(input, session, tank, clerk, said, refuse) {
  shiny::observeEvent(input$drawing_wanted, {
    if (is.null(tank$gear)) return()
    said("flume_clerk", busy = TRUE, what = "drawing")
    clerk$ask(
      "drawing", function() tank$request("drawing", NULL),
      function(answer) {
        if (session$isClosed()) return()
        said("flume_clerk", busy = FALSE, what = "drawing")
        if (is.null(answer)) return()
        if (!is.null(answer$problem)) return(refuse(answer$problem, "drawing"))
        said("flume_drawing", svg = answer$found)
      }
    )
  })
}
