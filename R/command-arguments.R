# The arguments of a command: list(plan = what is no option, options = by name), or the text of its
# help where that is asked for.

parse_command <- function(name, command, arguments) {
  taken <- list(rest = arguments)
  if (any(vapply(command$options, function(option) option@long_flag == "--set", NA))) {
    taken <- take_sets(arguments)
  }
  if (any(vapply(command$options, function(option) option@long_flag == "--slider", NA))) {
    taken[c("slider", "rest")] <- take_repeated(taken$rest, "--slider")
  }
  parser <- command_parser(name, command)
  if (any(taken$rest %in% c("--help", "-h"))) {
    said <- utils::capture.output(optparse::print_help(parser))
    return(paste0(paste(said, collapse = "\n"), "\n"))
  }
  found <- tryCatch(
    optparse::parse_args(parser, taken$rest, positional_arguments = TRUE),
    error = function(e) {
      missing_value <- 'flag "([^"]+)" requires an argument'
      said <- conditionMessage(e)
      if (!grepl(missing_value, said)) abort_usage(trimws(said), ".")
      abort_usage("--", sub(paste0(".*", missing_value, ".*"), "\\1", said), " needs a value.")
    }
  )
  given <- length(found$args)
  wrong <- switch(command$takes,
    "KIND [NAME=VALUE...]" = if (!given) {
      paste("a KIND is needed, one of", paste(names(new_plan_kinds()), collapse = ", "))
    },
    "PLAN FILE..." = if (given < 2L) "a PLAN and a FILE are needed",
    "PLAN FILE.html" = if (given != 2L) "a PLAN and a FILE.html are needed",
    "PLAN" = if (given != 1L) "one PLAN is needed",
    "ACTION STORE [PLAN]" = if (!given %in% 2:3) "an ACTION and a STORE are needed",
    "[PLAN]" = if (given > 1L) "at most one PLAN is needed",
    if (given) "no PLAN is needed"
  )
  if (!is.null(wrong)) abort_usage(wrong, ", not ", given, ".")
  found$options$slider <- NULL
  list(
    plan = found$args,
    options = c(found$options, list(set = taken$set), if (length(taken$slider)) taken["slider"])
  )
}

command_parser <- function(name, command) {
  optparse::OptionParser(
    usage = trimws(paste("codend", name, if (length(command$options)) "[options]", command$takes)),
    description = paste0(command$does, if (grepl("PLAN", command$takes)) {
      " PLAN is a file or the name of a shipped plan (`codend gears`)."
    }, command$more),
    option_list = command$options
  )
}

# Takes every occurrence of an option with its value out of the arguments, since optparse keeps only
# the last of one that is repeated: list(texts, rest).
take_repeated <- function(arguments, flag) {
  at <- which(arguments == flag)
  if (any(at == length(arguments))) abort_usage(flag, " needs a value.")
  joined <- which(startsWith(arguments, paste0(flag, "=")))
  place <- order(c(at, joined))
  list(
    texts = c(arguments[at + 1L], substring(arguments[joined], nchar(flag) + 2L))[place],
    rest = arguments[setdiff(seq_along(arguments), c(at, at + 1L, joined))]
  )
}

# The same of "--set FIELD=VALUE". Of two for the same field the last counts.
take_sets <- function(arguments) {
  if (identical(utils::tail(arguments, 1L), "--set")) abort_usage("--set needs FIELD=VALUE.")
  taken <- take_repeated(arguments, "--set")
  texts <- taken$texts
  wrong <- grep("^[^=]+=.", texts, invert = TRUE)
  if (length(wrong)) abort_usage("--set is ", texts[wrong[1]], "; it must be FIELD=VALUE.")
  set <- setNames(lapply(sub("^[^=]+=", "", texts), plan_value), sub("=.*", "", texts))
  list(set = set[!duplicated(names(set), fromLast = TRUE)], rest = taken$rest)
}

# A bare number is SI, yes and no are truth values, as in a plan file; all else is text.
plan_value <- function(text) {
  if (grepl("^[-+]?([0-9]+[.]?[0-9]*|[.][0-9]+)([eE][-+]?[0-9]+)?$", text)) return(as.numeric(text))
  if (tolower(text) %in% c("yes", "true")) return(TRUE)
  if (tolower(text) %in% c("no", "false")) return(FALSE)
  text
}
