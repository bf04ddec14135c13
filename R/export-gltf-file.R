# A glTF 2.0 file: a JSON tree that describes the layout of a buffer of numbers. The buffer is
# collected in a file next to the target, part by part, so that it is never in memory as a whole.

# Returns a list of functions. `add_places(x, y, z of points)`, `add_colours(colours, opacity)` and
# `add_track(numbers of an animation)` return the number of an accessor. `done()` closes the buffer.
gltf_buffer <- function(folder) {
  path <- tempfile(".export-", tmpdir = folder, fileext = ".bin")
  connection <- base::file(path, "wb")
  open <- TRUE
  views <- list()
  accessors <- list()
  bytes <- 0
  shut <- function() {
    if (open) close(connection)
    open <<- FALSE
  }
  add <- function(values, size, accessor, target = list(target = 34962L)) {
    writeBin(values, connection, size = size, endian = "little")
    length <- size * length(values)
    views[[length(views) + 1L]] <<- c(
      list(buffer = 0L, byteOffset = bytes, byteLength = length), target
    )
    bytes <<- bytes + length
    accessors[[length(accessors) + 1L]] <<- c(list(bufferView = length(views) - 1L), accessor)
    length(accessors) - 1L
  }
  list(
    add_places = function(x) {
      # Minimum and maximum must match the stored values, which are single precision.
      ends <- apply(matrix(x, 3L), 1L, range)
      ends <- matrix(readBin(writeBin(as.vector(ends), raw(), 4L), "double", 6L, 4L), 2L)
      add(x, 4L, list(
        componentType = 5126L, count = length(x) / 3, type = "VEC3", min = ends[1L, ],
        max = ends[2L, ]
      ))
    },
    add_colours = function(colours, opacity = 1) {
      known <- unique(colours)
      share <- rbind(linear_light(grDevices::col2rgb(known) / 255), opacity)
      numbers <- as.integer(round(65535 * share))
      values <- matrix(numbers, 4L)[, match(colours, known)]
      # Two bytes store 0 to 65535 as R's signed integers 0 to -1.
      values <- as.vector(values - 65536L * (values > 32767L))
      add(values, 2L, list(
        componentType = 5123L, normalized = TRUE, count = length(colours), type = "VEC4"
      ))
    },
    # x: points (one column per time) or numbers at the times of an animation.
    add_track = function(x) {
      places <- is.matrix(x)
      ends <- if (places) apply(x, 1L, range) else matrix(range(x))
      ends <- matrix(readBin(writeBin(as.vector(ends), raw(), 4L), "double", length(ends), 4L), 2L)
      add(as.vector(x), 4L, list(
        componentType = 5126L, count = if (places) ncol(x) else length(x),
        type = if (places) "VEC3" else "SCALAR", min = I(ends[1L, ]), max = I(ends[2L, ])
      ), NULL)
    },
    views = function() views, accessors = function() accessors, bytes = function() bytes,
    path = path,
    done = shut,
    remove = function() {
      shut()
      unlink(path)
    }
  )
}

# Converts sRGB values (IEC 61966-2-1) to the linear values of glTF.
linear_light <- function(share) {
  ifelse(share <= 0.04045, share / 12.92, ((share + 0.055) / 1.055)^2.4)
}

gltf_json <- function(scene, buffer, uri = NULL) {
  scene$bufferViews <- buffer$views()
  scene$accessors <- buffer$accessors()
  scene$buffers <- list(c(list(byteLength = buffer$bytes()), if (!is.null(uri)) list(uri = uri)))
  enc2utf8(as.character(jsonlite::toJSON(scene, auto_unbox = TRUE, digits = NA)))
}

write_gltf_text <- function(path, scene, buffer) {
  buffer$done()
  numbers <- readBin(buffer$path, "raw", buffer$bytes())
  uri <- paste0("data:application/octet-stream;base64,", jsonlite::base64_enc(numbers))
  writeBin(charToRaw(gltf_json(scene, buffer, gsub("\n", "", uri, fixed = TRUE))), path)
}

# Writes the binary file: a header of 12 bytes, then tree and buffer. Each has its length and kind
# in front and is padded to a multiple of four bytes.
write_glb <- function(path, scene, buffer) {
  buffer$done()
  tree <- charToRaw(gltf_json(scene, buffer))
  tree <- c(tree, rep(charToRaw(" "), -length(tree) %% 4))
  connection <- base::file(path, "wb")
  on.exit(close(connection))
  word <- function(x) writeBin(low_word_first(x)[1L], connection, endian = "little")
  writeBin(charToRaw("glTF"), connection)
  word(2)
  word(12 + 8 + length(tree) + 8 + buffer$bytes())
  word(length(tree))
  writeBin(charToRaw("JSON"), connection)
  writeBin(tree, connection)
  word(buffer$bytes())
  writeBin(c(charToRaw("BIN"), as.raw(0)), connection)
  from <- base::file(buffer$path, "rb")
  on.exit(close(from), add = TRUE)
  while (length(block <- readBin(from, "raw", 2^24))) writeBin(block, connection)
}
