# A file for other programs: its path is checked before anything is computed, and it is there whole
# or not at all.

check_export_path <- function(file, extensions) {
  given <- is_text(file) && nzchar(basename(file))
  extension <- if (given) tolower(sub("^.*[.]", ".", basename(file)))
  if (!given || !extension %in% extensions) {
    abort_export(file, "must be one path that ends in {.or {.val {extensions}}}.",
      list(extensions = extensions))
  }
  folder <- dirname(file)
  if (!dir.exists(folder)) abort_export(file, "must lie in a folder that exists.")
  if (file.access(folder, 2L) != 0L) abort_export(file, "must lie in a folder that can be written.")
  extension
}

# write: a function(path) that writes to that path.
export_whole <- function(file, write) {
  beside <- tempfile(".export-", tmpdir = dirname(file))
  on.exit(unlink(beside))
  write(beside)
  if (!suppressWarnings(file.rename(beside, file))) abort_export(file, "cannot be written.")
  invisible(file)
}

abort_export <- function(file, what, values = list()) {
  cli::cli_abort(paste("{.arg file} is {show_value(file)}; it", what),
    class = c("codend_error_input", "codend_error"), call = NULL,
    .envir = list2env(c(list(file = file), values), parent = environment(abort_export)))
}

# What a state or a trajectory is asked to be; allowed: their names without `codend_`.
check_exported <- function(x, allowed) {
  if (inherits(x, paste0("codend_", allowed))) return(invisible())
  cli::cli_abort(
    "{.arg x} must be a {.or {allowed}} ({.fn settle}, {.fn tow}), not {.cls {class(x)}}.",
    class = c("codend_error_argument", "codend_error"), call = NULL
  )
}
