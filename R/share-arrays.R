# Named arrays as one string for a shared page, and the numbers of a gear as such arrays.

# Returns the arrays of a nested list by path, as the engine reads them. An unnamed list becomes its
# length, of class "groups", followed by its arrays.
flat_arrays <- function(x, prefix = "") {
  out <- list()
  for (name in names(x)) {
    value <- x[[name]]
    path <- paste0(prefix, name)
    if (is.null(value)) next
    if (!is.list(value)) {
      out[[path]] <- as.vector(value)
    } else if (is.null(names(value))) {
      out[[path]] <- structure(length(value), class = "groups")
      for (k in seq_along(value)) out <- c(out, flat_arrays(value[[k]], paste0(path, ".", k, ".")))
    } else {
      out <- c(out, flat_arrays(value, paste0(path, ".")))
    }
  }
  out
}

# Returns list(head, body). `head` lists for each array: type (d: double, f: single, i: integer, w:
# strings, g: groups), count, first byte, distinct strings. `body` is from deflated(). Integers and
# strings are stored as differences.
packed_arrays <- function(arrays) {
  head <- bodies <- list()
  at <- 0
  for (name in names(arrays)) {
    x <- arrays[[name]]
    if (inherits(x, "groups")) {
      head[[name]] <- list("g", as.integer(unclass(x)))
      next
    }
    type <- array_type(x)
    levels <- if (type == "w") unique(x)
    numbers <- switch(type,
      w = diff(c(0L, match(x, levels) - 1L)), i = diff(c(0L, as.integer(x))), as.double(x)
    )
    head[[name]] <- c(list(type, length(x), at), if (type == "w") list(I(levels)))
    size <- if (type == "d") 8L else 4L
    bodies[[name]] <- writeBin(numbers, raw(), size = size, endian = "little")
    at <- at + length(bodies[[name]])
  }
  list(head = head, body = deflated(do.call(c, c(list(raw()), unname(bodies)))))
}

array_type <- function(x) {
  if (is.character(x)) return("w")
  if (inherits(x, "single_floats")) return("f")
  if (is.double(x)) "d" else "i"
}

# Marks numbers for storage in single precision.
single_floats <- function(x) structure(as.double(x), class = "single_floats")

# Rounds each number to this many bits.
few_figures <- function(x, bits) {
  step <- 2^(floor(log2(pmax(abs(x), 1e-99))) + 1 - bits)
  round(x / step) * step
}

deflated <- function(bytes) jsonlite::base64_enc(memCompress(bytes, "gzip"))

# Returns the numbers for the engine of a page (`numbers.` and path), and the numbers for pictures
# and warnings (`page/` and name). `standard`: kinds of the measures that every gear has.
shared_arrays <- function(si, netting, standard) {
  parts <- part_table(si)
  asked <- c(si$measures, lapply(standard, function(kind) list(kind = kind)))
  numbers <- numbers_to_settle(si, netting, asked)
  strength <- rep(0, nrow(parts))
  strength[seq_along(si$ropes)] <-
    vapply(si$ropes, function(rope) as.double(first_of(rope$strength, 0)), 0)
  strength[is.na(strength)] <- 0
  c(flat_arrays(numbers, "numbers."), list(
    "page/speed" = as.double(si$towing$speed), "page/size" = part_sizes(si, list(parts = parts)),
    "page/strength" = strength,
    "page/stall" = vapply(si$otter_boards, stall_angle, 0, USE.NAMES = FALSE)
  ))
}
