# Entry point of `make bench`: runs every measurement. Argument: largest node count (1e5).
library(codend)
rooms <- c("release", "cases", "own-process", "sizes", "rivals", "results", "page", "cost-plot")
for (script in rooms) source(file.path("bench", paste0(script, ".R")))

given <- commandArgs(TRUE)
most <- if (length(given)) as.numeric(given[1]) else 1e5
if (is.na(most) || most < sizes$nodes[1]) {
  stop("NODES is ", given[1], "; it must be a number of nodes, ", sizes$nodes[1], " or more.")
}

build_release()
runs <- run_all(most, keep = function(runs) save_table(runs, "runs"))
check_sizes(runs)
ratios <- compare_versions(runs)
save_table(ratios, "ratios")
medians <- summarise_runs(runs)
exponents <- fit_exponents(medians)
save_table(medians, "medians")
save_table(exponents, "exponents")
save_cost_plot(medians, exponents)
rivals <- compare_rivals()
save_table(rivals, "rivals")
write_page(runs, ratios, medians, exponents, rivals)
cat(readLines(file.path(results_folder, "results.md")), sep = "\n")
