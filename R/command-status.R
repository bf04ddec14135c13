# What a command says at its end, with the status that it returns (0: done, 1: not, 2: was asked
# wrongly).

# ...: a line for the error stream.
tell <- function(status, ...) {
  cat(..., "\n", sep = "", file = stderr())
  status
}

# ...: texts for the output, as they are.
cat_and <- function(status, ...) {
  cat(..., sep = "")
  status
}
