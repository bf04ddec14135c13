# Schedule of a tow in the engine's format: moving, growing and breaking parts.

# `given`: fields of a tow_schedule(); `until`: end time (s). Returns list(schedule, curves,
# breaks). `schedule`: input of engine_tow(). `curves`: speed, course, heave, warps by rope, catch.
# `breaks`: times (s) at which the motion has a discontinuity.
scheduled_motion <- function(si, mesh, given, until) {
  given["winch"] <- list(si_winch(given$winch))
  if (is_swell(given$heave)) given$heave <- swell(given$heave)
  curve <- function(name, dimension, otherwise) {
    if (is.null(given[[name]])) return(constant_curve(otherwise))
    schedule_curve(given[[name]], name, dimension, until)
  }
  speed <- curve("speed", "speed", si$towing$speed)
  course <- curve("course", "angle", 0)
  if (abs(curve_at(course, 0, after = TRUE)) > 1e-9) {
    abort_schedule("course", "must be 0 at the start: the course is relative to the start.")
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
  if (!is.null(given$catch) && !length(catch_parts(mesh)) && is.null(si$catch)) {
    abort_schedule("catch",
      "needs a catch in netting or a piece whose role is {.val catch}; this gear has none.")
  }
  if (min(catch$begin, catch$end) < 0) abort_schedule("catch", "must not fall below 0.")
  current <- current_curves(si, given$current, until)

  towed <- moved_nodes(si, mesh, moved)
  track <- vessel_track(speed, course, until)
  track$swing <- vessel_swing(given$vessel_motion, si$water$waves)
  growing <- c(
    do.call("c", c(list(list()), lapply(names(warps), function(rope) {
      growing_warp(si, mesh, rope, warps[[rope]], given)
    }))),
    if (!is.null(given$catch)) {
      lapply(catch_parts(mesh), function(part) growing_catch(si, mesh, part, catch))
    }
  )
  ruptures <- rupture_events(si, mesh, given$breaking)
  list(
    schedule = list(
      motion = c(towed, track, list(heading = course, z = heave)),
      release = shooting_times(si, mesh), growing = growing, current_x = current$x,
      current_y = current$y, ruptures = ruptures,
      sticking = list(present = si$sticking, anchor = numeric())
    ),
    curves = list(speed = speed, course = course, heave = heave, warps = warps, catch = catch),
    breaks = sort(unique(c(
      curve_breaks(speed, FALSE), curve_breaks(course, FALSE), curve_breaks(heave, FALSE),
      unlist(lapply(growing, function(part) {
        curve_breaks(part$factor, kinks = part$name %in% names(warps))
      })),
      # the water's acceleration jumps if the rate of the current jumps
      unlist(lapply(c(current$x, current$y), curve_breaks, kinks = TRUE)),
      vapply(ruptures, `[[`, 0, "time")
    )))
  )
}

# Returns nodes that move with the vessel: list(node, place = 3 coordinates each [m]).
moved_nodes <- function(si, mesh, moved) {
  node <- unname(vapply(moved, function(name) mesh$points[[name]], 0L))
  place <- vapply(moved, function(name) as.double(si$points[[name]]$position), numeric(3))
  for (edge in mesh$held_edges) {
    if (!all(edge$between %in% moved)) next
    inner <- -c(1L, length(edge$node))
    node <- c(node, edge$node[inner])
    ends <- place[, edge$between]
    place <- cbind(place, ends[, 1] + outer(ends[, 2] - ends[, 1], edge$at[inner]))
  }
  list(node = as.integer(node), place = as.double(place))
}

warp_ropes <- function(si) {
  role <- vapply(si$ropes, `[[`, "", "role")
  names(role)[role %in% c("warp", "purse_wire")]
}

# Returns the paid-out length of each warp as curves [m] by rope.
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
      "has the name ", show_value(name), "; the warps of this gear are ", word_list(known), "."
    ))
  })
  out <- lapply(names(value), function(name) {
    path <- paste0("warp_out$", name)
    checked_warp(schedule_curve(value[[name]], path, "length", until), path, winch)
  })
  setNames(out, unlist(ropes))
}

# Smallest paid-out length (m); at 0 the bars would have no length.
least_warp <- 1

checked_warp <- function(curve, path, winch) {
  if (min(curve$begin, curve$end) < least_warp) {
    abort_schedule(path, sprintf("falls below %s m, the minimum length.", least_warp))
  }
  if (length(curve_breaks(curve, FALSE))) abort_schedule(path, "has a jump; a winch needs time.")
  limit <- winch$speed_limit
  if (is.null(limit)) curve else limited_curve(curve, limit)
}

# Limits the rate of a curve to `limit` (per second).
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
  # drop points on straight parts
  bend <- c(TRUE, abs(diff(reached, differences = 2)) > 1e-9, TRUE)
  straight_curve(time[bend], reached[bend])
}

# Returns the growing groups of a warp. A laid rope has one group per bar, and the bar next to the
# vessel comes in first. Other warps are one group with a common factor.
growing_warp <- function(si, mesh, rope, curve, given) {
  bars <- rope_bars(mesh, rope)
  whole <- si$ropes[[rope]]$length
  if (!rope %in% names(si$laid$ropes)) {
    return(list(growing_bars(si, mesh, rope, bars, whole, curve, given)))
  }
  for (name in c("winch", "control")) {
    if (!is.null(given[[name]])) {
      abort_schedule(name, paste("must be omitted for the laid rope", rope, "(use `warp_out`)."))
    }
  }
  long <- mesh$model$bars$rest[bars]
  long <- long * whole / sum(long)
  least <- least_bar * long
  # paid-out length when a bar is in
  inner <- whole - cumsum(long - least)
  lapply(seq_along(bars), function(k) {
    curve[c("begin", "end")] <- lapply(curve[c("begin", "end")], `+`, least[k] - inner[k])
    own <- clipped_curve(curve, least[k], long[k])
    growing_bars(si, mesh, rope, bars[k], long[k], own, given)
  })
}

# Fraction of a bar's length that remains when it is in.
least_bar <- 0.01

# Returns bars of a warp as one group. `whole`: length in the plan [m]; `curve`: length over time.
growing_bars <- function(si, mesh, rope, bars, whole, curve, given) {
  full <- si$ropes[[rope]]
  rest <- mesh$model$bars$rest[bars]
  ends <- mesh$model$bars$node[rep(2L * bars, each = 2L) - 1:0]
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
    own_volumes(mesh, ends, surface_height(full$diameter, rep(rest, each = 2L)),
      gear_gravity * si$water$density * half * full$volume_per_length)
  )
}

# Returns the buoyancy [N] of a group by entry of the mesh's volumes. `point`, `height`: position
# and height of its bodies.
own_volumes <- function(mesh, point, height, buoyancy) {
  known <- mesh$model$volumes
  at <- match(paste(point, height), paste(known$node, known$height))
  volumes <- unique(at[!is.na(at)])
  own <- buoyancy[!is.na(at)]
  list(
    volumes = volumes,
    buoyancy = as.double(rowsum(own, match(at[!is.na(at)], volumes), reorder = TRUE))
  )
}

catch_parts <- function(mesh) {
  which(mesh$parts$kind == "piece" & mesh$parts$role %in% "catch")
}

# Returns the catch as a group that grows by its fraction of the plan's catch.
growing_catch <- function(si, mesh, part, curve) {
  spheres <- which(mesh$sphere_part == part)
  piece <- si$pieces[[mesh$parts$name[part]]]
  node <- mesh$model$spheres$node[spheres]
  n <- length(node)
  each <- piece$number / max(n, 1L)
  c(
    list(
      name = mesh$parts$name[part], whole = 1, factor = curve, control = NULL, bars = integer(),
      rest = numeric(), points = node, mass = rep(each * piece$mass, n),
      load = rep(-gear_gravity * each * (piece$mass - si$water$density * piece$volume), n),
      spheres = spheres, drag_area = mesh$model$spheres$drag_area[spheres],
      added_mass = mesh$model$spheres$added_mass[spheres]
    ),
    own_volumes(mesh, node, rep(piece$height, n),
      rep(gear_gravity * si$water$density * each * piece$volume, n))
  )
}

# Returns currents over the ground: a pair of curves per depth of the plan's profile. `given`: one
# or several lists of speed, toward (schedules) and depth; NULL: as in the plan.
current_curves <- function(si, given, until) {
  if (is.null(given)) return(list(x = list(), y = list()))
  layers <- if (!is.null(given$speed)) list(given) else given
  depths <- si$water$current$depth
  if (length(layers) != length(depths)) {
    abort_schedule("current", sprintf(
      "has %d depths; it must have the depths of the plan: %s m.", length(layers),
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

# Returns list(x, y) for a current with speed [m/s] and direction [rad], smooth between breaks.
# Breaks keep jumps as jumps: a fast smooth turn would cause forces from the water's acceleration.
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
    # jump at time 0: the gear settles in the current before it
    first <- curve_at(speed, 0) * way(curve_at(toward, 0))
    if (first == curve$begin[1L]) return(curve)
    join_curves(list(straight_curve(c(-1, 0), rep(first, 2)), curve))
  }
  list(
    x = before(join_curves(lapply(parts, `[[`, "x")), cos),
    y = before(join_curves(lapply(parts, `[[`, "y")), sin)
  )
}

# Returns the ropes that may break. `given`: list of list(rope, time, place). Without a time, the
# rope breaks at its breaking load.
rupture_events <- function(si, mesh, given) {
  lapply(given, function(event) {
    if (!is_text(event$rope) || !event$rope %in% names(si$ropes)) {
      abort_schedule("breaking", paste0(
        "has the rope ", show_value(event$rope), "; the ropes of this gear are ",
        word_list(names(si$ropes)), "."
      ))
    }
    bars <- rope_bars(mesh, event$rope)
    place <- first_of(event$position, "middle")
    strength <- si$ropes[[event$rope]]$strength
    if (is.null(event$time) && is.na(strength)) {
      abort_schedule("breaking", paste0(
        "needs a time for the rope ", event$rope, ": the plan does not give its breaking load."
      ))
    }
    time <- if (is.null(event$time)) Inf else quantity_number(event$time, "time", "breaking$time")
    list(
      rope = event$rope, bars = bars,
      at = rope_bar(mesh, event$rope, place), time = time,
      strength = if (is.null(event$time)) as.double(strength) else Inf, broken = 0L, broken_at = 0
    )
  })
}
