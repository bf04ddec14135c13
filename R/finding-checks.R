# Checks for warnings: properties of a gear or state outside practice and measurements. Each warning
# has a value, a location and advice. A new check is a row of inst/extdata/findings.csv and an entry
# in a file `finding-*.R`. Checks of single numbers are rows of another table (finding-numbers.R).

# All checks by name. The files of checks fill this environment when the package is built.
finding_checks <- new.env(parent = emptyenv())

# Texts of checks. `of`: "plan" if the plan is enough, "state" if the check needs a settled shape,
# "tow" if it needs a trajectory. `rank`: 1 if the gear breaks or does not fish, 2 if it is out of
# proportion, 3 if the model is used outside its tested range. `message`: a sentence about the odd
# property, with bounds and sources. A check with several `text` and `advice` has a row for each
# `case`. `field`: the field to change in the plan or the part, empty for the location itself.
finding_strings <- package_table("findings.csv")

no_values <- function() NULL

# Defines a check of a table. `test(gear, state)`: returns a list of `finding()` and NULL.
# `values()`: returns values for the placeholders of the message.
define_finding <- function(name, test, values = no_values, table = finding_strings) {
  row <- table[match(name, table$check), ]
  finding_checks[[name]] <- list(name = name, of = row$of, rank = row$rank, test = test,
    message = row$message, values = values)
}

# Returns a warning of a check. `location`: the plan's field, or parts of the gear. `value`: the odd
# number, and `label` its text with a unit, which replaces {value} in the text. `...`: values for
# other placeholders of text and advice.
finding <- function(check, location, value, label, ..., case = "") {
  row <- finding_strings[finding_strings$check == check & finding_strings$case == case, ]
  list(location = location, value = value, label = label,
    message = template(row$text, value = label, ...), advice = template(row$advice, ...),
    field = if (nzchar(row$field)) row$field)
}

# Returns a template with placeholders such as {load} and their values, which may be templates too.
# `fill_template()` translates and fills it.
template <- function(text, ...) list(text = text, values = list(...))

# translate: function that translates a string.
fill_template <- function(template, translate = identity) {
  if (!is.list(template)) return(translate(one_line(template)))
  fill_places(translate(one_line(template$text)), lapply(template$values, fill_template, translate))
}

fill_places <- function(text, values) {
  for (name in names(values)) {
    text <- gsub(paste0("{", name, "}"), values[[name]], text, fixed = TRUE)
  }
  text
}

# Returns the path of the plan's field that a warning is about, or NA. For a location such as "rope
# bridle_upper_port" it is the part's description ("bridles.upper"), with the part's field if given.
finding_field <- function(plan, location, field) {
  has <- function(path) !is.null(tryCatch(plan_field(plan, path), error = function(e) NULL))
  for (gear in names(plan$gears)) {
    own <- sub(paste0("^([a-z]+ )?", gear, "(_[0-9]+)?[_ ]"), "\\1", location)
    if (own == location) next
    inner <- finding_field(gear_like(plan$gears, gear), own, field)
    return(if (!is.na(inner)) gear_field_path(plan$gears, gear, inner) else inner)
  }
  # A field that the plan may contain can be absent.
  known <- names(plan_node(plan)$properties)
  if (!is.null(field) && (field %in% known || has(field))) return(field)
  if (grepl("^[a-z_]+([.][a-z_]+)*$", location) && has(location)) return(location)
  part <- part_field(plan, sub("^(rope|panel|piece|netting) ", "", location), has)
  if (is.null(part)) return(NA_character_)
  within <- if (!is.null(field)) paste(part, field, sep = ".")
  if (!is.null(within) && has(within)) within else part
}

# Returns the path at which a plan describes a part, or NULL. First it tries the part's name in an
# assembly. Next are the first words of its name as a group ("hand_ropes.upper" for
# hand_rope_upper_port). Then follow later words ("square" for back_square) and fields within a
# group ("rings.bridles").
part_field <- function(plan, name, has) {
  name <- gsub(" ", "_", name)
  for (group in names(plan)) {
    if (name %in% names(plan[[group]])) return(paste(group, name, sep = "."))
  }
  words <- strsplit(name, "_", fixed = TRUE)[[1L]]
  begins <- described_at(plan, words, has)
  if (!is.null(begins)) return(begins)
  # Panel names contain the position, then the section.
  section <- Filter(function(one) endsWith(name, paste0("_", one)), names(plan$sections))
  if (length(section)) return(paste0("sections.", section[1L]))
  for (first in seq_along(words)[-1L]) {
    later <- described_at(plan, words[first:length(words)], has)
    if (!is.null(later)) return(later)
  }
  other <- intersect(described_as[[words[1L]]], names(plan))
  if (length(other)) return(other[1L])
  # The last word distinguishes panels and the first distinguishes ropes. Sides of the gear
  # distinguish neither.
  told <- setdiff(words, c("port", "starboard"))
  ends <- told[c(length(told), 1L)]
  for (group in names(plan)) {
    within <- intersect(c(ends, paste0(ends, "s")), names(plan[[group]]))
    if (length(within)) return(paste(group, within[1L], sep = "."))
  }
  NULL
}

# Groups of parts whose name starts with another word.
described_as <- list(brace = c("beam", "collar"), strut = "beam", collar = "frame")

# Returns the group of a plan that matches the first words, or its field named by the next word;
# NULL if there is none.
described_at <- function(plan, words, has) {
  for (first in rev(seq_along(words))) {
    head <- paste(words[seq_len(first)], collapse = "_")
    for (group in paste0(head, c("s", ""))) {
      # Skip the plan's own `name`.
      if (!is.list(plan[[group]])) next
      inner <- words[-seq_len(first)]
      path <- if (length(inner)) paste(group, inner[1L], sep = ".")
      return(if (!is.null(path) && has(path)) path else group)
    }
  }
  NULL
}

one_line <- function(text) gsub("[[:space:]]+", " ", text)
