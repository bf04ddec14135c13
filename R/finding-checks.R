# Worth a look: what a gear or a state has that practice and measurement do not know, each with its
# number, its place and what to try. A new check is a new entry in a file `finding-*.R`.

# Every check, by name: list(name, words, of, test) as define_finding() makes them. The files of
# checks fill it while the package is built.
finding_checks <- new.env(parent = emptyenv())

# name: of the check, in words; words: what is worth a look, in one sentence, with the bounds and
# where they come from, or a function that gives it; of: "plan" where the plan alone tells it,
# "state" where a settled shape is needed; test(gear, state): a list of finding() and NULL, `state`
# being NULL for a check of a plan; rank: 1 where the gear breaks or does not fish so, 2 where it is
# out of proportion, 3 where the model is used outside what it is known for.
define_finding <- function(name, of, words, test, rank = 2L) {
  finding_checks[[name]] <- list(name = name, words = words, of = of, test = test, rank = rank)
}

# place: the plan's field, or the parts of the gear; value: the number, as it is told with its unit
# in `shown`; words: what is odd; advice: what to try; field: the field to change: of the plan where
# there is such a one, else of the part at `place`; NULL for the place itself. shown, words and
# advice are texts, or what told() makes.
finding <- function(place, value, shown, words, advice, field = NULL) {
  list(place = place, value = value, shown = shown, words = words, advice = advice, field = field)
}

# A text with places such as {load}, and what fills them, which may be such texts themselves: it is
# put into words by told_in(), in whatever language.
told <- function(text, ...) list(text = text, values = list(...))

# translate: a function of a text that gives its translation, or the text itself.
told_in <- function(told, translate = identity) {
  if (!is.list(told)) return(translate(one_line(told)))
  fill_places(translate(one_line(told$text)), lapply(told$values, told_in, translate))
}

fill_places <- function(text, values) {
  for (name in names(values)) {
    text <- gsub(paste0("{", name, "}"), values[[name]], text, fixed = TRUE)
  }
  text
}

# The plan's field that a finding is about: of a place such as "rope bridle_upper_port" where its
# part is described ("bridles.upper"), with the part's field where that is given.
finding_field <- function(plan, place, field) {
  has <- function(path) !is.null(tryCatch(plan_field(plan, path), error = function(e) NULL))
  # what a plan may have it may lack
  known <- names(plan_node(plan)$properties)
  if (!is.null(field) && (field %in% known || has(field))) return(field)
  if (grepl("^[a-z_]+([.][a-z_]+)*$", place) && has(place)) return(place)
  part <- part_field(plan, sub("^(rope|panel|piece|netting) ", "", place), has)
  if (is.null(part)) return(NA_character_)
  within <- if (!is.null(field)) paste(part, field, sep = ".")
  if (!is.null(within) && has(within)) within else part
}

# Where a plan describes a part of the gear: by its name in an assembly, else by the words of its
# name, of which the first are the group's ("hand_ropes.upper" for hand_rope_upper_port), or later
# ones ("square" for back_square), or those of a field within a group ("rings.bridles").
part_field <- function(plan, name, has) {
  name <- gsub(" ", "_", name)
  for (group in names(plan)) {
    if (name %in% names(plan[[group]])) return(paste(group, name, sep = "."))
  }
  words <- strsplit(name, "_", fixed = TRUE)[[1L]]
  begins <- described_at(plan, words, has)
  if (!is.null(begins)) return(begins)
  # panels are named by where they are and then by their section
  section <- Filter(function(one) endsWith(name, paste0("_", one)), names(plan$sections))
  if (length(section)) return(paste0("sections.", section[1L]))
  for (first in seq_along(words)[-1L]) {
    later <- described_at(plan, words[first:length(words)], has)
    if (!is.null(later)) return(later)
  }
  other <- intersect(described_as[[words[1L]]], names(plan))
  if (length(other)) return(other[1L])
  # its last word tells panels apart, its first one ropes; sides of the gear tell neither
  told <- setdiff(words, c("port", "starboard"))
  ends <- told[c(length(told), 1L)]
  for (group in names(plan)) {
    within <- intersect(c(ends, paste0(ends, "s")), names(plan[[group]]))
    if (length(within)) return(paste(group, within[1L], sep = "."))
  }
  NULL
}

# Parts by the first word of their name whose group has another.
described_as <- list(brace = c("beam", "collar"), strut = "beam", collar = "frame")

# The group of a plan that words begin with, or its field that the next word names; NULL: none.
described_at <- function(plan, words, has) {
  for (first in rev(seq_along(words))) {
    head <- paste(words[seq_len(first)], collapse = "_")
    for (group in paste0(head, c("s", ""))) {
      # a plan's own name is no part
      if (!is.list(plan[[group]])) next
      inner <- words[-seq_len(first)]
      path <- if (length(inner)) paste(group, inner[1L], sep = ".")
      return(if (!is.null(path) && has(path)) path else group)
    }
  }
  NULL
}

# A text over several lines of code as one line.
one_line <- function(text) gsub("[[:space:]]+", " ", text)
