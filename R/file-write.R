# The one way to write a file: the path is checked before anything is computed; the file is written
# next to its place, forced to the disk and renamed. On any failure the old file stays. A link is
# followed: what it leads to is written.

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
    # the system says better than a writer why it failed
    if (file.exists(path)) check_all()
    abort_unwritten(file, conditionMessage(e))
  })
  check_all()
  if (dir.exists(path) && dir.exists(file)) {
    # no folder can be renamed onto one that holds files
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

# Where a file is that is given by a link, or the file itself. A link to nothing is followed too.
linked_file <- function(file) {
  for (step in 1:40) {
    target <- Sys.readlink(path.expand(file))
    if (is.na(target) || !nzchar(target)) return(file)
    absolute <- grepl("^(/|[A-Za-z]:)", target)
    file <- if (absolute) target else file.path(dirname(file), target)
  }
  abort_file(file, "is a link that leads round in a circle.")
}

# A name next to a file for what is being written; it says who writes.
unwritten_path <- function(file) {
  remove_leftovers(dirname(file))
  tempfile(sprintf(".codend-%s-%d-", this_host(), Sys.getpid()), tmpdir = dirname(file))
}

this_host <- function() gsub("[^A-Za-z0-9]+", "-", Sys.info()[["nodename"]])

# Folders in which this session has looked for leftovers, and how old (s) these must be.
searched_folders <- new.env(parent = emptyenv())
leftover_seconds <- 3600

# Removes what processes of this machine left in a folder that were killed as they wrote.
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
  # signal 0 is sent to nobody: it says whether the process is there
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
  abort_as("file", paste("{.arg file} is {said_value(file)}; it", what), !!!values,
    envir = list2env(values, parent = environment(abort_file)))
}

write_csv <- function(table, file) {
  # exponents would follow the session's taste
  kept <- options(scipen = 0)
  on.exit(options(kept))
  table <- without_formulas(table)
  write_file(file, function(path) utils::write.csv(table, path, row.names = FALSE, na = ""))
}

# A table whose texts and column names no spreadsheet runs as formulas: those that begin with =, +,
# - or @ get an apostrophe first (OWASP, CSV injection). Quantities such as "-5 deg" stay.
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
