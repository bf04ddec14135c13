# The header of a NetCDF file in the classic format with 64-bit offsets, read before the NetCDF
# library sees it: the library allocates whatever a forged header asks for. The layout is that of
# the "NetCDF Classic and 64-bit Offset File Formats" specification (Unidata), of which codend
# writes a part.

# More than any file of codend's has: bytes of a header, and entries of one of its lists.
most_header_bytes <- 2^24
most_header_entries <- 1000L

# Bytes of a value of each type that codend writes: characters, integers, doubles.
header_widths <- c("2" = 1, "4" = 4, "6" = 8)

# Stops by wrong(why) unless every count of a file's header and every variable lies within the file.
# cut: whether its last records may be missing. Returns how many of the records are there.
whole_records <- function(file, cut, wrong) {
  size <- file_size(file)
  bytes <- readBin(file, "raw", min(size, most_header_bytes))
  at <- 0
  take <- function(n) {
    if (at + n > length(bytes)) wrong("its header does not end")
    at <<- at + n
    bytes[at - n + seq_len(n)]
  }
  whole <- function(most = Inf) {
    value <- readBin(take(4L), "integer", endian = "big")
    if (is.na(value) || value < 0L || value > most) wrong("its header holds a wrong number")
    value
  }
  text <- function(n) take(4 * ceiling(n / 4))
  name <- function() text(whole())
  # a list of a header: its mark and its length, both 0 where there is none
  entries <- function(mark, one) {
    found <- whole()
    n <- whole(most_header_entries)
    if (found != mark && (found != 0L || n != 0L)) wrong("its header is none of codend's")
    lapply(seq_len(n), function(k) one())
  }
  width <- function() {
    type <- header_widths[as.character(whole())]
    if (is.na(type)) wrong("it holds numbers of an unknown type")
    type[[1]]
  }
  attribute <- function() {
    name()
    text(width() * whole())
  }
  take(4L)
  records <- whole()
  lengths <- unlist(entries(10L, function() {
    name()
    whole()
  }))
  entries(12L, attribute)
  variables <- entries(11L, function() {
    name()
    across <- vapply(seq_len(whole(8L)), function(k) whole(length(lengths) - 1), 0L)
    entries(12L, attribute)
    width <- width()
    whole()
    offset <- sum(readBin(take(8L), "integer", 8L, size = 1L, signed = FALSE) * 256^(7:0))
    length <- lengths[across + 1L]
    growing <- length(length) > 0L && length[1L] == 0L
    if (growing) length <- length[-1L]
    c(offset = offset, bytes = width * prod(length), growing = growing)
  })
  variables <- vapply(variables, identity, c(offset = 0, bytes = 0, growing = 0))
  growing <- variables["growing", ] > 0
  begin <- variables["offset", ]
  bytes <- variables["bytes", ]
  short <- "it is shorter than what it says to hold"
  if (any(begin[!growing] + bytes[!growing] > size)) wrong(short)
  if (!any(growing)) return(0)
  # a file is padded to whole words, but for its end
  of_record <- sum(4 * ceiling(bytes[growing] / 4))
  there <- min(records, floor((size - begin - bytes)[growing] / of_record + 1))
  if (there < records && !cut) wrong(short)
  max(0, there)
}
