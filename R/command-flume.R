# Runs until an interrupt. Only browsers on this computer can reach the page.
run_flume <- function(plan, options) {
  port <- options$port
  if (!is.null(port) && !port %in% 1024:65535) {
    abort_usage("--port is ", port, "; it must be a whole number from 1024 to 65535.")
  }
  changed <- length(options$set) > 0L
  gear <- if (length(plan)) read_changed(plan, options)
  if (is.null(gear) && changed) abort_usage("--set changes a plan: give PLAN too.")
  tank <- do.call(flume, c(
    list(gear = gear, folder = options$folder, hosts = options$host), settle_arguments(options)
  ))
  serve_flume(tank, port, opens = FALSE)
}
