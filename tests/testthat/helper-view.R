# Unsettled states in the initial layout of the mesh: a picture shows any shape.
unsettled <- function(plan, nodes = 200, netting = NULL) {
  gear <- if (is.character(plan)) read_gear(plan) else as_gear(plan)
  si <- gear_si(gear)
  mesh <- build_mesh(si, nodes = nodes, netting = netting)
  new_state(gear, si, mesh, start_of(mesh), list(converged = FALSE))
}

# A sheet of diamond netting, a sheet of square netting below it and a pointed tip below that, hung
# by two lines and towed.
sheets_plan <- list(
  codend = 1, name = "Sheets <& 'quotes'>", towing = list(speed = 1),
  points = list(
    port = list(position = c(0, -2, 0), held = "moved"),
    starboard = list(position = c(0, 2, 0), held = "moved")
  ),
  ropes = list(
    line_port = list(from = "port", to = "top.upper_left", length = 20, diameter = 0.01,
      material = "PA"),
    line_starboard = list(from = "starboard", to = "top.upper_right", length = 20,
      diameter = 0.01, material = "PA"),
    headline = list(along = list("top.upper"), length = 4, diameter = 0.01, material = "PA",
      role = "headline")
  ),
  panels = list(
    top = list(mesh_size = 0.1, meshes = list(upper = 60, lower = 40, deep = 30),
      twine = list(diameter = 0.002, material = "PA")),
    middle = list(mesh_size = 0.1, meshes = list(upper = 40, lower = 40, deep = 20),
      orientation = "square", twine = list(diameter = 0.002, material = "PA")),
    tip = list(mesh_size = 0.1, meshes = list(upper = 40, lower = 0, deep = 40),
      twine = list(diameter = 0.002, material = "PA"))
  ),
  seams = list(
    upper = list(edges = list("top.lower", "middle.upper")),
    lower = list(edges = list("middle.lower", "tip.upper"))
  ),
  pieces = list(
    floats = list(along = "headline", number = 40, buoyancy = "5 N", diameter = 0.12,
      role = "float"),
    board = list(at = "top.upper_left", mass = 20, density = 7850, area = 1, lift_coefficient = 1,
      lift_direction = "port", role = "otter_board"),
    sinker = list(at = "tip.lower_left", mass = 10, density = 7850)
  )
)

# TRUE for columns of `wanted` (3 x n) that are columns of `points`.
are_among <- function(wanted, points) {
  key <- function(x) paste(x[1, ], x[2, ], x[3, ])
  key(wanted) %in% key(points)
}

# An empty folder that is deleted when the test ends.
test_folder <- function(frame = parent.frame()) {
  folder <- tempfile("view")
  dir.create(folder)
  do.call(on.exit, list(bquote(unlink(.(folder), recursive = TRUE)), add = TRUE), envir = frame)
  folder
}

# Numbers of a scene (see packed()).
unpacked <- function(text, what, size) {
  bytes <- jsonlite::base64_dec(text)
  readBin(bytes, what, length(bytes) / size, size = size, signed = size > 2, endian = "little")
}

# Series of a scene (see packed_series()) as series x times.
unpacked_series <- function(told) {
  bytes <- as.integer(memDecompress(jsonlite::base64_dec(told$text), "gzip"))
  size <- length(bytes) / 2
  x <- matrix(bytes[seq_len(size)] + 256 * bytes[size + seq_len(size)], told$count, byrow = TRUE)
  for (k in seq_len(told$order)) x <- t(apply(x, 1L, cumsum))
  x %% 65536
}

# Positions of a scene at its k-th time (3 x n), and its values, as the viewer reads them.
places_at <- function(told, k) {
  if (!is.null(told$floats)) return(matrix(unpacked(told$floats, "double", 4), 3L))
  floats <- function(field) unpacked(told[[field]], "double", 4)
  matrix(floats("low") + floats("step") * unpacked_series(told$steps)[, k], 3L)
}
values_at <- function(told, k) {
  root <- unpacked_series(told$steps)[, k]
  root <- ifelse(root > 32767, root - 65536, root)
  ifelse(root == -32768, NA, sign(root) * told$top * (root / 4095)^2)
}

# Draws x by plot(x, ...) to a file, checks that the file is not empty, and returns x.
expect_picture <- function(x, ...) {
  file <- tempfile(fileext = ".png")
  expect_identical(plot(x, ..., file = file), x)
  expect_gt(file.size(file), 5000)
}
