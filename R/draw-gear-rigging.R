# Rigging of a plan drawing: a schematic of the ropes between points. Identical ropes are drawn
# once.

# Greatest number of points side by side in the rigging between the nets of a rig. If there are
# more, identical points are drawn once.
most_side_by_side <- 5L

# Returns the schematics of a gear's rigging. A rig has one of the ropes between its nets, and one
# of the ropes of each kind of net.
plan_riggings <- function(gears, si, ropes, pieces, frames) {
  nets <- Filter(function(one) length(one$parts$panels), gears)
  if (!length(nets)) return(Filter(length, list(plan_rigging(si, ropes, pieces, frames))))
  of_nets <- unlist(lapply(nets, function(one) one$parts[drawn_groups]), use.names = FALSE)
  others <- function(group) setdiff(names(si[[group]]), of_nets)
  between <- plan_rigging(with_parts(si, others), ropes, pieces,
    frames[setdiff(names(frames), of_nets)], nets = nets)
  plans <- lapply(nets, `[[`, "plan")
  first <- match(plans, plans)
  # Equal plans have equal rigging. So may plans that differ in other fields, or by their sides.
  each <- lapply(nets[unique(first)], function(one) {
    mine <- function(group) intersect(names(si[[group]]), one$parts[[group]])
    plan_rigging(with_parts(si, mine), ropes, pieces,
      frames[intersect(names(frames), one$parts$ropes)], start = one$joined)
  })
  each <- Filter(length, each)
  kind <- vapply(each, `[[`, "", "kind")[names(nets)[first]]
  each <- lapply(each[!duplicated(vapply(each, `[[`, "", "kind"))], function(one) {
    c(one, list(of = names(nets)[kind %in% one$kind]))
  })
  Filter(length, c(list(between), each))
}

drawn_groups <- c("ropes", "pieces", "otter_boards")

# Returns the SI numbers with the parts of `drawn_groups` that `named(group)` returns.
with_parts <- function(si, named) {
  for (group in drawn_groups) si[[group]] <- si[[group]][named(group)]
  si
}

# Returns the rigging as a graph, or NULL without ropes between points.
#
# `kind`: a string that is equal for identical graphs. `separate`: TRUE if identical nodes are not
# merged. `nodes`: data frame of layer, order, held, motion (text), netting, letters (of pieces),
# net (names of nets in a rig, or ""). `ropes`: data frame of from, to (rows of nodes), item (NA for
# a frame or joint), length, joint (to a net).
#
# frames: struts that the rope list omits, such as the shoes of a beam trawl. start: points that a
# rig joins to others. nets: gears that are drawn as boxes.
plan_rigging <- function(si, ropes, pieces, frames = list(), start = character(), nets = list()) {
  free <- Filter(function(rope) !is.null(rope$from), si$ropes)
  if (!length(free)) return(NULL)
  found <- rigging_places(si)
  item <- ropes$item[match(vapply(names(free), rope_kind, "", si = si), ropes$kind)]
  on_free <- vapply(lapply(found$places, parse_place), function(p) {
    if (p$kind == "rope" && p$name %in% names(free)) p$name else ""
  }, "")
  # A rope that slides through points, or has points along it, runs from either end to each such
  # point.
  stretches <- do.call(rbind, lapply(seq_along(free), function(k) {
    rope <- free[[k]]
    by <- c(rope$through, found$places[on_free == names(free)[k]])
    if (!length(by)) return(data.frame(rope = k, from = rope$from, to = rope$to))
    rbind(
      data.frame(rope = k, from = rope$from, to = by),
      data.frame(rope = k, from = rope$to, to = by)
    )
  }))
  # Braces from a frame to a rope, or across to its mirror image, only stiffen the model. They do
  # not exist on the gear and are left out.
  ends <- function(end) found$of(vapply(frames, `[[`, "", end))
  struts <- data.frame(rope = rep(NA, length(frames)), from = ends("from"), to = ends("to"))
  on_rope <- found$places[on_free != ""]
  stretches <- rbind(stretches, struts[!(struts$from %in% on_rope | struts$to %in% on_rope), ])
  free <- c(free, list(list(length = NA_real_)))
  item <- c(item, NA)
  stretches$rope[is.na(stretches$rope)] <- length(free)
  edges <- data.frame(from = match(found$of(stretches$from), found$places),
    to = match(found$of(stretches$to), found$places), item = item[stretches$rope],
    length = vapply(free, `[[`, 0, "length")[stretches$rope], joint = rep(FALSE, nrow(stretches)))
  edges <- rbind(edges, net_joints(nets, found))
  boxes <- length(nets)
  nodes <- data.frame(
    held = c(found$held, logical(boxes)), motion = c(found$motion, character(boxes)),
    netting = c(found$netting, logical(boxes)),
    letters = c(piece_letters(found, pieces, si), character(boxes)),
    start = c(found$held | found$places %in% found$of(start), logical(boxes)),
    net = c(rep("", length(found$places)), names(nets))
  )
  alike <- match(lapply(nets, `[[`, "plan"), lapply(nets, `[[`, "plan"))
  kind <- place_kinds(nodes, c(rep(0L, length(found$places)), alike), edges)
  separate <- boxes > 0L && max(table(rigging_layers(nodes, edges))) <= most_side_by_side
  c(list(kind = paste(sort(unique(kind)), collapse = "\n"), separate = separate),
    merged_rigging(nodes, edges, if (separate) seq_along(kind) else match(kind, unique(kind))))
}

# Returns the joints of the nets of a rig: edges to the boxes, which follow the places.
net_joints <- function(nets, found) {
  named <- vapply(lapply(found$places, parse_place), `[[`, "", "name")
  do.call(rbind, lapply(seq_along(nets), function(k) {
    parts <- nets[[k]]$parts
    met <- found$places %in% found$of(parts$points) | named %in% unlist(parts[c("ropes", "panels")])
    data.frame(from = which(met), to = rep(length(found$places) + k, sum(met)),
      item = rep(NA_integer_, sum(met)), length = rep(NA_real_, sum(met)),
      joint = rep(TRUE, sum(met)))
  }))
}

# Returns list(nodes, ropes) of a graph in which the nodes of each class are one node.
merged_rigging <- function(nodes, edges, class) {
  edges$from <- class[edges$from]
  edges$to <- class[edges$to]
  flip <- edges$from > edges$to
  edges[flip, c("from", "to")] <- edges[flip, c("to", "from")]
  edges <- edges[!duplicated(edges[c("from", "to", "item")]), ]
  edges <- edges[!is.na(edges$item) | edges$from != edges$to, ]
  net <- vapply(split(nodes$net, class), function(of) {
    if (length(of) > 1L && nzchar(of[1L])) sprintf("net, %d off", length(of)) else of[1L]
  }, "")
  nodes <- nodes[!duplicated(class), ]
  nodes$net <- unname(net)
  nodes$layer <- rigging_layers(nodes, edges)
  nodes$order <- rigging_order(nodes, edges)
  list(nodes = nodes, ropes = edges)
}

# Returns the positions of rope ends and pieces: list(places (strings), held, motion (support in
# words), netting, of = function that returns the position of a string). All points of a free otter
# board share the same position.
rigging_places <- function(si) {
  board_of <- unlist(lapply(names(si$otter_boards), function(board) {
    points <- si$otter_boards[[board]]$points
    setNames(rep(paste0("board ", board), length(points)), points)
  }))
  of <- function(texts) {
    vapply(texts, function(text) {
      repeat {
        if (text %in% names(board_of)) return(board_of[[text]])
        at <- si$points[[text]]$at
        if (is.null(at)) return(text)
        text <- at
      }
    }, "", USE.NAMES = FALSE)
  }
  ends <- unlist(lapply(si$ropes, function(rope) c(rope$from, rope$through, rope$to)),
    use.names = FALSE)
  set <- unlist(lapply(si$pieces, `[[`, "at"), use.names = FALSE)
  places <- unique(of(c(ends, set)))
  gathered <- of(unlist(lapply(si$seams, `[[`, "gathered_at"), use.names = FALSE))
  parsed <- lapply(places, parse_place)
  on_rope <- vapply(parsed, function(p) p$kind == "rope" && !is.null(si$ropes[[p$name]]$along), NA)
  list(
    places = places, of = of,
    held = vapply(places, function(p) is_given(si$points[[p]]$held), NA, USE.NAMES = FALSE),
    motion = vapply(places, function(p) {
      held <- si$points[[p]]$held
      if (is_given(held)) symbol_of(held)$label else ""
    }, "", USE.NAMES = FALSE),
    netting = places %in% gathered | on_rope | vapply(parsed, `[[`, "", "kind") == "panel"
  )
}

piece_letters <- function(found, pieces, si) {
  letters <- rep("", length(found$places))
  add <- function(place, name) {
    item <- pieces$item[vapply(pieces$parts, function(parts) name %in% parts, NA)]
    k <- match(place, found$places)
    if (!is.na(k)) letters[k] <<- paste0(letters[k], if (nzchar(letters[k])) " ", item)
  }
  for (name in names(si$pieces)) {
    at <- si$pieces[[name]]$at
    if (!is.null(at)) add(found$of(at), name)
  }
  for (name in names(si$otter_boards)) add(paste0("board ", name), name)
  letters
}

# Returns a string per node that is equal for identical nodes. It contains the node's properties and
# the ropes that meet there with the properties at their other ends. `alike`: 0, or the first net
# with the same plan.
place_kinds <- function(nodes, alike, edges) {
  own <- paste(nodes$held, nodes$start, nodes$netting, nodes$letters, alike)
  met <- split(c(paste(edges$item, own[edges$to]), paste(edges$item, own[edges$from])),
    factor(c(edges$from, edges$to), levels = seq_along(own)))
  paste(own, vapply(met, function(m) paste(sort(unique(m)), collapse = ";"), ""))
}

# Returns the number of ropes between each node and the nearest start, or the first node if there is
# none. Nets are in the last layer.
rigging_layers <- function(nodes, edges) {
  net <- nzchar(nodes$net)
  edges <- edges[!edges$joint, ]
  layer <- ifelse(nodes$start, 0, Inf)
  if (all(layer > 0)) layer[1L] <- 0
  repeat {
    known <- layer
    for (k in seq_len(nrow(edges))) {
      ends <- c(edges$from[k], edges$to[k])
      layer[ends] <- pmin(layer[ends], layer[rev(ends)] + 1)
    }
    if (identical(known, layer)) break
  }
  # Nodes without a path to them, such as pieces on the netting, go into the last layer.
  layer[net] <- max(layer[is.finite(layer)]) + 1
  ifelse(is.finite(layer), layer, max(layer[is.finite(layer)]) + 1)
}

# Returns the order of every node in its layer, near the mean of its neighbours in previous layers.
rigging_order <- function(nodes, edges) {
  order <- numeric(nrow(nodes))
  for (layer in sort(unique(nodes$layer))) {
    mine <- which(nodes$layer == layer)
    mean_before <- vapply(mine, function(n) {
      other <- c(edges$to[edges$from == n], edges$from[edges$to == n])
      other <- other[nodes$layer[other] < layer]
      if (length(other)) mean(order[other]) else 0
    }, 0)
    order[mine[order(mean_before, mine)]] <- seq_along(mine) - (length(mine) + 1) / 2
  }
  for (layer in sort(unique(nodes$layer))) {
    order <- uncrossed_layer(order, which(nodes$layer == layer), nodes$layer, edges)
  }
  order
}

# Permutes the nodes of a layer to minimise crossings. Layers of more than five nodes are unchanged.
uncrossed_layer <- function(order, mine, layer, edges) {
  if (length(mine) > 5L) return(order)
  least <- crossings(order, layer, edges)
  best <- order
  for (way in permutations(order[mine])) {
    if (least == 0) break
    tried <- replace(order, mine, way)
    found <- crossings(tried, layer, edges)
    if (found < least) {
      least <- found
      best <- tried
    }
  }
  best
}

permutations <- function(x) {
  if (length(x) < 2L) return(list(x))
  do.call(c, lapply(seq_along(x), function(k) lapply(permutations(x[-k]), function(r) c(x[k], r))))
}

crossings <- function(order, layer, edges) {
  a <- ifelse(layer[edges$from] <= layer[edges$to], edges$from, edges$to)
  b <- edges$from + edges$to - a
  same <- outer(layer[a], layer[a], "==") & outer(layer[b], layer[b], "==") &
    (layer[a] != layer[b])
  sum(same & outer(order[a], order[a], "-") * outer(order[b], order[b], "-") < 0) / 2
}

# Distance (mm) between ropes that join a node to its mirror image, such as a tickler chain from
# shoe to shoe. They leave the node upwards or downwards.
next_pitch <- function(look) 2 * look$balloon + look$gap

# Returns the height (mm) that ropes to mirror images need above and below all nodes.
next_space <- function(rigging, look) {
  within <- rigging$ropes$from[rigging$ropes$from == rigging$ropes$to]
  count <- as.vector(table(factor(within, seq_len(nrow(rigging$nodes)))))
  up <- rigging$nodes$order < 0
  next_pitch(look) * c(up = max(0, count[up]), down = max(0, count[!up]))
}

# frame: left, bottom, right, top.
draw_rigging <- function(sheet, figure, rigging, frame, look) {
  nodes <- rigging$nodes
  ropes <- rigging$ropes
  on_sheet(sheet, component = "heading", layer = "NAMES", draw = {
    heading <- rigging_heading(rigging)
    sheet_text(sheet, frame[1], frame[4] - look$line / 2, heading[1L], look$t, bold = TRUE)
    sheet_text(sheet, frame[1] + text_width(paste0(heading[1L], "  "), look$t, TRUE),
      frame[4] - look$line / 2, heading[2L], look$t, italic = TRUE)
  })
  netting <- any(nodes$netting)
  last <- max(nodes$layer)
  boxes <- nzchar(nodes$net)
  bag <- max(text_width(if (netting) "netting" else nodes$net, look$t)) + 3 * look$gap
  right <- frame[3] - if (netting) bag + 4 * look$gap else if (any(boxes)) bag else 5 * look$t
  left <- frame[1] + text_width("towing point", look$t) / 2
  x <- if (last == 0L) rep(left, nrow(nodes)) else left + (right - left) * nodes$layer / last
  beyond <- next_space(rigging, look)
  middle <- (frame[2] + beyond[["down"]] + frame[4] - beyond[["up"]] - 1.5 * look$line) / 2
  most <- max(table(nodes$layer))
  step <- (frame[4] - frame[2] - sum(beyond) - 4.5 * look$line) / max(1, most - 1)
  y <- middle - min(step, 40) * nodes$order
  use <- new_page_use()
  if (netting) draw_net_box(sheet, nodes, x, y, frame[3], bag, look, use)
  for (k in seq_len(nrow(nodes))) {
    if (boxes[k]) {
      draw_box(sheet, x[k], y[k] + c(-1, 1) * look$line, bag, nodes$net[k], look, use)
    } else {
      take_box(use, c(x[k], y[k], x[k], y[k]) + c(-1, -1, 1, 1) * 0.8 * look$t)
    }
  }
  frames <- is.na(ropes$item)
  within <- which(nodes$layer[ropes$from] == nodes$layer[ropes$to] & !frames)
  lines <- lapply(seq_len(nrow(ropes)), function(k) {
    a <- ropes$from[k]
    b <- ropes$to[k]
    if (ropes$joint[k]) {
      higher <- 0.6 * look$line * sign(y[a] - y[b])
      return(rbind(c(x[a], y[a]), c(x[b], y[b] + higher)))
    }
    number <- sum(ropes$from[seq_len(k)] == a & ropes$to[seq_len(k)] == b)
    if (a == b) {
      far <- number * next_pitch(look) * (if (nodes$order[a] < 0) 1 else -1)
      return(cbind(x[a] + c(0, 0, 4.5 * look$balloon), y[a] + c(0, far, far)))
    }
    rope_curve(c(x[a], y[a]), c(x[b], y[b]), k %in% within, number)
  })
  for (k in seq_along(lines)) {
    line <- lines[[k]]
    take_lines(use, line[, 1], line[, 2])
    ref <- if (frames[k]) "" else paste0("ropes.", rope_of(ropes$item[k], figure))
    on_sheet(sheet, component = if (frames[k]) "piece" else "rope", ref = ref, layer = "RIGGING",
      draw = if (ropes$joint[k]) {
        sheet_line(sheet, line[, 1], line[, 2], dash = c(1.5, 1))
      } else {
        sheet_line(sheet, line[, 1], line[, 2],
          sheet_width[[if (frames[k]) "thick" else "middle"]])
      })
  }
  for (k in which(!frames)) {
    if (ropes$from[k] == ropes$to[k]) {
      label_rope_to_next(sheet, lines[[k]], ropes[k, ], figure, look, use)
    } else {
      label_rope(sheet, lines[[k]], ropes[k, ], figure, frame, look, use)
    }
  }
  for (k in which(!boxes)) draw_node(sheet, nodes[k, ], x[k], y[k], figure, look, use)
}

# Returns the heading of a schematic and its remark.
rigging_heading <- function(rigging) {
  number <- length(rigging$of)
  if (!number) {
    return(c("Rigging", paste0("not to scale",
      if (!rigging$separate) "; identical parts are drawn once")))
  }
  c(if (number > 1L) "Rigging of each net" else paste("Rigging of", gsub("_", " ", rigging$of)),
    if (number > 1L) paste(number, "off:", toString(gsub("_", " ", rigging$of))) else "")
}

rope_of <- function(item, figure) figure$ropes$first[match(item, figure$ropes$item)]

draw_net_box <- function(sheet, nodes, x, y, right, wide, look, use) {
  on <- nodes$netting
  left <- right - wide
  draw_box(sheet, left, range(y[on]) + c(-1.5, 1.5) * look$t, wide, "netting", look, use)
  for (k in which(on)) {
    if (left - x[k] < 0.5) next
    take_lines(use, c(x[k], left), c(y[k], y[k]))
    on_sheet(sheet, component = "netting", layer = "RIGGING",
      draw = sheet_line(sheet, c(x[k], left), c(y[k], y[k]), dash = c(1.5, 1)))
  }
}

# Draws a box with a label, which is narrower aft. `span`: y of its lower and upper corner ahead.
draw_box <- function(sheet, left, span, wide, label, look, use) {
  middle <- mean(span)
  narrow <- max(0.9 * look$t, min(1.6 * look$t, diff(span) / 2))
  on_sheet(sheet, component = "netting", layer = "RIGGING", draw = {
    sheet_polygon(sheet, left + c(0, wide, wide, 0),
      c(span[2], middle + narrow, middle - narrow, span[1]), sheet_fill)
    sheet_text(sheet, left + wide / 2, middle, label, look$t, 0.5)
  })
  take_box(use, c(left, span[1], left + wide, span[2]))
}

# Returns a straight line, or an arc within a layer or between nodes with several ropes.
rope_curve <- function(a, b, within, number) {
  bend <- if (within) 0.35 else 0.16 * (number - 1)
  if (bend == 0) return(rbind(a, (a + b) / 2, b))
  s <- seq(0, 1, length.out = 17L)
  across <- c(-(b[2] - a[2]), b[1] - a[1])
  across <- across / sqrt(sum(across^2))
  # Arcs within a layer bend towards the previous layer.
  if (within && across[1] > 0) bend <- -bend
  bend <- bend * min(1, 20 / sqrt(sum((b - a)^2))) * sqrt(sum((b - a)^2))
  cbind(
    a[1] + s * (b[1] - a[1]) + bend * 4 * s * (1 - s) * across[1],
    a[2] + s * (b[2] - a[2]) + bend * 4 * s * (1 - s) * across[2]
  )
}

label_rope_to_next <- function(sheet, line, rope, figure, look, use) {
  ref <- paste0("ropes.", rope_of(rope$item, figure))
  end <- line[3, ]
  r <- 0.4 * look$t
  at <- c((line[2, 1] + end[1]) / 2, end[2])
  take_box(use, c(at, at) + (look$balloon + 0.2) * c(-1, -1, 1, 1))
  take_box(use, c(end, end) + r * c(-1, -1, 1, 1))
  on_sheet(sheet, component = "rope", ref = ref, layer = "RIGGING", draw = {
    sheet_circle(sheet, end[1], end[2], r)
    draw_balloon(sheet, at[1], at[2], rope$item, look)
  })
  metres <- paste(short_number(rope$length), "m")
  for (text in c(paste(metres, "to the next"), metres)) {
    size <- c(text_width(text, look$t), look$line)
    where <- find_space(use, rbind(end + c(r + look$gap + size[1] / 2, 0)), size)
    # The rope list also contains the length.
    if (is.null(where)) next
    on_sheet(sheet, component = "length", ref = paste0(ref, ".length"), layer = "RIGGING",
      draw = sheet_text(sheet, where[1], where[2], text, look$t, 0.5))
    return(invisible())
  }
}

label_rope <- function(sheet, line, rope, figure, frame, look, use) {
  long <- c(0, cumsum(sqrt(rowSums(diff(line)^2))))
  share <- c(0.5, 0.6, 0.4, 0.7, 0.3, 0.8, 0.2, 0.9, 0.1)
  places <- apply(line, 2L, function(x) {
    stats::approx(long, x, share * max(long), ties = "ordered")$y
  })
  size <- rep(2 * look$balloon + 0.4, 2L)
  at <- find_space(use, places, size, lines = FALSE)
  if (is.null(at)) at <- places[1L, ]
  ref <- paste0("ropes.", rope_of(rope$item, figure))
  on_sheet(sheet, component = "rope", ref = ref, layer = "RIGGING",
    draw = draw_balloon(sheet, at[1], at[2], rope$item, look))
  text <- paste(short_number(rope$length), "m")
  size <- c(text_width(text, look$t) + 0.4, look$line)
  away <- look$balloon + size / 2 + 0.2
  beside <- rbind(
    at + c(0, away[2]), at - c(0, away[2]), at + c(away[1], 0), at - c(away[1], 0),
    at + c(away[1], away[2]), at + c(away[1], -away[2]), at + c(-away[1], away[2]),
    at + c(-away[1], -away[2]), at + c(0, 2 * away[2]), at - c(0, 2 * away[2])
  )
  inside <- beside[, 1] - size[1] / 2 >= frame[1] & beside[, 1] + size[1] / 2 <= frame[3] &
    beside[, 2] + size[2] / 2 <= frame[4] - look$line & beside[, 2] - size[2] / 2 >= frame[2]
  where <- find_space(use, beside[inside, , drop = FALSE], size)
  # The rope list also contains the length.
  if (is.null(where)) return(invisible())
  on_sheet(sheet, component = "length", ref = paste0(ref, ".length"), layer = "RIGGING",
    draw = sheet_text(sheet, where[1], where[2], text, look$t, 0.5))
}

draw_node <- function(sheet, node, x, y, figure, look, use) {
  r <- 0.4 * look$t
  if (node$held) {
    on_sheet(sheet, component = "held", layer = "RIGGING", draw = {
      sheet_polygon(sheet, x + 2.2 * r * c(-1, 1, 0), y + 2 * r * c(-1, -1, 1), "white")
      size <- c(text_width(node$motion, look$t), look$line)
      where <- find_space(use, cbind(x, y + c(-1, 1) * 2 * look$line), size)
      if (!is.null(where)) {
        sheet_text(sheet, where[1], where[2], node$motion, look$t, 0.5, italic = TRUE)
      }
    })
  } else {
    on_sheet(sheet, component = "joint", layer = "RIGGING",
      draw = sheet_circle(sheet, x, y, r, sheet_ink))
  }
  letters <- strsplit(node$letters, " ", fixed = TRUE)[[1L]]
  far <- 2.2 * look$balloon
  for (letter in letters) {
    places <- cbind(x + far * c(0, 0, 1, -1, 1, -1, 0, 0), y + far * c(-1, 1, 0, 0, -1, -1, -2, 2))
    at <- find_space(use, places, rep(2 * look$balloon + 0.4, 2L))
    if (is.null(at)) at <- find_space(use, places, rep(2 * look$balloon + 0.4, 2L), lines = FALSE)
    if (is.null(at)) next
    on_sheet(sheet, component = "piece", ref = figure$pieces$ref[match(letter, figure$pieces$item)],
      layer = "PIECES", draw = draw_balloon(sheet, at[1], at[2], letter, look, square = TRUE))
  }
}
