# Writes the measures of every shipped plan, settled and towed, with all digits to a CSV file:
#
#   Rscript tools/measures.R before.csv
#   (change codend and install it)
#   Rscript tools/measures.R after.csv before.csv
#
# With a second file it compares the two files. It fails if a measure is missing or differs by a
# fraction of more than 1e-9. The difference is divided by at least 1e-3, because angles and depths
# may be 0.

arguments <- commandArgs(TRUE)
if (!length(arguments) %in% 1:2) stop("usage: measures.R OUT.csv [BEFORE.csv]")
suppressPackageStartupMessages(library(codend))

rows <- function(gear, how, values) {
  data.frame(gear = gear, how = how, measure = names(values), value = unname(values))
}

settled <- function(name, netting = NULL) {
  state <- suppressWarnings(settle(name, nodes = 800, netting = netting))
  tensions <- as.data.frame(state, what = "tensions")
  sums <- c(
    measures(state), nodes = state$report$nodes,
    position_sum = sum(abs(state$position)), tension_sum = sum(tensions$tension_N)
  )
  list(state = state, rows = rows(name, paste(c("settled", netting), collapse = " "), sums))
}

towed <- function(name, state) {
  trajectory <- if (name == "purse_seine") {
    tow(name, until = 6, every = 3, nodes = 300)
  } else {
    tow(state, until = 6, every = 3, scheme = "tr_bdf2")
  }
  now <- suppressWarnings(measures(state_at(trajectory, 6)))
  rows(name, "towed", c(now, position_sum = sum(abs(trajectory$position))))
}

all <- do.call(rbind, lapply(gears()$name, function(name) {
  found <- settled(name)
  more <- tryCatch(settled(name, "cells")$rows, codend_error = function(e) NULL)
  rbind(found$rows, more, towed(name, found$state))
}))
all$value <- sprintf("%.17g", all$value)
utils::write.csv(all, arguments[1], row.names = FALSE)
cat(nrow(all), "measures of", length(unique(all$gear)), "plans\n")

if (length(arguments) == 2L) {
  before <- utils::read.csv(arguments[2])
  after <- utils::read.csv(arguments[1])
  both <- merge(before, after, by = c("gear", "how", "measure"), all.x = TRUE,
    suffixes = c("_before", "_after"))
  scale <- pmax(abs(both$value_before), 1e-3)
  both$change <- abs(both$value_after - both$value_before) / scale
  same <- both$value_before == both$value_after |
    (is.na(both$value_before) & is.na(both$value_after)) | both$change <= 1e-9
  off <- both[!(same %in% TRUE), ]
  cat(sprintf("%d compared, %d identical, largest change %.1e\n", nrow(both),
    sum(both$value_before == both$value_after, na.rm = TRUE), max(both$change, 0, na.rm = TRUE)))
  if (nrow(off)) {
    print(utils::head(off[order(-off$change), ], 40), row.names = FALSE)
    quit(status = 1)
  }
}
