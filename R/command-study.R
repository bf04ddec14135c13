study_actions <- c("new", "run", "status", "table", "errors", "effects", "pairs", "indices", "plot")

run_study_command <- function(given, options) {
  action <- given[1L]
  if (!action %in% study_actions) {
    abort_usage("there is no action ", action, "; the actions are ", toString(study_actions), ".")
  }
  if ((action == "new") != (length(given) == 3L)) {
    abort_usage(if (action == "new") "new takes a STORE and a PLAN." else {
      paste(action, "takes only a STORE.")
    })
  }
  store <- given[2L]
  switch(action,
    new = {
      print(summary(do.call(vary, c(
        list(given[3L], study_designs(options), store = store, tasks = 0), settle_arguments(options)
      ))))
    },
    run = {
      task <- first_of(options$task, 1)
      of <- first_of(options$of, 1)
      if (task > of) abort_usage("--task is ", task, "; it must be at most --of, ", of, ".")
      done <- run_study(store, task, of)
      write_output(0L, done, " designs settled in task ", task, " of ", of, ".")
    },
    status = print(summary(read_study(store))),
    plot = {
      if (is.null(options$out) || !grepl("[.](png|pdf|svg)$", options$out)) {
        abort_usage("plot needs --out FILE.png, .pdf or .svg.")
      }
      plot(read_study(store), parts_of(options$measures), file = options$out)
      write_output(0L, "Written: ", options$out)
    },
    {
      check_place(options$out)
      found <- read_study(store)
      what <- c(effects = "fields", pairs = "pairs", indices = "indices")[action]
      if (!is.na(what)) found <- effects(found, parts_of(options$measures), what)
      give_csv(if (action == "errors") errors_by_design(found) else found, options$out)
    }
  )
}

# Returns the designs of a table, or of ranges and values.
study_designs <- function(options) {
  if (is.null(options$designs) == is.null(options$change)) {
    abort_usage("new needs either --designs FILE.csv or --change RANGES.")
  }
  if (!is.null(options$designs)) return(designs(read_csv_option(options$designs, "--designs")))
  do.call(designs, c(study_axes(options$change), list(how = options$how, number = options$number,
    seed = first_of(options$seed, 1))))
}

# Converts "a = 1 m .. 2 m; b = 3, 4" to ranges and values by path.
study_axes <- function(text) {
  form <- "FIELD = FROM .. TO or FIELD = A, B"
  named_parts(text, "--change", ".+", form, function(said) {
    ends <- trimws(strsplit(said, "..", fixed = TRUE)[[1L]])
    if (length(ends) == 2L) return(value_range(plan_value(ends[1L]), plan_value(ends[2L])))
    if (length(ends) > 2L) abort_usage("--change has ", said, "; it must be FROM .. TO.")
    unlist(lapply(trimws(strsplit(said, ",", fixed = TRUE)[[1L]]), plan_value))
  })
}
