# Entry point of `make robust`: counts how often settle() converges. Argument: number of variations
# (500). Writes to bench/results/: robust.csv (a row per run), robust.md, and in robust-failed/ the
# plan of each gear that did not settle.
library(codend)
for (script in c("own-process", "results", "variations")) {
  source(file.path("bench", paste0(script, ".R")))
}

nodes <- 1500
limit <- 120  # CPU seconds of one settle()
given <- commandArgs(TRUE)
count <- if (length(given)) as.integer(given[1]) else 500L
failed_folder <- file.path(results_folder, "robust-failed")
unlink(failed_folder, recursive = TRUE)
dir.create(failed_folder, recursive = TRUE)

# Returns one run as a row, with its state in `state` if it settled.
try_settling <- function(name, gear, netting) {
  settle_once <- function() {
    setTimeLimit(cpu = limit, transient = TRUE)
    on.exit(setTimeLimit())
    settle(gear, nodes, netting)
  }
  seconds <- cpu(found <- tryCatch(settle_once(), error = identity))
  settled <- inherits(found, "codend_state")
  report <- found$report
  row <- list(
    run = name, netting = netting, settled = settled, cpu = seconds,
    iterations = if (is.null(report)) NA else report$iterations,
    residual = if (is.null(report)) NA else report$residual,
    class = class(found)[1L],
    said = if (settled) "" else gsub("[[:space:]]+", " ", conditionMessage(found))
  )
  if (!settled) write_gear(gear, file.path(failed_folder, paste0(gsub(" ", "-", name), ".yaml")))
  cat(sprintf("%-16s %-10s %s %5.1f CPU s %s\n", name, netting,
    if (settled) "settled" else "FAILED ", seconds, substr(row$said, 1, 120)))
  list(row = row, state = if (settled) found)
}

rows <- lapply(seq_len(count), function(number) {
  variation <- vary_trawl(number)
  try_settling(paste("variation", number), variation$gear, variation$netting)$row
})

for (netting in c("bars", "cells")) {
  found <- try_settling(paste("stiff ropes", netting), stiffen_ropes(), netting)
  rows <- c(rows, list(found$row))
}

# Tangled starts: every node of the crude layout is displaced by 10 m (standard deviation) in each
# direction. Coarser levels are omitted because they would remove most of the tangle.
trawl <- read_gear("midwater_trawl")
si <- codend:::gear_si(trawl)
crude <- codend:::build_mesh(si, nodes, "bars")
settle_numbers <- codend:::settle_numbers
answer <- as.vector(settle(trawl, nodes, "bars")$position)
for (number in seq_len(min(30L, count))) {
  set.seed(number, kind = "Mersenne-Twister", normal.kind = "Inversion")
  tangle <- crude$start + stats::rnorm(length(crude$start), sd = 10)
  utils::assignInNamespace("settle_numbers", function(si, nodes, netting, ...) {
    settle_numbers(si, nodes, netting, list(mesh = crude, position = tangle), FALSE)
  }, "codend")
  found <- try_settling(paste("tangle", number), trawl, "bars")
  if (!is.null(found$state)) {
    moved <- matrix(as.vector(found$state$position) - answer, 3L)
    found$row$apart <- max(sqrt(colSums(moved^2)))
  }
  rows <- c(rows, list(found$row))
}

runs <- bind_rows(rows)
save_table(runs, "robust")
kind <- sub(" [^ ]*$", "", runs$run)
outcomes <- bind_rows(lapply(unique(kind), function(name) {
  of <- runs[kind == name, ]
  list(
    runs = name, number = nrow(of), settled = sum(of$settled),
    `settled, %` = 100 * mean(of$settled),
    `steps, median` = stats::median(of$iterations, na.rm = TRUE),
    `steps, most` = max(of$iterations, na.rm = TRUE), `CPU s, median` = stats::median(of$cpu),
    `CPU s, most` = max(of$cpu), `farthest apart, m` = max(c(-Inf, of$apart), na.rm = TRUE)
  )
}))
names(outcomes) <- c("runs", "number", "settled", "settled, %", "steps, median", "steps, most",
  "CPU s, median", "CPU s, most", "farthest apart, m")
outcomes$`farthest apart, m`[!is.finite(outcomes$`farthest apart, m`)] <- NA
failed <- runs[!runs$settled, ]
failed <- failed[order(-failed$residual), ]
save_page(c(
  "# Whether settling finds the balance", "",
  paste("Written by `make robust`; [what is tried](../README.md).", measured_with()), "",
  markdown_table(outcomes), "",
  if (nrow(failed)) {
    c("What did not settle, the worst first:", "", sprintf("- %s (%s): %s", failed$run,
      failed$netting, failed$said))
  }
), "robust")
cat(readLines(file.path(results_folder, "robust.md")), sep = "\n")
