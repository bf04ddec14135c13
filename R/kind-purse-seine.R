# Purse seine (short form).
#
# Panels hang next to each other from the float line; the left edge of each is shot first. After
# shooting, the vessel is between the ends of the net: the first end is fastened at the bow, the
# last at the stern. The purse wire comes aboard at two davits between them.

expand_purse_seine <- function(fields, plan) {
  lines <- list(
    float_line = seine_line_length(fields, "float_line"),
    lead_line = seine_line_length(fields, "lead_line")
  )
  net <- seine_net(fields, plan)
  rings <- seine_rings(fields, plan)
  out <- shared_fields(plan[names(plan) != "tow"], plan)
  out$water$free_surface <- first_of(out$water$free_surface, TRUE)
  out$points <- c(seine_vessel(fields, lines$float_line), rings$points)
  out$panels <- net$panels
  out$seams <- net$seams
  end_rope <- function(at, end) rope_between(at, end, plan$end_ropes, "end_rope")
  out$ropes <- c(net$ropes, list(
    end_rope_first = end_rope("bow", "float_line.start"),
    end_rope_last = end_rope("stern", "float_line.end")
  ), rings$ropes)
  out$pieces <- c(
    list(
      floats = part_with_role(plan$floats, "float", along = "float_line"),
      sinkers = part_with_role(plan$sinkers, "sinker", along = "lead_line")
    ),
    rings$pieces
  )
  out$shooting <- c(
    list(rope = "float_line"), plan$shooting[intersect(c("speed", "arc"), names(plan$shooting))]
  )
  out$shooting$arc <- fields$shooting$arc
  out$tow <- seine_tow(fields, plan, lines)
  out$measures <- seine_measures()
  out
}

# Returns the length (m) of the float line or the lead line.
seine_line_length <- function(fields, line) {
  given <- fields[[line]]
  if (!is.null(given$length)) return(given$length)
  edge <- if (line == "float_line") "upper" else "lower"
  given$hanging_ratio * sum(vapply(fields$panels, function(panel) {
    panel$meshes[[edge]] * panel$mesh_size
  }, 0))
}

# Returns the panels with their selvedges, the seams between them and the lines around the net.
seine_net <- function(fields, plan) {
  names <- names(plan$panels)
  strips <- list(upper = "selvedge_upper", lower = "selvedge_lower")
  strips <- strips[intersect(names(strips), names(plan$selvedges))]
  panels <- seams <- list()
  # Returns the panels in one column of the net, from the float line down.
  column <- function(name) {
    c(
      if (!is.null(strips$upper)) paste0(strips$upper, "_", name), name,
      if (!is.null(strips$lower)) paste0(strips$lower, "_", name)
    )
  }
  for (name in names) {
    own <- fields$panels[[name]]
    for (edge in names(strips)) {
      given <- plan$selvedges[[edge]]
      across <- own$meshes[[edge]] * own$mesh_size / fields$selvedges[[edge]]$mesh_size
      panels[[paste0(strips[[edge]], "_", name)]] <- c(
        given[setdiff(names(given), "deep")],
        list(
          meshes = list(upper = across, lower = across, deep = given$deep),
          part = paste0("selvedge_", edge)
        )
      )
    }
    panels[[name]] <- c(plan$panels[[name]], list(part = name))
    stack <- column(name)
    for (k in seq_along(stack)[-1L]) {
      seams[[paste(stack[k - 1L], stack[k], sep = "_to_")]] <-
        list(edges = c(paste0(stack[k - 1L], ".lower"), paste0(stack[k], ".upper")))
    }
  }
  for (k in seq_along(names)[-1L]) {
    left <- column(names[k - 1L])
    right <- column(names[k])
    for (row in seq_along(left)) {
      seams[[paste(left[row], right[row], sep = "_beside_")]] <-
        list(edges = c(paste0(left[row], ".right"), paste0(right[row], ".left")))
    }
  }
  top <- vapply(names, function(name) column(name)[1L], "", USE.NAMES = FALSE)
  foot <- vapply(names, function(name) rev(column(name))[1L], "", USE.NAMES = FALSE)
  first <- column(names[1L])
  last <- column(names[length(names)])
  ropes <- list(
    float_line = part_with_role(plan$float_line, "float_line", along = paste0(top, ".upper")),
    lead_line = part_with_role(plan$lead_line, "lead_line", along = paste0(foot, ".lower")),
    side_line_first = part_with_role(plan$side_lines, "side_line", along = paste0(first, ".left")),
    side_line_last = part_with_role(plan$side_lines, "side_line", along = paste0(last, ".right"))
  )
  list(panels = panels, seams = seams, ropes = ropes)
}

# Bow and stern are at the ends of the shooting course, the davits at 1/3 and 2/3.
seine_vessel <- function(fields, float_line) {
  way <- list(arc = fields$shooting$arc, from = c(0, 0))
  bow <- c(0, 0)
  stern <- as.vector(vessel_path(way, float_line, float_line))
  held <- function(at, height) list(position = list(at[1], at[2], height), held = "fixed")
  davit <- fields$davit_height
  list(
    bow = held(bow, 0), stern = held(stern, 0),
    davit_first = held(bow + (stern - bow) / 3, davit),
    davit_last = held(bow + (stern - bow) * 2 / 3, davit)
  )
}

# Returns rings along the lead line at equal distances, half a distance from its ends.
seine_rings <- function(fields, plan) {
  n <- fields$rings$number
  ring <- sprintf("ring_%d", seq_len(n))
  share <- (seq_len(n) - 0.5) / n
  bridle <- function(k) {
    at <- sprintf("lead_line[%s]", format(share[k], digits = 8, scientific = FALSE))
    rope_between(at, ring[k], c(plan$rings$bridles, list(segments = 1)), "bridle")
  }
  one <- plan$rings[setdiff(names(plan$rings), c("number", "bridles"))]
  wire <- plan$purse_wire
  list(
    points = stats::setNames(rep(list(nothing), n), ring),
    ropes = c(
      stats::setNames(lapply(seq_len(n), bridle), paste0("bridle_", seq_len(n))),
      list(purse_wire = c(
        list(from = "davit_first", to = "davit_last", through = ring), wire,
        list(role = "purse_wire")
      ))
    ),
    pieces = stats::setNames(
      lapply(ring, function(at) c(list(at = at), one, list(role = "ring"))), ring
    )
  )
}

# Returns the `tow` of the operation: shooting, sinking, and pursing until the wire is hauled.
seine_tow <- function(fields, plan, lines) {
  wire <- fields$purse_wire$length
  shot <- lines$float_line / fields$shooting$speed
  pursing <- fields$pursing
  if (pursing$until >= wire) {
    abort_field("pursing.until", format_si(pursing$until, "length"),
      paste("less than the purse wire,", format_si(wire, "length")))
  }
  begin <- shot + pursing$wait
  end <- begin + (wire - pursing$until) / pursing$speed
  at <- function(time, value) list(time = time, value = value)
  own <- list(
    until = end, every = end / 200,
    warp_out = list(purse_wire = list(at(0, wire), at(begin, wire), at(end, pursing$until)))
  )
  own[names(plan$tow)] <- plan$tow
  own
}

seine_measures <- function() {
  places <- c(
    first_end = "lead_line.start", quarter = "lead_line[0.25]", middle = "lead_line[0.5]",
    three_quarters = "lead_line[0.75]", last_end = "lead_line.end"
  )
  depths <- lapply(places, function(place) list(depth = place))
  names(depths) <- paste0("lead_line_depth_", names(places))
  c(
    depths,
    list(
      sinking_speed = list(sinking_speed = "lead_line[0.5]"),
      enclosed_volume = list(enclosed_volume = "lead_line"),
      float_line_depth = list(depth = "float_line.middle"),
      purse_wire_tension = list(tension = "purse_wire.max"),
      end_rope_first_tension = list(tension = "end_rope_first.max"),
      end_rope_last_tension = list(tension = "end_rope_last.max")
    )
  )
}
