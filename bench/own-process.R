# Runs a script in a separate R process, so that memory is counted per run and a crash costs one
# row.

# Memory (MB) of this process: `VmHWM` (peak so far) or `VmRSS` (now). NA if the system does not
# report it.
memory <- function(kind) {
  file <- "/proc/self/status"
  if (!file.exists(file)) return(NA_real_)
  line <- grep(paste0("^", kind, ":"), readLines(file), value = TRUE)
  if (length(line) == 1L) as.numeric(gsub("[^0-9]", "", line)) / 1024 else NA_real_
}

# CPU seconds that an expression takes in all threads of this process.
cpu <- function(expression) {
  start <- proc.time()
  force(expression)
  sum((proc.time() - start)[c("user.self", "sys.self")])
}

# Runs bench/<script> with arguments; the script writes its results to the file named last. Returns
# that list, or list(outcome = reason of failure).
in_own_process <- function(script, ...) {
  file <- tempfile(fileext = ".json")
  on.exit(unlink(file))
  status <- system2(
    file.path(R.home("bin"), "Rscript"), c(file.path("bench", script), ..., file)
  )
  if (!file.exists(file)) return(list(outcome = paste("process ended with status", status)))
  jsonlite::read_json(file, simplifyVector = TRUE)
}

# Writes results (a list of single values) for in_own_process().
leave_results <- function(results, file) {
  jsonlite::write_json(results, file, auto_unbox = TRUE, digits = NA, na = "null")
}
