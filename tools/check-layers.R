# Whether R functions use only what stands in their own room or below it:
#
#   Rscript tools/check-layers.R
#
# The first word of a file's name is its room; tools/layers.csv lists the rooms from the lowest up.
# The run fails on a file without a room, on a call to a higher room, on rooms that call each other
# in a cycle, on more than 5 files that all reach each other, and on a name that is defined twice.
# It reads the sources: nothing has to be installed.
#
# A call is any use of a name that the package defines: also as a default, in a list or handed over
# as a value, in braces of a text that cli fills in, and in quotes where do.call(), match.fun() and
# the like look a function up. Methods of R's generics are called by R and may stand in any room.

# How many files may all reach each other.
most_knotted <- 5L

# Which argument of these is a function or the name of one.
looks_up <- c(
  do.call = 1, match.fun = 1, get = 1, get0 = 1, Map = 1, Filter = 1, Reduce = 1, mapply = 1,
  lapply = 2, sapply = 2, vapply = 2
)

# Names that stand in the texts of an expression.
names_in_texts <- function(e) {
  if (is.character(e)) return(unlist(lapply(e, names_in_braces)))
  if (!is.call(e) && !is.list(e) && !is.pairlist(e)) return(NULL)
  at <- if (is.call(e) && is.name(e[[1]])) unname(looks_up[as.character(e[[1]])]) else NA
  named <- if (!is.na(at) && length(e) > at) Filter(is.character, as.list(e)[at + 1])
  c(unlist(named), unlist(lapply(as.list(e), function(part) {
    if (!missing(part)) names_in_texts(part)
  })))
}

# Functions that a text such as "{.arg file} is {show_value(file)}" calls.
names_in_braces <- function(text) {
  braces <- regmatches(text, gregexpr("\\{[^.{}?][^{}]*\\}", text))[[1]]
  code <- tryCatch(parse(text = braces, keep.source = FALSE), error = function(e) NULL)
  unlist(lapply(as.list(code), function(e) {
    codetools::findGlobals(as.function(list(e)), merge = FALSE)$functions
  }))
}

# What the expressions of a file define and use: list(name, "" where nothing; file; uses).
read_expressions <- function(file) {
  lapply(as.list(parse(file.path("R", file), keep.source = FALSE)), function(e) {
    assigns <- is.call(e) && is.name(e[[1]]) && as.character(e[[1]]) %in% c("<-", "=") &&
      is.name(e[[2]])
    value <- if (assigns) e[[3]] else e
    list(
      name = if (assigns) as.character(e[[2]]) else "", file = file,
      uses = unique(c(codetools::findGlobals(as.function(list(value))), names_in_texts(value)))
    )
  })
}

# The sets of nodes that reach each other and themselves, largest first; edges: two columns of
# names.
cycles <- function(nodes, edges) {
  reach <- matrix(FALSE, length(nodes), length(nodes), dimnames = list(nodes, nodes))
  reach[cbind(edges[[1]], edges[[2]])] <- TRUE
  for (k in nodes) reach <- reach | outer(reach[, k], reach[k, ])
  both <- reach & t(reach)
  knots <- unique(lapply(nodes[diag(both)], function(node) nodes[both[node, ]]))
  knots[order(-lengths(knots))]
}

layers <- utils::read.csv("tools/layers.csv")
files <- list.files("R", "[.]R$")
room <- stats::setNames(sub("[-.].*$", "", files), files)
height <- stats::setNames(seq_along(layers$room), layers$room)

found <- unlist(lapply(files, read_expressions), recursive = FALSE)
name <- vapply(found, `[[`, "", "name")
file <- vapply(found, `[[`, "", "file")
defined <- name[nzchar(name)]
home <- stats::setNames(file[nzchar(name)], defined)

calls <- do.call(rbind, lapply(found, function(one) {
  # every function reads fields, by the package's own `$`
  to <- setdiff(intersect(one$uses, defined), c(one$name, "$"))
  if (length(to) == 0) return(NULL)
  data.frame(from = one$name, to = to, from_file = one$file, to_file = unname(home[to]))
}))
calls <- unique(calls)
calls$from_room <- unname(room[calls$from_file])
calls$to_room <- unname(room[calls$to_file])
between <- calls[calls$from_room != calls$to_room, ]
up <- between[which(height[between$from_room] < height[between$to_room]), ]

lost <- files[!room %in% layers$room]
twice <- unique(defined[duplicated(defined)])
rings <- cycles(unique(unname(room)), unique(between[c("from_room", "to_room")]))
rings <- rings[lengths(rings) > 1]
between_files <- unique(calls[calls$from_file != calls$to_file, c("from_file", "to_file")])
knots <- cycles(files, between_files)

cat(sprintf("%d files in %d rooms, %d names\n", length(files), length(unique(room)),
  length(defined)))
cat(sprintf("%d calls between functions, %d between rooms, %d upwards\n", nrow(calls),
  nrow(between), nrow(up)))
cat(sprintf("%d rooms in cycles, %d files in the largest knot\n", sum(lengths(rings)),
  max(0L, lengths(knots))))

wrong <- c(
  sprintf("R/%s: tools/layers.csv has no room `%s`", lost, room[lost]),
  sprintf("R/%s: %s() calls %s() of R/%s, which is higher", up$from_file, up$from, up$to,
    up$to_file),
  vapply(rings, function(ring) paste("rooms call each other:", paste(ring, collapse = ", ")), ""),
  vapply(knots[lengths(knots) > most_knotted], function(knot) {
    paste("files reach each other:", toString(file.path("R", knot)))
  }, ""),
  vapply(twice, function(one) {
    sprintf("`%s` is defined twice: %s", one, toString(file.path("R", file[name == one])))
  }, "")
)
if (length(wrong)) {
  cat(wrong, sep = "\n")
  quit(status = 1)
}
