run_new <- function(arguments, options) {
  given <- named_values(arguments[-1L], "the argument after KIND is", "NAME=VALUE")
  gear <- do.call(new_plan, c(list(arguments[1]), given, list(file = options$file,
    ask = options$ask)))
  if (is.null(options$file)) cat(format(gear, remarks = TRUE))
}
