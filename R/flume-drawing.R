# The net drawing of the draft. The slow worker draws it, because drawing takes longer than
# settling.

drawing_page <- "A3"

flume_draws <- function(page) {
  tank <- page$tank
  list(drawing_wanted = function(given) {
    if (is.null(tank$gear)) return()
    edited <- tank$edited
    page$request_slow_worker("drawing", tank$draft, function(found) {
      # if the draft has changed, the page requests a new drawing
      if (edited == tank$edited) page$said("flume_drawing", svg = found)
    })
  })
}
