run_export <- function(given, options) {
  plan <- given[1L]
  files <- given[-1L]
  kept <- grepl("[.]nc$", plan)
  if (kept && length(unlist(options[c("set", "nodes", "netting", "accuracy")]))) {
    abort_usage("--set, --nodes, --netting and --accuracy cannot change the result file ", plan,
      "; give a PLAN.")
  }
  for (file in files) check_place(file, NULL, vapply(export_formats, `[[`, "", "extension"))
  shown <- if (kept) read_result(plan)
  of_tow <- inherits(shown, "codend_trajectory")
  formats <- formats_of(if (of_tow) "trajectory" else "state")
  odd <- Find(function(file) is.null(format_of_file(file, formats)), files)
  if (!is.null(odd)) {
    abort_usage(odd, if (of_tow) {
      paste0(" holds a state, and ", plan, " a tow.")
    } else {
      " holds a tow; export it from the file of one (codend tow)."
    })
  }
  if (!kept) shown <- settle_changed(plan, options)
  for (file in files) write_result(shown, file)
  write_output(0L, "Written: ", paste(files, collapse = ", "))
}
