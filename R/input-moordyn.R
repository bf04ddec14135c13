#' Read a MoorDyn file as a gear
#'
#' Reads the lines, points and water of an input file of MoorDyn 2, a program for mooring lines.
#' [write_result()] writes such files.
#'
#' - Points are named `point_1`, lines `line_1` and so on.
#' - Points that are `Fixed`, or move with a vessel (`Vessel`, `Coupled`), are held at their
#'   position in the file. Free points start at this position and get a piece for their mass, volume
#'   and drag.
#' - `WtrDpth` becomes a seabed with the file's friction (default 0).
#' - `Currents 1` reads `current_profile.txt` from the same folder.
#' - Waves, damping, time steps and outputs are ignored. They do not affect a steady shape.
#'
#' @param file Character: path of the file.
#' @return A gear of class `codend_gear`. An error of class `codend_error_file` is thrown if the
#'   file cannot be read. The same error is thrown for bodies, rods, nonlinear stiffness, a
#'   non-standard gravity or a varying current.
#' @seealso [write_result()] to write MoorDyn files, [settle()] for the shape of the gear.
#' @export
#' @examples
#' file <- file.path(tempdir(), "lines.txt")
#' write_result(settle("towed_cable"), file)
#' read_moordyn(file)
read_moordyn <- function(file) {
  check_given("file")
  if (!is_text(file) || !file.exists(file) || dir.exists(file)) {
    abort_file(file, "must be the path of a file.")
  }
  sections <- moordyn_sections(file)
  options <- moordyn_options(file, sections[["options"]])
  types <- moordyn_table(file, sections, "line types", c("name", "diameter", "mass", "stiffness",
    "damping", "bending", "normal", "added", "along", "added_along"), "name")
  points <- moordyn_table(file, sections, "points", c("id", "held", "x", "y", "z", "mass", "volume",
    "area", "added"), "held")
  lines <- moordyn_table(file, sections, "lines", c("id", "type", "from", "to", "length",
    "segments"), "type")
  tree <- list(
    codend = 1, name = tools::file_path_sans_ext(basename(file)),
    water = list(density = options$density), points = list(), ropes = list(), pieces = list()
  )
  if (options$currents) tree$water$current <- moordyn_current(file)
  if (!is.na(options$depth)) {
    tree$seabed <- list(
      depth = options$depth, friction = options$friction, stiffness = options$stiffness
    )
  }
  for (k in seq_len(nrow(points))) {
    point <- points[k, ]
    name <- paste0("point_", point$id)
    held <- switch(tolower(point$held), fixed = , fix = "fixed", vessel = , coupled = "moved",
      free = , connect = , point = NA_character_,
      abort_file(file, "has point {id} attached to {to}; codend does not support this attachment.",
        id = point$id, to = point$held))
    at <- list(point$x, point$y, point$z)
    tree$points[[name]] <- if (is.na(held)) list(near = at) else list(position = at, held = held)
    if (is.na(held) && any(c(point$mass, point$volume, point$area) > 0)) {
      tree$pieces[[paste0("piece_", point$id)]] <- list(
        at = name, mass = point$mass, volume = point$volume, area = point$area,
        drag_coefficient = 1, added_mass = point$added
      )
    }
  }
  for (k in seq_len(nrow(lines))) {
    line <- lines[k, ]
    type <- types[match(line$type, types$name), ]
    ends <- paste0("point_", c(line$from, line$to))
    if (is.na(type$name)) {
      abort_file(file, "has line {id} of the type {type}, but does not define this type.",
        id = line$id, type = line$type)
    }
    if (!all(ends %in% names(tree$points))) {
      abort_file(file, "has line {id} from {ends[1]} to {ends[2]}, but not both points.",
        id = line$id, ends = ends)
    }
    tree$ropes[[paste0("line_", line$id)]] <- list(
      from = ends[1L], to = ends[2L], length = line$length, diameter = type$diameter,
      axial_stiffness = type$stiffness, mass_per_length = type$mass,
      volume_per_length = pi / 4 * type$diameter^2, bending_stiffness = type$bending,
      # MoorDyn's coefficient refers to the circumference.
      coefficients = list(normal = type$normal, tangential = pi * type$along),
      added_mass = list(normal = type$added, tangential = type$added_along),
      segments = line$segments
    )
  }
  as_gear(tree[lengths(tree) > 0L])
}

# Returns the rows of numbers and words of each section, by name, without comments.
moordyn_sections <- function(file) {
  lines <- readLines(file, warn = FALSE)
  lines <- iconv(lines, "UTF-8", "UTF-8", sub = "?")
  head <- grepl("^\\s*---", lines)
  title <- tolower(lines)
  name <- rep(NA_character_, length(lines))
  known <- c(options = "options", `line types` = "line (types|dictionary)", rods = "rods|rod types",
    bodies = "bodies", points = "(point|connection|node)s?( properties)?\\b",
    lines = "\\blines\\b|line properties")
  for (k in rev(seq_along(known))) name[head & grepl(known[k], title)] <- names(known)[k]
  if (!all(c("line types", "points", "lines") %in% name)) {
    abort_file(file, "must be a MoorDyn file with sections of line types, points and lines.")
  }
  if (any(name %in% c("rods", "bodies"))) {
    abort_file(file, "has {part}; codend does not support them.",
      part = intersect(c("rods", "bodies"), name)[1L])
  }
  section <- cumsum(head)
  rows <- lapply(which(head & !is.na(name)), function(at) {
    body <- lines[section == section[at] & !head]
    if (name[at] != "options") body <- body[-(1:2)]
    body <- trimws(sub("[!#%].*", "", body))
    strsplit(body[nzchar(body)], "[[:space:]]+")
  })
  stats::setNames(rows, name[head & !is.na(name)])
}

# Returns the first columns of a section as a data frame. `words`: columns of strings.
moordyn_table <- function(file, sections, section, columns, words) {
  rows <- sections[[section]]
  short <- which(lengths(rows) < length(columns))
  if (!length(rows) || length(short)) {
    abort_file(file, "must have rows of {count} values under {section}.",
      count = length(columns), section = section)
  }
  cells <- lapply(stats::setNames(seq_along(columns), columns), function(k) {
    vapply(rows, `[`, "", k)
  })
  for (column in setdiff(columns, words)) {
    number <- suppressWarnings(as.numeric(cells[[column]]))
    if (anyNA(number)) {
      abort_file(file, "has {value} as the {column} of {section}; it must be a number.",
        value = cells[[column]][is.na(number)][1L], column = column, section = section)
    }
    cells[[column]] <- number
  }
  as.data.frame(cells)
}

moordyn_currents <- "current_profile.txt"

moordyn_options <- function(file, rows) {
  rows <- rows[lengths(rows) >= 2L]
  names <- tolower(vapply(rows, `[`, "", 2L))
  number <- function(name, default) {
    at <- match(TRUE, names %in% name)
    if (is.na(at)) return(default)
    value <- suppressWarnings(as.numeric(rows[[at]][1L]))
    if (!is.finite(value)) {
      abort_file(file, "has {value} as {name}; it must be a number.", value = rows[[at]][1L],
        name = rows[[at]][2L])
    }
    value
  }
  gravity <- number(c("g", "gravity"), gear_gravity)
  if (abs(gravity / gear_gravity - 1) > 0.005) {
    abort_file(file, "has a gravity of {gravity} m/s2; it must be {own} m/s2.", gravity = gravity,
      own = gear_gravity)
  }
  currents <- number("currents", 0)
  if (!currents %in% 0:1) abort_file(file, "has a time-dependent current; it must be constant.")
  list(
    density = number(c("wtrdnsty", "rhow"), 1025), depth = number("wtrdpth", NA),
    friction = number("frictioncoefficient", 0), stiffness = number("kbot", 3e6),
    currents = currents == 1
  )
}

moordyn_current <- function(file) {
  other <- file.path(dirname(file), moordyn_currents)
  if (!file.exists(other)) abort_file(other, "does not exist, but the MoorDyn file refers to it.")
  rows <- tryCatch(utils::read.table(other, skip = 3L), error = function(e) NULL)
  if (is.null(rows) || ncol(rows) < 3L || !all(vapply(rows[1:3], is.numeric, NA))) {
    abort_file(other, "must have rows of z, ux, uy and uz after three lines.")
  }
  lapply(order(-rows[[1L]]), function(k) {
    list(
      depth = -rows[[1L]][k], speed = sqrt(rows[[2L]][k]^2 + rows[[3L]][k]^2),
      toward = atan2(rows[[3L]][k], rows[[2L]][k])
    )
  })
}
