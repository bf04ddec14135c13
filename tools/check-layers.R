# Checks that R functions call only functions of their own layer or of lower layers:
#
#   Rscript tools/check-layers.R
#
# The first word of a file name is its layer. tools/layers.csv lists the layers from the lowest to
# the highest. The check reads the sources, so codend need not be installed. Failures:
#
# - A file has no layer.
#
# - A function calls a function of a higher layer, or layers call each other in a cycle.
#
# - More than 5 files all reach each other.
#
# - A name is defined twice.
#
# A call is any use of a name that the package defines. This includes default values, list elements
# and functions passed as values. It also includes names in braces of a string that cli fills in,
# and quoted names in do.call(), match.fun() and similar functions.
#
# R calls the methods of its generics, so they may be in any layer.

# Largest number of files that may all reach each other.
most_knotted <- 5L

# Position of the argument that is a function or its name.
looks_up <- c(
  do.call = 1, match.fun = 1, get = 1, get0 = 1, Map = 1, Filter = 1, Reduce = 1, mapply = 1,
  lapply = 2, sapply = 2, vapply = 2
)

# Returns names of functions in the strings of an expression.
names_in_texts <- function(e) {
  if (is.character(e)) return(unlist(lapply(e, names_in_braces)))
  if (!is.call(e) && !is.list(e) && !is.pairlist(e)) return(NULL)
  at <- if (is.call(e) && is.name(e[[1]])) unname(looks_up[as.character(e[[1]])]) else NA
  named <- if (!is.na(at) && length(e) > at) Filter(is.character, as.list(e)[at + 1])
  c(unlist(named), unlist(lapply(as.list(e), function(part) {
    if (!missing(part)) names_in_texts(part)
  })))
}

# Returns the functions that a string such as "{.arg file} is {show_value(file)}" calls.
names_in_braces <- function(text) {
  braces <- regmatches(text, gregexpr("\\{[^.{}?][^{}]*\\}", text))[[1]]
  code <- tryCatch(parse(text = braces, keep.source = FALSE), error = function(e) NULL)
  unlist(lapply(as.list(code), function(e) {
    codetools::findGlobals(as.function(list(e)), merge = FALSE)$functions
  }))
}

# Returns a list for each expression of a file: name (defined name or ""), file, uses (used names).
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

# Returns the sets of nodes that reach each other and themselves, largest first. edges: data frame
# with two columns of names.
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
layer <- stats::setNames(sub("[-.].*$", "", files), files)
height <- stats::setNames(seq_along(layers$layer), layers$layer)

found <- unlist(lapply(files, read_expressions), recursive = FALSE)
name <- vapply(found, `[[`, "", "name")
file <- vapply(found, `[[`, "", "file")
defined <- name[nzchar(name)]
home <- stats::setNames(file[nzchar(name)], defined)

calls <- do.call(rbind, lapply(found, function(one) {
  # `$` is left out: nearly all functions use the package's own `$`.
  to <- setdiff(intersect(one$uses, defined), c(one$name, "$"))
  if (length(to) == 0) return(NULL)
  data.frame(from = one$name, to = to, from_file = one$file, to_file = unname(home[to]))
}))
calls <- unique(calls)
calls$from_layer <- unname(layer[calls$from_file])
calls$to_layer <- unname(layer[calls$to_file])
between <- calls[calls$from_layer != calls$to_layer, ]
up <- between[which(height[between$from_layer] < height[between$to_layer]), ]

lost <- files[!layer %in% layers$layer]
twice <- unique(defined[duplicated(defined)])
rings <- cycles(unique(unname(layer)), unique(between[c("from_layer", "to_layer")]))
rings <- rings[lengths(rings) > 1]
between_files <- unique(calls[calls$from_file != calls$to_file, c("from_file", "to_file")])
knots <- cycles(files, between_files)

cat(sprintf("%d files in %d layers, %d names\n", length(files), length(unique(layer)),
  length(defined)))
cat(sprintf("%d calls between functions, %d between layers, %d upwards\n", nrow(calls),
  nrow(between), nrow(up)))
cat(sprintf("%d layers in cycles, %d files in the largest knot\n", sum(lengths(rings)),
  max(0L, lengths(knots))))

wrong <- c(
  sprintf("R/%s: tools/layers.csv has no layer `%s`", lost, layer[lost]),
  sprintf("R/%s: %s() calls %s() of R/%s, which is in a higher layer", up$from_file, up$from, up$to,
    up$to_file),
  vapply(rings, function(ring) paste("layers call each other:", paste(ring, collapse = ", ")), ""),
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
