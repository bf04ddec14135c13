# Tries codend with unusual plans, files, models and messages. A case is a finding unless codend
# accepts it or rejects it with a codend_error. Findings are: another error, a warning of R, or
# NaN in a result or a message. A plan that changes when written, 20 CPU seconds without an answer,
# more than 2 GB and a crash are findings too.
#
#   Rscript tests/fuzz/run.R SECONDS [SEED [COUNT]]   cases from number SEED until the time is over,
#                                                     or COUNT cases
#   Rscript tests/fuzz/run.R --case N                 one case, in this process, as it was
#
# The number of a case defines it on every machine. Equal findings are reported once.

library(codend)
given <- commandArgs(TRUE)
here <- dirname(sub("^--file=", "", grep("^--file=", commandArgs(), value = TRUE)))
for (part in c("plans.R", "files.R", "cases.R")) source(file.path(here, part))
options(warn = 1, cli.num_colors = 1L, device = function(...) grDevices::pdf(NULL, ...))

most_seconds <- 20
most_bytes <- 2e9
shares <- vapply(kinds, `[[`, 0, "share")

# Returns list(kind, came_to, found = NULL or string) of a case.
run_case <- function(number) {
  set.seed(number, "Mersenne-Twister", "Inversion", "Rejection")
  kind <- sample(names(kinds), 1L, prob = shares)
  setTimeLimit(cpu = most_seconds, transient = TRUE)
  on.exit(setTimeLimit())
  tryCatch(
    list(kind = kind, came_to = kinds[[kind]]$run()),
    error = function(e) list(kind = kind, came_to = "found", found = conditionMessage(e))
  )
}

if (given[1L] == "--case") {
  found <- run_case(as.integer(given[2L]))
  print(found)
  quit(status = !is.null(found$found))
}

# Starts a process for some hundred cases; it logs each case before the run and its result after it.
batch <- function(numbers, log) {
  note <- function(...) cat(paste(..., sep = "\t"), "\n", sep = "", file = log, append = TRUE)
  parallel::mcparallel({
    for (number in numbers) {
      note("case", number)
      found <- run_case(number)
      note("came", number, found$kind, found$came_to, gsub("[\t\n]", " ", c(found$found, "")[1L]))
      if (most_memory() > most_bytes) {
        note("came", number, found$kind, "found", "more than 2 GB")
        break
      }
    }
  }, mc.set.seed = FALSE)
}

# Peak memory (bytes) of this process; 0 if the system does not report it.
most_memory <- function() {
  status <- "/proc/self/status"
  if (!file.exists(status)) return(0)
  line <- grep("^VmHWM", readLines(status), value = TRUE)
  1024 * as.double(gsub("[^0-9]", "", line))
}

seconds <- as.double(given[1L])
first_case <- if (length(given) > 1L) as.integer(given[2L]) else 1L
set.seed(1)
invisible(kept())
count <- if (length(given) > 2L) as.integer(given[3L]) else Inf
last_case <- first_case + count - 1
until <- proc.time()[["elapsed"]] + seconds
results <- list()
while (first_case <= last_case && proc.time()[["elapsed"]] < until) {
  log <- tempfile()
  file.create(log)
  numbers <- as.integer(seq(first_case, min(first_case + 499, last_case)))
  job <- batch(numbers, log)
  last <- c("", 0)
  repeat {
    done <- parallel::mccollect(job, wait = FALSE, timeout = 0.5)
    now <- proc.time()[["elapsed"]]
    lines <- readLines(log, warn = FALSE)
    about <- utils::tail(lines, 1L)
    if (!identical(about, last[1L])) last <- c(about, now)
    # R's time limit does not stop every case; the machine may be busy
    hangs <- now - as.double(last[2L]) > 10 * most_seconds
    if (!is.null(done) || hangs || now > until) break
  }
  if (is.null(done)) {
    tools::pskill(job$pid, tools::SIGKILL)
    suppressWarnings(parallel::mccollect(job))
  }
  lines <- readLines(log, warn = FALSE)
  came <- strsplit(sub("^came\t", "", grep("^came\t", lines, value = TRUE)), "\t")
  results <- c(results, lapply(came, function(of) c(of, "")[1:4]))
  tried <- as.integer(sub("case\t", "", utils::tail(grep("^case\t", lines, value = TRUE), 1L)))
  unanswered <- grepl("^case\t", utils::tail(lines, 1L))
  if (unanswered && now <= until) {
    results <- c(results, list(c(tried, "", "found", if (hangs) "no answer" else "crashed")))
  }
  first_case <- tried + 1L
}

results <- as.data.frame(do.call(rbind, results))
names(results) <- c("case", "kind", "came_to", "found")
print(table(results$kind, results$came_to))
bad <- results[results$came_to == "found", ]
# one example per kind: numbers and quoted strings differ
way <- gsub("[0-9.]+", "#", gsub("`[^`]*`|\"[^\"]*\"|\u201c[^\u201d]*\u201d", "`#`", bad$found))
first <- !duplicated(way)
for (k in which(first)) {
  cat(sprintf("%s (%s, %d alike): %s\n", bad$case[k], bad$kind[k], sum(way == way[k]),
    substr(bad$found[k], 1L, 300L)))
}
cat(sprintf("%d cases, %d found\n", nrow(results), nrow(bad)))
quit(status = nrow(bad) > 0)
