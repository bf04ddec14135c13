# Checksum at the end of a file: the MD5 sum of all preceding bytes. It reveals truncated or changed
# files before any data are used. NetCDF readers ignore it.

seal_mark <- "codend md5 "
seal_bytes <- nchar(seal_mark) + 32L

seal_file <- function(file) {
  sum <- unname(tools::md5sum(file))
  connection <- base::file(file, "ab")
  tryCatch(writeBin(charToRaw(paste0(seal_mark, sum)), connection), finally = close(connection))
}

# Returns "good", "broken" or "none" (no checksum).
seal_of <- function(file) {
  size <- file.size(file)
  if (size < seal_bytes) return("none")
  connection <- base::file(file, "rb")
  on.exit(close(connection))
  seek(connection, size - seal_bytes)
  seal <- readBin(connection, "raw", seal_bytes)
  marked <- seq_len(nchar(seal_mark))
  if (!identical(seal[marked], charToRaw(seal_mark))) return("none")
  # md5sum() accepts only whole files
  before <- tempfile()
  on.exit(unlink(before), add = TRUE)
  copy <- base::file(before, "wb")
  seek(connection, 0)
  left <- size - seal_bytes
  while (left > 0) {
    block <- readBin(connection, "raw", min(left, 2^24))
    writeBin(block, copy)
    left <- left - length(block)
  }
  close(copy)
  sum <- charToRaw(unname(tools::md5sum(before)))
  if (identical(seal[-marked], sum)) "good" else "broken"
}
