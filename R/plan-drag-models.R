# Drag and wake models: names, coefficients, valid ranges and sources, from
# inst/schema/drag_models.csv. tools/schema.R also generates the engine's enumerations and the
# schema's strings from this file.
#
# Each row is a model. `of` is "twine", "netting" or "wake". `form` is "morison", "blended" or:
# "numbers": the row has normal, tangential and skin coefficients on diameter times length.
# "formula" or "screen": the engine computes the drag.
#
# `least_*` and `most_*` are the ends of the valid range, or NA. Help pages print `across`, `along`
# and `source`.
laws <- utils::read.csv(
  system.file("schema", "drag_models.csv", package = "codend", mustWork = TRUE)
)

drag_model_names <- function(of, forms = laws$form) laws$name[laws$of == of & laws$form %in% forms]

drag_model_column <- function(field, of, forms = laws$form) {
  names <- drag_model_names(of, forms)
  stats::setNames(laws[[field]][laws$of == of][match(names, drag_model_names(of))], names)
}

# Returns "`loland` (its source), `aarsnes` (its source)" for help pages.
drag_model_sources <- function(of, forms = laws$form) {
  names <- drag_model_names(of, forms)
  paste0("`", names, "` (", drag_model_column("source", of, forms), ")", collapse = "; ")
}

twine_drag_model_rows <- function() {
  rows <- laws[laws$of == "twine", ]
  sprintf("| `%s` | %s | %s (%s) |", rows$name, rows$across, rows$along, rows$source)
}

# Returns the solidity ranges of the screen drag models: "0.1 to 0.35 (`loland`, `aarsnes`), ...".
screen_ranges <- function() {
  rows <- laws[laws$of == "netting" & laws$form == "screen", ]
  range <- paste(rows$least_solidity, "to", rows$most_solidity)
  named <- tapply(paste0("`", rows$name, "`"), factor(range, unique(range)), toString)
  paste0(names(named), " (", named, ")", collapse = ", ")
}
