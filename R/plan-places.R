# Where each field of a plan stands in the text of its file, so that errors name line and column and
# a change leaves the remarks around it alone. The YAML that people write: maps and lists in block
# and in flow form, and scalars; what an alias stands for has no place of its own. Where a text has
# tags or complex keys its places end.

# Longer texts are not gone through: it takes time, and no plan that people write is as long.
placed_characters_limit <- 3e5

# The places of a text's fields, or NULL where they cannot be told: a list of equal lengths
#   path     steps joined by ".", items of lists by their number
#   key      first character of the key (of an item: of its dash, or of its value within [ ])
#   from, to first and last character of the value; NA where it is empty
#   flow     whether it stands within { } or [ ]
#   line, column  of the key
plan_places <- function(text) {
  if (!length(text) || nchar(text) > placed_characters_limit) return(NULL)
  scanner <- new_scanner(text)
  done <- tryCatch(
    {
      scanner$skip()
      if (!scanner$ended()) scanner$block(scanner$column(), "")
      scanner$skip()
      scanner$ended()
    },
    codend_unplaced = function(e) FALSE
  )
  places <- scanner$places()
  attr(places, "whole") <- done
  places
}

# Ends the search for places, or what needs them.
unplaced <- function() {
  stop(structure(class = c("codend_unplaced", "error", "condition"),
    list(message = "unplaced", call = NULL)))
}

# A scanner of a text: list of the functions that plan_places() goes by. What has been found before
# it stops stays found.
new_scanner <- function(text) {
  ch <- strsplit(text, "", fixed = TRUE)[[1]]
  n <- length(ch)
  starts <- c(1L, which(ch == "\n") + 1L)
  at <- 1L
  found <- list()
  here <- function(k = 0L) if (at + k <= n) ch[at + k] else ""
  ended <- function() at > n
  column <- function(place = at) place - starts[findInterval(place, starts)] + 1L
  blank <- function(x) x == " " || x == "\n" || x == "\r" || x == ""
  comment_here <- function() {
    here() == "#" && (at == 1L || blank(ch[at - 1L]) || ch[at - 1L] == "\t")
  }
  to_line_end <- function() while (!ended() && ch[at] != "\n") at <<- at + 1L
  # Past blanks and remarks; within one line where asked.
  skip <- function(one_line = FALSE) {
    while (!ended()) {
      if (comment_here()) {
        to_line_end()
      } else if (ch[at] == " " || ch[at] == "\r" || ch[at] == "\t") {
        at <<- at + 1L
      } else if (ch[at] == "\n" && !one_line) {
        at <<- at + 1L
      } else if (at == 1L && ch[1] == "\ufeff") {
        at <<- 2L
      } else if (column() == 1L && here() == "-" && here(1L) == "-" && here(2L) == "-") {
        to_line_end()
      } else {
        break
      }
    }
  }
  note <- function(path, key, from, to, flow) {
    found[[length(found) + 1L]] <<- list(path = path, key = key, from = from, to = to, flow = flow)
  }
  # Reserves the place of a field before what it holds, so that places keep the order of the text.
  open <- function(path, key, flow) {
    note(path, key, NA_integer_, NA_integer_, flow)
    length(found)
  }
  close <- function(k, from, to) {
    found[[k]]$from <<- from
    found[[k]]$to <<- to
  }
  quoted <- function() {
    mark <- here()
    at <<- at + 1L
    repeat {
      if (ended()) unplaced()
      if (mark == "\"" && here() == "\\") {
        at <<- at + 2L
      } else if (here() == mark) {
        if (mark == "'" && here(1L) == "'") {
          at <<- at + 2L
        } else {
          break
        }
      } else {
        at <<- at + 1L
      }
    }
    at <<- at + 1L
  }
  # A key up to its colon; the name it gives.
  key_text <- function(stops) {
    from <- at
    if (here() %in% c("\"", "'")) {
      quoted()
      name <- paste(ch[seq(from, at - 1L)], collapse = "")
      name <- tryCatch(yaml::yaml.load(name), error = function(e) name)
      while (here() == " ") at <<- at + 1L
    } else {
      if (here() %in% c("&", "*", "!", "?", "%", "@", "`")) unplaced()
      while (!ended() && !(here() == ":" && (blank(here(1L)) || here(1L) %in% stops))) {
        if (here() == "\n" || here() %in% stops) unplaced()
        at <<- at + 1L
      }
      name <- trimws(paste(ch[seq(from, max(from, at - 1L))], collapse = ""))
    }
    if (here() != ":") unplaced()
    at <<- at + 1L
    as.character(name)
  }
  # Past an anchor before a value; whether there was one.
  past_anchor <- function() {
    if (here() != "&") return(FALSE)
    while (!blank(here())) at <<- at + 1L
    TRUE
  }
  join_step <- function(path, step) join(path, as.character(step))
  # Whether a key of a block map begins here.
  key_here <- function() {
    was <- at
    held <- tryCatch({
      key_text(character())
      TRUE
    }, codend_unplaced = function(e) FALSE)
    line <- findInterval(c(was, at), starts)
    at <<- was
    held && line[1] == line[2]
  }
  flow <- function(path) {
    if (here() == "{") return(flow_map(path))
    if (here() == "[") return(flow_list(path))
    from <- at
    if (here() %in% c("\"", "'")) {
      quoted()
      return(c(from, at - 1L))
    }
    if (here() %in% c("&", "!")) unplaced()
    last <- from - 1L
    while (!ended() && !here() %in% c(",", "]", "}", "[", "{") && !comment_here() &&
      !(here() == ":" && (blank(here(1L)) || here(1L) %in% c(",", "}", "]")))) {
      if (!blank(here())) last <- at
      at <<- at + 1L
    }
    if (here() %in% c(":", "[", "{")) unplaced()
    if (last < from) c(NA_integer_, NA_integer_) else c(from, last)
  }
  flow_map <- function(path) {
    from <- at
    at <<- at + 1L
    repeat {
      skip()
      if (ended()) unplaced()
      if (here() == "}") break
      if (here() == ",") {
        at <<- at + 1L
        next
      }
      key <- at
      name <- key_text(c(",", "}", "]", "{", "["))
      one <- join_step(path, name)
      k <- open(one, key, TRUE)
      skip()
      range <- if (here() %in% c(",", "}")) c(NA_integer_, NA_integer_) else flow(one)
      close(k, range[1], range[2])
    }
    at <<- at + 1L
    c(from, at - 1L)
  }
  flow_list <- function(path) {
    from <- at
    at <<- at + 1L
    item <- 0L
    repeat {
      skip()
      if (ended()) unplaced()
      if (here() == "]") break
      if (here() == ",") {
        at <<- at + 1L
        next
      }
      item <- item + 1L
      one <- join_step(path, item)
      k <- open(one, at, TRUE)
      range <- flow(one)
      close(k, range[1], range[2])
    }
    at <<- at + 1L
    c(from, at - 1L)
  }
  # A plain or a folded scalar; above: the column that its further lines must lie right of.
  scalar <- function(above) {
    from <- at
    if (here() == "!") unplaced()
    folded <- here() %in% c("|", ">")
    last <- at
    repeat {
      while (!ended() && here() != "\n" && !(!folded && comment_here())) {
        if (!blank(here())) last <- at
        at <<- at + 1L
      }
      if (!folded && comment_here()) break
      was <- at
      while (!ended() && blank(here())) at <<- at + 1L
      if (ended() || column() <= above || (!folded && here() == "#")) {
        at <<- was
        break
      }
    }
    c(from, last)
  }
  # The value that begins here at a column; above: that of the map or list that it stands in.
  block <- function(col, path, above = 0L) {
    # the column is where the scanner stands now, not where it will
    force(col)
    if (here() %in% c("{", "[")) return(flow(path))
    if (here() == "-" && blank(here(1L))) return(block_list(col, path))
    if (!here() %in% c("|", ">") && key_here()) return(block_map(col, path))
    if (here() %in% c("\"", "'")) {
      from <- at
      quoted()
      return(c(from, at - 1L))
    }
    scalar(above)
  }
  block_map <- function(col, path) {
    from <- at
    to <- at
    repeat {
      key <- at
      name <- key_text(character())
      to <- at - 1L
      one <- join_step(path, name)
      k <- open(one, key, FALSE)
      range <- value(col, one, listed = TRUE)
      close(k, range[1], range[2])
      if (!is.na(range[2])) to <- range[2]
      skip()
      if (ended() || column() < col) break
      if (column() > col) unplaced()
    }
    c(from, to)
  }
  block_list <- function(col, path) {
    from <- at
    to <- at
    item <- 0L
    repeat {
      item <- item + 1L
      key <- at
      at <<- at + 1L
      one <- join_step(path, item)
      k <- open(one, key, FALSE)
      range <- value(col, one, listed = FALSE)
      close(k, range[1], range[2])
      if (!is.na(range[2])) to <- range[2]
      skip()
      if (ended() || column() < col || !(here() == "-" && blank(here(1L)))) break
      if (column() > col) unplaced()
    }
    c(from, to)
  }
  # What follows a key's colon or an item's dash. listed: whether a list may stand at that column.
  value <- function(col, path, listed) {
    skip(one_line = TRUE)
    if (past_anchor()) skip(one_line = TRUE)
    on_line <- !ended() && here() != "\n"
    if (on_line) {
      if (!listed) return(block(column(), path, col))
      if (here() %in% c("{", "[")) return(flow(path))
      if (here() %in% c("\"", "'")) {
        from <- at
        quoted()
        return(c(from, at - 1L))
      }
      return(scalar(col))
    }
    was <- at
    skip()
    inside <- !ended() && (column() > col ||
      (listed && column() == col && here() == "-" && blank(here(1L))))
    if (!inside) {
      at <<- was
      return(c(NA_integer_, NA_integer_))
    }
    block(column(), path, col)
  }
  places <- function() {
    pick <- function(field, as) vapply(found, `[[`, as, field)
    key <- as.integer(pick("key", 0L))
    line <- findInterval(key, starts)
    list(
      path = pick("path", ""), key = key, from = pick("from", 0L), to = pick("to", 0L),
      flow = pick("flow", NA), line = line, column = key - starts[line] + 1L
    )
  }
  list(skip = skip, ended = ended, column = column, block = block, places = places)
}

# Line and column of the field at a path, of the nearest one around it where it is missing; NULL
# where that cannot be told.
field_place <- function(text, path) {
  if (is.null(path) || !is_text(path)) return(NULL)
  places <- plan_places(text)
  path <- gsub("\\[([0-9]+)\\]", ".\\1", path)
  repeat {
    k <- match(path, places$path)
    if (!is.na(k)) return(list(line = places$line[k], column = places$column[k]))
    if (!grepl(".", path, fixed = TRUE)) return(NULL)
    path <- sub("[.][^.]*$", "", path)
  }
}

# The first key that a map of a text has twice: list(path, line, column, first = line of the first),
# or NULL.
doubled_key <- function(text) {
  places <- plan_places(text)
  k <- which(duplicated(places$path))[1]
  if (is.na(k)) return(NULL)
  list(
    path = places$path[k], line = places$line[k], column = places$column[k],
    first = places$line[match(places$path[k], places$path)]
  )
}
