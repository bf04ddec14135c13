# Prints of tables that fit a screen: headers have one word per line, and the last line counts the
# omitted rows and columns.

# Largest number of rows and of measures of a print by default, which then has at most 30 lines.
most_rows <- 20
most_measures <- 9L

# Returns numbers with the digits that the median error of the column allows. The largest number has
# at most four digits.
certain_figures <- function(x, error = NULL) {
  known <- error[is.finite(error) & error > 0]
  last <- 3 * 10^(floor(log10(max(abs(x), 1e-4, na.rm = TRUE))) - 3)
  text <- align_points(figures(x, max(last, if (length(known)) stats::median(known))))
  text[is.na(x)] <- "-"
  text
}

# Returns a column of `cat_headed()`: words of the header below each other, the unit, and cells. The
# last word is the kind of a measure, such as "spread".
headed <- function(words, unit, cells) {
  words <- gsub("[._]", " ", words)
  list(head = c(strwrap(words, max(9L, nchar(cells)) + 1L), unit), cells = cells,
    kind = sub(".* ", "", words))
}

# Prints columns of `headed()` under their headers, with the first `fixed` columns on the left. The
# columns beyond the width are left out, or follow in further blocks if `all`. Returns the number
# of printed columns without the fixed ones.
cat_headed <- function(columns, fixed, all = FALSE) {
  left <- columns[seq_len(fixed)]
  right <- columns[-seq_len(fixed)]
  room <- getOption("width") - 2 - sum(printed_widths(left))
  if (!all) right <- right[fitting_columns(right, room)]
  block <- column_blocks(printed_widths(right), room)
  for (one in seq_len(max(block, 1L))) {
    if (one > 1L) cat("\n")
    shown <- c(left, right[block == one])
    depth <- max(lengths(lapply(shown, `[[`, "head")))
    cat_columns(lapply(shown, function(column) {
      c(rep("", depth - length(column$head)), column$head, column$cells)
    }), seq_len(fixed))
  }
  length(right)
}

printed_widths <- function(columns) {
  vapply(columns, function(column) 2 + max(nchar(c(column$head, column$cells))), 0)
}

# Returns the columns that fit into `room`, at least one. Drag comes first, then a column of each
# kind.
fitting_columns <- function(columns, room) {
  kind <- vapply(columns, `[[`, "", "kind")
  order <- order(kind != "drag", duplicated(kind))
  used <- cumsum(printed_widths(columns)[order])
  sort(order[used <= max(room, used[1L])])
}

# Returns the block of each column. A block is filled up to `room` and has at least one column.
column_blocks <- function(widths, room) {
  block <- 1L
  used <- 0
  out <- integer(length(widths))
  for (k in seq_along(widths)) {
    if (used > 0 && used + widths[k] > room) {
      block <- block + 1L
      used <- 0
    }
    used <- used + widths[k]
    out[k] <- block
  }
  out
}

# Prints a line with the numbers of omitted rows and columns, such as c(design = 3, measure = 28).
cat_more <- function(counts, how = "print(x, n = Inf)") {
  counts <- counts[counts > 0]
  if (!length(counts)) return(invisible())
  names <- paste0(names(counts), ifelse(counts == 1, "", "s"))
  cat("  ... and ", paste(counts, "more", names, collapse = " and "), ": ", how, "\n", sep = "")
}

# Prints a sentence on at most `most` lines.
cat_wrapped <- function(..., indent = 2L, most = 3L) {
  lines <- strwrap(paste0(...), getOption("width"), indent = indent, exdent = indent + 2L)
  if (length(lines) > most) lines <- c(lines[seq_len(most - 1L)], paste0(lines[most], " ..."))
  cat(lines, sep = "\n")
}

# Prints at most `n` rows of columns.
cat_rows <- function(columns, left, n, kind) {
  cat_columns(lapply(columns, utils::head, n), left)
  cat_more(setNames(length(columns[[1L]]) - n, kind))
}

check_rows <- function(n) {
  if (!(is.numeric(n) && length(n) == 1L && !is.na(n) && n >= 1)) {
    abort_argument("{.arg n} is {.val {n}}; it must be a number of rows, or Inf for everything.")
  }
}

# Returns a table with the argument `row.names` as names of its rows. `what`: TRUE if the argument
# `what` chooses the table, because users give its value first by mistake.
with_row_names <- function(table, rows, what = FALSE) {
  if (is.null(rows)) return(table)
  if (length(rows) != nrow(table)) {
    hint <- if (what && is_text(rows)) " Name the table: {.code what = \"{rows}\"}."
    abort_argument(paste0("{.arg row.names} has the length {length(rows)}; it must have one name per
      row, {nrow(table)}.", hint))
  }
  row.names(table) <- rows
  table
}
