# The laws of drag and wake: their names, numbers, the ranges that they are used in and their
# sources stand once, in inst/schema/laws.csv, from which the engine's enumerations and the schema's
# words are made too (tools/schema.R).
#
# A row a law: of ("twine", "netting" or "wake"), name, form ("numbers": normal, tangential and skin
# on diameter times length; "formula" or "screen": of the engine; "twines", "blended"), the ends
# of its
# range, NA where it has none, what help says of it across and along the axis, and its source.
laws <- utils::read.csv(
  system.file("schema", "laws.csv", package = "codend", mustWork = TRUE)
)

# Names of the laws of a kind, of some forms.
law_names <- function(of, forms = laws$form) laws$name[laws$of == of & laws$form %in% forms]

# A column of the laws of a kind and form, by their names.
law_column <- function(field, of, forms = laws$form) {
  names <- law_names(of, forms)
  stats::setNames(laws[[field]][laws$of == of][match(names, law_names(of))], names)
}

# "`loland` (its source), `aarsnes` (its source)": what help says of laws.
law_sources <- function(of, forms = laws$form) {
  names <- law_names(of, forms)
  paste0("`", names, "` (", law_column("source", of, forms), ")", collapse = "; ")
}

# The rows of help's table of the sets of coefficients.
twine_law_rows <- function() {
  rows <- laws[laws$of == "twine", ]
  sprintf("| `%s` | %s | %s (%s) |", rows$name, rows$across, rows$along, rows$source)
}

# "a solidity of 0.1 to 0.35 (`loland`, `aarsnes`), ...": the ranges of the screens' laws.
screen_ranges <- function() {
  rows <- laws[laws$of == "netting" & laws$form == "screen", ]
  range <- paste(rows$least_solidity, "to", rows$most_solidity)
  named <- tapply(paste0("`", rows$name, "`"), factor(range, unique(range)), toString)
  paste0(names(named), " (", named, ")", collapse = ", ")
}
