# Options of several commands. They are checked before a computation, so that a long solve does not
# end at a folder that is not writable.

# Reads a plan and applies --set.
read_changed <- function(plan, options) with_fields(read_gear(plan), options$set)

# Returns the options for functions that settle gears.
settle_arguments <- function(options) {
  options[intersect(c("nodes", "netting", "accuracy", "file"), names(options))]
}

settle_changed <- function(plan, options) {
  do.call(settle, c(list(read_changed(plan, options)), settle_arguments(options)))
}

# Throws a usage error if a file is not writable or does not end in `ends`. "-" is standard output.
# option: name of the option, or NULL.
check_place <- function(file, option = "--out", ends = NULL) {
  if (is.null(file) || is.null(ends) && file == "-") return(invisible())
  ended <- is.null(ends) || any(endsWith(tolower(file), ends))
  if (ended && !dir.exists(file) && may_write(dirname(file))) return(invisible())
  abort_usage(
    if (is.null(option)) file else paste0(option, " is ", file, "; it"), " must ",
    if (is.null(ends)) "be a file in" else {
      paste("end in", if (length(ends) > 1L) "one of", toString(ends), "and lie in")
    }, " a writable folder."
  )
}

may_write <- function(folder) dir.exists(folder) && file.access(folder, 2L) == 0L

nearest_existing <- function(path) {
  while (!file.exists(path) && dirname(path) != path) path <- dirname(path)
  path
}

# Writes tables of a state or a trajectory as CSV and returns their file names.
write_tables <- function(of, tables, folder) {
  files <- paste0(tables, ".csv")
  for (k in seq_along(tables)) {
    write_csv(as.data.frame(of, what = tables[k]), file.path(folder, files[k]))
  }
  files
}

# Splits an option at semicolons.
parts_of <- function(text) {
  if (!is.null(text)) Filter(nzchar, trimws(strsplit(text, ";", fixed = TRUE)[[1L]]))
}

# Returns the values of an option such as "a = 3 m; b = 4" by name. `read` converts the text after
# an equals sign, which has the pattern `values`. `form`: string for error messages.
named_parts <- function(text, option, values, form, read) {
  parts <- parts_of(text)
  if (!length(parts)) abort_usage(option, " is empty; it must be ", form, ".")
  wrong <- grep(paste0("^[^=]+=", values, "$"), parts, invert = TRUE, value = TRUE)
  if (length(wrong)) abort_usage(option, " has ", wrong[1L], "; it must be ", form, ".")
  setNames(lapply(trimws(sub("^[^=]+=", "", parts)), read), trimws(sub("=.*", "", parts)))
}

read_csv_option <- function(file, option) {
  if (!file.exists(file) || dir.exists(file)) {
    abort_usage(option, " is ", file, "; it must be a CSV file that exists.")
  }
  read_designs(file)
}

# out: a file; "-" or NULL is standard output.
give_csv <- function(table, out) {
  if (is.null(out) || out == "-") {
    table <- without_formulas(table)
    with_plain_numbers(utils::write.csv(table, stdout(), row.names = FALSE, na = ""))
  } else {
    write_csv(table, out)
  }
}
