# Fields are read by their whole name. R's own `$` takes a field whose name only begins with what is
# asked for, such as `towing` for `tow` where a plan has no `tow`.

# `$` of all of codend's code.
#
# x: a list, an environment or NULL; name: of a field. Returns the field, NULL where there is none.
# What has a class is read as its `[[` does, a data frame as the list that it is.
`$` <- function(x, name) {
  if (is.object(x) || is.environment(x)) {
    if (inherits(x, "data.frame")) return(.subset2(x, substitute(name)))
    return(x[[as.character(substitute(name))]])
  }
  .subset2(x, substitute(name))
}

# What a script finds by `$` in a gear: as it is, but that each list of fields is read exactly too.
exact_fields <- function(value) {
  if (is.list(value) && !is.object(value)) class(value) <- "codend_fields"
  value
}

# The plain lists that exact_fields() was given, at all depths.
plain_fields <- function(value) {
  if (!is.list(value) || (is.object(value) && !inherits(value, "codend_fields"))) return(value)
  value <- unclass(value)
  value[] <- lapply(value, plain_fields)
  value
}

# R would put these methods to the `$` above
#' @rawNamespace S3method(base::"$",codend_fields)
`$.codend_fields` <- function(x, name) exact_fields(.subset2(x, name))

#' @export
`[[.codend_fields` <- function(x, i, ...) exact_fields(unclass(x)[[i]])

#' @export
`[.codend_fields` <- function(x, i) exact_fields(unclass(x)[i])

#' @export
print.codend_fields <- function(x, ...) {
  print(plain_fields(x), ...)
  invisible(x)
}

#' @rawNamespace S3method(base::"$",codend_gear)
`$.codend_gear` <- `$.codend_fields`

#' @export
`$<-.codend_gear` <- function(x, name, value) { # nolint: object_name_linter.
  x <- unclass(x)
  x[[name]] <- plain_fields(value)
  structure(x, class = "codend_gear")
}
