command_flume <- function() {
  list(
    takes = "[PLAN]",
    does = "Open a page with the settled gear and its controls: the live flume tank.",
    options = list(
      optparse::make_option("--port", metavar = "N", help = paste(
        "port of this machine at which a browser finds the page [one that is free]"
      )),
      set_option(), nodes_option()
    ),
    run = run_flume
  )
}

# Ends with an interrupt. Only this machine's own browsers reach the page.
run_flume <- function(plan, options) {
  check_lattice_options(options)
  port <- options$port
  if (!is.null(port) && !(grepl("^[0-9]{1,5}$", port) && as.numeric(port) %in% 1024:65535)) {
    abort_usage("--port is ", port, "; it must be a whole number from 1024 to 65535.")
  }
  gear <- read_changed(if (length(plan)) plan else "midwater_trawl", options)
  app <- do.call(flume, c(list(gear), lattice_arguments(options)))
  shiny::runApp(app, host = "127.0.0.1", launch.browser = FALSE,
    port = if (!is.null(port)) as.integer(port))
}
