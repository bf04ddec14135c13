picture_types <- c(".png", ".pdf", ".svg")

# page: width and height, inches; draw: function(page) that draws on the open device.
write_picture <- function(file, page, title, draw) {
  extension <- check_file_path(file, picture_types)
  write_file(file, function(path) {
    # Devices replace % by a page number.
    path <- gsub("%", "%%", path, fixed = TRUE)
    before <- grDevices::dev.cur()
    switch(extension,
      .png = grDevices::png(path, page[1], page[2], units = "in", res = 200),
      .pdf = grDevices::pdf(path, page[1], page[2], title = title),
      .svg = grDevices::svg(path, page[1], page[2])
    )
    device <- grDevices::dev.cur()
    on.exit({
      grDevices::dev.off(device)
      if (before > 1L) grDevices::dev.set(before)
    })
    draw(page)
  })
}

# Draws on the current device, or to a file if given. Returns x, invisibly. `draw`: function(page),
# with the page size in inches. `height`: of the page in a file, `fitting` if NULL.
show_picture <- function(x, draw, file, width, height, title, fitting) {
  check_between("width", width, 3, 100, " of inches")
  if (!is.null(height)) check_between("height", height, 3, 100, " of inches")
  if (is.null(file)) draw(grDevices::dev.size()) else {
    check_file_path(file, picture_types)
    write_picture(file, c(width, first_of(height, fitting)), title, draw)
  }
  invisible(x)
}
