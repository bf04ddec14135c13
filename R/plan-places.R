# Locates the fields of a plan in the text of its file, for line and column in errors and for edits
# that keep remarks. It supports common YAML: maps and lists in block and flow form, and scalars.
# The target of an alias has no position. The search ends at tags and complex keys.

# Longer texts are not scanned, to limit the run time. No plan written by hand is as long.
placed_characters_limit <- 3e5

# Returns the positions of a text's fields as a list of equal lengths, or NULL:
# `path`: steps joined by ".", list items by their number.
# `key`: first character of the key (for an item: its dash, or its value within [ ]).
# `from`, `to`: first and last character of the value; NA if it is empty.
# `flow`: TRUE within { } or [ ].
# `line`, `column`: of the key.
plan_places <- function(text) {
  if (!length(text) || nchar(text) > placed_characters_limit) return(NULL)
  scanner <- new_scanner(text)
  done <- tryCatch(
    {
      scanner$skip()
      if (!scanner$ended()) scanner$value("", 0L, nests = TRUE)
      scanner$skip()
      scanner$ended()
    },
    codend_unplaced = function(e) FALSE
  )
  places <- scanner$places()
  attr(places, "whole") <- done
  places
}

# Stops the scan or an edit that needs positions.
unplaced <- function() {
  stop(structure(class = c("codend_unplaced", "error", "condition"),
    list(message = "unplaced", call = NULL)))
}

# Tokens of the scanner: regular expressions that always match, with a lookbehind of one character.
# Keys end at a colon, a line end, or (in { } and [ ]) an invalid character.
plan_tokens <- list(
  line_blanks = "(?:[ \\t\\r]|(?<=\\s)#[^\\n]*+)*+",
  blanks = "(?:\\s|(?<=\\s)#[^\\n]*+|(?<=\\n)---[^\\n]*+|(?<=\\n)\ufeff)*+",
  quoted = "\"(?:[^\"\\\\]++|\\\\.)*+(?:\"|\\z)|'(?:[^']++|'')*+(?:'|\\z)",
  key = "[^\\n]*?(?=:(?:\\s|\\z)|\\n|\\z)",
  flow_key = "[^\\n,\\]}{\\[]*?(?=:(?:[\\s,\\]}{\\[]|\\z)|[\\n,\\]}{\\[]|\\z)",
  line = "(?:[^\\n#]|(?<!\\s)#)*+",
  folded_line = "[^\\n]*+",
  flow_text = "(?:[^,\\]}{\\[:#]|:(?![\\s,\\]}{\\[]|\\z)|(?<!\\s)#)*+"
)

# Returns the functions of a scanner for `plan_places()`. Positions found before a stop remain.
new_scanner <- function(text) {
  ch <- strsplit(text, "", fixed = TRUE)[[1]]
  n <- length(ch)
  starts <- c(1L, which(ch == "\n") + 1L)
  at <- 1L
  found <- list()
  none <- c(NA_integer_, NA_integer_)
  here <- function(k = 0L) if (at + k <= n) ch[at + k] else ""
  ended <- function() at > n
  column <- function() at - starts[findInterval(at, starts)] + 1L
  # Moves past a token. `window`: number of characters to match; it grows if the token fills it.
  take <- function(token, window = 400L) {
    to <- min(n, at + window)
    piece <- paste(c(if (at > 1L) ch[at - 1L] else "\n", if (!ended()) ch[at:to]), collapse = "")
    fit <- regexpr(paste0("(?s)\\A.\\K(?:", plan_tokens[[token]], ")"), piece, perl = TRUE)
    length <- attr(fit, "match.length")
    if (to < n && length > window - 4L) return(take(token, 8L * window))
    at <<- at + length
  }
  # Returns the range from a position to the scanner's, without trailing blanks.
  range_from <- function(from) {
    last <- at - 1L
    while (last >= from && grepl("\\s", ch[last])) last <- last - 1L
    if (last < from) none else c(from, last)
  }
  quoted <- function() {
    from <- at
    take("quoted")
    if (at - from < 2L || ch[at - 1L] != ch[from]) unplaced()
    c(from, at - 1L)
  }
  is_quoted <- function() here() %in% c("\"", "'")
  is_dash <- function() here() == "-" && grepl("^\\s?$", here(1L))
  # Moves past a key and its colon. Returns the name, or NULL without a key.
  key <- function(flow) {
    from <- at
    if (is_quoted()) {
      quoted()
      name <- paste(ch[seq(from, at - 1L)], collapse = "")
      name <- tryCatch(yaml::yaml.load(name), error = function(e) name)
      take("line_blanks")
    } else {
      if (here() %in% c("&", "*", "!", "?", "%", "@", "`")) return(NULL)
      take(if (flow) "flow_key" else "key")
      name <- trimws(paste(ch[seq_len(at - from) + from - 1L], collapse = ""))
    }
    if (here() != ":") return(NULL)
    at <<- at + 1L
    as.character(name)
  }
  # TRUE if a key of a block map starts here.
  is_key <- function() {
    was <- at
    held <- !is.null(tryCatch(key(FALSE), codend_unplaced = function(e) NULL))
    lines <- findInterval(c(was, at), starts)
    at <<- was
    held && lines[1] == lines[2]
  }
  # Records a field before its content, in text order. hold(): returns the range of the content.
  note <- function(path, key, flow, hold) {
    k <- length(found) + 1L
    found[[k]] <<- list(path = path, key = key, from = NA_integer_, to = NA_integer_, flow = flow)
    range <- hold()
    found[[k]][c("from", "to")] <<- as.list(range)
    range
  }
  # Returns the range of the value that starts here. `above`: continuation lines start right of this
  # column; `nests`: a block map or list may start here.
  value <- function(path, above, nests, flow = FALSE) {
    if (here() %in% c("{", "[")) return(flow_items(path))
    if (nests && is_dash()) return(block_items(path, listed = TRUE))
    if (nests && !here() %in% c("|", ">") && is_key()) return(block_items(path, listed = FALSE))
    if (is_quoted()) return(quoted())
    if (here() == "!" || (flow && here() == "&")) unplaced()
    from <- at
    if (flow) {
      take("flow_text")
      if (here() %in% c(":", "[", "{")) unplaced()
      return(range_from(from))
    }
    folded <- here() %in% c("|", ">")
    repeat {
      take(if (folded) "folded_line" else "line")
      range <- range_from(from)
      if (here() == "#") return(range)
      was <- at
      while (grepl("\\s", here())) at <<- at + 1L
      if (ended() || column() <= above || (!folded && here() == "#")) {
        at <<- was
        return(range)
      }
    }
  }
  flow_items <- function(path) {
    from <- at
    close <- if (here() == "{") "}" else "]"
    item <- 0L
    at <<- at + 1L
    repeat {
      take("blanks")
      if (ended()) unplaced()
      if (here() == close) break
      if (here() == ",") {
        at <<- at + 1L
        next
      }
      first <- at
      item <- item + 1L
      step <- if (close == "}") key(TRUE) else item
      if (is.null(step)) unplaced()
      one <- join(path, as.character(step))
      note(one, first, TRUE, function() {
        take("blanks")
        if (here() %in% c(",", close)) none else value(one, 0L, nests = FALSE, flow = TRUE)
      })
    }
    at <<- at + 1L
    c(from, at - 1L)
  }
  # listed: TRUE for a list (dashes), FALSE for a map.
  block_items <- function(path, listed) {
    from <- at
    column_of <- column()
    item <- 0L
    repeat {
      first <- at
      item <- item + 1L
      if (listed) at <<- at + 1L
      step <- if (listed) item else key(FALSE)
      if (is.null(step)) unplaced()
      to <- at - 1L
      one <- join(path, as.character(step))
      range <- note(one, first, FALSE, function() block_value(one, column_of, listed))
      if (!is.na(range[2])) to <- range[2]
      take("blanks")
      if (ended() || column() < column_of || (listed && !is_dash())) return(c(from, to))
      if (column() > column_of) unplaced()
    }
  }
  # Returns the range of the value after a key's colon or an item's dash, on the same line or below.
  block_value <- function(path, above, listed) {
    take("line_blanks")
    if (here() == "&") {
      while (!grepl("^\\s?$", here())) at <<- at + 1L
      take("line_blanks")
    }
    if (!here() %in% c("", "\n")) return(value(path, above, nests = listed))
    was <- at
    take("blanks")
    inside <- !ended() && (column() > above || (!listed && column() == above && is_dash()))
    if (inside) return(value(path, above, nests = TRUE))
    at <<- was
    none
  }
  places <- function() {
    pick <- function(field, as) vapply(found, `[[`, as, field)
    key <- pick("key", 0L)
    line <- findInterval(key, starts)
    list(
      path = pick("path", ""), key = key, from = pick("from", 0L), to = pick("to", 0L),
      flow = pick("flow", NA), line = line, column = key - starts[line] + 1L
    )
  }
  list(skip = function() take("blanks"), ended = ended, value = value, places = places)
}

# Returns line and column of a field or its nearest existing parent; NULL if unknown.
field_place <- function(text, path) {
  if (is.null(path) || !is_text(path)) return(NULL)
  places <- plan_places(text)
  path <- dotted_path(path)
  repeat {
    k <- match(path, places$path)
    if (!is.na(k)) return(list(line = places$line[k], column = places$column[k]))
    if (!grepl(".", path, fixed = TRUE)) return(NULL)
    path <- sub("[.][^.]*$", "", path)
  }
}

# Returns the first duplicate key: list(path, line, column, first = first line), or NULL.
doubled_key <- function(text) {
  places <- plan_places(text)
  k <- which(duplicated(places$path))[1]
  if (is.na(k)) return(NULL)
  list(
    path = places$path[k], line = places$line[k], column = places$column[k],
    first = places$line[match(places$path[k], places$path)]
  )
}
