# The output at the end of a command, with its exit status (0: success, 1: failure, 2: wrong usage).

# ...: a line for standard error.
write_output <- function(status, ...) {
  cat(..., "\n", sep = "", file = stderr())
  status
}

# ...: strings for standard output.
cat_and <- function(status, ...) {
  cat(..., sep = "")
  status
}
