run_calibrate <- function(plan, options) {
  check_plan_out(options$out)
  check_place(options$predicted, "--predicted")
  check_place(options$file, "--file")
  if (is.null(options$data)) abort_usage("--data is missing; it must be a CSV file.")
  if (is.null(options$match)) abort_usage("--match is missing; it must be COLUMN ~ MEASURE.")
  match <- lapply(parts_of(options$match), function(text) {
    found <- tryCatch(str2lang(text), error = function(e) NULL)
    if (!(is.call(found) && identical(found[[1L]], as.name("~")) && length(found) == 3L)) {
      abort_usage("--match has ", text, "; it must be COLUMN ~ MEASURE.")
    }
    stats::as.formula(found, env = baseenv())
  })
  data <- read_csv_option(options$data, "--data")
  others <- if (!is.null(options$predict)) read_csv_option(options$predict, "--predict")
  arguments <- list(read_changed(plan, options), data, option_ranges(options$change), match)
  found <- do.call(calibrate, c(arguments, settle_arguments(options)))
  print(summary(found))
  if (options$explain) print(explain_misfit(found))
  if (!is.null(others)) give_csv(stats::predict(found, others), options$predicted)
  write_found(found$gear, options$out)
}
