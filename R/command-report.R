command_report <- function() {
  list(
    takes = "PLAN", does = "Settle a gear and write a report of it as one HTML page.",
    options = list(
      optparse::make_option("--out", metavar = "FILE", help = paste(
        "the page to write, ending in .html [the plan's name, here]"
      )),
      set_option(), aimed_nodes_option(), netting_option()
    ),
    run = run_report
  )
}

run_report <- function(plan, options) {
  check_lattice_options(options)
  file <- options$out
  if (is.null(file)) file <- paste0(sub("[.][^.]*$", "", basename(plan)), ".html")
  if (!grepl("[.]html$", file) || !may_place(file)) {
    abort_usage(
      "--out is ", file, "; it must end in .html and lie in a folder that can be written."
    )
  }
  report(settle_changed(plan, options), file)
  tell(0L, "Written: ", file)
}
