# Common format of state and trajectory files. Data are plain; reading evaluates no code.

# The format of files that this codend writes and reads.
saved_format <- list(state = 11L, trajectory = 15L)

# Opens a NetCDF file of codend. Attributes of the result: `what` ("state" or "trajectory") and
# `records`, the number of records. A trajectory without a checksum comes from a killed run; its
# last records may be missing.
open_saved <- function(file) {
  check_netcdf()
  if (!is_text(file) || !file.exists(file)) abort_file(file, "does not exist.")
  if (is.na(file_size(file))) abort_file(file, "is a folder or not a regular file.")
  magic <- readBin(file, "raw", 4L)
  if (!identical(magic, c(charToRaw("CDF"), as.raw(2L)))) {
    abort_file(file, "is not a NetCDF file from codend.")
  }
  seal <- seal_of(file)
  if (seal == "broken") abort_damaged(file, "its checksum is wrong")
  records <- whole_records(file, seal == "none", function(why) abort_damaged(file, why))
  nc <- tryCatch(RNetCDF::open.nc(file), error = function(e) {
    abort_damaged(file, conditionMessage(e))
  })
  refuse <- function(...) {
    RNetCDF::close.nc(nc)
    abort_file(file, ...)
  }
  version_of <- function(what) {
    name <- paste0("codend_", what)
    tryCatch(RNetCDF::att.get.nc(nc, "NC_GLOBAL", name), error = function(e) NULL)
  }
  versions <- Filter(Negate(is.null), lapply(setNames(nm = names(saved_format)), version_of))
  if (length(versions) != 1L) refuse("has no state or trajectory of codend.")
  what <- names(versions)
  version <- versions[[what]]
  known <- saved_format[[what]]
  if (!identical(as.integer(version), known)) {
    refuse(paste("has format {version}; this codend reads only format {known}. Read the file with",
      "the codend version that wrote it, or settle its plan again."), version = version,
      known = known)
  }
  if (seal == "none" && what == "state") {
    RNetCDF::close.nc(nc)
    abort_damaged(file, "it ends without its checksum")
  }
  attr(nc, "records") <- records
  attr(nc, "what") <- what
  nc
}

abort_damaged <- function(file, why) abort_file(file, "is damaged: {why}.", why = why)

# Calls read(get) on an open file and closes it. Other errors become "damaged file" errors.
read_saved <- function(nc, file, read) {
  on.exit(RNetCDF::close.nc(nc))
  tryCatch(read(file_getter(nc)), error = function(e) {
    if (inherits(e, "codend_error_file")) stop(e)
    abort_damaged(file, sub("[.[:space:]]+$", "", conditionMessage(e)))
  })
}

# Returns a function(name, start, count) that reads a variable; numeric() if it is absent.
file_getter <- function(nc) {
  info <- RNetCDF::file.inq.nc(nc)
  known <- vapply(seq_len(info$nvars) - 1L, function(id) RNetCDF::var.inq.nc(nc, id)$name, "")
  function(name, start = NA, count = NA, rawchar = FALSE) {
    if (!name %in% known) return(numeric())
    RNetCDF::var.get.nc(nc, name, start, count, na.mode = 3, rawchar = rawchar, collapse = FALSE)
  }
}

# ---- content of files ----------------------------------------------------------------------------

# Describes a variable. `across`: names of its dimensions; `words`, `unit`, `error`: NULL if absent.
file_variable <- function(type, across, words = NULL, unit = NULL, value = NULL, error = NULL) {
  list(type = type, across = across, words = words, unit = unit, value = value, error = error)
}

model_variables <- function(mesh) {
  model <- mesh$model
  whole <- function(value, across, words) file_variable("NC_INT", across, words, value = value)
  list(
    bar_node = whole(matrix(model$bars$node, 2L), c("bar_end", "bar"),
      "nodes that a bar joins, from 1"),
    bar_part = whole(mesh$bar_part, "bar", "part that a bar belongs to, from 1"),
    cell_node = whole(matrix(model$cells$node, 4L), c("corner", "cell"),
      "nodes at a cell's corners, from 1; triangles repeat the last node"),
    cell_part = whole(mesh$cell_part, "cell", "part that a cell belongs to, from 1"),
    part = file_variable("NC_CHAR", c("letter", "part"), "name of a part in the plan",
      value = enc2utf8(mesh$parts$name)),
    hexagonal_cell = whole(which(has_straight_bars(mesh)), "hexagonal_cell",
      "cells of hexagonal meshes, from 1")
  )
}

# Defines dimensions, variables and global attributes of a new file; the caller defines time.
# Variables with a missing dimension are skipped. `sizes`: further dimensions; `what`: "state" or
# "trajectory".
define_file <- function(nc, variables, sizes, mesh, gear, title, what) {
  length_of <- function(name) length(variables[[name]]$value)
  sizes <- c(
    node = mesh$nodes, part = nrow(mesh$parts), bar_end = 2L, corner = 4L,
    letter = max(nchar(variables$part$value, "bytes")),
    hexagonal_cell = length_of("hexagonal_cell"), sizes,
    saved_byte = length_of("saved_form"), saved_number = length_of("saved_numbers"),
    saved_integer = length_of("saved_integers")
  )
  sizes <- sizes[sizes > 0L]
  for (name in names(sizes)) RNetCDF::dim.def.nc(nc, name, sizes[[name]])
  variables <- Filter(function(of) all(of$across %in% c("time", names(sizes))), variables)
  for (name in names(variables)) {
    of <- variables[[name]]
    RNetCDF::var.def.nc(nc, name, of$type, if (length(of$across)) of$across else NA)
    put_attributes(nc, name, c(units = of$unit, long_name = of$words))
    if (!is.null(of$error)) RNetCDF::att.put.nc(nc, name, "error", "NC_DOUBLE", of$error)
  }
  put_attributes(nc, "z_m", c(positive = "up"))
  put_attributes(nc, "part", c("_Encoding" = "utf-8"))
  put_attributes(nc, "NC_GLOBAL", c(Conventions = "CF-1.10", title = title,
    source = paste("codend", utils::packageVersion("codend")), plan = enc2utf8(format(gear))))
  RNetCDF::att.put.nc(nc, "NC_GLOBAL", paste0("codend_", what), "NC_INT",
    saved_format[[what]])
}

put_attributes <- function(nc, variable, texts) {
  for (name in names(texts)) RNetCDF::att.put.nc(nc, variable, name, "NC_CHAR", texts[[name]])
}

# ---- private data of codend ----------------------------------------------------------------------

# Returns variables that store a list with its gear and mesh.
saved_variables <- function(what) {
  what$plan_text <- enc2utf8(format(what$gear))
  what$plan_file <- what$gear$file
  if (!is.null(what$gear$source)) what$plan_source <- enc2utf8(what$gear$source)
  if (!is.null(what$mesh)) what$recipe <- mesh_recipe(what$mesh)
  what$gear <- what$mesh <- NULL
  flat <- flatten_tree(what)
  list(
    saved_form = file_variable("NC_CHAR", "saved_byte", "structure of the stored data, as JSON",
      value = charToRaw(flat$form)),
    saved_numbers = file_variable("NC_DOUBLE", "saved_number", "its real numbers",
      value = flat$numbers),
    saved_integers = file_variable("NC_INT", "saved_integer", "its integers and logical values",
      value = flat$integers)
  )
}

read_saved_variables <- function(get) {
  text <- rawToChar(as.raw(get("saved_form", rawchar = TRUE)))
  Encoding(text) <- "UTF-8"
  # NA_integer_ is stored as the smallest integer, so the conversion warns
  integers <- suppressWarnings(as.integer(get("saved_integers")))
  what <- build_tree(text, as.vector(get("saved_numbers")), integers, stop)
  gear <- gear_of_text(what$plan_text, what$plan_file, what$plan_source)
  what <- c(list(gear = gear), what)
  what$si <- first_of(what$si, gear_si(gear))
  what[setdiff(names(what), c("plan_text", "plan_file", "plan_source"))]
}

gear_of_text <- function(text, file, source) {
  if (!is_text(text)) stop("it holds no plan")
  if (!is.null(source) && !is_text(source)) stop("its plan has no text")
  gear <- gear_of_bytes(charToRaw(enc2utf8(text)), "plan", file)
  gear["source"] <- list(source)
  gear
}
