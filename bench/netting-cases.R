# Netting with a known solution: mesh by mesh, or analytical. Twine has realistic stiffness.

as_gear <- codend:::as_gear

held_at <- function(...) list(position = c(...), held = "fixed")

# A diamond panel of 160 by 90 meshes of 80 mm hung in 0.6 m/s, a chain at its foot.
panel_case <- function(stiffness, netting, columns = NULL) {
  net <- list(
    mesh_size = 0.08, meshes = list(upper = 160, lower = 160, deep = 90), knotted = FALSE,
    netting = netting,
    twine = list(diameter = 0.002, axial_stiffness = stiffness, mass_per_length = 0.0036)
  )
  net$columns <- columns
  as_gear(list(
    codend = 1, name = "Hanging panel", water = list(current = list(speed = 0.6, toward = 0)),
    points = list(a = held_at(0, -4, -1), b = held_at(0, 4, -1)), panels = list(net = net),
    seams = list(beam = list(edges = list("net.upper"), held_between = list("a", "b"))),
    ropes = list(chain = list(
      along = "net.lower", hanging_ratio = 0.625, diameter = 0.016, material = "steel_chain"
    )),
    measures = list(
      width = list(spread = list("chain.start", "chain.end")), net_drag = list(drag = list("net"))
    )
  ))
}

# A tapered cone of four panels behind a square frame, gathered at a drag of 1.5 m2, in 1.5 m/s.
cone_case <- function(stiffness, netting, columns = NULL) {
  sides <- c("top", "right", "bottom", "left")
  net <- list(
    mesh_size = 0.1, meshes = list(upper = 60, lower = 15, deep = 120), knotted = FALSE,
    netting = netting,
    twine = list(diameter = 0.002, axial_stiffness = stiffness, mass_per_length = 0.0036)
  )
  net$columns <- columns
  mouth <- lapply(1:4, function(k) {
    list(edges = list(paste0(sides[k], ".upper")),
      held_between = as.list(paste0("c", c(k - 1, k %% 4))))
  })
  along <- lapply(1:4, function(k) {
    list(edges = list(paste0(sides[k], ".right"), paste0(sides[k %% 4 + 1], ".left")))
  })
  as_gear(list(
    codend = 1, name = "Cone", water = list(current = list(speed = 1.5, toward = 0)),
    points = list(
      c0 = held_at(0, -1.5, -8.5), c1 = held_at(0, 1.5, -8.5), c2 = held_at(0, 1.5, -11.5),
      c3 = held_at(0, -1.5, -11.5), tail = list()
    ),
    panels = stats::setNames(rep(list(net), 4), sides),
    seams = c(
      stats::setNames(mouth, paste0("mouth_", 1:4)), stats::setNames(along, paste0("side_", 1:4)),
      list(end = list(edges = as.list(paste0(sides, ".lower")), gathered_at = "tail"))
    ),
    pieces = list(catch = list(at = "tail", drag_area = 1.5)),
    measures = list(
      length = list(length = list("c0", "tail")), net_drag = list(drag = as.list(sides))
    )
  ))
}

# A square-mesh sheet that sags between two level bars 5 m apart, in 0.4 m/s along it.
sheet_case <- function(stiffness, netting, columns = NULL) {
  net <- list(
    mesh_size = 0.08, meshes = list(upper = 150, lower = 150, deep = 150), orientation = "square",
    knotted = FALSE, netting = netting,
    twine = list(diameter = 0.002, axial_stiffness = stiffness, mass_per_length = 0.012)
  )
  net$columns <- columns
  as_gear(list(
    codend = 1, name = "Sagging sheet",
    water = list(current = list(speed = 0.4, toward = "90 deg")),
    points = list(
      a = held_at(0, 0, -5), b = held_at(6, 0, -5), c = held_at(0, 5, -5), d = held_at(6, 5, -5)
    ),
    panels = list(net = net),
    seams = list(
      one = list(edges = list("net.upper"), held_between = list("a", "b")),
      two = list(edges = list("net.lower"), held_between = list("c", "d"))
    ),
    pieces = list(ball = list(along = "net.left", number = 5, mass = 2, density = 7850)),
    measures = list(net_drag = list(drag = list("net")))
  ))
}

# A closed tube of 48 by 72 diamonds of 0.1 m, full of catch, as `strips` panels of one column each.
tube_case <- function(stiffness, strips) {
  around <- 48
  radius <- tube_radius(around)
  names <- paste0("net_", seq_len(strips))
  ring <- lapply(seq_len(strips), function(k) {
    angle <- 2 * pi * (k - 1) / strips
    list(position = c(0, radius * cos(angle), radius * sin(angle) - 10), held = "moved",
      at = paste0(names[k], ".upper_left"))
  })
  each <- around / strips
  net <- list(
    mesh_size = 0.1, meshes = list(upper = each, lower = each, deep = 72), knotted = FALSE,
    columns = 1, rows = 72 * strips / 48,
    twine = list(diameter = 0.003, axial_stiffness = stiffness, mass_per_length = 0.0072453)
  )
  along <- lapply(seq_len(strips), function(k) {
    list(edges = list(paste0(names[k], ".right"), paste0(names[k %% strips + 1], ".left")))
  })
  as_gear(list(
    codend = 1, name = "Tube", towing = list(speed = 1.5), coefficients = list(normal = 0),
    points = c(stats::setNames(ring, paste0("ring_", seq_len(strips))), list(codline = list())),
    panels = stats::setNames(rep(list(net), strips), names),
    seams = c(stats::setNames(along, paste0("side_", seq_len(strips))), list(
      codline = list(edges = as.list(paste0(names, ".lower")), gathered_at = "codline")
    )),
    catch = list(panels = as.list(names), blocked_meshes = 60)
  ))
}

# Netting under a pressure p on its wall and on its closed end has tan(phi)^2 = 2 and r = N m
# sin(phi) / (2 pi), with mesh size m.
tube_radius <- function(around, size = 0.1) around * size * sqrt(2 / 3) / (2 * pi)

# Bar tensions are p r a / sqrt(2), with a and r of the stretched bar.
tube_tension <- function(stiffness, around = 48, size = 0.1, speed = 1.5) {
  still <- 0.5 * 1.4 * 1025 * speed^2 * tube_radius(around, size) * size / 2 / sqrt(2)
  tension <- still
  for (turn in 1:100) tension <- still * (1 + tension / stiffness)^2
  tension
}
