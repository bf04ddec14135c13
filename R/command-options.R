# Options that several commands take, and what is checked of them before anything is computed: a
# long solve must not end in a folder that cannot be written.

# The gear of a plan with the fields that --set changes.
read_changed <- function(plan, options) {
  gear <- read_gear(plan)
  for (field in names(options$set)) gear <- set_field(gear, field, options$set[[field]])
  gear
}

# The arguments of settle() and tow() that options give.
lattice_arguments <- function(options) options[intersect(c("nodes", "netting"), names(options))]

settle_changed <- function(plan, options) {
  do.call(settle, c(list(read_changed(plan, options)), lattice_arguments(options)))
}

# That a file can be written, with one of some ends of its name; "-" is standard output. option:
# that names it, or NULL.
check_place <- function(file, option = "--out", ends = NULL) {
  if (is.null(file) || is.null(ends) && file == "-") return(invisible())
  ended <- is.null(ends) || any(endsWith(tolower(file), ends))
  if (ended && !dir.exists(file) && may_write(dirname(file))) return(invisible())
  abort_usage(
    if (is.null(option)) file else paste0(option, " is ", file, "; it"), " must ",
    if (is.null(ends)) "be a file in" else {
      paste("end in", if (length(ends) > 1L) "one of", toString(ends), "and lie in")
    }, " a folder that can be written."
  )
}

may_write <- function(folder) dir.exists(folder) && file.access(folder, 2L) == 0L

nearest_existing <- function(path) {
  while (!file.exists(path) && dirname(path) != path) path <- dirname(path)
  path
}

# Tables of a state or a trajectory as CSV files of their names. Returns these.
write_tables <- function(of, tables, folder) {
  files <- paste0(tables, ".csv")
  for (k in seq_along(tables)) {
    write_csv(as.data.frame(of, what = tables[k]), file.path(folder, files[k]))
  }
  files
}

# The parts of an option between semicolons, or NULL.
parts_of <- function(text) {
  if (!is.null(text)) Filter(nzchar, trimws(strsplit(text, ";", fixed = TRUE)[[1L]]))
}

# What --change has, by the fields' paths: of each of its parts what `read` makes of the text after
# the equals sign, which has the pattern `values`. what, form: the words for that and for a part.
changed_fields <- function(text, what, values, form, read) {
  parts <- parts_of(text)
  if (!length(parts)) abort_usage("--change must have fields with their ", what, ".")
  wrong <- grep(paste0("^[^=]+=", values, "$"), parts, invert = TRUE, value = TRUE)
  if (length(wrong)) abort_usage("--change has ", wrong[1L], "; it must be ", form, ".")
  setNames(lapply(sub("^[^=]+=", "", parts), read), trimws(sub("=.*", "", parts)))
}

# A table that an option names.
read_csv_option <- function(file, option) {
  if (!file.exists(file) || dir.exists(file)) {
    abort_usage(option, " is ", file, "; it must be a CSV file that exists.")
  }
  read_designs(file)
}

# A table as CSV: on standard output, or in a file.
give_csv <- function(table, out) {
  if (is.null(out) || out == "-") {
    table <- without_formulas(table)
    with_plain_numbers(utils::write.csv(table, stdout(), row.names = FALSE, na = ""))
  } else {
    write_csv(table, out)
  }
}
