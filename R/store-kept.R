# What the files of states and trajectories share: how they are opened and what codend itself keeps
# in them, as plain data. Nothing in a file is evaluated.

# Writes a file and seals it; fill: as in write_netcdf().
write_kept <- function(file, fill) {
  write_file(file, function(path) {
    fill_netcdf(path, fill)
    seal_file(path)
  })
}

# Formats that this codend reads; it writes the last. States of format 7, moments of tows of format
# 8 and trajectories up to format 11 hold the arrays of their mesh.
kept_versions <- list(state = 7:9, trajectory = 10:12)

# An open NetCDF file as this version of codend keeps it, with the attributes `what` ("state" or
# "trajectory") and `records`, their number. A trajectory without a seal is one of a run that was
# killed; where the machine stopped too, its last records may be missing.
open_kept <- function(file) {
  check_netcdf()
  if (!is_text(file) || !file.exists(file)) abort_file(file, "does not exist.")
  if (is.na(file_size(file))) abort_file(file, "is a folder or no regular file.")
  magic <- readBin(file, "raw", 4L)
  if (!identical(magic, c(charToRaw("CDF"), as.raw(2L)))) {
    abort_file(file, "is no NetCDF file of codend.")
  }
  seal <- seal_of(file)
  if (seal == "broken") abort_damaged(file, "its checksum does not fit")
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
  versions <- Filter(Negate(is.null), lapply(setNames(nm = names(kept_versions)), version_of))
  if (length(versions) != 1L) refuse("holds no state or trajectory of codend.")
  what <- names(versions)
  version <- versions[[what]]
  known <- kept_versions[[what]]
  if (!(length(version) == 1L && version %in% known)) {
    refuse(paste("is of format {version}; this codend reads format {.or {known}} alone.",
      if (all(version < 3)) "Older ones held objects of R, which reading would have run."),
      version = version, known = known)
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

# Reads with a function(get) of an open file's variables; closes it. Whatever does not fit is told
# as damage.
read_kept <- function(nc, file, read) {
  on.exit(RNetCDF::close.nc(nc))
  tryCatch(read(file_getter(nc)), error = function(e) {
    if (inherits(e, "codend_error_file")) stop(e)
    abort_damaged(file, sub("[.[:space:]]+$", "", conditionMessage(e)))
  })
}

# A function(name, start, count) that gives a variable's numbers, none where it is not in the file.
file_getter <- function(nc) {
  info <- RNetCDF::file.inq.nc(nc)
  known <- vapply(seq_len(info$nvars) - 1L, function(id) RNetCDF::var.inq.nc(nc, id)$name, "")
  function(name, start = NA, count = NA, rawchar = FALSE) {
    if (!name %in% known) return(numeric())
    RNetCDF::var.get.nc(nc, name, start, count, na.mode = 3, rawchar = rawchar, collapse = FALSE)
  }
}

# ---- what files hold -----------------------------------------------------------------------------

# A variable of a file. across: names of its dimensions; words, unit: NULL for none.
file_variable <- function(type, across, words = NULL, unit = NULL, value = NULL) {
  list(type = type, across = across, words = words, unit = unit, value = value)
}

# The variables of a gear's model, by name.
model_variables <- function(lattice) {
  mesh <- lattice$mesh
  whole <- function(value, across, words) file_variable("NC_INT", across, words, value = value)
  list(
    bar_node = whole(matrix(mesh$bars$node, 2L), c("bar_end", "bar"),
      "nodes that a bar joins, from 1"),
    bar_part = whole(lattice$bar_part, "bar", "part that a bar belongs to, from 1"),
    cell_node = whole(matrix(mesh$cells$node, 4L), c("corner", "cell"),
      "nodes at a cell's corners, from 1; of three the last is there twice"),
    cell_part = whole(lattice$cell_part, "cell", "part that a cell belongs to, from 1"),
    part_name = file_variable("NC_CHAR", c("letter", "part"), "name of a part in the plan",
      value = enc2utf8(lattice$parts$name))
  )
}

# Defines a new file: its dimensions but for time, those of the variables that have all of theirs,
# and what every file says. sizes: of more dimensions; what: "state" or "trajectory".
define_file <- function(nc, variables, sizes, lattice, gear, title, what) {
  length_of <- function(name) length(variables[[name]]$value)
  sizes <- c(
    node = lattice$nodes, part = nrow(lattice$parts), bar_end = 2L, corner = 4L,
    letter = max(nchar(variables$part_name$value, "bytes")), sizes,
    kept_byte = length_of("kept_form"), kept_number = length_of("kept_numbers"),
    kept_integer = length_of("kept_integers")
  )
  sizes <- sizes[sizes > 0L]
  for (name in names(sizes)) RNetCDF::dim.def.nc(nc, name, sizes[[name]])
  variables <- Filter(function(of) all(of$across %in% c("time", names(sizes))), variables)
  for (name in names(variables)) {
    of <- variables[[name]]
    RNetCDF::var.def.nc(nc, name, of$type, if (length(of$across)) of$across else NA)
    put_texts(nc, name, c(units = of$unit, long_name = of$words))
  }
  put_texts(nc, "z", c(positive = "up"))
  put_texts(nc, "NC_GLOBAL", c(Conventions = "CF-1.10", title = title,
    source = paste("codend", utils::packageVersion("codend")), plan = enc2utf8(format(gear))))
  RNetCDF::att.put.nc(nc, "NC_GLOBAL", paste0("codend_", what), "NC_INT",
    max(kept_versions[[what]]))
}

# Attributes of a variable, texts by name.
put_texts <- function(nc, variable, texts) {
  for (name in names(texts)) RNetCDF::att.put.nc(nc, variable, name, "NC_CHAR", texts[[name]])
}

# ---- what codend keeps for itself ---------------------------------------------------------------

# The variables of what is kept, with a gear and a lattice.
kept_numbers <- function(what) {
  what$plan_text <- enc2utf8(format(what$gear))
  what$plan_file <- what$gear$file
  if (!is.null(what$gear$source)) what$plan_source <- enc2utf8(what$gear$source)
  if (!is.null(what$lattice)) what$mesh <- mesh_recipe(what$lattice)
  what$gear <- what$lattice <- NULL
  what$levels_in_si <- TRUE
  flat <- flatten_tree(what)
  list(
    kept_form = file_variable("NC_CHAR", "kept_byte", "form of what codend reads again, as JSON",
      value = charToRaw(flat$form)),
    kept_numbers = file_variable("NC_DOUBLE", "kept_number", "its numbers", value = flat$numbers),
    kept_integers = file_variable("NC_INT", "kept_integer", "its whole numbers and truth values",
      value = flat$integers)
  )
}

read_kept_numbers <- function(get) {
  text <- rawToChar(as.raw(get("kept_form", rawchar = TRUE)))
  Encoding(text) <- "UTF-8"
  # NA is the least of all integers
  integers <- suppressWarnings(as.integer(get("kept_integers")))
  what <- build_tree(text, as.vector(get("kept_numbers")), integers, stop)
  gear <- gear_of_text(what$plan_text, what$plan_file, what$plan_source)
  what <- c(list(gear = gear), what)
  what$si <- first_of(what$si, gear_si(gear))
  if (is.null(what$mesh)) what <- with_kept_lattice(what)
  what[setdiff(names(what), c("plan_text", "plan_file", "plan_source", "places", "levels_in_si"))]
}

# What a file of an older format keeps, with a recipe in place of its lattice.
with_kept_lattice <- function(what) {
  old <- what$lattice
  if (!inherits(old, "codend_lattice")) stop("it holds no model")
  fields <- old$engine
  # Files of before crossings of knotless netting counted once in wakes.
  if (is.null(fields$wake_sheets$overlap)) {
    fields$wake_sheets$overlap <- numeric(length(fields$wake_sheets$law))
  }
  # Files of before levels' measures were kept in SI.
  if (is.null(what$levels_in_si)) what <- with_levels_in_si(what)
  old$mesh <- engine_mesh(fields)
  fields <- engine_mesh_fields(old$mesh)
  what$mesh <- mesh_recipe(old)
  again <- engine_mesh_fields(lattice_of_recipe(what$si, what$mesh)$mesh)
  if (length(again$mass) != length(fields$mass)) stop("its nodes do not fit")
  what$mesh$changes <- fields[!mapply(identical, fields, again[names(fields)])]
  what$lattice <- NULL
  what
}

# What a file keeps with its measures of other lattices in the units that they are shown in.
with_levels_in_si <- function(what) {
  kinds <- measured_kinds(what$si)
  size <- setNames(vapply(measure_units(kinds), unit_size, 0), names(kinds))
  named_in_si <- function(values) if (!is.null(values)) values * unname(size[names(values)])
  in_si <- function(levels) {
    lapply(levels, function(level) {
      level$values <- named_in_si(level$values)
      level
    })
  }
  what$levels <- in_si(what$levels)
  compared <- what$compared
  if (is.null(compared$time)) {
    if (!is.null(compared)) compared$levels <- in_si(compared$levels)
    compared$values <- named_in_si(compared$values)
  } else {
    compared$values <- compared$values * unname(size[compared$measures])
    compared$last <- named_in_si(compared$last)
  }
  what$compared <- compared
  what
}

gear_of_text <- function(text, file, source) {
  if (!is_text(text)) stop("it holds no plan")
  if (!is.null(source) && !is_text(source)) stop("its plan has no text")
  gear <- gear_of_bytes(charToRaw(enc2utf8(text)), "plan", file)
  gear["source"] <- list(source)
  gear
}
