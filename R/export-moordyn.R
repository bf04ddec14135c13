# Writes the ropes of a state as a file of MoorDyn 2. Returns `file`, invisibly.
write_moordyn <- function(state, file) {
  deck <- moordyn_deck(state)
  water <- state$lattice$mesh$water
  if (any(c(water$x, water$y) != 0)) write_moordyn_currents(water, file)
  write_file(file, function(path) writeLines(deck, path))
}

# The profile that goes with a file. Other files of the folder may need the one that is there.
write_moordyn_currents <- function(water, file) {
  rows <- order(-water$depth)
  lines <- c(
    "Water that flows past the gear, by codend", "x aft, y to starboard, z up",
    "z (m), ux (m/s), uy (m/s), uz (m/s)",
    moordyn_rows(list(-water$depth[rows], water$x[rows], water$y[rows], 0))
  )
  profile <- file.path(dirname(file), moordyn_currents)
  if (basename(file) == moordyn_currents) {
    abort_file(file, "must have another name than that of MoorDyn's currents.")
  }
  if (file.exists(profile) && !identical(readLines(profile, warn = FALSE), lines)) {
    abort_file(file, "must lie in a folder without the currents of another, {.file {profile}}.",
      profile = profile)
  }
  write_file(profile, function(path) writeLines(lines, path))
}

# Rows of a table from its columns, as text.
moordyn_rows <- function(columns) {
  columns <- lapply(columns, function(x) if (is.numeric(x)) plain_number(x) else x)
  do.call(paste, columns)
}

# The lines of the file.
moordyn_deck <- function(state) {
  si <- state$si
  ropes <- moordyn_ropes(state)
  if (!length(ropes)) {
    abort_argument("{.arg state} has no rope that is not laced to netting, for MoorDyn.")
  }
  if (!is.null(si$ground) && si$ground$normal[3L] < 1) {
    abort_argument("The sea bed of {.arg state} slopes, which MoorDyn's file cannot say.")
  }
  points <- moordyn_points(state, ropes)
  type <- vapply(ropes, function(rope) moordyn_type(si$ropes[[rope$name]]), "")
  types <- unique(type)
  lines <- moordyn_rows(list(
    seq_along(ropes), paste0("type", match(type, types)),
    match(vapply(ropes, function(rope) rope$node[1L], 0L), points$node),
    match(vapply(ropes, function(rope) rope$node[length(rope$node)], 0L), points$node),
    vapply(ropes, `[[`, 0, "length"), vapply(ropes, function(rope) length(rope$node) - 1, 0), "-"
  ))
  water <- state$lattice$mesh$water
  c(
    "--------------------- MoorDyn Input File ---------------------",
    paste("Ropes of", gsub("[[:cntrl:]]", " ", si$name), "by codend"),
    "---------------------- LINE TYPES ----------------------------",
    "TypeName Diam Mass/m EA BA/-zeta EI Cd Ca CdAx CaAx",
    "(name) (m) (kg/m) (N) (N-s/-) (N-m^2) (-) (-) (-) (-)",
    paste0("type", seq_along(types), " ", types),
    "---------------------- POINTS --------------------------------",
    "ID Attachment X Y Z Mass Volume CdA Ca", "(#) (-) (m) (m) (m) (kg) (m^3) (m^2) (-)",
    moordyn_rows(c(list(seq_along(points$node)), points[-1L])),
    "---------------------- LINES ---------------------------------",
    "ID LineType AttachA AttachB UnstrLen NumSegs LineOutputs", "(#) (name) (#) (#) (m) (-) (-)",
    lines,
    "---------------------- OPTIONS -------------------------------",
    moordyn_rows(list(c(water$density, gear_gravity), c("WtrDnsty", "g"))),
    moordyn_rows(if (is.null(si$ground)) {
      # below all of it
      list(1000 + ceiling(max(-state$position[3L, ])), "WtrDpth")
    } else {
      list(c(-si$ground$height, si$ground$stiffness, si$ground$friction),
        c("WtrDpth", "kBot", "FrictionCoefficient"))
    }),
    if (any(c(water$x, water$y) != 0)) "1 Currents",
    "---------------------- need this line ------------------------"
  )
}

# What a rope is made of, as a row of line types without its name.
moordyn_type <- function(rope) {
  moordyn_rows(list(
    # the diameter of the volume
    sqrt(4 / pi * rope$volume_per_length), rope$mass_per_length, rope$axial_stiffness,
    if (rope$damping > 0) rope$damping else -1, rope$bending_stiffness,
    rope$coefficients$normal * rope$diameter / sqrt(4 / pi * rope$volume_per_length),
    rope$added_mass[["normal"]],
    rope$coefficients$tangential / pi * rope$diameter / sqrt(4 / pi * rope$volume_per_length),
    rope$added_mass[["tangential"]]
  ))
}

# Stretches of ropes between points: list(name, node (from its start on), length, m, unstretched).
moordyn_ropes <- function(state) {
  lattice <- state$lattice
  mesh <- lattice$mesh
  names <- names(Filter(function(rope) is.null(rope$along) && !rope$strut, state$si$ropes))
  sliding <- names[lengths(lapply(state$si$ropes[names], `[[`, "through")) > 0L]
  if (length(sliding)) {
    abort_argument("Rope {.val {sliding[1L]}} slides through rings, which MoorDyn does not have.")
  }
  path <- lapply(lattice$ropes[names], `[[`, "node")
  ends <- unlist(lapply(path, function(node) node[c(1L, length(node))]))
  all <- unlist(path)
  stops <- unique(c(ends, all[duplicated(all)], mesh$spheres$node, moordyn_held(state, names)))
  unlist(lapply(names, function(name) {
    node <- path[[name]]
    rest <- mesh$bars$rest[bars_of_part(state, rope_part(lattice, name))]
    at <- which(node %in% stops)
    lapply(seq_len(length(at) - 1L), function(k) {
      within <- at[k]:at[k + 1L]
      list(name = name, node = node[within], length = sum(rest[within[-1L] - 1L]))
    })
  }), recursive = FALSE)
}

# The row of a rope in the table of parts.
rope_part <- function(lattice, name) {
  which(lattice$parts$kind == "rope" & lattice$parts$name == name)
}

# Nodes on which something acts that MoorDyn does not have; ropes: names of those that are written.
moordyn_held <- function(state, ropes) {
  lattice <- state$lattice
  mesh <- lattice$mesh
  written <- lattice$bar_part %in% vapply(ropes, rope_part, 0L, lattice = lattice)
  unique(c(
    which(mesh$held), bar_ends(state, which(!written)), mesh$cells$node, mesh$blended$node,
    mesh$lifts$node, mesh$plates$node, unlist(mesh$ties[c("first", "second")]),
    which(colSums(abs(matrix(point_loads(state), 3L))) > 0)
  ))
}

# Loads of the plan's points: 3 x nodes, N.
point_loads <- function(state) {
  load <- matrix(0, 3L, ncol(state$position))
  for (name in names(state$si$points)) {
    node <- state$lattice$points[[name]]
    load[, node] <- load[, node] + state$si$points[[name]]$load
  }
  load
}

# A data frame of the points at the ends of stretches: node, attachment, x, y, z, mass, volume, CdA,
# Ca.
moordyn_points <- function(state, ropes) {
  mesh <- state$lattice$mesh
  node <- unique(unlist(lapply(ropes, function(rope) rope$node[c(1L, length(rope$node))])))
  of_ropes <- function(each) {
    share <- lapply(ropes, function(rope) {
      each(state$si$ropes[[rope$name]]) * rope$length / (length(rope$node) - 1L) / 2
    })
    ends <- unlist(lapply(ropes, function(rope) rope$node[c(1L, length(rope$node))]))
    vapply(node, function(one) sum(rep(unlist(share), each = 2L)[ends == one]), 0)
  }
  volumes <- mesh$volumes
  buoyancy <- vapply(node, function(one) sum(volumes$buoyancy[volumes$node == one]), 0)
  weight <- mesh$water$density * gear_gravity
  volume <- if (weight > 0) buoyancy / weight else numeric(length(node))
  spheres <- function(value) {
    vapply(node, function(one) sum(value[mesh$spheres$node == one]), 0)
  }
  # what rounding leaves of differences is nothing
  left <- function(x, of) ifelse(x < 1e-9 * of, 0, signif(x, 12L))
  mass <- left(mesh$mass[node] - of_ropes(function(rope) rope$mass_per_length), mesh$mass[node])
  volume <- left(volume - of_ropes(function(rope) rope$volume_per_length), volume)
  held <- node %in% moordyn_held(state, unique(vapply(ropes, `[[`, "", "name")))
  at <- state$position[, node, drop = FALSE]
  data.frame(
    node = node, attachment = ifelse(held, "Fixed", "Free"), x = at[1L, ], y = at[2L, ],
    z = at[3L, ], mass = ifelse(held, 0, mass), volume = ifelse(held, 0, volume),
    area = ifelse(held, 0, spheres(mesh$spheres$drag_area)),
    added = ifelse(held | volume == 0, 0, spheres(mesh$spheres$added_mass) / volume)
  )
}
