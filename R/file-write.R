# Atomic file writing. The path is checked before any computation. The file is written next to the
# target, forced to the disk and renamed. On failure the old file remains. For a symbolic link, the
# target is written.

# Raises an error unless `file` is a single path with an allowed extension in a writable folder.
# extensions: such as ".png"; none allows any name. Returns the extension in lower case.
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
  if (!dir.exists(folder)) abort_file(file, "must be in a folder that exists.")
  if (file.access(folder, 2L) != 0L) abort_file(file, "must be in a writable folder.")
  extension
}

# Writes a file atomically. write: function(path) that writes a file, or a folder of files, at that
# path. Returns `file`, invisibly.
write_file <- function(file, write) {
  given <- file
  file <- linked_file(file)
  path <- unwritten_path(file)
  on.exit(unlink(path, recursive = TRUE))
  check_all <- function() {
    written <- if (dir.exists(path)) list.files(path, full.names = TRUE) else path
    for (each in written) check_written(file, file_sync(each))
  }
  tryCatch(write(path), error = function(e) {
    if (inherits(e, "codend_error")) stop(e)
    # The system reports the cause more precisely than the writer.
    if (file.exists(path)) check_all()
    abort_unwritten(file, conditionMessage(e))
  })
  check_all()
  if (dir.exists(path) && dir.exists(file)) {
    # A folder cannot be renamed onto a folder that contains files.
    old <- unwritten_path(file)
    check_written(file, file_replace(file, old))
    on.exit({
      if (!dir.exists(file)) file_replace(old, file)
      unlink(old, recursive = TRUE)
    }, add = TRUE)
  }
  check_written(file, file_replace(path, file))
  invisible(given)
}

# Resolves symbolic links, also links to a missing file.
linked_file <- function(file) {
  for (step in 1:40) {
    target <- Sys.readlink(path.expand(file))
    if (is.na(target) || !nzchar(target)) return(file)
    absolute <- grepl("^(/|[A-Za-z]:)", target)
    file <- if (absolute) target else file.path(dirname(file), target)
  }
  abort_file(file, "is a circular link.")
}

# The temporary name contains the host and process id of the writer.
unwritten_path <- function(file) {
  remove_leftovers(dirname(file))
  tempfile(sprintf(".codend-%s-%d-", this_host(), Sys.getpid()), tmpdir = dirname(file))
}

this_host <- function() gsub("[^A-Za-z0-9]+", "-", Sys.info()[["nodename"]])

# Folders that this session has already searched for leftovers, and the minimum age (s) of
# leftovers.
searched_folders <- new.env(parent = emptyenv())
leftover_seconds <- 3600

# Removes partial files of processes on this host that were killed while writing.
remove_leftovers <- function(folder) {
  key <- normalizePath(folder, mustWork = FALSE)
  if (!is.null(searched_folders[[key]])) return(invisible())
  searched_folders[[key]] <- TRUE
  begin <- sprintf(".codend-%s-", this_host())
  left <- list.files(folder, "^[.]codend-", full.names = TRUE, all.files = TRUE)
  left <- left[startsWith(basename(left), begin)]
  writer <- sub("-.*", "", substring(basename(left), nchar(begin) + 1L))
  left <- left[grepl("^[0-9]{1,9}$", writer)]
  writer <- as.integer(writer[grepl("^[0-9]{1,9}$", writer)])
  age <- as.double(Sys.time()) - as.double(file.mtime(left))
  old <- !is.na(age) & age > leftover_seconds
  # Signal 0 only checks that the process exists.
  gone <- vapply(writer, function(id) !isTRUE(tools::pskill(id, 0L)), NA)
  unlink(left[old & gone], recursive = TRUE)
}

write_text <- function(text, file) {
  bytes <- charToRaw(enc2utf8(paste(text, collapse = "\n")))
  write_file(file, function(path) {
    connection <- base::file(path, "wb")
    tryCatch(writeBin(bytes, connection), finally = close(connection))
  })
}

check_written <- function(file, why) if (nzchar(why)) abort_unwritten(file, why)

abort_unwritten <- function(file, why, trajectory = NULL) {
  done <- if (!is.null(trajectory)) " The condition's {.field trajectory} has the completed part."
  abort_file(file, paste0("could not be written: {why}.", done),
    why = sub("[.[:space:]]+$", "", why), trajectory = trajectory)
}

check_file_exists <- function(file) {
  if (is_text(file) && file.exists(file) && !dir.exists(file)) return(invisible())
  abort_file(as.character(file)[1L], "does not exist.")
}

# Raises an error about a file. `what` completes the sentence, for cli, with the values in `...`.
# These values are also fields of the condition. `argument`: its name as the user typed it.
abort_file <- function(file, what, ..., argument = "file") {
  values <- c(list(file = file), list(...))
  abort_as("file", paste0("{.arg ", argument, "} is {describe_value(file)}; it ", what), !!!values,
    envir = list2env(values, parent = environment(abort_file)))
}

write_csv <- function(table, file) {
  # Makes the notation of numbers independent of the session's options.
  kept <- options(scipen = 0)
  on.exit(options(kept))
  table <- without_formulas(table)
  write_file(file, function(path) utils::write.csv(table, path, row.names = FALSE, na = ""))
}

# Prevents spreadsheets from running strings and column names as formulas (OWASP, CSV injection).
# Strings that start with =, +, - or @ get an apostrophe, except quantities such as "-5 deg".
without_formulas <- function(table) {
  plain <- function(text) {
    quantity <- "^[-+]?[0-9.]+(e[-+]?[0-9]+)?[A-Za-z0-9 /%]*$"
    runs <- grepl("^[=+@\t\r-]", text) & !grepl(quantity, text)
    ifelse(runs, paste0("'", text), text)
  }
  texts <- vapply(table, is.character, NA)
  table[texts] <- lapply(table[texts], plain)
  names(table) <- plain(names(table))
  table
}
