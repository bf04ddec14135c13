# The command line: `exec/codend` passes its arguments and exits with the returned status.

# arguments: strings from a shell. Results go to standard output, all else to standard error.
# Returns the exit status: 0 success, 1 invalid plan or gear that does not settle, 2 wrong usage,
# 130 interrupted.
run_command <- function(arguments) {
  if (!length(arguments)) return(write_output(2L, command_usage()))
  name <- arguments[1]
  if (name %in% c("--help", "-h")) return(cat_and(0L, command_usage(), "\n"))
  if (name == "--version") {
    return(cat_and(0L, "codend ", format(utils::packageVersion("codend")), "\n"))
  }
  known <- command_words()
  if (!name %in% names(known)) {
    return(write_output(2L, "codend: there is no command ", name, "; the commands are ",
      toString(names(known)), "."))
  }
  tryCatch(
    withCallingHandlers(
      {
        given <- parse_command(name, known[[name]], arguments[-1])
        if (is.character(given)) return(cat_and(0L, given))
        command_runs()[[name]](given$plan, given$options)
        0L
      },
      # The message would be repeated by every command.
      codend_message_units = function(m) invokeRestart("muffleMessage"),
      warning = function(w) {
        write_output(0L, "Warning: ", conditionMessage(w))
        invokeRestart("muffleWarning")
      }
    ),
    codend_error_usage = function(e) {
      write_output(2L, "codend ", name, ": ", conditionMessage(e), " See codend ", name, " --help.")
    },
    error = function(e) write_output(1L, conditionMessage(e)),
    interrupt = function(e) write_output(130L, "Interrupted.")
  )
}

# Returns a function of arguments and options for each command in inst/commands.yaml.
command_runs <- function() {
  list(
    check = run_check, gears = run_gears, settle = run_settle, tow = run_tow, report = run_report,
    share = run_share, export = run_export, draw = run_draw, study = run_study_command,
    find = run_find, optimise = run_optimise, calibrate = run_calibrate,
    sensitivities = run_sensitivities, flume = run_flume, new = run_new,
    expand = function(plan, options) {
      cat(format(assembly(read_gear(plan), if (isTRUE(options$net)) "net")))
    }
  )
}

command_usage <- function() {
  known <- command_words()
  does <- vapply(known, `[[`, "", "does")
  paste0(
    "Usage: codend COMMAND [options] [PLAN]\n\n",
    "Shape and tensions of fishing gear in water. PLAN is a file or the name of a shipped plan.\n",
    "\n",
    paste0("  ", format(names(known)), "  ", does, "\n", collapse = ""),
    "\ncodend COMMAND --help   the options of a command\n",
    "codend --version"
  )
}

# ---- short commands ------------------------------------------------------------------------------

run_check <- function(plan, options) {
  gear <- read_changed(plan, options)
  print(gear)
  found <- findings(gear)
  if (nrow(found)) cat("", cli::style_bold("Warnings"), finding_lines(found), sep = "\n")
}

run_gears <- function(plan, options) {
  plans <- gears()
  cat(paste0(format(c("PLAN", plans$name)), "  ", c("TITLE", plans$title), "\n"), sep = "")
}

run_sensitivities <- function(plan, options) {
  check_place(options$out)
  state <- settle_changed(plan, options)
  give_csv(sensitivities(state, parts_of(options$of), parts_of(options$to)), options$out)
}
