# make errors: whether the errors that are told of measures hold. 30 variations of five shipped
# gears are settled, and again with 8 times the nodes; the difference is taken for the true error.
# Argument: nodes (1500; `make errors NODES=1000`). Writes to bench/results/: errors.csv, a row per
# measure; errors.md. Rows of other nodes stay.
library(codend)
for (room in c("sizes", "results")) source(file.path("bench", paste0(room, ".R")))

given <- commandArgs(TRUE)
nodes <- if (length(given)) as.numeric(given[1]) else 1500
finer <- 8

# Each by six factors of what drives it.
factors <- c(0.7, 0.8, 0.9, 1, 1.1, 1.2)
varied <- list(
  midwater_trawl = "towing.speed", poly_noreastern_trawl = "towing.speed",
  pair_trawl = "towing.speed", cage = "water.current.speed", gillnet = "water.current.speed"
)

one <- function(name, factor) {
  gear <- read_gear(name)
  path <- strsplit(varied[[name]], ".", fixed = TRUE)[[1]]
  value <- gear$plan[[path]]
  if (is.character(value)) {
    parts <- strsplit(value, " ", fixed = TRUE)[[1]]
    value <- paste(factor * as.numeric(parts[1]), parts[2])
  } else {
    value <- factor * value
  }
  gear <- do.call(update, c(list(gear), setNames(list(value), varied[[name]])))
  settled <- tryCatch(
    suppressWarnings(list(settle(gear, nodes), settle(gear, finer * nodes))),
    codend_error_not_converged = function(e) NULL
  )
  if (is.null(settled)) {
    cat(name, factor, "did not settle\n")
    return(NULL)
  }
  told <- as.data.frame(settled[[1]], what = "measures")
  told$fine <- as.double(measures(settled[[2]]))[match(told$measure, names(measures(settled[[2]])))]
  cat(name, factor, sum(abs(told$value - told$fine) <= 2 * told$error, na.rm = TRUE), "of",
    sum(is.finite(told$error)), "\n")
  cbind(nodes = nodes, gear = name, factor = factor, told)
}

rows <- do.call(rbind, unlist(lapply(names(varied), function(name) {
  lapply(factors, one, name = name)
}), recursive = FALSE))
rows <- rows[is.finite(rows$error) & is.finite(rows$fine), ]
rows$true <- abs(rows$value - rows$fine)
rows$within <- rows$true <= 2 * rows$error
kept <- file.path(results_folder, "errors.csv")
kept <- if (file.exists(kept)) utils::read.csv(kept)
rows <- rbind(kept[kept$nodes != nodes, ], rows)
save_table(rows, "errors")
of <- function(rows, name) {
  share <- function(x) stats::median(100 * x / abs(rows$fine), na.rm = TRUE)
  list(
    nodes = rows$nodes[1], gear = name, measures = nrow(rows),
    `within twice the error, %` = 100 * mean(rows$within),
    `told error, median %` = share(rows$error), `true error, median %` = share(rows$true)
  )
}
table <- bind_rows(unlist(lapply(sort(unique(rows$nodes)), function(n) {
  some <- rows[rows$nodes == n, ]
  c(
    lapply(unique(some$gear), function(name) of(some[some$gear == name, ], name)),
    list(of(some, "all"))
  )
}), recursive = FALSE))
names(table) <- c("nodes", "gear", "measures", "within twice the error, %", "told error, median %",
  "true error, median %")
save_page(c(
  "# Whether the errors of measures hold", "",
  paste0("Written by `make errors` and `make errors NODES=1000`: so many nodes against ", finer,
    " times as many. ", measured_with()), "",
  markdown_table(table)
), "errors")
cat(readLines(file.path(results_folder, "errors.md")), sep = "\n")
