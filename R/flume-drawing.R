# The net drawing of the draft. The clerk draws it: that takes longer than a settle.

# The page that it is drawn on.
drawing_page <- "A3"

# Answers a page that wants its drawing.
flume_draws <- function(input, tank, ask_clerk, said) {
  shiny::observeEvent(input$drawing_wanted, {
    if (is.null(tank$gear)) return()
    edited <- tank$edited
    ask_clerk("drawing", tank$draft, function(found) {
      # else the page has asked, or will, for that of the draft as it is now
      if (edited == tank$edited) said("flume_drawing", svg = found)
    })
  })
}
