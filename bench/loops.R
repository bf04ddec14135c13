# Entry point of `make bench-loops`: measures the cost of a change to a settled gear. Arguments:
# largest node count (1e4), then libraries of earlier codend versions as name=path. Writes loops.csv
# and loops.md to bench/results/.
library(codend)
for (script in c("own-process", "results")) source(file.path("bench", paste0(script, ".R")))

given <- commandArgs(TRUE)
sizes <- c(1500, 1e4)
sizes <- sizes[sizes <= if (length(given)) as.numeric(given[1]) else 1e4]
given <- given[-1]
libraries <- c(stats::setNames(sub("^[^=]*=", "", given), sub("=.*", "", given)), now = "")

rows <- NULL
for (nodes in sizes) {
  for (version in names(libraries)) {
    found <- in_own_process("measure-loops.R", shQuote(libraries[[version]]), nodes)
    if (is.null(found$gear)) stop(version, ": ", found$outcome)
    rows <- rbind(rows, cbind(version = version, asked = nodes, found))
  }
}
save_table(rows, "loops")

now <- rows[rows$version == "now", ]
# versions may mesh a gear differently
key <- function(rows) paste(rows$gear, rows$asked, rows$field, rows$percent)
columns <- lapply(names(libraries), function(version) {
  of <- rows[rows$version == version, ]
  of <- of[match(key(now), key(of)), ]
  stats::setNames(of[c("steps", "cpu")], paste0(c("steps, ", "CPU s, "), version))
})
table <- cbind(
  now[c("gear", "nodes", "field")], `change, %` = now$percent, do.call(cbind, columns)
)
save_page(c(
  "# What a change of a settled gear takes", "",
  paste("Written by `make bench-loops`; [what is measured](../README.md).", measured_with()), "",
  markdown_table(table)
), "loops")
cat(readLines(file.path(results_folder, "loops.md")), sep = "\n")
