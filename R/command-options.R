# Options that several commands take, and what is checked of them before anything is computed: a
# long solve must not end in a folder that cannot be written.

set_option <- function() {
  optparse::make_option("--set", metavar = "FIELD=VALUE", help = paste(
    "change a field of the plan, such as towing.speed=\"5 knot\" or",
    "ropes.warp.length=300; may be given several times"
  ))
}

# usual: how many are taken without.
nodes_option <- function(usual = "1500") {
  optparse::make_option("--nodes", metavar = "N", help = sprintf(
    "about how many nodes [%s]", usual
  ))
}

# Of what is settled once.
aimed_nodes_option <- function() {
  nodes_option("1500, or up to 4000 where main measures would err by over 1 %")
}

netting_option <- function() {
  optparse::make_option("--netting", metavar = "NAME", help = paste(
    "bars or cells for every panel [each panel's own choice in the plan]"
  ))
}

# The gear of a plan with the fields that --set changes.
read_changed <- function(plan, options) {
  gear <- read_gear(plan)
  for (field in names(options$set)) gear <- set_field(gear, field, options$set[[field]])
  gear
}

# The arguments of settle() and tow() that options give.
lattice_arguments <- function(options) {
  given <- options["netting"]
  if (!is.null(options$nodes)) given$nodes <- as.numeric(options$nodes)
  Filter(Negate(is.null), given)
}

settle_changed <- function(plan, options) {
  do.call(settle, c(list(read_changed(plan, options)), lattice_arguments(options)))
}

check_lattice_options <- function(options) {
  nodes <- options$nodes
  if (!is.null(nodes) && !grepl("^[1-9][0-9]{0,8}$", nodes)) {
    abort_usage("--nodes is ", nodes, "; it must be a whole number, 1 or more.")
  }
  if (!is.null(options$netting) && !options$netting %in% c("bars", "cells")) {
    abort_usage("--netting is ", options$netting, "; it must be bars or cells.")
  }
}

check_out_folder <- function(out) {
  if (!is.null(out) && !may_write(nearest_existing(out))) {
    abort_usage("--out is ", out, "; it must be a folder that can be written.")
  }
}

# Whether a file can be written at a place.
may_place <- function(file) !dir.exists(file) && may_write(dirname(file))

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

check_csv_out <- function(out, option = "--out") {
  if (!is.null(out) && out != "-" && !may_place(out)) {
    abort_usage(option, " is ", out, "; it must be a file in a folder that can be written.")
  }
}

# A table as CSV: on standard output, or in a file.
give_csv <- function(table, out) {
  if (is.null(out) || out == "-") {
    with_plain_numbers(utils::write.csv(table, stdout(), row.names = FALSE, na = ""))
  } else {
    write_csv(table, out)
  }
}
