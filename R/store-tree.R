# Stores nested lists and vectors as plain data: structure as JSON, numbers exactly in two arrays.
# Only the classes and attributes in this file can be read; functions are never restored.

tree_attributes <- c("names", "dim", "dimnames", "row.names", "levels", "class")
tree_classes <- c("data.frame", "factor", "codend_mesh")

# Returns list(form = JSON string, numbers = doubles, integers).
flatten_tree <- function(tree) {
  numbers <- list()
  integers <- list()
  form_of <- function(x) {
    if (is.function(x)) return(list(kind = "function"))
    kind <- typeof(x)
    form <- list(kind = kind)
    held <- attributes(x)
    stopifnot(names(held) %in% tree_attributes, held$class %in% tree_classes)
    if (identical(names(held), "names")) {
      form$names <- strings_to_json(held$names)
    } else if (length(held)) {
      form$attributes <- form_of(held)
    }
    switch(kind,
      NULL = NULL,
      list = form$items <- lapply(unname(as.list(unclass(x))), form_of),
      character = form$text <- strings_to_json(as.vector(unclass(x))),
      double = {
        form$length <- length(x)
        numbers[[length(numbers) + 1L]] <<- as.vector(unclass(x))
      },
      integer = , logical = {
        form$length <- length(x)
        integers[[length(integers) + 1L]] <<- as.integer(unclass(x))
      },
      stop("files cannot store ", kind)
    )
    form
  }
  form <- form_of(tree)
  list(
    form = enc2utf8(as.character(jsonlite::toJSON(form, auto_unbox = TRUE, null = "null"))),
    numbers = as.double(unlist(numbers)), integers = as.integer(unlist(integers))
  )
}

# Converts strings to JSON and back; null represents a missing string.
strings_to_json <- function(words) lapply(enc2utf8(words), function(word) if (!is.na(word)) word)

strings_from_json <- function(form) {
  vapply(form, function(word) if (is.null(word)) NA_character_ else word, "")
}

# Rebuilds the list. `wrong`: function that stops with a message. Functions become a
# lost_function().
build_tree <- function(form, numbers, integers, wrong) {
  used <- c(numbers = 0, integers = 0)
  take <- function(from, of, length) {
    good <- is.numeric(length) && length(length) == 1L && length >= 0 && length == floor(length)
    if (!good || used[[of]] + length > length(from)) wrong("its arrays are too short")
    used[[of]] <<- used[[of]] + length
    from[used[[of]] - length + seq_len(length)]
  }
  value_of <- function(form) {
    if (!is.list(form) || !is_text(form$kind)) wrong("its form is unknown")
    attributes <- if (!is.null(form$attributes)) value_of(form$attributes)
    x <- switch(form$kind,
      NULL = NULL,
      list = lapply(form$items, value_of),
      character = strings_from_json(form$text),
      double = take(numbers, "numbers", form$length),
      integer = take(integers, "integers", form$length),
      logical = as.logical(take(integers, "integers", form$length)),
      `function` = lost_function(),
      wrong("its form is unknown")
    )
    if (!is.null(form$names)) names(x) <- strings_from_json(form$names)
    if (!is.null(attributes)) {
      known <- all(names(attributes) %in% tree_attributes) &&
        all(attributes$class %in% tree_classes)
      if (!known) wrong("its form is unknown")
      attributes(x) <- attributes
    }
    x
  }
  value <- value_of(jsonlite::fromJSON(form, simplifyVector = FALSE))
  if (any(used != c(length(numbers), length(integers)))) wrong("its arrays are too long")
  value
}
