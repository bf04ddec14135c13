# Numbers as strings with four digits, and columns of strings.

# Returns numbers without scientific notation, with the digits that their errors allow, at most six.
# Numbers without a known error have four digits. All have at most four decimals.
figures <- function(x, error = NA) {
  exponent <- function(x) ifelse(is.na(x) | x == 0, 0, floor(log10(abs(x))))
  known <- is.finite(error) & error > 0
  last <- pmax(exponent(x) - ifelse(known, 5, 3), ifelse(known, error_exponent(error), -4), -4)
  # Adding 0 changes -0 to 0.
  text <- format_each(round(x / 10^last) * 10^last + 0, pmax(-last, 0))
  text[!is.na(x) & abs(x) < 5e-5] <- "0"
  text[is.na(x)] <- ""
  text
}

# Returns the power of ten of the last digit of an error with one digit, or two if the first is 1.
error_exponent <- function(error) {
  size <- floor(log10(pmax(error, 1e-300)))
  ifelse(error < 2 * 10^size, size - 1, size)
}

# Returns discretisation errors rounded up to one digit, or two digits if the first digit is 1; ""
# for NA. The text is "computed to 0.6", because readers take a plus-minus sign for the whole
# uncertainty (JCGM 100:2008, 7.2.2).
error_text <- function(error) {
  known <- is.finite(error)
  text <- rep("", length(error))
  unit <- 10^error_exponent(error[known])
  up <- pmax(ceiling(error[known] / unit * (1 - 1e-9)) * unit, 1e-4)
  decimals <- pmin(pmax(-round(log10(unit)), 0), 4)
  text[known] <- format_each(up, decimals)
  text[known & error == 0] <- ""
  text
}

format_each <- function(x, decimals) {
  as.character(mapply(formatC, x, digits = decimals,
    MoreArgs = list(format = "f", decimal.mark = ".")))
}

# Returns at most `n` lines. The last one counts omitted lines.
limited_lines <- function(lines, n) {
  omitted <- length(lines) - (n - 1)
  if (omitted <= 1) return(lines)
  c(utils::head(lines, n - 1), sprintf("  ... and %d more: print(x, n = Inf)", omitted))
}

# Returns ends of intervals to two digits of their standard uncertainty.
interval_ends <- function(x, uncertainty) {
  decimals <- pmin(ifelse(uncertainty > 0, 1 - floor(log10(uncertainty)), 3), 6)
  format_each(round(x, decimals), pmax(0, decimals))
}

# Returns the percentages of a total with one decimal; "" without a total.
share_text <- function(x, total) {
  if (total == 0) rep("", length(x)) else formatC(100 * x / total, format = "f", digits = 1)
}

# Returns numbers to two digits of their errors, and numbers without an error to four digits.
sure_digits <- function(x, error) {
  known <- is.finite(error) & error > 0
  text <- with_plain_numbers(vapply(signif(x, 4), format, ""))
  if (any(known)) text[known] <- interval_ends(x[known], error[known])
  text
}

# The largest number of the column determines the decimals that give it four digits.
column_figures <- function(x) {
  size <- max(abs(x), 0, na.rm = TRUE)
  decimals <- if (size == 0) 0 else min(max(3 - floor(log10(size)), 0), 4)
  text <- formatC(x, format = "f", digits = decimals, decimal.mark = ".")
  text[!is.na(x) & abs(x) < 0.5 * 10^-decimals] <- "0"
  text[is.na(x)] <- ""
  align_points(text)
}

# Pads numbers so that their decimal points are aligned.
align_points <- function(text) {
  decimals <- nchar(sub("^[^.]*", "", text))
  paste0(text, strrep(" ", max(decimals, 0L) - decimals))
}

# Returns the lines of a table. Columns in `left` are aligned left, others right.
align_columns <- function(columns, left = 1L) {
  cells <- lapply(seq_along(columns), function(k) {
    format(columns[[k]], justify = if (k %in% left) "left" else "right")
  })
  sub(" +$", "", paste0("  ", do.call(paste, c(cells, sep = "  "))))
}

cat_columns <- function(columns, left = 1L) {
  cat(paste0(align_columns(columns, left), "\n"), sep = "")
}

# Rounds x up to 1, 2 or 5 times a power of ten.
round_step <- function(x) {
  power <- 10^floor(log10(x))
  power * c(1, 2, 5, 10)[which(c(1, 2, 5, 10) * power >= x * (1 - 1e-9))[1]]
}

# Labels of groups of sources of uncertainty.
group_words <- c(
  coefficients = "coefficients", plan = "plan", conditions = "conditions",
  mesh = "discretisation", model = "model"
)

# Returns the contribution of each group to each measure's variance [%]: measures x groups.
group_percent <- function(table) {
  variance <- as.matrix(table[names(group_words)])^2
  100 * variance / pmax(rowSums(variance), .Machine$double.xmin)
}
