# Numbers as text, to four figures, and columns of text.

# Numbers as text to four figures at most four decimals, never in powers of ten.
figures <- function(x) {
  size <- ifelse(is.na(x) | x == 0, 0, floor(log10(abs(x))))
  decimals <- pmin(pmax(3 - size, 0), 4)
  text <- mapply(formatC, signif(x, 4), digits = decimals,
    MoreArgs = list(format = "f", decimal.mark = "."))
  text[!is.na(x) & abs(x) < 5e-5] <- "0"
  text[is.na(x)] <- ""
  as.character(text)
}

plus_minus <- function() if (shows_unicode()) "\u00b1" else "+-"

# Errors as text: "\u00b1 0.6", rounded up to one figure, to two where it begins with 1; "" for NA.
error_text <- function(error) {
  known <- is.finite(error)
  text <- rep("", length(error))
  size <- floor(log10(pmax(error[known], 1e-300)))
  unit <- 10^ifelse(error[known] < 2 * 10^size, size - 1, size)
  up <- pmax(ceiling(error[known] / unit * (1 - 1e-9)) * unit, 1e-4)
  decimals <- pmin(pmax(-round(log10(unit)), 0), 4)
  text[known] <- paste(plus_minus(), format_each(up, decimals))
  text[known & error == 0] <- ""
  text
}

format_each <- function(x, decimals) {
  as.character(mapply(formatC, x, digits = decimals,
    MoreArgs = list(format = "f", decimal.mark = ".")))
}

# Ends of intervals to two figures of the standard uncertainty of each.
interval_ends <- function(x, uncertainty) {
  decimals <- ifelse(uncertainty > 0, pmax(0, 1 - floor(log10(uncertainty))), 3)
  format_each(x, decimals = pmin(decimals, 6))
}

# A column of numbers with as many decimals as its largest needs for four figures.
column_figures <- function(x) {
  size <- max(abs(x), 0, na.rm = TRUE)
  decimals <- if (size == 0) 0 else min(max(3 - floor(log10(size)), 0), 4)
  text <- formatC(x, format = "f", digits = decimals, decimal.mark = ".")
  text[!is.na(x) & abs(x) < 0.5 * 10^-decimals] <- "0"
  text[is.na(x)] <- ""
  align_points(text)
}

# Numbers as text, padded so that their decimal points stand below each other.
align_points <- function(text) {
  decimals <- nchar(sub("^[^.]*", "", text))
  paste0(text, strrep(" ", max(decimals) - decimals))
}

# Lines of a table: columns of text, the first aligned left and the others right unless `left`.
align_columns <- function(columns, left = 1L) {
  cells <- lapply(seq_along(columns), function(k) {
    format(columns[[k]], justify = if (k %in% left) "left" else "right")
  })
  sub(" +$", "", paste0("  ", do.call(paste, c(cells, sep = "  "))))
}
