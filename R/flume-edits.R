# What a page sends of a design: changes of fields of a plan, by path. It comes from a browser, and
# may be anything.

# Changes at most in one message, and characters of a path or a text.
most_edits <- 500L
most_characters <- 4000L

# The gear with changed fields. edits: a list by path of
#   list(value, unit)   a number in a unit, a word, or what a plan writes there on one line
#   list(gone = TRUE)   the field is taken out
#   list(like = path)   it becomes as another part of the plan is
apply_edits <- function(gear, edits) {
  if (!is_map(edits)) abort_argument("Changes are told by the paths of their fields.")
  if (length(edits) > most_edits || any(nchar(names(edits)) > most_characters)) {
    abort_argument("At most {most_edits} fields change at once.")
  }
  plan <- gear$plan
  for (path in names(edits)) plan <- apply_edit(plan, path, as.list(edits[[path]]))
  as_gear(plan, file = gear$file, like = gear)
}

apply_edit <- function(plan, path, given) {
  if (!nzchar(path)) abort_argument("A field is changed by its path.")
  if (isTRUE(given$gone)) return(set_plan_field(plan, path, NULL))
  if (!is.null(given$like)) return(set_plan_field(plan, path, part_like(plan, path, given$like)))
  set_plan_field(plan, path, edit_value(plan, path, given))
}

# What a part becomes that is to be as another.
part_like <- function(plan, path, like) {
  field <- if (is_text(like) && nchar(like) <= most_characters) plan_field(plan, like)
  if (is.null(field)) abort_argument("{.val {path}} cannot be like a part that there is not.")
  field$value
}

# What a field becomes. A number with a unit becomes text such as "4.8 knot".
edit_value <- function(plan, path, given) {
  value <- given$value
  refuse <- function(must) abort_field(path, value, must)
  if (!length(value) || length(value) > 1L || is.list(value)) refuse("one value")
  if (is.character(value) && nchar(value) > most_characters) refuse("a shorter text")
  field <- plan_field(plan, path)
  node <- if (is.null(field$node)) path_node(plan, path) else field$node
  # an unknown field is told by who sets it
  if (is.null(node)) return(value)
  if (is_number_node(node)) return(number_value(value, given$unit, node, refuse))
  if (node$shape == "boolean") {
    if (!is.logical(value) || is.na(value)) refuse("yes or no")
    return(value)
  }
  if (node$shape == "string") {
    if (!is_text(value) || !nzchar(value)) refuse(describe(node))
    return(value)
  }
  if (is.character(value)) yaml_value(value, refuse) else value
}

number_value <- function(value, unit, node, refuse) {
  if (!is.numeric(value) || !is.finite(value)) refuse("a number")
  known <- names(plan_units[[first_of(node[["x-dimension"]], "number")]])
  # without a unit it is in SI
  if (is.null(unit) || identical(unit, "")) return(as.double(value))
  if (!is_text(unit) || nchar(unit) > 40 || !plain_unit(unit) %in% known) {
    refuse(paste("in one of these units:", word_list(known)))
  }
  paste(shortest_decimal(as.double(value)), unit)
}

# What a plan says on one line, as a value. Nothing of it is run.
yaml_value <- function(text, refuse) {
  line <- gsub("[\r\n]+", " ", enc2utf8(text))
  tree <- tryCatch(
    plan_of_bytes(charToRaw(enc2utf8(paste0("value: ", line))), "on this page"),
    codend_error = function(e) NULL
  )
  if (is.null(tree$value)) refuse("as a plan writes it, such as 4 m, [1, 2] or {length: 2 m}")
  tree$value
}
