run_draw <- function(given, options) {
  plan <- given[1L]
  files <- given[-1L]
  for (file in files) check_place(file, NULL, drawing_types)
  page <- first_of(options$page, "A4")
  if (!page %in% names(sheet_sizes)) {
    abort_usage("--page is ", page, "; it must be one of ", toString(names(sheet_sizes)), ".")
  }
  gear <- read_changed(plan, options)
  for (file in files) plot(gear, file = file, page = page)
  tell(0L, "Written: ", toString(files))
}
