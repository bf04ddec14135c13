run_draw <- function(given, options) {
  plan <- given[1L]
  files <- given[-1L]
  for (file in files) check_place(file, NULL, drawing_types)
  gear <- read_changed(plan, options)
  for (file in files) plot(gear, file = file, page = first_of(options$page, "A4"))
  write_output(0L, "Written: ", toString(files))
}
