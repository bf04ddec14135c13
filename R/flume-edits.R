# Changes of plan fields that a page sends, by path. A browser may send anything.

# Limits: changes per message, characters of a path or string, and characters of a name.
most_edits <- 500L
most_characters <- 4000L
most_name <- 60L

# A value that differs from the old value by this factor needs a confirmation. Metres instead of
# millimetres are a factor of 1,000, and the new mesh may be several times smaller.
doubtful_factor <- 100

# Checks the fields of a request, which change together. Returns list(paths, field (the first one)).
requested_field <- function(plan, paths) {
  paths <- unlist(paths)
  if (!is.character(paths) || length(paths) > most_edits || any(nchar(paths) > most_characters)) {
    abort_argument("The path of the field is missing.")
  }
  field <- plan_field(plan, paths[1L])
  if (is.null(field$node) || !is_number_node(field$node)) {
    abort_argument("The plan has no number at {.val {paths[1]}}; choose another field.")
  }
  list(paths = paths, field = field)
}

# Returns list(plan, understood) after changes of fields; the plan may be invalid. `understood` has
# list(text, doubt) for each typed number, by path; `doubt` is NULL or list(message, instead).
# `edits` is a list by path with these items.
#   `list(value, unit)`: a number with its own unit or in `unit`, a word, or YAML on one line; a
#     value without a list has no unit.
#   `list(gone = TRUE)` removes the field.
#   `list(like = path, after)` copies another part of the plan; the copy follows `after`.
#   `list(rename = name)` renames the part.
#   `list(move = places)` moves the part by this number of positions among its siblings.
edited_plan <- function(plan, edits) {
  if (!is_map(edits)) abort_argument("Changes must be given by the paths of their fields.")
  if (length(edits) > most_edits || any(nchar(names(edits)) > most_characters)) {
    abort_argument("At most {most_edits} fields can change at once.")
  }
  understood <- list()
  for (path in names(edits)) {
    given <- edits[[path]]
    if (!is.list(given)) given <- list(value = given)
    before <- plan
    plan <- edited_field(plan, path, given)
    if (is.character(given$value)) understood[[path]] <- understood_value(before, plan, path)
  }
  list(plan = plan, understood = understood)
}

edited_field <- function(plan, path, given) {
  if (!nzchar(path)) abort_argument("The path of the field is missing.")
  if (isTRUE(given$gone)) return(set_plan_field(plan, path, NULL))
  of_part <- intersect(c("like", "rename", "move"), names(given))
  if (!length(of_part)) return(set_plan_field(plan, path, edit_value(plan, path, given)))
  check_part(plan, if (of_part[1] == "like") given$like else path)
  switch(of_part[1],
    like = copied_part(plan, path, given$like, if (is_text(given$after)) given$after),
    rename = renamed_part(plan, path, check_part_name(given$rename, path)),
    move = moved_part(plan, path, if (is.numeric(given$move)) round(given$move[1]) else 0)
  )
}

check_part <- function(plan, path) {
  there <- is_text(path) && nchar(path) <= most_characters &&
    !is.null(at_path(plan, path_steps(path)))
  if (!there) {
    abort_argument("The plan does not have this part; it cannot be copied, renamed or moved.")
  }
}

check_part_name <- function(name, path) {
  if (!is_text(name) || !grepl("^[A-Za-z][A-Za-z0-9_]*$", name) || nchar(name) > most_name) {
    abort_field(path, name, "a name of letters, digits and _")
  }
  name
}

# Returns the new value of a field, such as "4.8 knot" for a number with a unit. Unsuitable values
# stay as they are, so that the plan check reports them.
edit_value <- function(plan, path, given) {
  value <- given$value
  refuse <- function(must) abort_field(path, value, must)
  if (length(value) != 1L || is.list(value) || is.na(value)) refuse("one value")
  if (is.character(value) && nchar(value) > most_characters) refuse("a shorter text")
  field <- plan_field(plan, path)
  node <- if (is.null(field$node)) path_node(plan, path) else field$node
  # set_plan_field() reports unknown fields
  if (is.null(node)) return(value)
  if (is_number_node(node)) return(number_value(value, given$unit, node, refuse))
  if (node$shape %in% c("boolean", "string")) return(value)
  if (is.character(value)) yaml_value(value, refuse) else value
}

number_value <- function(value, unit, node, refuse) {
  if (is.logical(value)) refuse("a number")
  known <- names(plan_units[[first_of(node[["x-dimension"]], "number")]])
  parts <- if (is.numeric(value)) c(shortest_decimal(as.double(value)), "") else {
    split_quantity(with_point(value))
  }
  if (is.null(parts)) return(value)
  own <- nzchar(parts[2])
  if (own) unit <- parts[2]
  # a number without a unit is in SI
  if (is.null(unit) || identical(unit, "")) return(as.double(parts[1]))
  if (!is_text(unit) || nchar(unit) > 40 || !plain_unit(unit) %in% known) {
    if (own) return(value)
    refuse(paste("a number with one unit from this list:", word_list(known)))
  }
  paste(parts[1], unit)
}

# Replaces a decimal comma by a point. A comma before exactly three digits may separate thousands.
with_point <- function(text) {
  sub("^([[:space:]]*[-+]?)(?!0*[1-9][0-9]{0,2},[0-9]{3}(?![0-9]))([0-9]*),([0-9])", "\\1\\2.\\3",
    text, perl = TRUE)
}

# Adds the unit of the example `like` to a bare number in a text field.
typed_quantity <- function(text, like) {
  text <- with_point(text)
  parts <- split_quantity(text)
  unit <- split_quantity(like)[2]
  if (is.null(parts) || nzchar(parts[2]) || !isTRUE(nzchar(unit))) text else paste(parts[1], unit)
}

# Returns the text of a number from a text field, with its unit, and its SI value: list(text, si).
# like: an example with the default unit; name: of the number in messages.
typed_number <- function(given, like, name) {
  good <- is_text(given) && nchar(given) <= most_name
  text <- if (good) trimws(typed_quantity(given, like)) else ""
  dimension <- first_of(stats::na.omit(quantity_dimension(like)), "number")
  si <- tryCatch(quantity_si(text, dimension), error = function(e) NA_real_)
  if (!isTRUE(is.finite(si))) {
    shown <- if (good) given else "something else"
    abort_argument("The {name} is {.val {shown}}; it must be a number such as {.val {like}}.")
  }
  list(text = text, si = si)
}

# Returns list(text, doubt), or NULL if the field is not a quantity.
understood_value <- function(before, after, path) {
  node <- path_node(after, path)
  now <- at_path(after, path_steps(path))
  dimension <- node[["x-dimension"]]
  if (is.null(dimension)) dimension <- plan_field(before, path)$node[["x-dimension"]]
  if (is.null(dimension)) return(NULL)
  si <- if (is.numeric(now) || is_text(now)) quantity_si(now, dimension) else NA
  if (length(si) != 1L || !is.finite(si)) return(NULL)
  text <- if (is_text(now)) now else format_si(si, dimension)
  list(text = text, doubt = doubt_of(si, now, at_path(before, path_steps(path)), dimension, text))
}

doubt_of <- function(si, now, was, dimension, text) {
  usual <- if (is.numeric(was) || is_text(was)) quantity_si(was, dimension) else NA
  if (length(usual) != 1L || !is.finite(usual) || usual == 0 || si == 0) return(NULL)
  far <- abs(log10(abs(si / usual))) >= log10(doubtful_factor) * (1 - 1e-9)
  if (!far) return(NULL)
  number <- if (is_text(now)) split_quantity(now)[1] else shortest_decimal(now)
  unit <- if (is_text(was)) split_quantity(was)[2] else ""
  instead <- paste(number, unit)
  near <- nzchar(unit) &&
    abs(log10(abs(quantity_si(instead, dimension) / usual))) < log10(doubtful_factor)
  list(
    message = sprintf("Is %s correct? The value was %s.", text, show_value(was)),
    instead = if (near) instead
  )
}

# Parses YAML on one line and never runs code.
yaml_value <- function(text, refuse) {
  line <- gsub("[\r\n]+", " ", enc2utf8(text))
  tree <- tryCatch(
    plan_of_bytes(charToRaw(enc2utf8(paste0("value: ", line))), "on this page"),
    codend_error = function(e) NULL
  )
  if (is.null(tree$value)) refuse("in the notation of plans, such as 4 m, [1, 2] or {length: 2 m}")
  tree$value
}
