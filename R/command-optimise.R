run_optimise <- function(plan, options) {
  if (is.null(options$minimise)) abort_usage("--minimise is missing; it must be a formula.")
  if (is.null(options$and)) check_plan_out(options$out) else check_place(options$out)
  check_place(options$file, "--file")
  keep <- if (!is.null(options$keep)) option_formula(options$keep, "--keep")
  objective <- option_formula(options$minimise, "--minimise")
  other <- if (!is.null(options$and)) option_formula(options$and, "--and")
  change <- option_ranges(options$change)
  gear <- read_changed(plan, options)
  if (!is.null(other)) {
    aims <- setNames(list(objective, other), c(options$minimise, options$and))
    arguments <- list(gear, aims, keep, change, points = first_of(options$points, 7))
    return(give_csv(do.call(trade_off, c(arguments, settle_arguments(options))), options$out))
  }
  arguments <- list(gear, objective, keep, change, starts = options$starts)
  found <- do.call(optimise_gear, c(arguments, settle_arguments(options)))
  print(found)
  write_found(found$gear, options$out)
}

# The empty environment provides no values to the formula.
option_formula <- function(text, option) {
  found <- tryCatch(str2lang(text), error = function(e) {
    abort_usage(option, " is ", text, "; it must be a formula.")
  })
  stats::as.formula(call("~", found), env = emptyenv())
}

# Converts "a = 1 m .. 2 m; b = 3 .. 4" to ranges by path.
option_ranges <- function(text) {
  named_parts(text, "--change", ".+[.][.].+", "FIELD = FROM .. TO", function(range) {
    ends <- trimws(strsplit(range, "..", fixed = TRUE)[[1L]])
    if (length(ends) != 2L) abort_usage("--change has ", range, "; it must be FROM .. TO.")
    lapply(ends, plan_value)
  })
}

check_plan_out <- function(out) check_place(out, "--out", c(".yaml", ".yml"))

write_found <- function(gear, out) {
  if (is.null(out)) return(invisible(NULL))
  write_gear(gear, out)
  write_output(0L, "Written: ", out)
}
