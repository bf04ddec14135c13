# One process: times a change of a settled gear, from update() to measures(), and a solve from
# scratch. Arguments: library of codend ("" for R's own), nodes, file.
given <- commandArgs(TRUE)
library(codend, lib.loc = if (nzchar(given[1])) given[1])
source("bench/own-process.R")
source("bench/scaled.R")
nodes <- as.numeric(given[2])
repeats <- 5

# Fields of shipped gears to change by 1 and by 10 %, as in this folder's plans; also no change.
fields <- list(
  midwater_trawl = c("towing.speed", "warps.length", "otter_boards.mass"),
  cage = "water.current.speed"
)
if (nodes > 2000) fields <- fields[1]

# Median time of several runs. Short runs are repeated because the clock is coarse.
seconds <- function(work) {
  times <- if (cpu(work()) < 0.1) 5 else 1
  stats::median(replicate(repeats, cpu(for (k in seq_len(times)) work()) / times))
}

rows <- list()
for (name in names(fields)) {
  gear <- read_gear(file.path("inst", "gears", paste0(name, ".yaml")))
  state <- suppressWarnings(settle(gear, nodes))
  for (field in c("none", fields[[name]])) for (percent in if (field == "none") 0 else c(1, 10)) {
    change <- function() if (percent == 0) gear else scaled(gear, field, 1 + percent / 100)
    found <- suppressWarnings(settle(change(), nodes, from = state))
    rows[[length(rows) + 1L]] <- data.frame(
      gear = name, nodes = ncol(state$position), field = field, percent = percent,
      steps = found$report$iterations, factorisations = found$report$factorisations,
      cpu = seconds(function() suppressWarnings(measures(settle(change(), nodes, from = state))))
    )
  }
}
jsonlite::write_json(do.call(rbind, rows), given[3], digits = NA)
