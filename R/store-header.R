# Checks the header of a NetCDF file (classic format, 64-bit offsets) before the NetCDF library
# opens it, because the library allocates as much memory as a forged header requests. Layout:
# "NetCDF Classic and 64-bit Offset File Formats" (Unidata), limited to the types that codend
# writes.

# Upper limits: bytes of a header, and entries of each list in it.
most_header_bytes <- 2^24
most_header_entries <- 1000L

# Bytes per value for the types that codend writes: characters, integers, doubles.
header_widths <- c("2" = 1, "4" = 4, "6" = 8)

# Stops by wrong(why) unless all variables lie within the file. `cut`: TRUE if the last records may
# be missing. Returns the number of complete records.
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
    if (is.na(value) || value < 0L || value > most) wrong("its header has an invalid number")
    value
  }
  text <- function(n) take(4 * ceiling(n / 4))
  name <- function() text(whole())
  # reads a list: its tag and length (both 0 if empty), then its entries
  entries <- function(mark, one) {
    found <- whole()
    n <- whole(most_header_entries)
    if (found != mark && (found != 0L || n != 0L)) wrong("its header was not written by codend")
    lapply(seq_len(n), function(k) one())
  }
  width <- function() {
    type <- header_widths[as.character(whole())]
    if (is.na(type)) wrong("it has numbers of an unknown type")
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
  short <- "it is shorter than its header requires"
  if (any(begin[!growing] + bytes[!growing] > size)) wrong(short)
  if (!any(growing)) return(0)
  # records are padded to 4 bytes, except at the end of the file
  of_record <- sum(4 * ceiling(bytes[growing] / 4))
  there <- min(records, floor((size - begin - bytes)[growing] / of_record + 1))
  if (there < records && !cut) wrong(short)
  max(0, there)
}
