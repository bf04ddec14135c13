run_report <- function(plan, options) {
  file <- options$out
  if (is.null(file)) file <- paste0(sub("[.][^.]*$", "", basename(plan)), ".html")
  check_place(file, "--out", ".html")
  report(settle_changed(plan, options), file)
  write_output(0L, "Written: ", file)
}
