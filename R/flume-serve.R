# The web server of the flume tank: static files of inst/ and one WebSocket per page, through which
# all messages of web/src/protocol.ts pass.

#' @export
print.codend_flume <- function(x, ...) {
  serve_flume(x)
  invisible(x)
}

# Serves the page of flume() until an interrupt. port: number, or NULL for a free port. opens: TRUE
# to open a browser.
serve_flume <- function(tank, port = NULL, opens = interactive()) {
  host <- "127.0.0.1"
  if (is.null(port)) port <- httpuv::randomPort(host = host)
  # takes a second; the first page would wait for it
  gallery_gears()
  server <- httpuv::startServer(host, port, list(
    call = function(request) not_found, staticPaths = served_files(),
    onWSOpen = function(socket) connect_page(socket, tank$open_page)
  ))
  on.exit({
    server$stop()
    # ends the processes of open pages
    later::run_now()
  })
  url <- paste0("http://", host, ":", port)
  message("Listening on ", url)
  if (opens) utils::browseURL(url)
  tryCatch(repeat httpuv::service(0), interrupt = function(i) NULL)
  invisible()
}

not_found <- list(status = 404L, headers = list("Content-Type" = "text/plain"), body = "Not found")

served_files <- function() {
  served <- function(folder, ...) {
    httpuv::staticPath(
      system.file(folder, package = "codend", mustWork = TRUE), headers = response_headers, ...
    )
  }
  c(
    list("/" = served("app", indexhtml = TRUE), "/view" = served("view")),
    if (has_measures_guide()) list("/doc" = served("doc"))
  )
}

# TRUE if codend was installed with its guides.
has_measures_guide <- function() nzchar(system.file("doc", "measures.html", package = "codend"))

# Opens a page on a WebSocket. A page that exceeds the limits of messages is disconnected.
connect_page <- function(socket, open_page) {
  pass <- message_gate()
  open <- TRUE
  page <- open_page(
    socket$request, send = function(type, message) socket$send(message_json(type, message)),
    send_bytes = function(bytes) socket$send(bytes), close = function() socket$close()
  )
  # with this code, the page does not connect again
  if (is.null(page)) return(socket$close(4000L))
  socket$onMessage(function(binary, message) {
    if (!open) return()
    open <<- !binary && pass(nchar(message, "bytes"))
    if (!open) return(socket$close())
    given <- tryCatch(jsonlite::parse_json(message), error = function(e) NULL)
    if (is_map(given) && length(given) == 1L) page$hear(names(given), given[[1L]])
  })
  socket$onClose(page$leave)
}
