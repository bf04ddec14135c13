# What runs in an R process of its own, so that its memory is its own and a crash is one row.

# Memory (MB) of this process: `VmHWM`, its peak so far, or `VmRSS`, that of now. NA where the
# system does not tell.
memory <- function(kind) {
  file <- "/proc/self/status"
  if (!file.exists(file)) return(NA_real_)
  line <- grep(paste0("^", kind, ":"), readLines(file), value = TRUE)
  if (length(line) == 1L) as.numeric(gsub("[^0-9]", "", line)) / 1024 else NA_real_
}

# CPU seconds of all threads of this process that an expression takes.
cpu <- function(expression) {
  start <- proc.time()
  force(expression)
  sum((proc.time() - start)[c("user.self", "sys.self")])
}

# Runs bench/<script> with arguments; it leaves its results in the file named by its last one.
# Returns that list, or list(outcome = why there is none).
in_own_process <- function(script, ...) {
  file <- tempfile(fileext = ".json")
  on.exit(unlink(file))
  status <- system2(
    file.path(R.home("bin"), "Rscript"), c(file.path("bench", script), ..., file)
  )
  if (!file.exists(file)) return(list(outcome = paste("process ended with status", status)))
  jsonlite::read_json(file, simplifyVector = TRUE)
}

# Leaves results (a list of single values) where in_own_process() looks for them.
leave_results <- function(results, file) {
  jsonlite::write_json(results, file, auto_unbox = TRUE, digits = NA, na = "null")
}
