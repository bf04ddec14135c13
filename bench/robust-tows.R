# Entry point of `make robust-tows`: runs random tows of random gears (random-tows.R) and counts
# failures. A tow may be refused before its motion starts; it must not fail later. Named arguments:
# count=100, seed=1 (of the first), nodes=150, minutes=1,5 (range of their duration; 1,20 for all),
# seconds=60 (CPU limit of one tow). Writes bench/results/robust-tows.md.
library(codend)
for (script in c("sizes", "results", "random-gears", "random-tows")) {
  source(file.path("bench", paste0(script, ".R")))
}
asked <- given_numbers(list(count = 100, seed = 1, nodes = 150, minutes = c(1, 5), seconds = 60))

# Returns the row of a tow. `end`: "reached", "refused" (before the motion), "stopped" (during the
# motion), "slow" (the CPU limit) or "error".
tow_row <- function(number) {
  one <- random_tow(number, asked$minutes)
  found <- run_random_tow(one, asked$nodes, asked$seconds, every = one$until / 20)
  towed <- inherits(found, "codend_trajectory")
  trajectory <- if (towed) found else found$trajectory
  report <- if (towed) found$report else found$report
  numbers <- unlist(unclass(trajectory)[c("position", "velocity", "bar_tension", "u_tension")])
  end <- if (towed) {
    "reached"
  } else if (!is.null(trajectory)) {
    "stopped"
  } else if (inherits(found, "codend_error")) {
    "refused"
  } else if (grepl("time limit", conditionMessage(found))) {
    "slow"
  } else {
    "error"
  }
  count <- function(name) if (is.null(report[[name]])) NA_real_ else report[[name]]
  list(tow = number, kind = c(one$gear$plan$kind, "net")[1L],
    changes = paste(one$changes, collapse = ", "), minutes = one$until / 60, end = end,
    not_finite = sum(!is.finite(numbers)),
    steps = count("steps"), shortest_step = count("shortest_step"),
    not_found = count("not_found"), unbalanced = count("unbalanced"),
    reason = if (towed) "" else gsub("[[:space:]]+", " ", conditionMessage(found)))
}

rows <- bind_rows(lapply(asked$seed - 1 + seq_len(asked$count), function(number) {
  row <- tow_row(number)
  cat(number, row$kind, row$end, row$reason, "\n")
  row
}))
of_kind <- function(kind, rows) {
  ends <- function(end) sum(rows$end == end)
  done <- rows[rows$end == "reached", ]
  list(kind = kind, tows = nrow(rows), refused = ends("refused"), stopped = ends("stopped"),
    slow = ends("slow"), error = ends("error"), `with NaN` = sum(rows$not_finite > 0),
    `steps, median` = stats::median(done$steps), `shortest step, s` = min(done$shortest_step, Inf))
}
counts <- bind_rows(c(
  lapply(sort(unique(rows$kind)), function(kind) of_kind(kind, rows[rows$kind == kind, ])),
  list(of_kind("all", rows))
))
names(counts) <- names(of_kind("all", rows))
failed <- rows[rows$end != "reached", ]
save_page(c(
  "# Whether random tows run", "",
  sprintf("Written by `make robust-tows`: %d tows from seed %d of %s minutes with %d nodes. %s",
    asked$count, asked$seed, paste(asked$minutes, collapse = " to "), asked$nodes,
    measured_with()), "",
  markdown_table(counts), "",
  if (nrow(failed)) {
    c("Tows that did not reach their end:", "",
      sprintf("- %d, %s (%s), %s: %s", failed$tow, failed$kind, failed$changes, failed$end,
        failed$reason))
  }
), "robust-tows")
cat(readLines(file.path(results_folder, "robust-tows.md")), sep = "\n")
