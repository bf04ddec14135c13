# Entry point of `make random-gears`: counts how many random gears settle. Named arguments:
# count=300, seed=1 (of the first), nodes=, netting=, law=, kind= (each empty: random for random
# gears, otherwise the default; kind=rig: random rigs; kind=net: random nets). Writes to
# bench/results/:
# random-gears.csv (a row per gear), random-gears.md, and in random-gears-failed/ the plan of each
# gear that did not settle.
library(codend)
for (script in c("random-gears", "own-process", "sizes", "results")) {
  source(file.path("bench", paste0(script, ".R")))
}

# The tests settle a few of the random nets.
nets <- new.env(parent = asNamespace("codend"))
sys.source("tests/testthat/helper-net.R", nets)

asked <- list(count = "300", seed = "1", nodes = "", netting = "", law = "", kind = "")
for (one in strsplit(commandArgs(TRUE), "=", fixed = TRUE)) {
  stopifnot(one[1L] %in% names(asked))
  asked[[one[1L]]] <- c(one, "")[2L]
}
given <- function(name) if (nzchar(asked[[name]])) asked[[name]]
failed_folder <- file.path(results_folder, "random-gears-failed")
unlink(failed_folder, recursive = TRUE)
dir.create(failed_folder, recursive = TRUE)

of_number <- function(number) {
  is_rig <- asked$kind == "rig"
  gear <- switch(asked$kind, rig = random_rig(number), net = nets$random_net(number),
    random_gear(number, given("kind"), given("law")))
  nodes <- if (is.null(given("nodes"))) attr(gear, "nodes") else as.numeric(asked$nodes)
  netting <- if (is.null(given("netting"))) attr(gear, "netting") else asked$netting
  seconds <- cpu(found <- tryCatch(
    suppressWarnings(settle(gear, nodes, netting)), error = identity
  ))
  settled <- inherits(found, "codend_state")
  report <- found$report
  if (!settled) write_gear(gear, file.path(failed_folder, paste0(number, ".yaml")))
  kind <- c(if (is_rig) paste("rig:", attr(gear, "fault")), attr(gear, "drawn"), "net")[1L]
  whole <- function(value) if (is.null(value)) NA else value
  list(
    gear = number, kind = kind, name = gear$plan$name, nodes = whole(nodes),
    netting = whole(netting), settled = settled, steps = whole(report$iterations),
    residual = whole(report$residual), cpu = seconds,
    error = if (settled) "" else class(found)[1L],
    said = if (settled) "" else gsub("[[:space:]]+", " ", conditionMessage(found))
  )
}

rows <- bind_rows(lapply(as.numeric(asked$seed) - 1 + seq_len(as.integer(asked$count)), of_number))
save_table(rows, "random-gears")
of_kind <- function(name, rows) {
  steps <- rows$steps[rows$settled]
  part <- function(share) if (length(steps)) stats::quantile(steps, share, names = FALSE) else NA
  list(
    kind = name, gears = nrow(rows), `settled, %` = 100 * mean(rows$settled),
    `steps, median` = part(0.5), `steps, 99 of 100` = part(0.99), `steps, most` = part(1),
    `CPU s, mean` = mean(rows$cpu), `CPU s, most of one that failed` =
      max(c(0, rows$cpu[!rows$settled]))
  )
}
counts <- bind_rows(c(
  lapply(sort(unique(rows$kind)), function(kind) of_kind(kind, rows[rows$kind == kind, ])),
  list(of_kind("all", rows))
))
names(counts) <- names(of_kind("all", rows))
failed <- rows[!rows$settled, ]
save_page(c(
  "# Whether gears drawn at random settle", "",
  sprintf(
    "Written by `make random-gears`; [random gears](../README.md). Seeds from %s%s. %s",
    asked$seed, paste0(c("", if (nzchar(asked$nodes)) paste(asked$nodes, "nodes"),
      given("netting"), given("law"), given("kind")), collapse = ", "), measured_with()), "",
  markdown_table(counts), "",
  if (nrow(failed)) {
    c("What did not settle:", "", sprintf("- %s, %s, %s nodes, %s (`%s`): %s", failed$gear,
      failed$name, failed$nodes, failed$netting, failed$error, failed$said))
  }
), "random-gears")
cat(readLines(file.path(results_folder, "random-gears.md")), sep = "\n")
