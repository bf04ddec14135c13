# Checks that the parts of a gear are connected consistently (`si`: SI numbers of `si_of()`).
# `last`: SI numbers of a checked gear, or NULL. An identical structure skips the later checks.
check_gear <- function(si, last = NULL) {
  check_points(si)
  held <- function(si) lapply(si$points, `[`, c("held", "position"))
  if (!is.null(last) && identical(gear_structure(si), gear_structure(last)) &&
    identical(held(si), held(last))) {
    return(invisible())
  }
  check_seams(si)
  check_places(si)
  check_joined(si)
}

# Returns the fields that define how parts are connected, except held points. They also define the
# mesh, except the requested node counts. Lengths, masses and areas are excluded.
gear_structure <- function(si) {
  c(si[c("seams", "share_places")], list(
    points = lapply(si$points, `[[`, "at"),
    ropes = lapply(si$ropes, `[`, c("along", "shares", "through", "from", "to")),
    pieces = lapply(si$pieces, `[[`, "along"),
    boards = lapply(si$otter_boards, `[[`, "points"),
    panels = panel_shapes(si$panels)
  ))
}

# Returns "fixed" or "moved" for each held point, named by point.
held_points <- function(si) {
  held <- vapply(si$points, `[[`, "", "held")
  held[!is.na(held)]
}

check_points <- function(si) {
  for (name in names(si$points)) {
    seen <- name
    at <- si$points[[name]]$at
    while (!is.null(at) && at %in% names(si$points)) {
      if (at %in% seen) {
        abort_field(paste0("points.", name, ".at"), at, NULL,
          paste("refers to itself through", word_list(seen)))
      }
      seen <- c(seen, at)
      at <- si$points[[at]]$at
    }
  }
  held <- held_points(si)
  if (length(held) == 0) {
    abort_field("points", NULL, NULL,
      "has no held point: give moorings or anchors, or a point with `position` and `held`")
  }
  if (si$towing$speed > 0 && !"moved" %in% held) {
    abort_field("towing.speed", format_si(si$towing$speed, "speed"),
      "0 if no point is moved (`held: moved`); for a fixed gear use a current")
  }
  if (si$towing$speed > 0 && "fixed" %in% held) {
    one <- function(kind) names(held)[held == kind][1]
    abort_field("points", held, NULL, sprintf(
      "has a fixed point `%s` and a moved point `%s`, which drift apart: %s", one("fixed"),
      one("moved"), "`towing.speed` must be 0 or all held points must be of the same kind"
    ))
  }
}

# Checks that chains of a seam differ in length by at most a factor of 3, without overlaps.
check_seams <- function(si) {
  for (name in names(si$seams)) {
    seam <- si$seams[[name]]
    path <- paste0("seams.", name)
    gathered <- !is.null(seam$gathered_at)
    edges <- paste0(path, ".edges")
    if (length(seam$edges) < 2 && !gathered && is.null(seam$held_between)) {
      abort_field(edges, 1, NULL,
        "has one chain; it must have at least two, or `gathered_at` or `held_between`")
    }
    size <- vapply(seam$edges, chain_length, 0, panels = si$panels)
    if (!gathered && any(size == 0)) {
      abort_plan(sprintf(
        "Plan field `%s[%d]` has no meshes; an edge without meshes needs `gathered_at`.", edges,
        which(size == 0)[1]
      ), edges, size)
    }
    if (!gathered && max(size) > 3 * min(size)) {
      abort_plan(sprintf(
        "Plan field `%s` joins stretched lengths of %s and %s; %s", edges,
        format_si(min(size), "length"), format_si(max(size), "length"),
        "they may differ by a factor of at most 3."
      ), edges, size, mesh_sizes = joined_mesh_sizes(si, seam))
    }
    if (!is.null(seam$held_between)) check_held_between(si, seam$held_between, min(size), path)
  }
  check_taken(si$seams)
}

# Returns the distinct mesh sizes (m) of the panels that a seam joins, named by panel.
joined_mesh_sizes <- function(si, seam) {
  panels <- unique(vapply(unlist(seam$edges, recursive = FALSE), `[[`, "", "panel"))
  sizes <- vapply(si$panels[panels], `[[`, 0, "mesh_size")
  sizes[!duplicated(sizes)]
}

# Checks that each stretch of an edge belongs to at most one seam.
check_taken <- function(seams) {
  edges <- lapply(seams, function(seam) unlist(seam$edges, recursive = FALSE))
  name <- rep(names(seams), lengths(edges))
  edges <- unlist(unname(edges), recursive = FALSE)
  key <- paste0(vapply(edges, `[[`, "", "panel"), ".", vapply(edges, `[[`, "", "edge"))
  from <- vapply(edges, `[[`, 0, "from")
  to <- vapply(edges, `[[`, 0, "to")
  for (k in which(duplicated(key))) {
    others <- which(key[seq_len(k - 1L)] == key[k])
    shared <- others[pmin(to[k], to[others]) - pmax(from[k], from[others]) > 1e-9]
    if (length(shared)) {
      abort_field(paste0("seams.", name[k]), key[k], NULL, sprintf(
        "joins meshes of the edge `%s`, but seam `%s` already joins them", key[k], name[shared[1L]]
      ))
    }
  }
}

# Held netting may be stretched to 1.5 times its stretched length; no twine elongates by half.
greatest_held_stretch <- 1.5

# size: stretched length (m) of the shortest chain of the seam.
check_held_between <- function(si, between, size, path) {
  held <- names(held_points(si))
  loose <- which(!between %in% held)[1]
  if (!is.na(loose)) {
    abort_field(
      sprintf("%s.held_between[%d]", path, loose), between[loose],
      paste("a held point from this list:", word_list(held))
    )
  }
  path <- paste0(path, ".held_between")
  apart <- sqrt(sum((si$points[[between[1]]]$position - si$points[[between[2]]]$position)^2))
  if (apart == 0) abort_field(path, between, "two points at different positions")
  if (apart > greatest_held_stretch * size) {
    abort_field(path, between, NULL, sprintf(
      "has netting of stretched length %s between points %s apart; %s at most %s times %s",
      format_si(size, "length"), format_si(apart, "length"), "this distance must be",
      format(greatest_held_stretch), "the stretched length"
    ))
  }
}

# Checks that every point, rope and panel is connected to a held point.
check_joined <- function(si) {
  body <- function(text) {
    place <- parse_place(text)
    paste0(place$kind, "s.", place$name)
  }
  panels_of <- function(chain) vapply(chain, function(edge) paste0("panels.", edge$panel), "")
  links <- list()
  for (name in names(si$points)) {
    at <- si$points[[name]]$at
    if (!is.null(at)) links <- c(links, list(c(paste0("points.", name), body(at))))
  }
  for (name in names(si$ropes)) {
    rope <- si$ropes[[name]]
    ends <- if (is.null(rope$along)) {
      vapply(c(rope$from, rope$through, rope$to), body, "", USE.NAMES = FALSE)
    } else {
      panels_of(rope$along)
    }
    links <- c(links, list(c(paste0("ropes.", name), ends)))
  }
  for (board in si$otter_boards) links <- c(links, list(paste0("points.", board$points)))
  for (seam in si$seams) {
    gathered <- if (!is.null(seam$gathered_at)) body(seam$gathered_at)
    held <- prefixed("points.", seam$held_between)
    links <- c(links, list(c(gathered, held, unlist(lapply(seam$edges, panels_of)))))
  }
  bodies <- c(
    prefixed("points.", names(si$points)), prefixed("ropes.", names(si$ropes)),
    prefixed("panels.", names(si$panels))
  )
  group <- joined_groups(bodies, links)
  held <- match(paste0("points.", names(held_points(si))), bodies)
  loose <- bodies[!group %in% group[held]]
  if (length(loose)) {
    abort_field(loose[1], NULL, NULL, "is not attached: no rope or seam leads to a held point")
  }
}

# Checks that the ends of ropes differ and that no location has two held points.
check_places <- function(si) {
  corners <- c("upper_left", "upper_right", "lower_left", "lower_right")
  links <- list()
  link <- function(...) links[[length(links) + 1]] <<- c(...)
  for (name in names(si$points)) link(name, si$points[[name]]$at)
  for (name in names(si$ropes)) {
    rope <- si$ropes[[name]]
    ends <- paste0(name, c(".start", ".end"))
    if (is.null(rope$along)) {
      link(ends[1], rope$from)
      link(ends[2], rope$to)
    } else {
      at <- chain_ends(rope$along, ends)
      link(ends[1], at[1])
      link(ends[2], at[2])
    }
    link(paste0(name, ".middle"))
    for (place in rope$through) link(place)
  }
  for (place in si$share_places) link(place)
  links <- c(links, as.list(paste0(rep(names(si$panels), each = 4L), ".", corners)))
  for (name in names(si$seams)) {
    seam <- si$seams[[name]]
    own <- paste0("seam ", name, c(" start", " end"))
    ends <- vapply(seam$edges, chain_ends, c("", ""), otherwise = own)
    if (is.null(seam$gathered_at)) {
      link(ends[1, ], seam$held_between[1])
      link(ends[2, ], seam$held_between[2])
    } else {
      link(seam$gathered_at, ends)
    }
  }
  places <- unique(unlist(links))
  group <- stats::setNames(joined_groups(places, links), places)
  for (name in names(si$ropes)) {
    rope <- si$ropes[[name]]
    check_through(rope, group, paste0("ropes.", name))
    check_rope_ends(rope, group, paste0("ropes.", name))
  }
  held <- names(held_points(si))
  twice <- which(duplicated(group[held]))[1]
  if (!is.na(twice)) {
    first <- held[match(group[held[twice]], group[held])]
    abort_field(paste0("points.", held[twice]), held[twice], NULL,
      sprintf("has the same position as the held point `points.%s`", first))
  }
}

# Checks that the ends of a rope are two locations, or by name the same one. A rope from a location
# to itself is a ring, which needs three segments to enclose an area.
check_rope_ends <- function(rope, group, path) {
  if (!is.null(rope$along) || length(rope$through)) return(invisible())
  if (rope$from != rope$to && group[[rope$from]] == group[[rope$to]]) {
    abort_field(paste0(path, ".to"), rope$to, NULL, sprintf(
      "is %s, the same position as the start %s. %s", rope$to, rope$from,
      "Choose another end; for a ring, give the same name to both ends"
    ))
  }
  if (rope$from == rope$to && !is.null(rope$segments) && rope$segments < 3) {
    abort_field(paste0(path, ".segments"), rope$segments, NULL, sprintf(
      "is %s; a ring, which ends where it starts, needs at least 3", rope$segments
    ))
  }
}

# Checks that consecutive points on a sliding rope are different locations.
check_through <- function(rope, group, path) {
  passed <- c(rope$from, rope$through, rope$to)
  if (!length(rope$through)) return(invisible())
  twice <- which(group[passed[-1L]] == group[passed[-length(passed)]])[1]
  if (is.na(twice)) return(invisible())
  abort_field(paste0(path, ".through"), rope$through, NULL, sprintf(
    "has %s and %s in succession, but they are the same position", passed[twice],
    passed[twice + 1L]
  ))
}

# Returns the start and end corner of a chain; `otherwise` for an end inside an edge.
chain_ends <- function(chain, otherwise) {
  corner <- function(edge, at, inside) {
    if (at != 0 && at != 1) return(inside)
    paste0(edge$panel, ".", edge_corners[[edge$edge]][at + 1])
  }
  first <- chain[[1]]
  last <- chain[[length(chain)]]
  c(
    corner(first, if (first$reversed) first$to else first$from, otherwise[1]),
    corner(last, if (last$reversed) last$from else last$to, otherwise[2])
  )
}

edge_corners <- list(
  upper = c("upper_left", "upper_right"), lower = c("lower_left", "lower_right"),
  left = c("upper_left", "lower_left"), right = c("upper_right", "lower_right")
)

prefixed <- function(prefix, names) if (length(names)) paste0(prefix, names)

# Returns a group number for each name. Names that share a link are in the same group.
joined_groups <- function(names, links) {
  of <- match(unlist(links), names)
  sizes <- lengths(links)
  first <- rep(of[cumsum(sizes) - sizes + 1], sizes)
  joined_labels(length(names), first, of)
}

# Returns connected components of nodes 1..n with edges (a, b), by smallest index.
joined_labels <- function(n, a, b) {
  label <- seq_len(n)
  repeat {
    la <- label[a]
    lb <- label[b]
    apart <- la != lb
    if (!any(apart)) return(label)
    high <- pmax(la, lb)[apart]
    low <- pmin(la, lb)[apart]
    order <- order(high, -low)
    label[high[order]] <- low[order]
    repeat {
      further <- label[label]
      if (identical(further, label)) break
      label <- further
    }
  }
}
