# Settles a plan of each class of gear in bench/gear-classes.csv and writes
# bench/results/gear-classes.md. Names and codes are from the ISSCFG of FAO; devices of trawls are
# included. Columns of the CSV file:
# `plan`: a shipped plan, or a file in inst/examples or tests/testthat/plans.
# `field`: the field of a trawl's plan that defines a device.
# Both are empty for classes that codend does not cover.
#
#   Rscript bench/gear-classes.R
library(codend)
source("bench/results.R")

plan_file <- function(name) {
  folders <- c("inst/gears", "inst/examples", "tests/testthat/plans")
  files <- file.path(folders, paste0(name, ".yaml"))
  files[file.exists(files)][1L]
}

classes <- utils::read.csv("bench/gear-classes.csv", na.strings = "")
plans <- unique(stats::na.omit(classes$plan))
settled <- do.call(rbind, lapply(plans, function(name) {
  file <- plan_file(name)
  gear <- read_gear(file)
  state <- tryCatch(suppressWarnings(settle(gear, nodes = 1500)), codend_error = identity)
  ok <- inherits(state, "codend_state")
  data.frame(plan = name, lines = length(readLines(file)),
    iterations = if (ok) state$report$iterations else NA)
}))
row <- match(classes$plan, settled$plan)
shipped <- dirname(vapply(classes$plan, plan_file, "")) == "inst/gears"
covered <- !is.na(classes$field) | !is.na(settled$iterations[row]) &
  (shipped | settled$lines[row] <= 80)
apart <- classes$remark %in% c("gear at rest", "gear adrift")
shown <- function(x) ifelse(is.na(x), "", x)
save_page(c(
  "# Classes of fishing gear that have a plan", "",
  "Written by `Rscript bench/gear-classes.R`.",
  sprintf(
    "%d of %d classes have a shipped plan, a plan of at most 80 lines that settles, or a field.",
    sum(covered), nrow(classes)),
  sprintf("%d of the other %d classes are at rest or adrift.", sum(apart), sum(!covered)),
  "Plans in `inst/examples` and `tests/testthat/plans` have typical values without a source.", "",
  markdown_table(data.frame(
    gear = classes$gear, ISSCFG = classes$isscfg,
    `plan or field` = shown(ifelse(is.na(classes$plan), classes$field, classes$plan)),
    lines = shown(settled$lines[row]), iterations = shown(settled$iterations[row]),
    limits = shown(classes$remark), check.names = FALSE
  ))
), "gear-classes")
