# A state as what a picture shows: straight lines with tensions, and marks where pieces and supports
# sit. Both plot() and view_3d() draw from here.

# At most about as many lines of netting, or of ropes, as a page or a screen can show.
drawn_lines <- 20000L

# Returns list(ropes, netting = lines (see new_lines), marks = data.frame(x, y, z, role, part, size,
# direction, board = its number among the free boards or 0), boards = their corners (see
# board_corners())). Every end of a line is a point of the state.
state_drawing <- function(state, limit = drawn_lines) {
  points <- state_points(state)
  marks <- rbind(piece_marks(state, points), board_marks(state), support_marks(state))
  marks$board <- match(marks$part, names(state$si$otter_boards), 0L)
  list(
    ropes = rope_lines(state, points, limit),
    netting = netting_lines(state, points, limit),
    marks = marks, boards = board_corners(state)
  )
}

# Lines between points: from and to (3 x n, m), ends (2 x n, which points), tension (N; of one twine
# in netting) and part (row of the lattice's table of parts).
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

# Means of x over groups 1..n.
weighted_means <- function(x, weight, group, n) {
  sum_by(x * weight, group, n) / sum_by(weight, group, n)
}

# The lines of ropes, with the mean tension of their bars.
rope_lines <- function(state, points, limit) group_lines(state, points, rope_groups(state, limit))

# Lines with the mean tension of the bars that each shows; 0 if no bar belongs to a line. groups: as
# rope_groups() and seam_groups() return them.
group_lines <- function(state, points, groups) {
  mean <- weighted_means(
    state$bar_tension[groups$element], groups$weight, groups$group, groups$count
  )
  new_lines(
    points, groups$first, groups$second, ifelse(is.nan(mean), 0, mean), groups$part
  )
}

# The bars whose mean tension each line of a rope shows: list(first, second = the points that a
# line joins, part = its row in the table of parts, element = bars, group = the line of each bar,
# weight = the length of each bar, count = number of lines). A rope of more bars than can be shown
# is drawn through every k-th of its nodes.
rope_groups <- function(state, limit) {
  lattice <- state$lattice
  ropes <- lapply(which(lattice$parts$kind == "rope"), bars_of_part, state = state)
  bars <- as.integer(unlist(ropes))
  group <- cumsum((sequence(lengths(ropes)) - 1L) %% ceiling(length(bars) / limit) == 0)
  ends <- bar_ends(state, bars)
  begins <- !duplicated(group)
  list(
    first = ends[1L, begins], second = ends[2L, !duplicated(group, fromLast = TRUE)],
    part = lattice$bar_part[bars[begins]], element = bars, group = group,
    weight = lattice$mesh$bars$rest[bars], count = sum(begins)
  )
}

join_groups <- function(one, other) {
  joined <- Map(c, one, other)
  joined$group <- c(one$group, other$group + one$count)
  joined$count <- one$count + other$count
  joined
}

# Netting: of bars, the bars themselves and the seams that their twines end on; of cells, the two
# twine directions through each cell of the panel's grid.
netting_lines <- function(state, points, limit) {
  panels <- state$lattice$panels
  part <- netting_parts(state)
  of_bars <- netting_of_bars(state)
  bars <- sum(state$lattice$bar_part %in% part[of_bars])
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
  vapply(state$lattice$panels, function(p) p$netting == "bars", NA)
}

# The nodes of the seams of panels of bars in order, a vector for each edge: list(nodes, panel).
seams_of_bars <- function(state, of_bars) {
  edges <- unlist(lapply(unname(state$si$seams), `[[`, "edges"), recursive = FALSE)
  edges <- unlist(edges, recursive = FALSE)
  panel <- match(vapply(edges, `[[`, "", "panel"), names(state$lattice$panels))
  edges <- edges[of_bars[panel]]
  panel <- panel[of_bars[panel]]
  division <- state$lattice$division
  nodes <- lapply(seq_along(edges), function(k) {
    edge <- edges[[k]]
    side <- 4L * (panel[k] - 1L) + match(edge$edge, c("upper", "lower", "left", "right"))
    at <- division$before[side] + seq_len(division$count[side])
    on <- division$fraction[at] > edge$from - 1e-9 & division$fraction[at] < edge$to + 1e-9
    division$edge_node[at[on]]
  })
  list(nodes = nodes, panel = panel)
}

# The bars whose mean tension each line of a seam shows, as rope_groups() returns them. A seam is
# drawn through every k-th of its nodes, once. Where meshes of two sizes meet, twines of one panel
# end between those of the other: the seam is what joins them. Its tension is the mean of the twines
# that end on it.
seam_groups <- function(state, part, seams, k) {
  lattice <- state$lattice
  nodes <- lapply(seams$nodes, function(node) node[block_ends(length(node), k)])
  first <- unlist(lapply(nodes, function(node) node[-length(node)]))
  second <- unlist(lapply(nodes, `[`, -1L))
  once <- first != second & !duplicated(cbind(pmin(first, second), pmax(first, second)))
  on <- rep.int(part[seams$panel], lengths(nodes) - 1L)[once]
  first <- first[once]
  second <- second[once]
  ending <- bar_shares(lattice, which(lattice$bar_part %in% on))
  bars_at <- split(seq_along(ending$node), factor(ending$node, seq_len(lattice$nodes)))
  at <- Map(c, bars_at[first], bars_at[second])
  bars <- as.integer(unlist(at, use.names = FALSE))
  list(
    first = first, second = second, part = on, element = ending$bar[bars],
    group = rep.int(seq_along(at), lengths(at)), weight = ending$share[bars], count = length(at)
  )
}

# Rows of the lattice's table of parts of its panels, in the order of `lattice$panels`.
netting_parts <- function(state) {
  parts <- state$lattice$parts
  match(names(state$lattice$panels), ifelse(parts$kind == "netting", parts$name, NA))
}

# Blocks of k by k cells in grids.
blocks_of <- function(grids, k) {
  sum(vapply(grids, function(g) prod(ceiling((dim(g) - 1) / k)), 0))
}

# The size of blocks of which there are at most so many.
block_to_draw <- function(grids, limit) {
  block <- 1
  longest <- max(0, vapply(grids, function(g) max(dim(g) - 1), 0))
  while (blocks_of(grids, block) > limit && block < longest) block <- block + 1
  block
}

# The twines through blocks of `block` by `block` cells of a panel's grid, with the mean tension of
# their cells. Twines of diamond meshes run along a cell's diagonals, those of square meshes along
# its sides.
panel_cell_lines <- function(state, points, name, part, block) {
  blocks <- block_cells(state, name, part, block)
  mean <- function(tension) {
    weighted_means(tension[blocks$cell], blocks$weight, blocks$block, blocks$count)
  }
  u <- mean(state$u_tension)
  v <- mean(state$v_tension)
  coarse <- state$lattice$panels[[name]]$grid[blocks$columns, blocks$rows, drop = FALSE]
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

# Blocks of `block` by `block` cells of a panel's grid, across first: list(columns, rows = which of
# the grid's bound them, count = blocks, cell = numbers of cells, block = that of each, weight = its
# bars).
block_cells <- function(state, name, part, block) {
  grid <- state$lattice$panels[[name]]$grid
  cell <- state$lattice$panels[[name]]$cell - 1L
  mine <- which(state$lattice$cell_part == part)
  columns <- block_ends(nrow(grid), block)
  rows <- block_ends(ncol(grid), block)
  across <- length(columns) - 1L
  deep <- length(rows) - 1L
  list(
    columns = columns, rows = rows, count = across * deep, cell = mine,
    block = cell %/% nrow(grid) %/% block * across + cell %% nrow(grid) %/% block + 1L,
    weight = cell_bars(state$lattice$mesh$cells, mine)
  )
}

block_ends <- function(n, block) unique(c(seq(1L, n, by = block), n))

# How panels of bars are drawn in lines of about `length` (m), about as far apart: list(every = of
# which twines, merge = how many bars of a twine are drawn as one line).
panel_thinning <- function(state, names, length) {
  drawn <- state$lattice$panels[names]
  side <- vapply(drawn, `[[`, 0, "lambda") *
    vapply(state$si$panels[names], `[[`, 0, "mesh_size") / 2
  bar <- side / vapply(drawn, `[[`, 0L, "segments")
  list(every = pmax(1, round(length / side)), merge = pmax(1, round(length / bar)))
}

# The length (m) at which panels of bars are drawn in at most about so many lines; 0: all bars.
shortest_line <- function(state, names, part, limit) {
  bars <- tabulate(state$lattice$bar_part, nrow(state$lattice$parts))[part]
  if (!length(bars) || sum(bars) <= limit) return(0)
  length <- 1e-3
  repeat {
    thin <- panel_thinning(state, names, length)
    lines <- bars / (thin$merge * thin$every)
    if (sum(lines) <= limit || all(lines < 1)) return(length)
    length <- length * 1.1
  }
}

# The bars of a panel, or lines of about `length` (m) along some of its twines, with the mean
# tension of their bars.
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
  # A line begins where a twine does, and after so many bars.
  begins <- c(TRUE, from[-1L] != to[-length(to)])
  k <- seq_along(kept)
  begins <- begins | (k - k[begins][cumsum(begins)]) %% thin$merge == 0
  line <- cumsum(begins)
  new_lines(
    points, from[begins], to[c(begins[-1L], TRUE)],
    weighted_means(tension[kept], state$lattice$mesh$bars$rest[bars[kept]], line, sum(begins)),
    part
  )
}

# On which equivalent twine of a panel each bar (its two ends) lies: list(family (1 or 2), number
# (counted from the panel's middle), along = where on it, backwards = whether its first end lies
# beyond its second).
bar_twines <- function(state, name, ends) {
  panel <- state$si$panels[[name]]
  drawn <- state$lattice$panels[[name]]
  node <- point_number(drawn$node, state$lattice$nodes)
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

# A piece spread along a rope is marked at up to this many of its nodes.
marks_of_piece <- 24L

piece_marks <- function(state, points) {
  lattice <- state$lattice
  parts <- length(state$si$ropes) + length(state$si$panels) + seq_along(state$si$pieces)
  if (!length(parts)) return(NULL)
  pieces <- unname(state$si$pieces[lattice$parts$name[parts]])
  nodes <- lapply(parts, function(part) {
    node <- unique(lattice$mesh$spheres$node[lattice$sphere_part == part])
    n <- min(length(node), max(marks_of_piece, 1L))
    node[unique(round(seq(1, length(node), length.out = n)))]
  })
  node <- unlist(nodes)
  each <- function(values) rep(values, lengths(nodes))
  role <- vapply(pieces, function(piece) as.character(piece$role), "")
  data.frame(
    x = points[1L, node], y = points[2L, node], z = points[3L, node],
    role = each(ifelse(is.na(role), "other", role)), part = each(lattice$parts$name[parts]),
    size = each(vapply(pieces, piece_size, 0)),
    direction = each(vapply(pieces, function(piece) as.character(piece$lift_direction), ""))
  )
}

# Root of the area (m) in which a piece is seen: its own, of a sphere of its volume, or where it has
# neither (a catch), the area that its drag counts.
piece_size <- function(piece) {
  area <- as.double(piece$area)
  if (!is.na(area)) return(sqrt(area))
  if (piece$volume > 0) sqrt(pi) * (3 * piece$volume / (4 * pi))^(1 / 3) else sqrt(piece$drag_area)
}

# Free otter boards, in the middle of their points.
board_marks <- function(state) {
  do.call(rbind, lapply(names(state$si$otter_boards), function(name) {
    board <- state$si$otter_boards[[name]]
    at <- rowMeans(state$position[, state$lattice$points[board$points]])
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
  node <- state$lattice$points[names(held)]
  if (!length(held)) return(NULL)
  data.frame(
    x = state$position[1L, node], y = state$position[2L, node], z = state$position[3L, node],
    role = vapply(held, function(p) p$held, ""), part = names(held),
    size = NA_real_, direction = NA_character_, row.names = NULL
  )
}
