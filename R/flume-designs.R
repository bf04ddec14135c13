# Designs of the flume tank. A design is list(plan, file, source) of a gear; its plan may be
# invalid. The page keeps its history and its stored designs as list(base = name of a shipped plan)
# or list(plan = text), with `edits`: a list of changes as in edited_plan(), in their order.

design_of <- function(gear) list(plan = gear$plan, file = gear$file, source = gear$source)

gear_of_design <- function(design, like = NULL) {
  as_gear(design$plan, file = design$file, like = like, source = design$source)
}

# The text contains the remarks of the source if possible.
draft_text <- function(design) edited_text(design$source, design$plan)

# Returns an opened gear as the page keeps it.
page_design <- function(gear) {
  base <- loaded_shipped(gear)
  if (!is.null(base)) list(base = base) else list(plan = draft_text(design_of(gear)))
}

# Returns the design that a page sends. An address may contain anything, so all of it is checked.
sent_design <- function(words) {
  words <- as.list(words)
  design <- if (is.null(words$base)) typed_design(words$plan) else shipped_design(words$base)
  edits <- words$edits
  # one map of changes is a list of one
  if (is_map(edits)) edits <- list(edits)
  if (!all(vapply(edits, is.list, NA)) || length(edits) > most_edits) {
    abort_argument("This address has no list of changed fields.")
  }
  plan <- design$plan
  for (some in edits) plan <- edited_plan(plan, some)$plan
  if (length(edits)) design$plan <- without_gone(plan, design$plan)
  design
}

shipped_design <- function(name) {
  if (!is_text(name) || !name %in% names(shipped_plans())) {
    abort_argument("No shipped gear has this name.")
  }
  design_of(read_gear(name))
}

typed_design <- function(text) {
  if (!is_text(text)) abort_plan("The plan must be text.", NULL)
  text <- enc2utf8(text)
  tree <- with_included_plans(plan_of_bytes(charToRaw(text), "on this page"), NULL)
  list(plan = split_uncertain(tree), file = NULL, source = text)
}

gear_of_words <- function(words) gear_of_design(sent_design(words))

# Returns a cleaned and shortened name, or `otherwise` if a page did not send a name.
design_name <- function(name, otherwise) {
  if (!is_text(name)) return(otherwise)
  name <- trimws(gsub("[[:cntrl:][:space:]]+", " ", substr(name, 1L, 4L * most_name)))
  if (nzchar(name)) substr(name, 1L, most_name) else otherwise
}
