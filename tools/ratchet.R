# Stored results that may not get worse. A script tests/ratchets/NAME.R sources this file, computes
# a table and ends with ratchet(), which compares the table with tests/ratchets/NAME.csv.
#   Rscript tests/ratchets/NAME.R           compares; the status is 1 if a value got worse
#   Rscript tests/ratchets/NAME.R --accept  stores the table; `make ratchet` runs all scripts so

# How a column is compared. A value may exceed (lower) or fall short of (higher) the stored value by
# `relative` times the stored value plus `absolute`.
lower <- function(relative = 0, absolute = 0) {
  c(sign = 1, relative = relative, absolute = absolute)
}
higher <- function(relative = 0, absolute = 0) {
  c(sign = -1, relative = relative, absolute = absolute)
}

# Compares `now`, a data frame, with the CSV file `file`, and quits R with the status.
#
# key: names of the columns that identify a row.
#
# columns: named list of lower() and higher().
#
# summarise: a function applied to both tables before the comparison, for example to compute totals.
ratchet <- function(now, file, key, columns, summarise = identity,
                    accept = "--accept" %in% commandArgs(TRUE)) {
  if (accept) {
    utils::write.csv(now, file, row.names = FALSE)
    cat("Stored", file, "\n")
    quit(status = 0L)
  }
  was <- if (file.exists(file)) utils::read.csv(file) else now[0L, ]
  rows <- compare_tables(summarise(was), summarise(now), key, columns)
  reported <- rows[rows$result != "equal", ]
  cat(sprintf("%s: %s of %s was %s, is %s (limit %s)\n", reported$result, reported$column,
    reported$row, shown(reported$was), shown(reported$now), shown(reported$limit)), sep = "")
  if (any(rows$result == "better")) cat("Run `make ratchet` and commit the better values.\n")
  worse <- sum(rows$result == "WORSE")
  if (worse) {
    cat("To accept worse values, run `make ratchet` and give the reason in the commit message.\n")
  }
  cat(sprintf("%d passed, %d failed, 0 skipped\n", nrow(rows) - worse, worse))
  quit(status = as.integer(worse > 0L))
}

# Returns a data frame with a row for each key and compared column. Columns: row, column, was, now,
# limit, result.
#
# result is "equal" (within the limit), "better" (by more than the limit) or "WORSE". A
# value that only one table has is WORSE.
compare_tables <- function(was, now, key, columns) {
  row_names <- function(table) do.call(paste, unname(as.list(table[key])))
  rows <- union(row_names(now), row_names(was))
  values <- function(table, column) as.numeric(table[[column]])[match(rows, row_names(table))]
  do.call(rbind, lapply(names(columns), function(column) {
    how <- columns[[column]]
    old <- values(was, column)
    new <- values(now, column)
    loss <- how[["sign"]] * (new - old)
    allowed <- how[["relative"]] * abs(old) + how[["absolute"]]
    worse <- is.na(old) != is.na(new) | (!is.na(loss) & loss > allowed)
    better <- !is.na(loss) & loss < -allowed
    data.frame(row = rows, column = column, was = old, now = new,
      limit = old + how[["sign"]] * allowed,
      result = ifelse(worse, "WORSE", ifelse(better, "better", "equal")))
  }))
}

shown <- function(values) {
  vapply(values, function(value) if (is.na(value)) "absent" else format(value, digits = 6), "")
}
