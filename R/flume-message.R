# Messages of the flume tank as JSON and bytes.

# Returns a message as JSON with its type.
message_json <- function(type, message) {
  to_json(stats::setNames(list(message), type), digits = I(15))
}

to_json <- function(x, digits) {
  as.character(jsonlite::toJSON(
    x, auto_unbox = TRUE, digits = digits, null = "null", na = "null", json_verbatim = TRUE
  ))
}

# Returns the bytes of a binary message: the length of its header (4 bytes, little-endian), the
# header as JSON, then `bytes`, which start at a multiple of 4.
with_header <- function(header, bytes) {
  text <- charToRaw(enc2utf8(to_json(header, digits = I(7))))
  text <- c(text, rep(charToRaw(" "), -length(text) %% 4L))
  c(writeBin(length(text), raw(), size = 4L, endian = "little"), text, bytes)
}

# Returns the numbers of arrays in single precision, little-endian.
single_bytes <- function(arrays) {
  writeBin(unlist(arrays, use.names = FALSE), raw(), size = 4L, endian = "little")
}
