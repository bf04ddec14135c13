command_new <- function() {
  list(
    takes = "KIND [NAME=VALUE...]", does = "Print a commented plan to begin with.",
    more = paste(
      " KIND is bottom_trawl, midwater_trawl, beam_trawl, pair_trawl, demersal_seine, cage,",
      "gillnet, longline, purse_seine, stow_net or dip_net; NAME=VALUE is a size such as",
      "head_line=\"32 m\" (--ask lists",
      "them), of kinds but trawls also any field by its path."
    ),
    options = list(
      optparse::make_option("--file", metavar = "FILE", help = "write it there instead"),
      optparse::make_option("--ask", action = "store_true", default = FALSE,
        help = "ask at the console for each value")
    ),
    run = run_new
  )
}

run_new <- function(arguments, options) {
  values <- arguments[-1]
  wrong <- grep("^[^=]+=.", values, invert = TRUE)
  if (length(wrong)) abort_usage("what follows KIND is ", values[wrong[1]],
    "; it must be NAME=VALUE.")
  given <- stats::setNames(lapply(sub("^[^=]+=", "", values), plan_value), sub("=.*", "", values))
  gear <- do.call(new_plan, c(list(arguments[1]), given, list(file = options$file,
    ask = options$ask)))
  if (is.null(options$file)) cat(format(gear, remarks = TRUE))
}
