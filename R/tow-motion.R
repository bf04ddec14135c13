# A tow as the engine reads it: what of the lattice moves, grows and parts with time.

# given: the fields of a tow_schedule(); until: s.
# Returns list(schedule = what engine_tow() reads, curves = speed, course, heave, warps by rope,
# catch, breaks = times (s) at which the motion breaks).
scheduled_motion <- function(si, lattice, given, until) {
  curve <- function(name, dimension, otherwise) {
    if (is.null(given[[name]])) return(constant_curve(otherwise))
    schedule_curve(given[[name]], name, dimension, until)
  }
  speed <- curve("speed", "speed", si$towing$speed)
  course <- curve("course", "angle", 0)
  if (abs(curve_at(course, 0, after = TRUE)) > 1e-9) {
    abort_schedule("course", "must be 0 at the start, from which it counts.")
  }
  heave <- curve("heave", "length", 0)
  moved <- names(held_points(si))[held_points(si) == "moved"]
  for (name in c("speed", "course", "heave", "vessel_motion")) {
    if (!length(moved) && !is.null(given[[name]])) {
      abort_schedule(name, "needs a point that is moved ({.code held: moved}); this gear has none.")
    }
  }
  warps <- warp_curves(si, given, until)
  catch <- curve("catch", "number", 1)
  if (!is.null(given$catch) && !length(catch_parts(lattice)) && is.null(si$catch)) {
    abort_schedule("catch",
      "needs a catch in netting or a piece whose role is {.val catch}; this gear has none.")
  }
  if (min(catch$begin, catch$end) < 0) abort_schedule("catch", "must not fall below 0.")
  current <- current_curves(si, given$current, until)

  towed <- moved_nodes(si, lattice, moved)
  track <- vessel_track(speed, course, until)
  track$swing <- vessel_swing(given$vessel_motion, si$water$waves)
  growing <- c(
    do.call("c", c(list(list()), lapply(names(warps), function(rope) {
      growing_warp(si, lattice, rope, warps[[rope]], given)
    }))),
    if (!is.null(given$catch)) {
      lapply(catch_parts(lattice), function(part) growing_catch(si, lattice, part, catch))
    }
  )
  ruptures <- rupture_events(si, lattice, given$breaking)
  list(
    schedule = list(
      motion = c(towed, track, list(heading = course, z = heave)),
      release = shooting_times(si, lattice), growing = growing, current_x = current$x,
      current_y = current$y, ruptures = ruptures,
      sticking = list(present = si$sticking, anchor = numeric())
    ),
    curves = list(speed = speed, course = course, heave = heave, warps = warps, catch = catch),
    breaks = sort(unique(c(
      curve_breaks(speed, FALSE), curve_breaks(course, FALSE), curve_breaks(heave, FALSE),
      unlist(lapply(growing, function(part) {
        curve_breaks(part$factor, kinks = part$name %in% names(warps))
      })),
      # the water's acceleration jumps where a current's rate does
      unlist(lapply(c(current$x, current$y), curve_breaks, kinks = TRUE)),
      vapply(ruptures, `[[`, 0, "time")
    )))
  )
}

# Nodes that move with the vessel: list(node, place = 3 numbers each, m).
moved_nodes <- function(si, lattice, moved) {
  node <- unname(vapply(moved, function(name) lattice$points[[name]], 0L))
  place <- vapply(moved, function(name) as.double(si$points[[name]]$position), numeric(3))
  for (edge in lattice$held_edges) {
    if (!all(edge$between %in% moved)) next
    inner <- -c(1L, length(edge$node))
    node <- c(node, edge$node[inner])
    ends <- place[, edge$between]
    place <- cbind(place, ends[, 1] + outer(ends[, 2] - ends[, 1], edge$at[inner]))
  }
  list(node = as.integer(node), place = as.double(place))
}

# Ropes that a winch holds: those of role warp or purse_wire.
warp_ropes <- function(si) {
  role <- vapply(si$ropes, `[[`, "", "role")
  names(role)[role %in% c("warp", "purse_wire")]
}

# Length paid out of each warp that the schedule names, as curves (m) by rope.
warp_curves <- function(si, given, until) {
  value <- given$warp_out
  winch <- given$winch
  steered <- !is.null(given[["control"]])
  if (is.null(value) && is.null(winch) && !steered) return(list())
  known <- warp_ropes(si)
  if (!length(known)) {
    abort_schedule("warp_out", "needs ropes whose role is {.val warp}; this gear has none.")
  }
  if (is.null(value)) {
    return(lapply(setNames(known, known), function(rope) constant_curve(si$ropes[[rope]]$length)))
  }
  if (!is.list(value) || is.data.frame(value)) {
    curve <- checked_warp(schedule_curve(value, "warp_out", "length", until), "warp_out", winch)
    return(setNames(rep(list(curve), length(known)), known))
  }
  ropes <- lapply(names(value), function(name) {
    found <- known[known == name | known == paste0("warp_", name)]
    if (length(found)) return(found)
    abort_schedule("warp_out", paste0(
      "names ", show_value(name), "; this gear's warps are ", word_list(known), "."
    ))
  })
  out <- lapply(names(value), function(name) {
    path <- paste0("warp_out$", name)
    checked_warp(schedule_curve(value[[name]], path, "length", until), path, winch)
  })
  setNames(out, unlist(ropes))
}

# The shortest length that a warp's bars may be drawn to, m: at 0 they would have none.
least_warp <- 1

checked_warp <- function(curve, path, winch) {
  if (min(curve$begin, curve$end) < least_warp) {
    abort_schedule(path, sprintf("falls below %s m, the least that may be out.", least_warp))
  }
  if (length(curve_breaks(curve, FALSE))) abort_schedule(path, "jumps; a winch takes time.")
  limit <- winch$speed_limit
  if (is.null(limit)) curve else limited_curve(curve, limit)
}

# A curve that follows another no faster than `limit` (per second).
limited_curve <- function(curve, limit) {
  fastest <- max(abs(c(curve$begin_rate, curve$end_rate)))
  if (fastest <= limit) return(curve)
  last <- curve$time[length(curve$time)]
  span <- sum(abs(diff(c(curve$begin, curve$end[length(curve$end)])))) / limit
  time <- seq(curve$time[1], last + span + 1, by = 0.5)
  wanted <- curve_at(curve, time)
  reached <- wanted
  for (k in seq_along(time)[-1]) {
    most <- limit * 0.5
    reached[k] <- reached[k - 1] + min(max(wanted[k] - reached[k - 1], -most), most)
  }
  # few pieces: only where the speed changes
  bend <- c(TRUE, abs(diff(reached, differences = 2)) > 1e-9, TRUE)
  straight_curve(time[bend], reached[bend])
}

# A warp as groups that grow: one by its length over the plan's; of a rope that was laid, a group
# for each bar, of which the next to the vessel comes in first.
growing_warp <- function(si, lattice, rope, curve, given) {
  bars <- rope_bars(lattice, rope)
  whole <- si$ropes[[rope]]$length
  if (!rope %in% names(si$laid$ropes)) {
    return(list(growing_bars(si, lattice, rope, bars, whole, curve, given)))
  }
  for (name in c("winch", "control")) {
    if (!is.null(given[[name]])) {
      abort_schedule(name, paste("must be left out for", rope, "which was laid: give `warp_out`."))
    }
  }
  long <- lattice$mesh$bars$rest[bars]
  long <- long * whole / sum(long)
  least <- least_bar * long
  # the length that is out when a bar is in
  inner <- whole - cumsum(long - least)
  lapply(seq_along(bars), function(k) {
    own <- clipped_curve(shifted_curve(curve, least[k] - inner[k]), least[k], long[k])
    growing_bars(si, lattice, rope, bars[k], long[k], own, given)
  })
}

# Share of a bar that is left of it when it is in.
least_bar <- 0.01

# Bars of a warp as one group. whole: their length in the plan, m; curve: that by time.
growing_bars <- function(si, lattice, rope, bars, whole, curve, given) {
  full <- si$ropes[[rope]]
  rest <- lattice$mesh$bars$rest[bars]
  ends <- lattice$mesh$bars$node[rep(2L * bars, each = 2L) - 1:0]
  half <- rep(rest / 2, each = 2L)
  mass <- half * full$mass_per_length
  weight <- gear_gravity * (mass - half * full$volume_per_length * si$water$density)
  points <- unique(ends)
  sums <- function(x) as.double(rowsum(x, match(ends, points), reorder = TRUE))
  control <- NULL
  if (!is.null(given$winch$tension_limit) || !is.null(given[["control"]])) {
    length <- curve_at(curve, 0)
    control <- list(
      target = curve, by_speed = !is.null(given[["control"]]), target_speed = 0,
      speed_limit = first_of(given$winch$speed_limit, 2),
      tension_limit = first_of(given$winch$tension_limit, Inf), bar = bars[1L],
      stiffness = full$axial_stiffness,
      full_length = full$length, least_length = least_warp, most_length = Inf, length = length,
      since = 0, speed = 0, near_limit = FALSE
    )
  }
  c(
    list(
      name = rope, whole = whole, factor = scale_curve(curve, 1 / whole), control = control,
      bars = bars,
      rest = rest, points = points, mass = sums(mass), load = -sums(weight), spheres = integer(),
      drag_area = numeric(), added_mass = numeric()
    ),
    own_volumes(lattice, ends, surface_height(full$diameter, rep(rest, each = 2L)),
      gear_gravity * si$water$density * half * full$volume_per_length)
  )
}

# Where a group's buoyancy (N, of bodies that leave the water over these heights at these points) is
# among the lattice's volumes.
own_volumes <- function(lattice, point, height, buoyancy) {
  known <- lattice$mesh$volumes
  at <- match(paste(point, height), paste(known$node, known$height))
  volumes <- unique(at[!is.na(at)])
  own <- buoyancy[!is.na(at)]
  list(
    volumes = volumes,
    buoyancy = as.double(rowsum(own, match(at[!is.na(at)], volumes), reorder = TRUE))
  )
}

# Rows of the pieces that are catch.
catch_parts <- function(lattice) {
  which(lattice$parts$kind == "piece" & lattice$parts$role %in% "catch")
}

# The catch as a group that grows by its share of the plan's.
growing_catch <- function(si, lattice, part, curve) {
  spheres <- which(lattice$sphere_part == part)
  piece <- si$pieces[[lattice$parts$name[part]]]
  node <- lattice$mesh$spheres$node[spheres]
  n <- length(node)
  each <- piece$number / max(n, 1L)
  c(
    list(
      name = lattice$parts$name[part], whole = 1, factor = curve, control = NULL, bars = integer(),
      rest = numeric(), points = node, mass = rep(each * piece$mass, n),
      load = rep(-gear_gravity * each * (piece$mass - si$water$density * piece$volume), n),
      spheres = spheres, drag_area = lattice$mesh$spheres$drag_area[spheres],
      added_mass = lattice$mesh$spheres$added_mass[spheres]
    ),
    own_volumes(lattice, node, rep(piece$height, n),
      rep(gear_gravity * si$water$density * each * piece$volume, n))
  )
}

# Currents over the ground, a pair of curves per depth of the plan's profile. given: a list of
# speed, toward (as schedules), and depth, one or several; NULL for the plan's own.
current_curves <- function(si, given, until) {
  if (is.null(given)) return(list(x = list(), y = list()))
  layers <- if (!is.null(given$speed)) list(given) else given
  depths <- si$water$current$depth
  if (length(layers) != length(depths)) {
    abort_schedule("current", sprintf(
      "has %d depths; it must have the plan's, which are %s m.", length(layers),
      word_list(format(depths))
    ))
  }
  curves <- lapply(seq_along(layers), function(k) {
    path <- sprintf("current[[%d]]", k)
    speed <- schedule_curve(layers[[k]]$speed, paste0(path, "$speed"), "speed", until)
    toward <- schedule_curve(first_of(layers[[k]]$toward, 0), paste0(path, "$toward"), "angle",
      until)
    if (all(toward$begin_rate == 0 & toward$end_rate == 0) && length(toward$begin) == 1L) {
      return(list(
        x = scale_curve(speed, cos(toward$begin)), y = scale_curve(speed, sin(toward$begin))
      ))
    }
    turned_current(speed, toward, until)
  })
  list(x = lapply(curves, `[[`, "x"), y = lapply(curves, `[[`, "y"))
}

# A current (curves of m/s and rad) along x and y: list(x, y), smooth from break to break. Water
# that is turned at once pushes nothing; turned within a short time it would by its acceleration.
turned_current <- function(speed, toward, until) {
  until <- until + 2 * function_step
  breaks <- c(curve_breaks(speed, TRUE), curve_breaks(toward, TRUE))
  breaks <- sort(unique(breaks[breaks > 0 & breaks < until]))
  begun <- c(0, breaks)
  parts <- lapply(seq_along(begun), function(k) {
    time <- c(begun, until)[k + 0:1]
    time <- seq(time[1L], time[2L], length.out = max(2, ceiling(diff(time) / function_step) + 1))
    last <- length(time)
    values <- function(curve) {
      c(curve_at(curve, time[-last], after = TRUE), curve_at(curve, time[last]))
    }
    s <- values(speed)
    a <- values(toward)
    list(x = smooth_curve(time, s * cos(a)), y = smooth_curve(time, s * sin(a)))
  })
  before <- function(curve, way) {
    # a jump where the tow begins: the water is settled in before it
    first <- curve_at(speed, 0) * way(curve_at(toward, 0))
    if (first == curve$begin[1L]) return(curve)
    join_curves(list(straight_curve(c(-1, 0), rep(first, 2)), curve))
  }
  list(
    x = before(join_curves(lapply(parts, `[[`, "x")), cos),
    y = before(join_curves(lapply(parts, `[[`, "y")), sin)
  )
}

# Ropes that may break. given: a list of list(rope, time, place) or list(rope), which goes at its
# breaking load.
rupture_events <- function(si, lattice, given) {
  lapply(given, function(event) {
    if (!is_text(event$rope) || !event$rope %in% names(si$ropes)) {
      abort_schedule("breaking", paste0(
        "names the rope ", show_value(event$rope), "; this gear's are ",
        word_list(names(si$ropes)), "."
      ))
    }
    bars <- rope_bars(lattice, event$rope)
    place <- first_of(event$place, "middle")
    strength <- si$ropes[[event$rope]]$strength
    if (is.null(event$time) && is.na(strength)) {
      abort_schedule("breaking", paste0(
        "gives no time for the rope ", event$rope, ", whose breaking load the plan does not know."
      ))
    }
    time <- if (is.null(event$time)) Inf else schedule_number(event$time, "breaking$time", "time")
    list(
      rope = event$rope, bars = bars,
      at = rope_bar(lattice, event$rope, place), time = time,
      strength = if (is.null(event$time)) as.double(strength) else Inf, broken = 0L, broken_at = 0
    )
  })
}
