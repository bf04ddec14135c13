# The net drawing of the draft. The slow worker draws it, because drawing takes longer than
# settling.

drawing_page <- "A3"

flume_draws <- function(input, tank, request_slow_worker, said) {
  shiny::observeEvent(input$drawing_wanted, {
    if (is.null(tank$gear)) return()
    edited <- tank$edited
    request_slow_worker("drawing", tank$draft, function(found) {
      # if the draft has changed, the page requests a new drawing
      if (edited == tank$edited) said("flume_drawing", svg = found)
    })
  })
}
