# The arguments of commands, as described in inst/commands.yaml.

# Returns the commands in inst/commands.yaml, with values for placeholders such as {kinds}.
command_words <- remembered(function() {
  text <- readLines(system.file("commands.yaml", package = "codend"), encoding = "UTF-8")
  known <- list(
    kinds = names(new_plan_kinds()), drawing_types = drawing_types, sheets = names(sheet_sizes),
    state_formats = formats_text("state"), tow_formats = formats_text("trajectory")
  )
  for (name in names(known)) {
    text <- gsub(paste0("{", name, "}"), toString(known[[name]]), text, fixed = TRUE)
  }
  words <- yaml::yaml.load(paste(text, collapse = "\n"))
  words[names(words) != "shared"]
})

# Returns list(plan = positional arguments, options = by name), or the help text of the command. The
# last value of a repeated option counts; --set and --slider collect all values.
parse_command <- function(name, words, arguments) {
  if (any(arguments %in% c("--help", "-h"))) return(command_help(name, words))
  flags <- names(words$options)[lengths(words$options) == 1L]
  options <- setNames(rep(list(FALSE), length(flags)), flags)
  plan <- character()
  while (length(arguments)) {
    one <- arguments[1L]
    arguments <- arguments[-1L]
    if (!startsWith(one, "-")) {
      plan <- c(plan, one)
      next
    }
    option <- sub("^--([^=]*).*", "\\1", one)
    if (!option %in% names(words$options)) abort_usage("there is no option ", one, ".")
    joined <- grepl("=", one, fixed = TRUE)
    if (option %in% flags) {
      if (joined) abort_usage("--", option, " takes no value.")
      options[[option]] <- TRUE
      next
    }
    if (!joined && !length(arguments)) abort_usage("--", option, " needs a value.")
    value <- if (joined) sub("^[^=]*=", "", one) else arguments[1L]
    if (!joined) arguments <- arguments[-1L]
    value <- option_value(option, words$options[[option]][[1L]], value)
    several <- option %in% c("set", "slider")
    options[[option]] <- c(if (several) options[[option]], value)
  }
  options$set <- named_values(options$set, "--set is", "FIELD=VALUE")
  check_arguments_taken(words, length(plan))
  list(plan = plan, options = options)
}

# Checks an option's value by its placeholder in the help. Whole numbers become numbers.
option_value <- function(option, called, text) {
  check <- function(good, must) {
    if (!good) abort_usage("--", option, " is ", text, "; it must be ", must, ".")
  }
  switch(called,
    N = , I = check(grepl("^[1-9][0-9]{0,8}$", text), "a whole number, 1 or more"),
    NAME = check(text %in% c("bars", "cells"), "bars or cells"),
    SIZE = check(text %in% names(sheet_sizes), paste("one of", toString(names(sheet_sizes)))),
    DIR = check(may_write(nearest_existing(text)), "a writable folder")
  )
  if (called %in% c("N", "I")) as.numeric(text) else text
}

# Checks the number of arguments. Names in brackets are optional, and dots allow further arguments.
check_arguments_taken <- function(words, given) {
  names <- strsplit(words$takes, " ")[[1L]]
  least <- sum(!startsWith(names, "["))
  most <- if (grepl("...", words$takes, fixed = TRUE)) Inf else length(names)
  if (given >= least && given <= most) return(invisible())
  abort_usage(first_of(words$needs, if (!most) "no PLAN is needed" else {
    paste(words$takes, "is needed")
  }), ", not ", given, ".")
}

command_help <- function(name, words) {
  usage <- c("Usage: codend", name, if (length(words$options)) "[options]", words$takes)
  does <- c(words$does, if (grepl("PLAN", words$takes)) {
    "PLAN is a file or the name of a shipped plan (`codend gears`)."
  }, words$more)
  said <- Map(function(option, name) {
    value <- if (length(option) > 1L) paste0("=", option[[1L]])
    c(paste0("  --", name, value), strwrap(option[[length(option)]], 96, 6, 6))
  }, words$options, names(words$options))
  paste0(c(
    paste(usage[nzchar(usage)], collapse = " "), strwrap(paste(does, collapse = " "), 96), "",
    unlist(said), "  -h, --help", "      show this and end", ""
  ), collapse = "\n")
}

# Converts strings NAME=VALUE to values by name; the last value of a name counts. `what`, `form`:
# strings for the error message.
named_values <- function(texts, what, form) {
  wrong <- grep("^[^=]+=.", texts, invert = TRUE)
  if (length(wrong)) abort_usage(what, " ", texts[wrong[1L]], "; it must be ", form, ".")
  values <- setNames(lapply(sub("^[^=]+=", "", texts), plan_value), sub("=.*", "", texts))
  values[!duplicated(names(values), fromLast = TRUE)]
}

# A bare number is in SI; yes and no are logical values, as in a plan file.
plan_value <- function(text) {
  if (grepl("^[-+]?([0-9]+[.]?[0-9]*|[.][0-9]+)([eE][-+]?[0-9]+)?$", text)) return(as.numeric(text))
  if (tolower(text) %in% c("yes", "true")) return(TRUE)
  if (tolower(text) %in% c("no", "false")) return(FALSE)
  text
}
