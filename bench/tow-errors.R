# Entry point of `make tow-errors`: checks the reported errors of tows against true errors.
#
# Each random tow (random-tows.R) is computed with a coarse mesh and the usual accuracy. The
# reference has four times as many nodes and a tenth of the accuracy. Their difference counts as the
# true error, at ten times of each tow and for its means and extremes. The seeds were not used to
# fit constants.
#
# Named arguments: count=24 (tows), seed=2001 (of the first), nodes=300, minutes=1,3 (range of their
# duration), seconds=200 (CPU limit of one tow). Writes bench/results/tow-errors.md.
library(codend)
for (script in c("sizes", "results", "random-gears", "random-tows")) {
  source(file.path("bench", paste0(script, ".R")))
}
asked <- given_numbers(list(count = 24, seed = 2001, nodes = 300, minutes = c(1, 3), seconds = 200))
commit <- system2("git", c("rev-parse", "--short", "HEAD"), stdout = TRUE)

# Group of a kind of measure, or "other".
group_of <- function(kind, unit) {
  names <- c(height = "heights", clearance = "heights", depth = "depths", least_depth = "depths",
    greatest_depth = "depths", spread = "spreads")
  found <- names[kind]
  ifelse(!is.na(found), found, ifelse(unit %in% c("kN", "N"), "forces", "other"))
}

# Returns the rows of one tow, or a text with the reason why there are none.
tow_rows <- function(number) {
  one <- random_tow(number, asked$minutes)
  run <- function(nodes, accuracy) {
    run_random_tow(one, nodes, asked$seconds, every = one$until / 10, accuracy = accuracy)
  }
  found <- run(asked$nodes, NULL)
  if (!inherits(found, "codend_trajectory")) return(conditionMessage(found))
  fine <- run(4 * asked$nodes, found$method$accuracy / 10)
  if (!inherits(fine, "codend_trajectory")) return(paste("reference:", conditionMessage(fine)))
  kinds <- attr(measures(state_at(found, found$time[2L])), "kind")
  table <- as.data.frame(found, what = "measures")
  reference <- as.data.frame(fine, what = "measures")
  at <- match(paste(table$measure, table$time_s), paste(reference$measure, reference$time_s))
  table$fine <- reference$value[at]
  table$what <- ifelse(table$time_s == 0, "start", "times")
  extremes <- summary(found)
  known <- summary(fine)
  known <- known[match(extremes$measure, known$measure), ]
  of_summary <- lapply(c("mean", "least", "greatest", "least_at_s", "greatest_at_s"), function(of) {
    data.frame(measure = extremes$measure, value = extremes[[of]], unit = extremes$unit,
      error = extremes[[paste0(of, "_error")]], fine = known[[of]], what = of)
  })
  rows <- do.call(rbind, c(list(table[names(of_summary[[1L]])]), of_summary))
  rows$group <- group_of(kinds[rows$measure], rows$unit)
  rows$tow <- number
  rows$kind <- c(one$gear$plan$kind, "net")[1L]
  rows$true <- abs(rows$value - rows$fine)
  # a value that the reference does not change is exact and does not test the estimate
  rows[which(is.finite(rows$error) & rows$true > 1e-7 * abs(rows$fine)), ]
}

numbers <- asked$seed - 1 + seq_len(asked$count)
found <- lapply(numbers, function(number) {
  rows <- tow_rows(number)
  cat(number, if (is.data.frame(rows)) {
    paste(rows$kind[1L], sprintf("%.1f %% within", 100 * mean(rows$true <= 2 * rows$error)))
  } else {
    rows
  }, "\n")
  rows
})
counts <- vapply(found, is.data.frame, NA)
rows <- do.call(rbind, found[counts])
# Values of one tow are correlated, and a longline has more than a thousand. The columns `of_tows`
# therefore give each tow the same weight.
by <- function(rows, of) {
  bind_rows(lapply(split(rows, rows[[of]]), function(some) {
    within <- 100 * (some$true <= 2 * some$error)
    ratio <- some$error / some$true
    row <- list(some[[of]][1L], nrow(some), length(unique(some$tow)),
      mean(within), mean(tapply(within, some$tow, mean)),
      stats::median(ratio), stats::median(tapply(ratio, some$tow, stats::median)),
      100 * mean(some$true > 5 * some$error))
    stats::setNames(row, c(of, "values", "tows", "within_twice_percent", "within_twice_of_tows",
      "error_over_truth_median", "median_of_tows", "missed_by_five_percent"))
  }))
}
times <- rows$what == "times"
extreme <- !rows$what %in% c("times", "start", "least_at_s", "greatest_at_s")
save_page(c(
  "# Whether the errors of tows hold", "",
  sprintf(paste("Written by `make tow-errors` on commit %s: %d random tows from seed %d with %d",
    "nodes, against %d nodes and a tenth of the accuracy. %s"), commit, sum(counts), asked$seed,
    asked$nodes, 4 * asked$nodes, measured_with()), "",
  "At ten times of each tow:", "", markdown_table(by(rows[times, ], "group")), "",
  "Means and extremes of each tow:", "", markdown_table(by(rows[extreme, ], "group")), "",
  "By statistic:", "", markdown_table(by(rows[!rows$what %in% c("times", "start"), ], "what")), "",
  "By kind of gear, at ten times:", "", markdown_table(by(rows[times, ], "kind")), "",
  if (any(!counts)) {
    c("Tows without a result:", "", sprintf("- %d: %s", numbers[!counts],
      gsub("[[:space:]]+", " ", unlist(found[!counts]))))
  }
), "tow-errors")
cat(readLines(file.path(results_folder, "tow-errors.md")), sep = "\n")
