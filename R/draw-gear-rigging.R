# The rigging of a plan drawing: ropes between points as a schematic, from the towing points to the
# netting. What is alike, such as both sides of a trawl, is one.

# Places that ropes join, taken together where they are alike, or NULL without ropes between points.
#
# Returns list(nodes (data frame: layer, order, held, motion (words), netting, letters (of pieces)),
# ropes (data frame: from, to (rows of nodes), item, length)).
plan_rigging <- function(si, ropes, pieces) {
  free <- Filter(function(rope) !is.null(rope$from), si$ropes)
  if (!length(free)) return(NULL)
  found <- rigging_places(si)
  item <- ropes$item[match(vapply(names(free), rope_kind, "", si = si), ropes$kind)]
  # A rope that slides through places runs from either end to all of them.
  stretches <- do.call(rbind, lapply(seq_along(free), function(k) {
    rope <- free[[k]]
    if (!length(rope$through)) return(data.frame(rope = k, from = rope$from, to = rope$to))
    rbind(
      data.frame(rope = k, from = rope$from, to = rope$through),
      data.frame(rope = k, from = rope$to, to = rope$through)
    )
  }))
  from <- match(found$of(stretches$from), found$places)
  to <- match(found$of(stretches$to), found$places)
  item <- item[stretches$rope]
  letters <- piece_letters(found, pieces, si)
  kind <- place_kinds(found, letters, from, to, item)
  class <- match(kind, unique(kind))
  first <- match(unique(class), class)
  edges <- data.frame(from = class[from], to = class[to], item = item,
    length = vapply(free, `[[`, 0, "length")[stretches$rope])
  flip <- edges$from > edges$to
  edges[flip, c("from", "to")] <- edges[flip, c("to", "from")]
  edges <- edges[!duplicated(edges[c("from", "to", "item")]), ]
  nodes <- data.frame(
    held = found$held[first], motion = found$motion[first], netting = found$netting[first],
    letters = letters[first]
  )
  nodes$layer <- rigging_layers(nodes, edges)
  nodes$order <- rigging_order(nodes, edges)
  list(nodes = nodes, ropes = edges)
}

# The places of ropes' ends and of pieces: list(places (texts); held, motion (how held, in words)
# and netting of each; of = function that gives the place of a text). All points of a free otter
# board are one place.
rigging_places <- function(si) {
  board_of <- unlist(lapply(names(si$otter_boards), function(board) {
    points <- si$otter_boards[[board]]$points
    setNames(rep(paste0("board ", board), length(points)), points)
  }))
  of <- function(texts) {
    vapply(texts, function(text) {
      if (text %in% names(board_of)) return(board_of[[text]])
      at <- si$points[[text]]$at
      if (is.null(at)) text else at
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

# The letters of the pieces at every place, in one text.
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

# What tells places apart: what they are, and the kinds of ropes that meet there with what is at
# their other ends.
place_kinds <- function(found, letters, from, to, item) {
  own <- paste(found$held, found$netting, letters)
  met <- split(c(paste(item, own[to]), paste(item, own[from])),
    factor(c(from, to), levels = seq_along(own)))
  paste(own, vapply(met, function(m) paste(sort(unique(m)), collapse = ";"), ""))
}

# Ropes from the nearest held place (or the first place) to every other.
rigging_layers <- function(nodes, edges) {
  layer <- ifelse(nodes$held, 0, Inf)
  if (all(layer > 0)) layer[1L] <- 0
  repeat {
    known <- layer
    for (k in seq_len(nrow(edges))) {
      ends <- c(edges$from[k], edges$to[k])
      layer[ends] <- pmin(layer[ends], layer[rev(ends)] + 1)
    }
    if (identical(known, layer)) break
  }
  # What no rope joins to them: pieces on the netting, behind all else.
  ifelse(is.finite(layer), layer, max(layer[is.finite(layer)]) + 1)
}

# Place of every node in its layer, near the mean of its neighbours before it.
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
  order
}

draw_rigging <- function(rigging, frame) {
  nodes <- rigging$nodes
  ropes <- rigging$ropes
  pen_text(frame[1], frame[4] - 0.05, "Rigging (not to scale)", adj = c(0, 0.5), font = 2,
    cex = plan_text[["heading"]])
  pen_text(frame[1] + pen_width("Rigging (not to scale)  ", font = 2,
    cex = plan_text[["heading"]]), frame[4] - 0.05, "what is alike is drawn once", adj = c(0, 0.5),
    font = 3, cex = plan_text[["label"]])
  netting <- any(nodes$netting)
  last <- max(nodes$layer)
  right <- frame[3] - if (netting) 0.75 else 0.25
  left <- frame[1] + 0.32
  x <- if (last == 0L) rep(left, nrow(nodes)) else left + (right - left) * nodes$layer / last
  middle <- (frame[2] + frame[4] - 0.25) / 2
  most <- max(table(nodes$layer))
  step <- min(0.8, (frame[4] - frame[2] - 0.6) / max(1, most - 1))
  y <- middle - step * nodes$order
  use <- new_page_use()
  if (netting) draw_net_box(nodes, x, y, frame)
  for (k in seq_len(nrow(nodes))) take_box(use, c(x[k], y[k], x[k], y[k]) + c(-1, -1, 1, 1) * 0.08)
  within <- which(nodes$layer[ropes$from] == nodes$layer[ropes$to])
  lines <- lapply(seq_len(nrow(ropes)), function(k) {
    a <- ropes$from[k]
    b <- ropes$to[k]
    number <- sum(ropes$from[seq_len(k)] == a & ropes$to[seq_len(k)] == b)
    rope_curve(c(x[a], y[a]), c(x[b], y[b]), k %in% within, number)
  })
  for (line in lines) pen_lines(line, lwd = 1.6)
  for (k in seq_along(lines)) label_rope(lines[[k]], ropes[k, ], use)
  for (k in seq_len(nrow(nodes))) draw_node(nodes[k, ], x[k], y[k], use)
}

# The netting as a bag behind the places that are on it.
draw_net_box <- function(nodes, x, y, frame) {
  on <- nodes$netting
  left <- max(x[on]) + 0.12
  span <- range(y[on]) + c(-0.15, 0.15)
  right <- frame[3]
  middle <- mean(span)
  pen_polygon(c(left, right, right, left), c(span[2], middle + 0.1, middle - 0.1, span[1]),
    border = plan_ink, col = "#F2F4F6", lwd = 0.8)
  pen_text((left + right) / 2, middle, "netting", cex = plan_text[["label"]])
  pen_segments(x[on], y[on], left, pmin(pmax(y[on], span[1]), span[2]), lwd = 0.8, lty = "22")
}

# A straight line, or an arc where it joins places of one layer or is one of several between two.
rope_curve <- function(a, b, within, number) {
  if (all(a == b)) {
    turn <- seq(0, 2 * pi, length.out = 25L)
    return(cbind(a[1] - 0.14 + 0.14 * cos(turn), a[2] + 0.1 * sin(turn)))
  }
  bend <- if (within) 0.35 else 0.16 * (number - 1)
  s <- seq(0, 1, length.out = 17L)
  across <- c(-(b[2] - a[2]), b[1] - a[1])
  across <- across / sqrt(sum(across^2))
  # Arcs within a layer bend towards the layer before it.
  if (within && across[1] > 0) bend <- -bend
  cbind(
    a[1] + s * (b[1] - a[1]) + bend * 4 * s * (1 - s) * across[1],
    a[2] + s * (b[2] - a[2]) + bend * 4 * s * (1 - s) * across[2]
  )
}

# The number of a rope on its line, and its length beside it.
label_rope <- function(line, rope, use) {
  n <- nrow(line)
  places <- line[pmax(1, round(c(0.5, 0.6, 0.4, 0.7, 0.3) * n)), , drop = FALSE]
  at <- find_room(use, places, c(0.17, 0.17))
  if (is.null(at)) at <- places[1L, ]
  draw_balloon(at[1], at[2], rope$item)
  text <- paste(short_number(rope$length), "m")
  size <- c(pen_width(text, cex = plan_text[["label"]]), plan_line)
  beside <- rbind(
    at + c(0, 0.15), at - c(0, 0.15), at + c(size[1] / 2 + 0.11, 0), at - c(size[1] / 2 + 0.11, 0)
  )
  where <- find_room(use, beside, size)
  if (is.null(where)) where <- beside[1L, ]
  # Lines may run behind.
  pen_rect(where[1] - size[1] / 2, where[2] - size[2] / 2, where[1] + size[1] / 2,
    where[2] + size[2] / 2, col = "white", border = NA)
  pen_text(where[1], where[2], text, cex = plan_text[["label"]])
}

draw_node <- function(node, x, y, use) {
  if (node$held) {
    pen_points(x, y, pch = 24, bg = "white", cex = 1.1)
    pen_text(x, y - 0.14, node$motion, cex = 0.9 * plan_text[["label"]], font = 3)
  } else {
    pen_points(x, y, pch = 21, bg = plan_ink, cex = 0.6)
  }
  letters <- strsplit(node$letters, " ", fixed = TRUE)[[1L]]
  for (letter in letters) {
    at <- find_room(use, cbind(x + c(0, 0, 0.17, -0.17), y + c(-0.17, 0.17, 0, 0)), c(0.16, 0.16))
    if (is.null(at)) at <- c(x, y - 0.17)
    draw_balloon(at[1], at[2], letter, square = TRUE)
  }
}
