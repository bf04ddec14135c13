command_study <- function() {
  list(
    takes = "ACTION STORE [PLAN]", does = "Settle a gear in many designs, in tasks of any number.",
    more = paste(
      " ACTION is new (makes the folder STORE for a PLAN and a table of --designs), run (settles",
      "the designs of a --task that are not done yet), status (tells how far it is) or table (what",
      "is done as CSV). Any number of tasks may run at once, on any machines that see STORE."
    ),
    options = list(
      optparse::make_option("--designs", metavar = "FILE.csv", help = paste(
        "of new: a table with a row per design and a column per field, named by its path; what is",
        "empty stays as in the plan"
      )),
      nodes_option(), netting_option(),
      optparse::make_option("--task", metavar = "I", help = "of run: which task [1]"),
      optparse::make_option("--of", metavar = "N", help = "of run: of how many tasks [1]"),
      optparse::make_option("--out", metavar = "FILE.csv", help = "of table: where it goes [-]")
    ),
    run = run_study_command
  )
}

run_study_command <- function(given, options) {
  action <- given[1L]
  actions <- c("new", "run", "status", "table")
  if (!action %in% actions) {
    abort_usage("there is no action ", action, "; the actions are ", toString(actions), ".")
  }
  if ((action == "new") != (length(given) == 3L)) {
    abort_usage(if (action == "new") "new takes a STORE and a PLAN." else {
      paste(action, "takes a STORE alone.")
    })
  }
  store <- given[2L]
  switch(action,
    new = {
      check_lattice_options(options)
      if (is.null(options$designs)) abort_usage("new needs --designs FILE.csv.")
      do.call(write_study, c(
        list(given[3L], designs(options$designs), store), lattice_arguments(options)
      ))
      print(study_status(store))
    },
    run = {
      task <- task_option(options, "task")
      of <- task_option(options, "of")
      if (task > of) abort_usage("--task is ", task, "; it must be at most --of, ", of, ".")
      done <- run_study(store, task, of)
      tell(0L, done, " designs settled in task ", task, " of ", of, ".")
    },
    status = print(study_status(store)),
    table = {
      out <- first_of(options$out, "-")
      if (out != "-" && !may_place(out)) {
        abort_usage("--out is ", out, "; it must be a file in a folder that can be written.")
      }
      found <- read_study(store)
      if (out == "-") {
        with_plain_numbers(utils::write.csv(found, stdout(), row.names = FALSE, na = ""))
      } else {
        write_csv(found, out)
      }
    }
  )
}

task_option <- function(options, name) {
  text <- first_of(options[[name]], "1")
  if (!grepl("^[1-9][0-9]{0,8}$", text)) {
    abort_usage("--", name, " is ", text, "; it must be a whole number, 1 or more.")
  }
  as.numeric(text)
}
