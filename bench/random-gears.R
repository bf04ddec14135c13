# Random gears of every kind: results of new_plan() over the whole range of its numbers, shipped
# plans and filled codends, with random changes of fields and sea. The number of a gear is its seed
# and gives the same gear on every machine.

# Relative frequency of each kind.
random_kinds <- c(
  bottom_trawl = 4, midwater_trawl = 5, pair_trawl = 2, beam_trawl = 1, cage = 2, gillnet = 2,
  longline = 1, purse_seine = 1, stow_net = 1, dip_net = 1, demersal_seine = 1, twin_trawl = 1,
  triple_rig = 0.5, quad_rig = 0.5, filled_codend = 2, shipped = 3
)
# Drag models that suit any netting.
random_drag_models <- c("morison", "blended", "loland", "aarsnes", "kristiansen_faltinsen")

# Returns gear number `number`. `kind` and `law` restrict the draw to a kind or a drag model
# (longlines have no drag model). By default the kind is random and has its default drag model.
# `changed` also varies the plan. A plan that its checks reject is drawn again. Attributes `drawn`,
# `nodes` and `netting` of the gear are its kind in `random_kinds` and a random mesh.
random_gear <- function(number, kind = NULL, law = NULL, changed = TRUE) {
  set.seed(number, kind = "Mersenne-Twister", normal.kind = "Inversion", sample.kind = "Rejection")
  any_kind <- sample(names(random_kinds), 1L, prob = random_kinds)
  if (is.null(kind)) kind <- any_kind
  nodes <- round(as.numeric(drawn(600, 3000)))
  netting <- sample(c("cells", "bars"), 1L)
  for (attempt in 1:200) {
    gear <- tryCatch(
      suppressWarnings({
        gear <- random_plan(kind)
        if (changed) gear <- changed_gear(gear)
        if (!is.null(law) && kind != "longline") gear <- update(gear, netting_drag = law)
        gear
      }),
      codend_error = function(e) NULL
    )
    if (!is.null(gear)) return(structure(gear, drawn = kind, nodes = nodes, netting = netting))
  }
  stop("no gear of number ", number)
}

random_plan <- function(kind) {
  if (kind == "filled_codend") return(random_codend())
  if (kind == "shipped") return(codend::read_gear(sample(codend::gears()$name, 1L)))
  do.call(codend::new_plan, c(list(kind), random_sizes(kind)))
}

# Returns a gear with random changes: groups of fields in design and sea, and in half of the gears
# up to six single fields.
changed_gear <- function(gear) {
  kind <- if (is.null(gear$plan$kind)) "assembly" else gear$plan$kind
  gear <- do.call(update, c(list(gear), random_changes(kind, gear$plan)))
  if (stats::runif(1) < 0.5) gear <- do.call(update, c(list(gear), random_fields(gear$plan)))
  gear
}

# A log-uniform random number as a string with its unit.
drawn <- function(low, high, unit = "") {
  trimws(paste(signif(exp(stats::runif(1, log(low), log(high))), 4), unit))
}

# Random arguments of new_plan().
random_sizes <- function(kind) {
  bottom <- function(least, most) {
    list(headline = drawn(least, most, "m"), mesh_size = drawn(60, 200, "mm"),
      codend_mesh_size = drawn(40, 58, "mm"), speed = drawn(2, 4.5, "knot"),
      depth = drawn(30, 400, "m"))
  }
  switch(kind,
    bottom_trawl = bottom(8, 80),
    twin_trawl = bottom(8, 40),
    triple_rig = bottom(10, 20),
    quad_rig = bottom(8, 20),
    midwater_trawl = {
      headline <- exp(stats::runif(1, log(15), log(250)))
      list(
        headline = paste(signif(headline, 4), "m"),
        mesh_size = drawn(max(0.4, headline / 60), min(64, headline / 4), "m"),
        codend_mesh_size = drawn(30, 60, "mm"), speed = drawn(2.8, 5, "knot"),
        depth = drawn(60, 300, "m")
      )
    },
    pair_trawl = utils::modifyList(bottom(10, 60),
      list(speed = drawn(1.5, 4, "knot"), depth = drawn(30, 90, "m"))),
    demersal_seine = utils::modifyList(bottom(20, 60),
      list(rope = drawn(1000, 3000, "m"), speed = drawn(1, 3, "knot"),
        depth = drawn(20, 160, "m"))),
    beam_trawl = list(
      beam = drawn(2, 12, "m"), mesh_size = drawn(60, 150, "mm"),
      codend_mesh_size = drawn(40, 58, "mm"), speed = drawn(2, 6, "knot"),
      depth = drawn(10, 100, "m")
    ),
    cage = list(
      diameter = drawn(15, 60, "m"), depth = drawn(6, 25, "m"), mesh_size = drawn(20, 80, "mm"),
      current = drawn(0.02, 1, "m/s")
    ),
    gillnet = list(
      length = drawn(20, 100, "m"), height = drawn(1.5, 8, "m"), mesh_size = drawn(60, 250, "mm"),
      depth = drawn(10, 200, "m"), current = drawn(0.02, 0.6, "m/s")
    ),
    longline = list(
      baskets = random_count(1, 200), branch_lines = random_count(1, 200),
      main_line = drawn(300, 3000, "m"), branch_line = drawn(5, 30, "m")
    ),
    purse_seine = list(
      length = drawn(150, 600, "m"), depth = drawn(25, 80, "m"), mesh_size = drawn(12, 60, "mm")
    ),
    stow_net = list(
      width = drawn(4, 16, "m"), height = drawn(2.5, 10, "m"), mesh_size = drawn(100, 300, "mm"),
      codend_mesh_size = drawn(15, 50, "mm"), current = drawn(0.3, 1.5, "m/s")
    ),
    dip_net = list(
      diameter = drawn(1.5, 6, "m"), depth = drawn(0.75, 3, "m"),
      bridles.number = sample(3:12, 1L)
    )
  )
}

# A log-uniform random count.
random_count <- function(low, high) {
  as.integer(round(exp(stats::runif(1, log(low - 0.4), log(high + 0.4)))))
}

# A codend of 100 meshes deep behind a round entrance, filled to 50 to 75 meshes.
random_codend <- function() {
  strips <- sample(c(4L, 8L, 16L), 1L)
  around <- strips * round(100 / strips)
  mesh <- exp(stats::runif(1, log(0.05), log(0.15)))
  net <- list(
    mesh_size = paste(round(1000 * mesh), "mm"),
    meshes = list(upper = around / strips, lower = around / strips, deep = 100),
    orientation = sample(c("diamond", "turned"), 1L),
    twine = list(diameter = drawn(2, 6, "mm"), material = sample(c("PE", "PA"), 1L),
      double = stats::runif(1) < 0.5)
  )
  # The entrance opens the meshes to 0.2 to 0.5 of the stretched circumference.
  radius <- around * mesh * stats::runif(1, 0.2, 0.5) / (2 * pi)
  angle <- 2 * pi * (seq_len(strips) - 1) / strips
  name <- paste0("net_", seq_len(strips))
  ends <- paste0(name, ".upper_left")
  ring <- lapply(seq_len(strips), function(k) {
    list(position = c(0, radius * cos(angle[k]), radius * sin(angle[k]) - 60), held = "moved",
      at = ends[k])
  })
  sides <- lapply(seq_len(strips), function(k) {
    list(edges = list(paste0(name[k], ".right"), paste0(name[k %% strips + 1L], ".left")))
  })
  end <- list(edges = as.list(paste0(name, ".lower")), gathered_at = "codline")
  codend::gear("Filled codend", towing = list(speed = drawn(0.7, 2.2, "m/s")),
    points = c(stats::setNames(ring, paste0("ring_", seq_len(strips))), list(codline = list())),
    panels = stats::setNames(rep(list(net), strips), name),
    seams = c(stats::setNames(sides, paste0("side_", seq_len(strips))), list(codline = end)),
    catch = list(panels = as.list(name), blocked_meshes = round(stats::runif(1, 50, 75), 1))
  )
}

# The values of a plan by their paths.
given_fields <- function(plan) {
  leaves <- codend:::plan_leaves(plan)
  stats::setNames(leaves$value, leaves$path)
}

# Three to ten single fields of a plan, each changed by a factor of up to 2: any field with a
# number that a study can vary.
random_fields <- function(plan) {
  fields <- given_fields(plan)[codend:::given_paths(plan)]
  fields <- fields[grepl("^[0-9.]+(e-?[0-9]+)?( [^ ]+)?$", vapply(fields, paste, ""))]
  if (identical(plan$otter_boards$attitude, "free")) {
    fields <- fields[!grepl("^(otter_boards|towing)[.]", names(fields))]
  }
  chosen <- sample(names(fields), min(length(fields), sample(3:10, 1L)))
  Map(scaled_value, fields[chosen], exp(stats::runif(length(chosen), -log(2), log(2))))
}

# Random changes of plan fields, selected by patterns of their paths. Each group of fields changes
# in half of the gears, all by one factor.
random_changes <- function(kind, plan) {
  fields <- given_fields(plan)
  changes <- list()
  scale <- function(pattern, low, high, chance = 0.5) {
    factor <- exp(stats::runif(1, log(low), log(high)))
    if (stats::runif(1) >= chance) return(invisible())
    for (path in grep(pattern, names(fields), value = TRUE, perl = TRUE)) {
      value <- if (is.null(changes[[path]])) fields[[path]] else changes[[path]]
      changes[[path]] <<- scaled_value(value, factor)
    }
  }
  # Boards as rigid bodies on a warp keep their speed. At less than 1/3 of the speed they fall over,
  # and the gear has no equilibrium.
  free <- kind %in% c("bottom_trawl", "midwater_trawl") && stats::runif(1) < 0.15
  scale("(towing|current)[.]speed$", 0.3, 2, chance = if (free) 0 else 0.5)
  scale("twine[.]diameter$", 0.7, 1.5)
  scale("^(headline|footrope|side_lines)[.](length|hanging_ratio)$", 0.93, 1.05)
  scale("^belly_lines[.]hanging_ratio$", 0.93, 1.05)
  scale("^(hammers|weights|shoes|centre_weight|hooks)[.]mass$", 0.5, 2)
  scale("^ground_gear[.]mass_in_water$", 0.5, 2)
  scale("^(floats|sinkers)[.]number$", 0.5, 2)
  scale("^warps?[.]length$", 0.7, 1.4)
  if (!free) scale("^otter_boards[.]area$", 0.5, 2)
  scale("^otter_boards[.]mass$", 0.7, 1.5)

  materials <- c("PA", "PE", "PP", "PES", "HMPE", "steel_wire", "combination_rope")
  of <- "^(headline|footrope|side_lines|belly_lines|bridles.*|hand_ropes.*|sweeps)[.]material$"
  for (path in grep(of, names(fields), value = TRUE)) {
    if (stats::runif(1) < 0.2) changes[[path]] <- sample(materials, 1L)
  }
  trawl <- grepl("trawl$", kind)
  if (stats::runif(1) < 0.3) {
    if (!is.null(fields[["water.current.toward"]])) {
      changes[["water.current.toward"]] <- drawn(1, 359, "deg")
    } else if (kind %in% c("bottom_trawl", "midwater_trawl", "pair_trawl")) {
      changes[["water.current"]] <- list(
        speed = drawn(0.05, 0.5, "knot"), toward = drawn(1, 359, "deg")
      )
    }
  }
  if (trawl && stats::runif(1) < 0.25) {
    changes$catch <- list(
      mass = drawn(50, 5000, "kg"), density = "1050 kg/m3", diameter = drawn(0.3, 2, "m")
    )
  }
  if (free) changes$otter_boards <- free_boards(plan$otter_boards)
  changes
}

# The boards of a plan as rigid bodies with the same area and mass.
free_boards <- function(boards) {
  area <- as.numeric(sub(" .*", "", boards$area))
  span <- sqrt(1.6 * area)
  chord <- area / span
  place <- function(aft, up, inward) {
    lapply(list(aft = aft * chord, up = up * span, inward = inward * chord), function(x) {
      paste(signif(x, 4), "m")
    })
  }
  list(
    attitude = "free", chord = paste(signif(chord, 4), "m"), span = paste(signif(span, 4), "m"),
    mass = boards$mass, density = boards$density, polar = "high_lift",
    warp_at = place(0.3, 0, 0.25), upper_backstrop_at = place(0.9, 0.3, 0.05),
    lower_backstrop_at = place(0.9, -0.3, 0.05)
  )
}

# A plan's value, as "12 m2" or a number, times a factor; integers remain integers.
scaled_value <- function(value, factor) {
  if (is.integer(value)) return(max(1L, as.integer(round(value * factor))))
  if (is.numeric(value)) return(signif(value * factor, 6))
  number <- sub(" .*", "", value)
  paste0(signif(as.numeric(number) * factor, 6), substring(value, nchar(number) + 1L))
}

# Returns rig number `number`: 2 to 4 nets of the shipped twin trawl side by side between two doors.
# A warp ends at each door and at a clump between two nets. Warps, sweeps and weights are random.
# `fault` is "none", "clump" (one clump is lost), "net" (one net is torn off at one side) or NULL
# for a random one; attribute `fault` of the gear is that of the result.
random_rig <- function(number, fault = NULL) {
  set.seed(number, kind = "Mersenne-Twister", normal.kind = "Inversion", sample.kind = "Rejection")
  twin <- codend::read_gear("twin_trawl")$plan
  nets <- sample(2:4, 1L)
  drawn_fault <- sample(c("none", "clump", "net"), 1L)
  if (is.null(fault)) fault <- drawn_fault
  faulty <- sample(nets - 1L, 1L)
  between <- seq_len(nets - 1L)
  ends <- c("door_port", paste0("clump_", between), "door_starboard")
  net <- twin$gears$port
  net$sweeps$length <- drawn(30, 80, "m")
  net$floats$number <- sample(10:24, 1L)
  first <- c(net[names(net) != "joined"], list(joined = list()))
  gears <- c(list(first), rep(list(list(like = "net_1", joined = list())), nets - 1L))
  names(gears) <- paste0("net_", seq_len(nets))
  for (k in seq_len(nets)) {
    gears[[k]]$joined <- list(board_port = ends[k], board_starboard = ends[k + 1L])
  }
  if (fault == "net") gears[[faulty]]$joined$board_starboard <- "torn"
  across <- seq(-4, 4, length.out = nets + 1L) * nets / 2
  winches <- lapply(across, function(y) list(position = list(0, y, 0), held = "moved"))
  names(winches) <- paste0("winch_", seq_along(ends))
  free <- c(ends, if (fault == "net") "torn")
  points <- c(winches, stats::setNames(rep(list(stats::setNames(list(), character())),
    length(free)), free))
  warps <- lapply(seq_along(ends), function(k) {
    list(from = names(winches)[k], to = ends[k], length = drawn(285, 315, "m"), diameter = "20 mm",
      material = "steel_wire", role = "warp")
  })
  names(warps) <- paste0("warp_", seq_along(ends))
  pieces <- twin$pieces[c("door_port", "door_starboard")]
  door_size <- as.numeric(drawn(0.8, 1.4)) * nets / 2
  for (door in names(pieces)) pieces[[door]]$area <- scaled_value(pieces[[door]]$area, door_size)
  clumps <- lapply(between, function(k) {
    utils::modifyList(twin$pieces$clump, list(at = ends[k + 1L], mass = drawn(400, 1000, "kg")))
  })
  names(clumps) <- ends[between + 1L]
  if (fault == "clump") clumps[[faulty]] <- NULL
  plan <- twin[c("towing", "seabed", "coefficients", "netting_drag")]
  plan$towing$speed <- drawn(2, 3.2, "knot")
  rig <- do.call(codend::gear, c(paste("Rig", number), plan, list(gears = gears, points = points,
    ropes = warps, pieces = c(pieces, clumps),
    measures = list(door_spread = list(spread = list("door_port", "door_starboard"))))))
  structure(rig, fault = fault)
}
