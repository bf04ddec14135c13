# Numbers as the viewer's script reads them: text of base64 of little-endian bytes.

packed <- function(numbers, size) {
  text <- jsonlite::base64_enc(writeBin(as.vector(numbers), raw(), size = size, endian = "little"))
  gsub("[\r\n]", "", text)
}

packed_floats <- function(x) packed(as.double(x), 4L)
packed_integers <- function(x) packed(as.integer(x), 4L)

# Whole numbers (n x times) whose lowest 16 bits are wanted, deflated: differences in time of the
# order-th order, each number's series after the other, low bytes before high ones. What moves
# smoothly takes half a byte a number so.
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

# Places (3 x n x times, m). Of one time single floats; of more whole steps from each number's
# least, of `step` (m) or what leaves at most 65535 of them.
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

# Values (n x times), negative ones pushing. Of more than one time the root of their share of the
# largest, with sign, in 4095 steps: small ones are told to as many figures as large ones need. No
# value but 0 becomes 0; -32768 stands for NA.
packed_values <- function(x, times) {
  if (times == 1L) return(list(floats = packed_floats(x)))
  if (!length(x)) return(list(floats = ""))
  top <- max(abs(x), 0, na.rm = TRUE)
  root <- if (top > 0) sqrt(abs(x) / top) else x
  share <- sign(x) * pmax(round(4095 * root), x != 0)
  share[is.na(share)] <- -32768
  list(top = top, steps = packed_series(matrix(share, ncol = times), 1L))
}
