# What the engine finds wrong with a lattice, or could not do.

# Called by the binding for every exception of the engine. field: what is wrong, such as
# "bars.rest", or "".
abort_engine <- function(message, field) {
  cli::cli_abort(
    "The engine stopped: {message}.", class = c("codend_error_engine", "codend_error"),
    field = if (nzchar(field)) field else NA_character_, call = NULL
  )
}
