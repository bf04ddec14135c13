# The command line: `exec/codend` hands its arguments over and ends with the status.

# arguments: text, as a shell hands them over. Results go to standard output, everything else to
# standard error. Returns the exit status: 0 done, 1 the plan is wrong or the gear does not settle,
# 2 the command is used wrongly, 130 interrupted.
run_command <- function(arguments) {
  if (!length(arguments)) return(tell(2L, command_usage()))
  name <- arguments[1]
  if (name %in% c("--help", "-h")) return(cat_and(0L, command_usage(), "\n"))
  if (name == "--version") {
    return(cat_and(0L, "codend ", format(utils::packageVersion("codend")), "\n"))
  }
  known <- commands()
  if (!name %in% names(known)) {
    return(tell(2L, "codend: there is no command ", name, "; the commands are ",
      paste(names(known), collapse = ", "), "."))
  }
  tryCatch(
    withCallingHandlers(
      {
        command <- known[[name]]()
        given <- parse_command(name, command, arguments[-1])
        if (is.character(given)) return(cat_and(0L, given))
        command$run(given$plan, given$options)
        0L
      },
      warning = function(w) {
        tell(0L, "Warning: ", conditionMessage(w))
        invokeRestart("muffleWarning")
      }
    ),
    codend_error_usage = function(e) {
      tell(2L, "codend ", name, ": ", conditionMessage(e), " See codend ", name, " --help.")
    },
    error = function(e) tell(1L, conditionMessage(e)),
    interrupt = function(e) tell(130L, "Interrupted.")
  )
}

# What the command line knows, in the order of its help: by name a function that makes the command,
# which is list(takes = its arguments after the options, does = a sentence, more = further ones or
# NULL, options = of optparse, run = a function(plan, options) of the arguments and of the options
# by name). Options take long to make: only those of the command that is called are.
commands <- function() {
  list(
    check = command_check, gears = command_gears, settle = command_settle, tow = command_tow,
    report = command_report, share = command_share, export = command_export, draw = command_draw,
    study = command_study, optimise = command_optimise, calibrate = command_calibrate,
    sensitivities = command_sensitivities, flume = command_flume, expand = command_expand,
    new = command_new
  )
}

command_usage <- function() {
  known <- commands()
  does <- vapply(known, function(command) command()$does, "")
  paste0(
    "Usage: codend COMMAND [options] [PLAN]\n\n",
    "Shape and tensions of fishing gear in water. PLAN is a file or the name of a shipped plan.\n",
    "\n",
    paste0("  ", format(names(known)), "  ", does, "\n", collapse = ""),
    "\ncodend COMMAND --help   the options of a command\n",
    "codend --version"
  )
}
