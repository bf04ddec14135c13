# The smallest part of make bench, for continuous integration: beside the last release no case may
# take, at the least, more than 1.25 times what it took in the median when bench/results/ratios.csv
# was written: the least of more runs is less.
# The last line counts cases as tests.
for (room in c("release", "cases", "own-process", "sizes", "results")) {
  source(file.path("bench", paste0(room, ".R")))
}
most_loss <- 1.25
build_release()
small <- c(square_net_20 = 0, trawl_bars = 1500, trawl_cells = 1500, panel_bars = 1500)
runs <- NULL
for (name in names(small)) {
  found <- run_case(name, small[[name]], 60, 2)
  runs <- c(runs, split(found, seq_len(nrow(found))))
}
runs <- bind_rows(runs)
check_sizes(runs)
now <- compare_versions(runs)
known <- utils::read.csv(file.path(results_folder, "ratios.csv"))
was <- known$ratio[match(paste(now$case, now$asked), paste(known$case, known$asked))]
# of a machine that others use too the least says most
lost <- !(now$least <= most_loss * was)
cat(sprintf("%-14s %4.2f of the release's CPU s per node, known is %4.2f%s\n", now$case, now$least,
  was, ifelse(lost, ": LOST", "")), sep = "")
cat(sprintf("%d passed, %d failed, 0 skipped\n", sum(!lost), sum(lost)))
