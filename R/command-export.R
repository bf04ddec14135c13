command_export <- function() {
  list(
    takes = "PLAN FILE...", does = "Settle a gear and write it for other programs.",
    more = paste0(
      " The end of each FILE's name says how: ", formats_text("state"),
      ". A PLAN that ends in .nc ",
      "is a state that was kept so, or a tow, to be written as ", formats_text("trajectory"), "."
    ),
    options = list(set_option(), aimed_nodes_option(), netting_option()),
    run = function(plan, options) run_export(plan[1], plan[-1], options)
  )
}

run_export <- function(plan, files, options) {
  check_lattice_options(options)
  kept <- grepl("[.]nc$", plan)
  if (kept && length(unlist(options[c("set", "nodes", "netting")]))) {
    abort_usage("--set, --nodes and --netting change a plan, not what is kept in ", plan, ".")
  }
  formats <- lapply(files, format_of_file)
  for (k in seq_along(files)) {
    if (is.null(formats[[k]])) {
      abort_usage(files[k], " must end in one of ",
        paste(vapply(export_formats, `[[`, "", "extension"), collapse = ", "), ".")
    }
    if (!may_place(files[k])) {
      abort_usage(files[k], " must be a file in a folder that can be written.")
    }
  }
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
