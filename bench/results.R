# Writes results atomically: tables for programs (CSV) and one page for readers (markdown).

results_folder <- file.path("bench", "results")

save_table <- function(table, name) {
  codend:::write_file(file.path(results_folder, paste0(name, ".csv")), function(path) {
    utils::write.csv(table, path, row.names = FALSE)
  })
}

save_page <- function(lines, name) {
  codend:::write_file(file.path(results_folder, paste0(name, ".md")), function(path) {
    writeLines(lines, path)
  })
}

# Returns a data frame as lines of a markdown table with its names as column heads.
markdown_table <- function(table) {
  row <- function(cells) paste0("| ", paste(cells, collapse = " | "), " |")
  is_number <- vapply(table, is.numeric, NA)
  cells <- table
  cells[] <- lapply(table, function(column) {
    if (is.numeric(column)) vapply(column, plain_number, "") else ifelse(is.na(column), "", column)
  })
  body <- vapply(seq_len(nrow(cells)), function(i) row(unlist(cells[i, ])), "")
  c(row(names(table)), row(ifelse(is_number, "---:", "---")), body)
}

# Three digits, without an exponent for readable sizes.
plain_number <- function(x) {
  if (is.na(x)) return("")
  if (x != 0 && abs(x) < 1e-4) return(format(x, digits = 2))
  if (x == round(x)) return(format(x, big.mark = ",", scientific = FALSE))
  format(signif(x, 3), big.mark = ",", scientific = FALSE, drop0trailing = TRUE)
}

plain_numbers <- function(x) vapply(x, plain_number, "")

# Returns the versions and machine of a measurement in one line.
measured_with <- function() {
  sprintf(
    "codend %s, %s, %d cores seen, %s.", utils::packageVersion("codend"), R.version.string,
    parallel::detectCores(), format(Sys.Date())
  )
}

# Returns one data frame from lists of single values that may have different names.
bind_rows <- function(rows) {
  columns <- unique(unlist(lapply(rows, names)))
  as.data.frame(
    stats::setNames(lapply(columns, function(column) {
      unlist(lapply(rows, function(row) if (is.null(row[[column]])) NA else row[[column]]))
    }), columns)
  )
}

# Returns `asked` with the numbers of the command line's arguments "name=1" or "name=1,2".
given_numbers <- function(asked) {
  for (one in strsplit(commandArgs(TRUE), "=", fixed = TRUE)) {
    stopifnot(length(one) == 2L, one[1L] %in% names(asked))
    asked[[one[1L]]] <- as.numeric(strsplit(one[2L], ",", fixed = TRUE)[[1L]])
  }
  asked
}
