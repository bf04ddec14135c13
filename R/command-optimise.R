run_optimise <- function(plan, options) {
  if (is.null(options$minimise)) abort_usage("--minimise must say what is to be small.")
  if (is.null(options$and)) check_plan_out(options$out) else check_place(options$out)
  keep <- if (!is.null(options$keep)) option_formula(options$keep, "--keep")
  aim <- option_formula(options$minimise, "--minimise")
  other <- if (!is.null(options$and)) option_formula(options$and, "--and")
  change <- option_ranges(options$change)
  gear <- read_changed(plan, options)
  if (!is.null(other)) {
    aims <- setNames(list(aim, other), c(options$minimise, options$and))
    arguments <- list(gear, aims, keep, change, points = first_of(options$points, 7))
    return(give_csv(do.call(trade_off, c(arguments, lattice_arguments(options))), options$out))
  }
  arguments <- list(gear, aim, keep, change, starts = options$starts)
  found <- do.call(optimise_gear, c(arguments, lattice_arguments(options)))
  print(found)
  write_found(found$gear, options$out)
}

# A formula of an option's text, with nothing around it to take values from.
option_formula <- function(text, option) {
  found <- tryCatch(str2lang(text), error = function(e) {
    abort_usage(option, " is ", text, "; it must be a formula.")
  })
  stats::as.formula(call("~", found), env = emptyenv())
}

# "a = 1 m .. 2 m; b = 3 .. 4" as ranges by paths.
option_ranges <- function(text) {
  changed_fields(text, "ranges", ".+[.][.].+", "FIELD = FROM .. TO", function(range) {
    ends <- trimws(strsplit(range, "..", fixed = TRUE)[[1L]])
    if (length(ends) != 2L) abort_usage("--change has ", range, "; it must be FROM .. TO.")
    lapply(ends, plan_value)
  })
}

check_plan_out <- function(out) check_place(out, "--out", c(".yaml", ".yml"))

write_found <- function(gear, out) {
  if (is.null(out)) return(invisible(NULL))
  write_gear(gear, out)
  tell(0L, "Written: ", out)
}
