command_draw <- function() {
  list(
    takes = "PLAN FILE...", does = "Draw the plan of a gear as net makers do.",
    more = paste0(
      " The end of each FILE's name says how: ", paste(drawing_types, collapse = ", "),
      ". A .dxf has the gear's true size in millimetres."
    ),
    options = list(
      set_option(),
      optparse::make_option("--page", metavar = "SIZE", default = "A4",
        help = paste0("sheet: ", paste(names(sheet_sizes), collapse = ", "), " [A4]"))
    ),
    run = function(plan, options) run_draw(plan[1], plan[-1], options)
  )
}

run_draw <- function(plan, files, options) {
  ends <- tolower(sub("^.*(?=[.])", "", basename(files), perl = TRUE))
  for (file in files[!ends %in% drawing_types]) {
    abort_usage(file, " must end in one of ", paste(drawing_types, collapse = ", "), ".")
  }
  for (file in files) {
    if (!may_place(file)) abort_usage(file, " must be a file in a folder that can be written.")
  }
  if (!options$page %in% names(sheet_sizes)) {
    abort_usage("--page is ", options$page, "; it must be one of ",
      paste(names(sheet_sizes), collapse = ", "), ".")
  }
  gear <- read_changed(plan, options)
  for (file in files) plot(gear, file = file, page = options$page)
  tell(0L, "Written: ", paste(files, collapse = ", "))
}
