# A state as straight lines with tensions, and marks at pieces and supports. Both plot() and
# view_3d() draw them.

# Approximate maximum number of lines of netting, or of ropes, that a page or screen can show.
drawn_lines <- 20000L

# Returns list(ropes, netting (lines, see `new_lines()`), marks, boards (see `board_corners()`)).
# Columns of marks: x, y, z, role, part, size, direction, board (number among the free boards, or
# 0). Every end of a line is a point of the state.
state_drawing <- function(state, limit = drawn_lines) {
  points <- state_points(state)
  marks <- rbind(piece_marks(state, points), board_marks(state), support_marks(state))
  marks$board <- match(marks$part, names(state$si$otter_boards), 0L)
  list(
    ropes = group_lines(state, points, rope_groups(state, limit)),
    netting = netting_lines(state, points, limit),
    marks = marks, boards = board_corners(state)
  )
}

# Returns lines between points. `from`, `to`: 3 x n, m. `ends`: numbers of the points, 2 x n.
# `tension`: N; for netting of one twine. `part`: row in the mesh's table of parts.
new_lines <- function(points, first, second, tension, part) {
  list(
    from = points[, first, drop = FALSE], to = points[, second, drop = FALSE],
    ends = rbind(as.vector(first), as.vector(second)), tension = tension,
    part = rep_len(part, length(tension))
  )
}

join_lines <- function(lines) {
  list(
    from = do.call(cbind, c(list(matrix(0, 3L, 0L)), lapply(lines, `[[`, "from"))),
    to = do.call(cbind, c(list(matrix(0, 3L, 0L)), lapply(lines, `[[`, "to"))),
    ends = do.call(cbind, c(list(matrix(0L, 2L, 0L)), lapply(lines, `[[`, "ends"))),
    tension = as.double(unlist(lapply(lines, `[[`, "tension"))),
    part = as.integer(unlist(lapply(lines, `[[`, "part")))
  )
}

weighted_means <- function(x, weight, group, n) {
  sum_by(x * weight, group, n) / sum_by(weight, group, n)
}

# Returns lines with the mean tension of their bars, 0 for a line without bars. groups: as returned
# by `rope_groups()` and `seam_groups()`.
group_lines <- function(state, points, groups) {
  mean <- weighted_means(
    state$bar_tension[groups$element], groups$weight, groups$group, groups$count
  )
  new_lines(
    points, groups$first, groups$second, ifelse(is.nan(mean), 0, mean), groups$part
  )
}

# Returns the lines of ropes with their bars. A rope with too many bars is drawn through every k-th
# node. Elements of the list: `first`, `second`: points that a line joins. `part`: row of the line
# in the table of parts. `element`: bars. `group`: line of each bar. `weight`: length of each bar.
# `count`: number of lines.
rope_groups <- function(state, limit) {
  mesh <- state$mesh
  ropes <- lapply(which(mesh$parts$kind == "rope"), bars_of_part, state = state)
  bars <- as.integer(unlist(ropes))
  group <- cumsum((sequence(lengths(ropes)) - 1L) %% ceiling(length(bars) / limit) == 0)
  ends <- bar_ends(state, bars)
  begins <- !duplicated(group)
  list(
    first = ends[1L, begins], second = ends[2L, !duplicated(group, fromLast = TRUE)],
    part = mesh$bar_part[bars[begins]], element = bars, group = group,
    weight = mesh$model$bars$rest[bars], count = sum(begins)
  )
}

join_groups <- function(one, other) {
  joined <- Map(c, one, other)
  joined$group <- c(one$group, other$group + one$count)
  joined$count <- one$count + other$count
  joined
}

# Returns the lines of netting. Netting of bars has its bars and the seams on which its twines end.
# Netting of cells has both twine directions through each cell of the panel's grid.
netting_lines <- function(state, points, limit) {
  panels <- state$mesh$panels
  part <- netting_parts(state)
  of_bars <- netting_of_bars(state)
  bars <- sum(state$mesh$bar_part %in% part[of_bars])
  grids <- lapply(panels[!of_bars], `[[`, "grid")
  seams <- seams_of_bars(state, of_bars)
  joined <- sum(lengths(seams$nodes))
  total <- bars + joined + 2 * blocks_of(grids, 1)
  block <- block_to_draw(grids, limit / total * blocks_of(grids, 1))
  shortest <- shortest_line(state, names(panels)[of_bars], part[of_bars], limit * (bars / total))
  lines <- lapply(seq_along(panels), function(p) {
    if (of_bars[p]) {
      panel_bar_lines(state, points, names(panels)[p], part[p], shortest)
    } else {
      panel_cell_lines(state, points, names(panels)[p], part[p], block)
    }
  })
  drawn <- if (joined) {
    group_lines(state, points, seam_groups(state, part, seams, ceiling(total / limit)))
  }
  join_lines(c(lines, list(drawn)))
}

netting_of_bars <- function(state) {
  vapply(state$mesh$panels, function(p) p$netting == "bars", NA)
}

# Returns the nodes of seams at panels of bars, a vector per edge.
seams_of_bars <- function(state, of_bars) {
  edges <- unlist(lapply(unname(state$si$seams), `[[`, "edges"), recursive = FALSE)
  edges <- unlist(edges, recursive = FALSE)
  panel <- match(vapply(edges, `[[`, "", "panel"), names(state$mesh$panels))
  edges <- edges[of_bars[panel]]
  panel <- panel[of_bars[panel]]
  division <- state$mesh$division
  nodes <- lapply(seq_along(edges), function(k) {
    edge <- edges[[k]]
    side <- 4L * (panel[k] - 1L) + match(edge$edge, c("upper", "lower", "left", "right"))
    at <- division$before[side] + seq_len(division$count[side])
    on <- division$fraction[at] > edge$from - 1e-9 & division$fraction[at] < edge$to + 1e-9
    division$edge_node[at[on]]
  })
  list(nodes = nodes, panel = panel)
}

# Returns the lines of seams with their bars, in the form of `rope_groups()`. Each seam is drawn
# once, through every k-th node. If mesh sizes differ, twines end between the twines of the other
# panel and only the seam connects them. The seam's tension is the mean of the twines that end on
# it.
seam_groups <- function(state, part, seams, k) {
  mesh <- state$mesh
  model <- mesh$model
  mesh <- list(nodes = mesh$nodes, bar_part = mesh$bar_part,
    model = list(bars = model$bars["node"], ties = model$ties))
  seam_lines(mesh, part, seams, k)
}

seam_lines <- remembered(new_seam_lines)

new_seam_lines <- function(mesh, part, seams, k) {
  nodes <- lapply(seams$nodes, function(node) node[block_ends(length(node), k)])
  first <- unlist(lapply(nodes, function(node) node[-length(node)]))
  second <- unlist(lapply(nodes, `[`, -1L))
  once <- first != second & !duplicated(cbind(pmin(first, second), pmax(first, second)))
  on <- rep.int(part[seams$panel], lengths(nodes) - 1L)[once]
  first <- first[once]
  second <- second[once]
  ending <- bar_shares(mesh, which(mesh$bar_part %in% on))
  bars_at <- split(seq_along(ending$node), factor(ending$node, seq_len(mesh$nodes)))
  at <- Map(c, bars_at[first], bars_at[second])
  bars <- as.integer(unlist(at, use.names = FALSE))
  list(
    first = first, second = second, part = on, element = ending$bar[bars],
    group = rep.int(seq_along(at), lengths(at)), weight = ending$share[bars], count = length(at)
  )
}

# Returns the rows of panels in the table of parts, in the order of `mesh$panels`.
netting_parts <- function(state) {
  parts <- state$mesh$parts
  match(names(state$mesh$panels), ifelse(parts$kind == "netting", parts$name, NA))
}

blocks_of <- function(grids, k) {
  sum(vapply(grids, function(g) prod(ceiling((dim(g) - 1) / k)), 0))
}

# Returns the smallest block size with at most `limit` blocks.
block_to_draw <- function(grids, limit) {
  block <- 1
  longest <- max(0, vapply(grids, function(g) max(dim(g) - 1), 0))
  while (blocks_of(grids, block) > limit && block < longest) block <- block + 1
  block
}

# Returns the twines through blocks of `block` by `block` cells of a panel's grid, with the mean
# tension of their cells. Twines of diamond meshes run along a cell's diagonals, twines of square
# meshes along its sides.
panel_cell_lines <- function(state, points, name, part, block) {
  blocks <- block_cells(state, name, part, block)
  mean <- function(tension) {
    weighted_means(tension[blocks$cell], blocks$weight, blocks$block, blocks$count)
  }
  u <- mean(state$u_tension)
  v <- mean(state$v_tension)
  coarse <- state$mesh$panels[[name]]$grid[blocks$columns, blocks$rows, drop = FALSE]
  across <- nrow(coarse) - 1L
  deep <- ncol(coarse) - 1L
  corner <- function(c, r) as.vector(coarse[seq_len(across) + c, seq_len(deep) + r])
  if (state$si$panels[[name]]$orientation != "square") {
    return(new_lines(points, c(corner(0, 0), corner(1, 0)), c(corner(1, 1), corner(0, 1)),
      c(u, v), part))
  }
  last_row <- seq_len(across) + across * (deep - 1L)
  last_column <- seq_len(deep) * across
  new_lines(
    points,
    c(corner(0, 0), corner(0, 1)[last_row], corner(0, 0), corner(1, 0)[last_column]),
    c(corner(1, 0), corner(1, 1)[last_row], corner(0, 1), corner(1, 1)[last_column]),
    c(u, u[last_row], v, v[last_column]), part
  )
}

# Returns blocks of `block` by `block` cells of a panel's grid, across first. `columns`, `rows`:
# bounds of the blocks in the grid. `count`: number of blocks. `cell`: numbers of cells. `block`:
# block of each cell. `weight`: number of bars in each cell.
block_cells <- function(state, name, part, block) {
  grid <- state$mesh$panels[[name]]$grid
  cell <- state$mesh$panels[[name]]$cell - 1L
  mine <- which(state$mesh$cell_part == part)
  columns <- block_ends(nrow(grid), block)
  rows <- block_ends(ncol(grid), block)
  across <- length(columns) - 1L
  deep <- length(rows) - 1L
  list(
    columns = columns, rows = rows, count = across * deep, cell = mine,
    block = cell %/% nrow(grid) %/% block * across + cell %% nrow(grid) %/% block + 1L,
    weight = state$mesh$model$frame$cells$bars[mine]
  )
}

block_ends <- function(n, block) unique(c(seq(1L, n, by = block), n))

# Returns how panels of bars are thinned to lines of about `length` (m) at about this spacing. Only
# multiples of `every` are drawn of the twines, and `merge` bars become a line.
panel_thinning <- function(state, names, length) {
  drawn <- state$mesh$panels[names]
  side <- vapply(drawn, `[[`, 0, "lambda") *
    vapply(state$si$panels[names], `[[`, 0, "mesh_size") / 2
  bar <- side / vapply(drawn, `[[`, 0L, "segments")
  list(every = pmax(1, round(length / side)), merge = pmax(1, round(length / bar)))
}

# Returns the line length (m) at which panels of bars have about `limit` lines; 0 to draw all bars.
shortest_line <- function(state, names, part, limit) {
  bars <- tabulate(state$mesh$bar_part, nrow(state$mesh$parts))[part]
  if (!length(bars) || sum(bars) <= limit) return(0)
  length <- 1e-3
  repeat {
    thin <- panel_thinning(state, names, length)
    lines <- bars / (thin$merge * thin$every)
    if (sum(lines) <= limit || all(lines < 1)) return(length)
    length <- length * 1.1
  }
}

# Returns the bars of a panel, or lines of about `length` (m) along some of its twines, with the
# mean tension of their bars.
panel_bar_lines <- function(state, points, name, part, length) {
  bars <- bars_of_part(state, part)
  ends <- bar_ends(state, bars)
  tension <- state$bar_tension[bars]
  if (length == 0) return(new_lines(points, ends[1L, ], ends[2L, ], tension, part))
  thin <- panel_thinning(state, name, length)
  on <- bar_twines(state, name, ends)
  kept <- which(on$number %% thin$every == 0)
  kept <- kept[order(on$family[kept], on$number[kept], on$along[kept])]
  backwards <- on$backwards[kept]
  from <- ends[cbind(1L + backwards, kept)]
  to <- ends[cbind(2L - backwards, kept)]
  # A line starts at the start of a twine and after every `merge` bars.
  begins <- c(TRUE, from[-1L] != to[-length(to)])
  k <- seq_along(kept)
  begins <- begins | (k - k[begins][cumsum(begins)]) %% thin$merge == 0
  line <- cumsum(begins)
  new_lines(
    points, from[begins], to[c(begins[-1L], TRUE)],
    weighted_means(tension[kept], state$mesh$model$bars$rest[bars[kept]], line, sum(begins)),
    part
  )
}

# Returns the equivalent twine of each bar in a panel. ends: the two nodes of each bar. `family`: 1
# or 2. `number`: number of the twine, from the panel's middle. `along`: position on the twine.
# `backwards`: TRUE if the bar's first end lies beyond its second.
bar_twines <- function(state, name, ends) {
  panel <- state$si$panels[[name]]
  drawn <- state$mesh$panels[[name]]
  node <- point_number(drawn$node, state$mesh$nodes)
  at <- matrix(match(ends, node), 2L)
  i <- matrix(drawn$i[at], 2L)
  j <- matrix(drawn$j[at], 2L)
  square <- panel$orientation == "square"
  u <- if (square) i else i + j
  v <- if (square) j else j - i
  along_u <- abs(u[2, ] - u[1, ]) > abs(v[2, ] - v[1, ])
  number <- function(x) {
    x <- colMeans(x)
    phase <- Arg(mean(exp(2i * pi * x / drawn$lambda))) / (2 * pi)
    n <- round(x / drawn$lambda - phase)
    n - round(stats::median(n))
  }
  twine <- integer(ncol(ends))
  if (any(along_u)) twine[along_u] <- number(v[, along_u, drop = FALSE])
  if (!all(along_u)) twine[!along_u] <- number(u[, !along_u, drop = FALSE])
  along <- v
  along[, along_u] <- u[, along_u]
  list(
    family = 2L - along_u, number = twine, along = along[1L, ] + along[2L, ],
    backwards = along[2L, ] < along[1L, ]
  )
}

marks_of_piece <- 24L

piece_marks <- function(state, points) {
  mesh <- state$mesh
  parts <- length(state$si$ropes) + length(state$si$panels) + seq_along(state$si$pieces)
  if (!length(parts)) return(NULL)
  pieces <- unname(state$si$pieces[mesh$parts$name[parts]])
  nodes <- lapply(parts, function(part) {
    node <- unique(mesh$model$spheres$node[mesh$sphere_part == part])
    n <- min(length(node), max(marks_of_piece, 1L))
    node[unique(round(seq(1, length(node), length.out = n)))]
  })
  node <- unlist(nodes)
  each <- function(values) rep(values, lengths(nodes))
  role <- vapply(pieces, function(piece) as.character(piece$role), "")
  data.frame(
    x = points[1L, node], y = points[2L, node], z = points[3L, node],
    role = each(ifelse(is.na(role), "other", role)), part = each(mesh$parts$name[parts]),
    size = each(vapply(pieces, piece_size, 0)),
    direction = each(vapply(pieces, function(piece) as.character(piece$lift_direction), ""))
  )
}

# Returns the square root of a piece's visible area (m). It uses the piece's area, otherwise the
# area of a sphere of its volume, or the drag area (for a catch).
piece_size <- function(piece) {
  area <- as.double(piece$area)
  if (!is.na(area)) return(sqrt(area))
  if (piece$volume > 0) sqrt(pi) * (3 * piece$volume / (4 * pi))^(1 / 3) else sqrt(piece$drag_area)
}

board_marks <- function(state) {
  do.call(rbind, lapply(names(state$si$otter_boards), function(name) {
    board <- state$si$otter_boards[[name]]
    at <- rowMeans(state$position[, state$mesh$points[board$points]])
    data.frame(
      x = at[1], y = at[2], z = at[3], role = board$role, part = name, size = sqrt(board$area),
      direction = board_direction(board)
    )
  }))
}

board_direction <- function(board) {
  if (is_kite(board)) {
    if (board$side > 0) "up" else "down"
  } else {
    if (board$side > 0) "starboard" else "port"
  }
}

support_marks <- function(state) {
  held <- Filter(function(p) is_given(p$held), state$si$points)
  node <- state$mesh$points[names(held)]
  if (!length(held)) return(NULL)
  data.frame(
    x = state$position[1L, node], y = state$position[2L, node], z = state$position[3L, node],
    role = vapply(held, function(p) p$held, ""), part = names(held),
    size = NA_real_, direction = NA_character_, row.names = NULL
  )
}
