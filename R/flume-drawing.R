# The net drawing of what is on screen. The clerk draws it: that takes longer than a settle.

# The page that it is drawn on.
drawing_page <- "A3"

# The SVG of a state's gear, as text.
drawing_text <- function(state) drawing_svg(state$gear, drawing_page)

# Answers a page that wants its drawing.
flume_draws <- function(input, tank, ask_clerk, said) {
  shiny::observeEvent(input$drawing_wanted, {
    if (is.null(tank$gear)) return()
    ask_clerk("drawing", "drawing", NULL, function(found) said("flume_drawing", svg = found))
  })
}
