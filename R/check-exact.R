# Fields are read by their full name. Base R's `$` also matches partially: it returns `towing` for
# `tow` if a plan has no `tow`.

# Replaces `$` within the package.
#
# x: a list, an environment or NULL; name: name of a field. Returns the field, or NULL if absent. An
# object with a class uses its `[[` method; a data frame is read as a list.
`$` <- function(x, name) {
  if (is.object(x) || is.environment(x)) {
    if (inherits(x, "data.frame")) return(.subset2(x, substitute(name)))
    return(x[[as.character(substitute(name))]])
  }
  .subset2(x, substitute(name))
}

# Marks a plain list so that scripts also read its fields by their full name, at every depth.
exact_fields <- function(value) {
  if (is.list(value) && !is.object(value)) class(value) <- "codend_fields"
  value
}

# Removes the class that `exact_fields()` added, at every depth.
plain_fields <- function(value) {
  if (!is.list(value) || (is.object(value) && !inherits(value, "codend_fields"))) return(value)
  value <- unclass(value)
  value[] <- lapply(value, plain_fields)
  value
}

# `@export` would register these methods for the package's own `$`, not for `base::"$"`.
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
