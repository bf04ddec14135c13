# make errors: whether the errors that are reported of measures hold. All shipped gears and some
# drawn at random are settled with several numbers of nodes, and with many more; the difference is
# taken for the true error. Arguments, by name: gears=20 of random ones, seed=1001 of the first of
# them, nodes=300,500,1500,4000, finest=12000. Writes to bench/results/: errors.csv, a row per
# measure; errors.md.
library(codend)
for (room in c("sizes", "results", "forge")) {
  source(file.path("bench", paste0(room, ".R")))
}

asked <- list(gears = 20, seed = 1001, nodes = c(300, 500, 1500, 4000), finest = 12000)
for (one in strsplit(commandArgs(TRUE), "=", fixed = TRUE)) {
  stopifnot(length(one) == 2L, one[1L] %in% names(asked))
  asked[[one[1L]]] <- as.numeric(strsplit(one[2L], ",", fixed = TRUE)[[1L]])
}
limit <- 60  # CPU seconds of one settle()

settled <- function(gear, nodes) {
  setTimeLimit(cpu = limit, transient = TRUE)
  on.exit(setTimeLimit())
  tryCatch(suppressWarnings(settle(gear, nodes)), error = function(e) NULL)
}

# Rows of one gear, or NULL where it does not settle finely.
of_gear <- function(name, gear) {
  finest <- settled(gear, asked$finest)
  if (is.null(finest)) {
    cat(name, "did not settle\n")
    return(NULL)
  }
  fine <- measures(finest)
  rows <- lapply(asked$nodes, function(nodes) {
    state <- settled(gear, nodes)
    if (is.null(state)) return(NULL)
    found <- as.data.frame(state, what = "measures")
    found$kind <- unname(attr(measures(state), "kind"))
    found$fine <- as.double(fine)[match(found$measure, names(fine))]
    cbind(gear = name, asked = nodes, nodes = state$lattice$nodes, found)
  })
  rows <- do.call(rbind, rows)
  within <- abs(rows$value - rows$fine) <= 2 * rows$error
  cat(name, sum(within, na.rm = TRUE), "of", nrow(rows), "\n")
  rows
}

shipped <- sub("[.]yaml$", "", list.files(system.file("gears", package = "codend"), "yaml$"))
rows <- lapply(shipped, function(name) of_gear(name, read_gear(name)))
for (number in asked$seed - 1 + seq_len(asked$gears)) {
  rows <- c(rows, list(of_gear(paste("drawn", number), forge_gear(number))))
}
rows <- do.call(rbind, rows)
rows$true <- abs(rows$value - rows$fine)
# what finer lattices do not change at all is exact, not estimated well
rows$exact <- rows$true <= 1e-7 * pmax(abs(rows$value), abs(rows$fine))
rows$within <- rows$true <= 2 * rows$error | rows$exact
save_table(rows, "errors")

summed <- function(rows) {
  moving <- which(!rows$exact & is.finite(rows$error))
  list(
    measures = nrow(rows), `without an error` = sum(is.na(rows$error)),
    `within twice the estimate, %` = 100 * mean(rows$within, na.rm = TRUE),
    `estimate over truth, median` = stats::median((rows$error / rows$true)[moving]),
    `truth over 5 estimates, %` = 100 * mean((rows$true > 5 * rows$error)[moving]),
    `true error, median %` = stats::median((100 * rows$true / abs(rows$fine))[moving])
  )
}
by <- function(rows, of) {
  table <- bind_rows(lapply(split(rows, rows[[of]]), function(some) {
    c(stats::setNames(list(as.character(some[[of]][1L])), of), summed(some))
  }))
  # names as they are
  names(table) <- c(of, names(summed(rows)))
  table
}
usual <- rows[rows$asked == 1500, ]
save_page(c(
  "# Whether the errors of measures hold", "",
  sprintf(
    paste("Written by `make errors`: %d gears, among them %d drawn at random (from seed %d), with",
      "%s nodes against %s. %s"),
    length(unique(rows$gear)), sum(startsWith(unique(rows$gear), "drawn")), asked$seed,
    paste(asked$nodes, collapse = ", "), asked$finest, measured_with()), "",
  markdown_table(by(rows, "asked")), "", "With 1,500 nodes, by gear:", "",
  markdown_table(by(usual, "gear")), "", "and by kind of measure:", "",
  markdown_table(by(usual, "kind"))
), "errors")
cat(readLines(file.path(results_folder, "errors.md")), sep = "\n")
