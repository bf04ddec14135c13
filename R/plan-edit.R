# Edits the text of a changed plan. Unchanged fields keep their text and remarks.

# Returns plan text that reads back as `plan`. `source`: the original text, or NULL. It is the
# source with changed fields, else with changed groups rewritten, else a new text.
edited_text <- function(source, plan) {
  plan <- join_uncertain(plan)
  anew <- paste0(c(yaml_lines(plan, 0), ""), collapse = "\n")
  if (is.null(source)) return(anew)
  # Returns the tree of a text, NULL if it is not a plan. A text that includes files is written with
  # their fields; names of shipped plans remain.
  tree_of <- function(text) {
    tryCatch(
      with_included_plans(plan_of_bytes(charToRaw(enc2utf8(text)), "plan"), NULL),
      error = function(e) NULL
    )
  }
  old <- tree_of(source)
  if (is.null(old)) return(anew)
  if (identical(old, plan)) return(source)
  for (deepest in c(Inf, 1)) {
    text <- tryCatch(edit_fields(source, old, plan, deepest), codend_unplaced = function(e) NULL)
    if (is.null(text)) next
    if (identical(tree_of(text), plan)) return(text)
  }
  anew
}

# deepest: a change below this depth replaces the enclosing field.
edit_fields <- function(source, old, plan, deepest) {
  places <- plan_places(source)
  if (!isTRUE(attr(places, "whole"))) unplaced()
  changes <- plan_changes(old, plan, deepest)
  edits <- c(
    lapply(changes, function(change) change_edit(source, places, change)),
    lapply(replaced_sections(old, changes), remark_edit, source = source, places = places)
  )
  # Edit from the end, so that earlier positions remain valid.
  for (edit in edits[order(-vapply(edits, `[[`, 0, "from"))]) {
    source <- paste0(substr(source, 1L, edit$from - 1), edit$text,
      substring(source, edit$to + 1))
  }
  source
}

# Returns the differences of two trees: a list of list(path, parent, name, value, was). `value` is
# NULL for a removed field, `was` is NULL for a new one. `deepest`: as in `edit_fields()`.
plan_changes <- function(old, new, deepest = Inf, path = "", depth = 1) {
  out <- list()
  for (name in union(names(old), names(new))) {
    if (identical(old[[name]], new[[name]])) next
    at <- join(path, name)
    inside <- depth < deepest && is_map(old[[name]]) && is_map(new[[name]]) &&
      length(old[[name]]) && length(new[[name]])
    out <- c(out, if (inside) {
      plan_changes(old[[name]], new[[name]], deepest, at, depth + 1)
    } else {
      list(list(path = at, parent = path, name = name, value = new[[name]], was = old[[name]]))
    })
  }
  out
}

# Returns the paths of sections of which most fields are lists or maps that changed. Remarks on such
# a section describe its former content.
replaced_sections <- function(old, changes) {
  parents <- vapply(Filter(function(change) is.list(change$was), changes), `[[`, "", "parent")
  Filter(function(path) {
    nzchar(path) && sum(parents == path) > length(at_path(old, path_steps(path))) / 2
  }, unique(parents))
}

# Removes the remark on the line of a section's name.
remark_edit <- function(path, source, places) {
  from <- places$key[match(path, places$path)]
  line <- sub("\n.*", "", substring(source, from))
  remark <- regexpr("(?<=:) +#.*$", line, perl = TRUE)
  end <- from + nchar(line) - 1
  list(from = if (remark > 0) from + remark - 1 else end + 1, to = end, text = "")
}

# Returns list(from, to, text): the characters that a change replaces; to < from inserts.
change_edit <- function(source, places, change) {
  k <- match(change$path, places$path)
  if (is.null(change$was)) return(added_edit(source, places, change))
  if (is.na(k) || is.na(places$from[k])) unplaced()
  if (is.null(change$value)) return(removed_edit(source, places, k))
  line <- yaml_inline(change$value)
  indent <- places$column[k] - 1L
  whole <- places$to[k]
  if (places$flow[k]) return(list(from = places$from[k], to = whole, text = line))
  was_line <- !grepl("\n", substr(source, places$from[k], whole), fixed = TRUE)
  flat <- !is.na(yaml_flow(change$value))
  if (was_line && flat) return(aligned_edit(source, places$from[k], whole, line))
  begin <- regexpr(":", substring(source, places$key[k]), fixed = TRUE)[1] + places$key[k]
  text <- if (flat) paste0(" ", line) else {
    paste0("\n", paste(yaml_lines(change$value, indent + 2L), collapse = "\n"))
  }
  list(from = begin, to = whole, text = text)
}

# Replaces a value on a line. A remark after it stays in its column if there is room.
aligned_edit <- function(source, from, to, text) {
  rest <- sub("\n.*", "", substring(source, to + 1))
  blanks <- attr(regexpr("^ +(?=#)", rest, perl = TRUE), "match.length")
  if (blanks > 0) {
    room <- max(1L, blanks - (nchar(text) - (to - from + 1L)))
    text <- paste0(text, strrep(" ", room))
    to <- to + blanks
  }
  list(from = from, to = to, text = text)
}

removed_edit <- function(source, places, k) {
  from <- places$key[k]
  to <- places$to[k]
  before <- substr(source, 1L, from - 1)
  after <- substring(source, to + 1)
  if (places$flow[k]) {
    comma <- attr(regexpr("^[ \n]*,[ \n]*", after), "match.length")
    if (comma > 0) return(list(from = from, to = to + comma, text = ""))
    ahead <- attr(regexpr(",[ \n]*$", before), "match.length")
    return(list(from = from - max(ahead, 0), to = to, text = ""))
  }
  if (!grepl("(^|\n) *$", before)) unplaced()
  list(
    from = from - (places$column[k] - 1L), to = to + nchar(sub("\n.*", "", after)) +
      grepl("\n", after, fixed = TRUE),
    text = ""
  )
}

# A new field follows the other fields of its map.
added_edit <- function(source, places, change) {
  name <- yaml_text(change$name)
  root <- !nzchar(change$parent)
  p <- match(change$parent, places$path)
  if (!root && is.na(p)) unplaced()
  if (!root && substr(source, places$from[p], places$from[p]) == "{") {
    end <- places$to[p]
    inside <- substr(source, places$from[p] + 1, end - 1)
    comma <- if (grepl("[^ \n]", inside) && !grepl(",[ \n]*$", inside)) ", " else ""
    blanks <- attr(regexpr("[ ]+$", inside), "match.length")
    at <- end - max(blanks, 0)
    return(list(from = at, to = end - 1,
      text = paste0(comma, name, ": ", yaml_inline(change$value))))
  }
  children <- which(sub("[.]?[^.]*$", "", places$path) == change$parent)
  if (!length(children) || any(places$flow[children])) unplaced()
  indent <- places$column[children[1]] - 1L
  field <- stats::setNames(list(change$value), change$name)
  lines <- paste0(paste(yaml_lines(field, indent), collapse = "\n"), "\n")
  last <- max(c(places$to[children], places$key[children]), na.rm = TRUE)
  end <- regexpr("\n", substring(source, last), fixed = TRUE)[1]
  if (end == -1L) {
    return(list(from = nchar(source) + 1, to = nchar(source), text = paste0("\n", lines)))
  }
  list(from = last + end, to = last + end - 1, text = lines)
}

yaml_inline <- function(value) {
  if (!is.list(value) && length(value) > 1L) value <- as.list(value)
  if (!is.list(value) || !length(value)) return(yaml_flow(value))
  items <- vapply(value, yaml_inline, "")
  if (is.null(names(value))) return(paste0("[", paste(items, collapse = ", "), "]"))
  paste0("{", paste0(vapply(names(value), yaml_text, ""), ": ", items, collapse = ", "), "}")
}
