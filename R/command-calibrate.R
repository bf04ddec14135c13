command_calibrate <- function() {
  list(
    takes = "PLAN", does = "Find fields of a plan from hauls or tank runs.",
    options = list(
      optparse::make_option("--data", metavar = "FILE", help = paste(
        "a CSV file with a row per haul; columns named by fields, such as towing.speed, set them"
      )),
      optparse::make_option("--match", metavar = "FORMULAS", help = paste(
        "columns and measures, such as \"DoorSpread ~ door_spread; Height ~ headline_height\""
      )),
      change_option(),
      optparse::make_option("--out", metavar = "FILE", help = "write the plan found (.yaml)"),
      optparse::make_option("--explain", action = "store_true", default = FALSE,
        help = "report what may explain the misfit"),
      optparse::make_option("--predict", metavar = "FILE.csv", help = paste(
        "predict other hauls of a table like that of --data"
      )),
      optparse::make_option("--predicted", metavar = "FILE.csv", help = paste(
        "of --predict: where the predictions go [-]"
      )),
      set_option(), nodes_option(), netting_option()
    ),
    run = run_calibrate
  )
}

run_calibrate <- function(plan, options) {
  check_lattice_options(options)
  check_plan_out(options$out)
  check_csv_out(options$predicted, "--predicted")
  if (is.null(options$data)) abort_usage("--data must be a CSV file.")
  if (is.null(options$match)) abort_usage("--match must say which column is which measure.")
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
  found <- do.call(calibrate, c(arguments, lattice_arguments(options)))
  print(summary(found))
  if (options$explain) print(explain_misfit(found))
  if (!is.null(others)) give_csv(stats::predict(found, others), options$predicted)
  write_found(found$gear, options$out)
}
