# The one way to write a file: the path is checked before anything is computed; the file is written
# beside its place, forced to the disk and renamed. On any failure the old file stays.

# Stops unless file is one path with one of the extensions (such as ".png"; none for any name) in a
# folder that can be written. Returns the extension in lower case.
check_file_path <- function(file, extensions = character()) {
  given <- is_text(file) && nzchar(basename(file))
  extension <- if (given) tolower(sub("^.*(?=[.])", "", basename(file), perl = TRUE))
  if (!given || length(extensions) && !extension %in% extensions) {
    abort_file(file, if (length(extensions)) {
      "must be one path that ends in {.or {.val {extensions}}}."
    } else {
      "must be one path."
    }, extensions = extensions)
  }
  folder <- dirname(file)
  if (!dir.exists(folder)) abort_file(file, "must lie in a folder that exists.")
  if (file.access(folder, 2L) != 0L) abort_file(file, "must lie in a folder that can be written.")
  extension
}

# write: a function(path) that writes a file, or a folder of files, at that path. Returns file,
# invisibly.
write_file <- function(file, write) {
  path <- tempfile(".codend-", tmpdir = dirname(file))
  on.exit(unlink(path, recursive = TRUE))
  check_all <- function() {
    written <- if (dir.exists(path)) list.files(path, full.names = TRUE) else path
    for (each in written) check_written(file, file_sync(each))
  }
  tryCatch(write(path), error = function(e) {
    if (inherits(e, "codend_error")) stop(e)
    # the system says better than a writer why it failed
    if (file.exists(path)) check_all()
    abort_unwritten(file, conditionMessage(e))
  })
  check_all()
  if (dir.exists(path) && dir.exists(file)) {
    # no folder can be renamed onto one that holds files
    old <- tempfile(".codend-", tmpdir = dirname(file))
    check_written(file, file_replace(file, old))
    on.exit({
      if (!dir.exists(file)) file_replace(old, file)
      unlink(old, recursive = TRUE)
    }, add = TRUE)
  }
  check_written(file, file_replace(path, file))
  invisible(file)
}

write_text <- function(text, file) {
  bytes <- charToRaw(enc2utf8(paste(text, collapse = "\n")))
  write_file(file, function(path) {
    connection <- base::file(path, "wb")
    tryCatch(writeBin(bytes, connection), finally = close(connection))
  })
}

# why: "" or the system's reason.
check_written <- function(file, why) if (nzchar(why)) abort_unwritten(file, why)

# trajectory: what a tow had done.
abort_unwritten <- function(file, why, trajectory = NULL) {
  done <- if (!is.null(trajectory)) " What is done is the condition's {.field trajectory}."
  abort_file(file, paste0("could not be written: {why}.", done),
    why = sub("[.[:space:]]+$", "", why), trajectory = trajectory)
}

check_file_exists <- function(file) {
  if (is_text(file) && file.exists(file) && !dir.exists(file)) return(invisible())
  abort_file(as.character(file)[1L], "does not exist.")
}

# what: the rest of the sentence, for cli with the values in `...`, which the condition has as
# fields.
abort_file <- function(file, what, ...) {
  values <- c(list(file = file), list(...))
  abort_as("file", paste("{.arg file} is {.val {file}}; it", what), !!!values,
    envir = list2env(values, parent = environment(abort_file)))
}

write_csv <- function(table, file) {
  # exponents would follow the session's taste
  kept <- options(scipen = 0)
  on.exit(options(kept))
  write_file(file, function(path) utils::write.csv(table, path, row.names = FALSE, na = ""))
}
