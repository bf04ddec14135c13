# A picture's file: checked before anything is drawn, and written whole or not at all.

picture_extension <- function(file, allowed) {
  if (!(is.character(file) && length(file) == 1L && !is.na(file) && nzchar(file))) {
    abort_view("{.arg file} must be one path.")
  }
  extension <- tolower(sub("^.*[.]", "", basename(file)))
  if (!grepl(".", basename(file), fixed = TRUE) || !extension %in% allowed) {
    abort_view(
      "{.arg file} is {.file {file}}; it must end in {.or {.val {paste0('.', allowed)}}}.",
      list(file = file, allowed = allowed)
    )
  }
  if (!dir.exists(dirname(file))) {
    abort_view(
      "{.arg file} must lie in a folder that exists, not {.file {dirname(file)}}.",
      list(file = file)
    )
  }
  extension
}

# write: a function(path) that writes the picture to that path.
write_whole <- function(file, write) {
  drawn <- tempfile(fileext = paste0(".", tolower(sub("^.*[.]", "", basename(file)))))
  beside <- tempfile(".view-", tmpdir = dirname(file))
  on.exit(unlink(c(drawn, beside)))
  write(drawn)
  # Renaming is only safe within one file system.
  if (!suppressWarnings(file.copy(drawn, beside) && file.rename(beside, file))) {
    abort_view("{.file {file}} cannot be written.", list(file = file))
  }
  invisible(file)
}

picture_types <- c("png", "pdf", "svg")

# page: width and height, inches; draw: a function(page) that draws on the open device.
write_picture <- function(file, page, title, draw) {
  extension <- picture_extension(file, picture_types)
  write_whole(file, function(path) {
    before <- grDevices::dev.cur()
    switch(extension,
      png = grDevices::png(path, page[1], page[2], units = "in", res = 200),
      pdf = grDevices::pdf(path, page[1], page[2], title = title),
      svg = grDevices::svg(path, page[1], page[2])
    )
    device <- grDevices::dev.cur()
    on.exit({
      grDevices::dev.off(device)
      if (before > 1L) grDevices::dev.set(before)
    })
    draw(page)
  })
}

abort_view <- function(message, values = list()) {
  cli::cli_abort(message, class = c("codend_error_argument", "codend_error"), call = NULL,
    .envir = list2env(values, parent = environment()))
}
