# Writes the ropes of a state as a MoorDyn 2 file. Returns `file`, invisibly.
write_moordyn <- function(state, file) {
  deck <- moordyn_deck(state)
  water <- state$mesh$model$water
  if (any(c(water$x, water$y) != 0)) write_moordyn_currents(water, file)
  write_file(file, function(path) writeLines(deck, path))
}

# Writes the current profile of a file. A different profile in the folder is an error, because other
# files may use it.
write_moordyn_currents <- function(water, file) {
  rows <- order(-water$depth)
  lines <- c(
    "Flow past the gear, written by codend", "x aft, y to starboard, z up",
    "z (m), ux (m/s), uy (m/s), uz (m/s)",
    moordyn_rows(list(-water$depth[rows], water$x[rows], water$y[rows], 0))
  )
  profile <- file.path(dirname(file), moordyn_currents)
  if (basename(file) == moordyn_currents) {
    abort_file(file, "must not have the name of MoorDyn's file of currents.")
  }
  if (file.exists(profile) && !identical(readLines(profile, warn = FALSE), lines)) {
    abort_file(file, "must be in a folder without another file {.file {profile}} (currents).",
      profile = profile)
  }
  write_file(profile, function(path) writeLines(lines, path))
}

moordyn_rows <- function(columns) {
  columns <- lapply(columns, function(x) if (is.numeric(x)) plain_number(x) else x)
  do.call(paste, columns)
}

moordyn_deck <- function(state) {
  si <- state$si
  ropes <- moordyn_ropes(state)
  if (!length(ropes)) {
    abort_argument("{.arg state} has no free rope; MoorDyn files hold only ropes that are not laced
      to netting.")
  }
  if (!is.null(si$ground) && si$ground$normal[3L] < 1) {
    abort_argument("The sea bed of {.arg state} slopes; MoorDyn files support a level sea bed
      only.")
  }
  points <- moordyn_points(state, ropes)
  type <- vapply(ropes, function(rope) moordyn_type(si$ropes[[rope$name]], si), "")
  types <- unique(type)
  lines <- moordyn_rows(list(
    seq_along(ropes), paste0("type", match(type, types)),
    match(vapply(ropes, function(rope) rope$node[1L], 0L), points$node),
    match(vapply(ropes, function(rope) rope$node[length(rope$node)], 0L), points$node),
    vapply(ropes, `[[`, 0, "length"), vapply(ropes, function(rope) length(rope$node) - 1, 0), "-"
  ))
  water <- state$mesh$model$water
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
      # A depth below the whole gear, since there is no sea bed.
      list(1000 + ceiling(max(-state$position[3L, ])), "WtrDpth")
    } else {
      list(c(-si$ground$height, si$ground$stiffness, si$ground$friction),
        c("WtrDpth", "kBot", "FrictionCoefficient"))
    }),
    if (any(c(water$x, water$y) != 0)) "1 Currents",
    "---------------------- need this line ------------------------"
  )
}

# Returns a rope's properties as a row of line types, without its name.
moordyn_type <- function(rope, si) {
  # MoorDyn's diameter is the diameter of the volume.
  diameter <- sqrt(4 / pi * rope$volume_per_length)
  drag <- rope_drag_coefficients(rope, si) * rope$diameter / diameter
  moordyn_rows(list(
    diameter, rope$mass_per_length, rope$axial_stiffness,
    if (rope$damping > 0) rope$damping else -1, rope$bending_stiffness,
    drag[["across"]], rope$added_mass[["normal"]],
    drag[["along"]] / pi, rope$added_mass[["tangential"]]
  ))
}

# Returns the drag coefficients of a rope across and along the flow, on diameter times length. They
# belong to the greatest of the towing and current speeds, and to 1 m/s in still water.
rope_drag_coefficients <- function(rope, si) {
  speed <- flow_speed(si)
  reynolds <- (if (speed > 0) speed else 1) * rope$diameter / si$water$viscosity
  drag <- rope$coefficients
  coefficients <- if (drag$law == "constant") drag else drag$law
  found <- twine_specimens(coefficients, c(across = pi / 2, along = 0), reynolds, 0)$drag
  setNames(found, c("across", "along"))
}

# Returns the stretches of ropes between points: a list of list(name, node (from its start on),
# length (m, unstretched)).
moordyn_ropes <- function(state) {
  mesh <- state$mesh
  model <- mesh$model
  names <- names(Filter(function(rope) is.null(rope$along) && !rope$strut, state$si$ropes))
  sliding <- names[lengths(lapply(state$si$ropes[names], `[[`, "through")) > 0L]
  if (length(sliding)) {
    abort_argument("Rope {.val {sliding[1L]}} slides through rings, which MoorDyn does not
      support.")
  }
  path <- lapply(mesh$ropes[names], `[[`, "node")
  ends <- unlist(lapply(path, function(node) node[c(1L, length(node))]))
  all <- unlist(path)
  stops <- unique(c(ends, all[duplicated(all)], model$spheres$node, moordyn_held(state, names)))
  unlist(lapply(names, function(name) {
    node <- path[[name]]
    rest <- model$bars$rest[bars_of_part(state, rope_part(mesh, name))]
    at <- which(node %in% stops)
    lapply(seq_len(length(at) - 1L), function(k) {
      within <- at[k]:at[k + 1L]
      list(name = name, node = node[within], length = sum(rest[within[-1L] - 1L]))
    })
  }), recursive = FALSE)
}

rope_part <- function(mesh, name) {
  which(mesh$parts$kind == "rope" & mesh$parts$name == name)
}

# Returns the nodes to be fixed because MoorDyn lacks a force on them. ropes: names of written
# ropes.
moordyn_held <- function(state, ropes) {
  mesh <- state$mesh
  model <- mesh$model
  written <- mesh$bar_part %in% vapply(ropes, rope_part, 0L, mesh = mesh)
  unique(c(
    which(model$held), bar_ends(state, which(!written)), model$cells$node, model$blended$node,
    model$lifts$node, model$plates$node, unlist(model$ties[c("first", "second")]),
    which(colSums(abs(matrix(point_loads(state), 3L))) > 0)
  ))
}

# Returns the loads of the plan's points (3 x nodes, N).
point_loads <- function(state) {
  load <- matrix(0, 3L, ncol(state$position))
  for (name in names(state$si$points)) {
    node <- state$mesh$points[[name]]
    load[, node] <- load[, node] + state$si$points[[name]]$load
  }
  load
}

# Returns the points at the ends of stretches. area: for CdA; added: for Ca.
moordyn_points <- function(state, ropes) {
  model <- state$mesh$model
  node <- unique(unlist(lapply(ropes, function(rope) rope$node[c(1L, length(rope$node))])))
  of_ropes <- function(each) {
    share <- lapply(ropes, function(rope) {
      each(state$si$ropes[[rope$name]]) * rope$length / (length(rope$node) - 1L) / 2
    })
    ends <- unlist(lapply(ropes, function(rope) rope$node[c(1L, length(rope$node))]))
    vapply(node, function(one) sum(rep(unlist(share), each = 2L)[ends == one]), 0)
  }
  volumes <- model$volumes
  buoyancy <- vapply(node, function(one) sum(volumes$buoyancy[volumes$node == one]), 0)
  weight <- model$water$density * gear_gravity
  volume <- if (weight > 0) buoyancy / weight else numeric(length(node))
  spheres <- function(value) {
    vapply(node, function(one) sum(value[model$spheres$node == one]), 0)
  }
  # Differences as small as rounding errors become 0.
  left <- function(x, of) ifelse(x < 1e-9 * of, 0, signif(x, 12L))
  mass <- left(model$mass[node] - of_ropes(function(rope) rope$mass_per_length), model$mass[node])
  volume <- left(volume - of_ropes(function(rope) rope$volume_per_length), volume)
  held <- node %in% moordyn_held(state, unique(vapply(ropes, `[[`, "", "name")))
  at <- state$position[, node, drop = FALSE]
  data.frame(
    node = node, attachment = ifelse(held, "Fixed", "Free"), x = at[1L, ], y = at[2L, ],
    z = at[3L, ], mass = ifelse(held, 0, mass), volume = ifelse(held, 0, volume),
    area = ifelse(held, 0, spheres(model$spheres$drag_area)),
    added = ifelse(held | volume == 0, 0, spheres(model$spheres$added_mass) / volume)
  )
}
