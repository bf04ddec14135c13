# Measures the overhead of each study backend and extrapolates to 10,000 designs of the midwater
# trawl. Runs 200 trawls, and 50 cables through each backend.
#   Rscript bench/studies.R [DESIGNS]
library(codend)
count <- as.integer(c(commandArgs(TRUE), "200")[1])
trawls <- designs(towing.speed = value_range("3.5 knot", "4.5 knot"),
  warps.length = value_range("550 m", "650 m"), how = "sobol", number = count)
cables <- designs(towing.speed = value_range("3 knot", "5 knot"), how = "grid", number = 50)

clock <- function(run) {
  taken <- system.time(run)
  c(elapsed = taken[["elapsed"]], cpu = sum(taken[-3]))
}
show <- function(name, taken, of) {
  cat(sprintf("%-28s %7.1f s, %7.1f CPU s here, %.3f s and %.3f CPU s a design\n", name,
    taken[["elapsed"]], taken[["cpu"]], taken[["elapsed"]] / of, taken[["cpu"]] / of))
}
folder <- tempfile("bench-")
dir.create(folder)
show("trawls, one process", clock(found <- vary("midwater_trawl", trawls)), count)
cat(sum(found$settled), "of", count, "settled\n")
show("cables, one process", clock(alone <- vary("towed_cable", cables)), 50)
show("cables, with a store", clock(vary("towed_cable", cables,
  store = file.path(folder, "one"))), 50)
future::plan("multisession", workers = 2)
show("cables, two sessions", clock(two <- vary("towed_cable", cables,
  store = file.path(folder, "two"))), 50)
stopifnot(identical(two, alone))
future::plan("multicore", workers = 2)
show("cables, two forks", clock(two <- vary("towed_cable", cables,
  store = file.path(folder, "three"))), 50)
stopifnot(identical(two, alone))
