# Runs lanes of continuous integration: the rows of tools/lanes.csv, quick ones first, as many at a
# time as there are cores.
#   Rscript tools/ci.R              runs every lane
#   Rscript tools/ci.R style cost   runs these lanes only
#
# A lane is a shell command. It passes if the command exits with status 0. Its output is stored in
# out/lanes/<lane>.log. A failed lane also prints the end of its output and the command to run it
# alone. The processor time excludes processes without a waiting parent, such as Chromium's. The
# last line counts tests as "N passed, N failed, N skipped". Lanes that end with such a line
# contribute their counts; any other lane counts as one test.

lanes <- utils::read.csv("tools/lanes.csv")
chosen <- commandArgs(TRUE)
unknown <- setdiff(chosen, lanes$lane)
if (length(unknown)) {
  stop("unknown lane ", toString(unknown), "; lanes are ", toString(lanes$lane), call. = FALSE)
}
if (length(chosen)) lanes <- lanes[match(chosen, lanes$lane), ]
folder <- file.path("out", "lanes")
dir.create(folder, FALSE, TRUE)
# Drop the flags of a make that started this script: they do not apply to the lanes.
Sys.unsetenv(c("MAKEFLAGS", "MFLAGS", "MAKELEVEL"))

# Returns c(passed, failed, skipped) from the last line of a lane's log.
count_tests <- function(lines, failed) {
  pattern <- "^([0-9]+) passed, ([0-9]+) failed, ([0-9]+) skipped$"
  found <- regmatches(tail(lines, 1L), regexec(pattern, tail(lines, 1L)))
  if (!length(found) || !length(found[[1L]])) return(c(!failed, failed, 0))
  count <- as.numeric(found[[1L]][-1L])
  if (failed && count[2L] == 0) count[2L] <- 1
  count
}

# Runs row k of `lanes`. Prints its result in one call, because lanes run in parallel.
run_lane <- function(k) {
  lane <- lanes[k, ]
  log <- file.path(folder, paste0(lane$lane, ".log"))
  time <- system.time(
    status <- system2("bash", c("-c", shQuote(lane$command)), stdout = log, stderr = log,
      stdin = "/dev/null")
  )
  lines <- readLines(log, warn = FALSE)
  failed <- status != 0
  cat(paste0(c(
    sprintf("%s  %-14s %5.1f min, %5.1f min of processor time",
      if (failed) "FAILED" else "passed", lane$lane, time[["elapsed"]] / 60,
      sum(time[c("user.child", "sys.child")]) / 60),
    if (failed) {
      c(paste("   ", tail(lines, 60L)), paste0("    Run it alone: make lane LANE=", lane$lane))
    }
  ), "\n"), sep = "")
  list(failed = failed, count = count_tests(lines, failed))
}

started <- Sys.time()
results <- parallel::mclapply(seq_len(nrow(lanes)), run_lane,
  mc.preschedule = FALSE, mc.cores = parallel::detectCores())
lost <- !vapply(results, is.list, NA)
results[lost] <- list(list(failed = TRUE, count = c(0, 1, 0)))
failed <- vapply(results, `[[`, NA, "failed")
cat(sprintf("%d of %d lanes passed in %.1f min\n", sum(!failed), nrow(lanes),
  as.numeric(Sys.time() - started, units = "mins")))
if (any(failed)) cat("Failed:", lanes$lane[failed], "\n")
total <- Reduce(`+`, lapply(results, `[[`, "count"))
cat(sprintf("%d passed, %d failed, %d skipped\n", total[1L], total[2L], total[3L]))
quit(status = any(failed))
