# Numbers in the form that the viewer's script reads: little-endian bytes as base64 text.

packed <- function(numbers, size) {
  text <- jsonlite::base64_enc(writeBin(as.vector(numbers), raw(), size = size, endian = "little"))
  gsub("[\r\n]", "", text)
}

packed_floats <- function(x) packed(as.double(x), 4L)
packed_integers <- function(x) packed(as.integer(x), 4L)

# Packs the lowest 16 bits of whole numbers (n x times), compressed. It stores differences in time
# of the given order, the series of each number in sequence, low bytes before high bytes. Smooth
# motion takes half a byte per number.
packed_series <- function(x, order) {
  n <- nrow(x)
  for (k in seq_len(order)) {
    x <- cbind(x[, 1L], x[, -1L, drop = FALSE] - x[, -ncol(x), drop = FALSE])
  }
  x <- as.vector(t(x)) %% 65536
  bytes <- as.raw(c(x %% 256, x %/% 256))
  text <- jsonlite::base64_enc(memCompress(bytes, "gzip"))
  list(count = n, order = order, text = gsub("[\r\n]", "", text))
}

# Packs positions (3 x n x times, m). A single time is stored as single precision floats. Several
# times are stored as whole steps from the minimum of each number. A step is at least `step` (m),
# with at most 65535 steps.
packed_places <- function(x, times, step = 1e-3) {
  if (times == 1L) return(list(floats = packed_floats(x)))
  x <- matrix(x, ncol = times)
  if (!nrow(x)) return(list(floats = ""))
  low <- apply(x, 1L, min)
  size <- apply(x, 1L, max) - low
  step <- pmax(step, size / 65535)
  list(
    low = packed_floats(low), size = packed_floats(size), step = packed_floats(step),
    steps = packed_series(round((x - low) / step), 2L)
  )
}

# Packs values (n x times); negative values mean compression. A single time is stored as floats.
# Several times are stored as signed square roots relative to the maximum, in 4095 steps, so that
# small values keep enough digits. Only 0 is stored as 0; -32768 means NA.
packed_values <- function(x, times) {
  if (times == 1L) return(list(floats = packed_floats(x)))
  if (!length(x)) return(list(floats = ""))
  top <- max(abs(x), 0, na.rm = TRUE)
  root <- if (top > 0) sqrt(abs(x) / top) else x
  share <- sign(x) * pmax(round(4095 * root), x != 0)
  share[is.na(share)] <- -32768
  list(top = top, steps = packed_series(matrix(share, ncol = times), 1L))
}
