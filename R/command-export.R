run_export <- function(given, options) {
  plan <- given[1L]
  files <- given[-1L]
  kept <- grepl("[.]nc$", plan)
  if (kept && length(unlist(options[c("set", "nodes", "netting")]))) {
    abort_usage("--set, --nodes and --netting change a plan, not what is kept in ", plan, ".")
  }
  for (file in files) check_place(file, NULL, vapply(export_formats, `[[`, "", "extension"))
  formats <- lapply(files, format_of_file)
  of_tow <- vapply(formats, function(format) identical(format$of, "trajectory"), NA)
  of_state <- vapply(formats, function(format) identical(format$of, "state"), NA)
  if (any(of_tow) && !kept) {
    abort_usage(files[of_tow][1], " holds a tow; export it from the file of one (codend tow).")
  }
  if (any(of_tow) && any(of_state)) {
    abort_usage(files[of_state][1], " holds a state and ", files[of_tow][1], " a tow; export one.")
  }
  shown <- if (any(of_tow) || (kept && !any(of_state) && keeps_trajectory(plan))) {
    read_trajectory(plan)
  } else if (kept) {
    read_state(plan)
  } else {
    settle_changed(plan, options)
  }
  for (k in seq_along(files)) formats[[k]]$write(shown, files[k])
  tell(0L, "Written: ", paste(files, collapse = ", "))
}
