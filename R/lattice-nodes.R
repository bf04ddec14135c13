# Nodes of a lattice: points, ropes and panels number their own, and seams, laced ropes and names
# for one place make them the same.

# Fractions along an edge of its nodes, from its pieces' counts.
edge_fractions <- function(pieces, counts, edge) {
  mine <- pieces$first[edge] + seq_len(pieces$count_of[edge])
  f <- unlist(lapply(mine, function(k) {
    pieces$from[k] + (pieces$to[k] - pieces$from[k]) * seq(0, counts[k] - 1L) / counts[k]
  }))
  c(f, 1)
}

# The division of a gear: for each panel its grid or its edges, for each rope its nodes; all in one
# numbering 1..n of nodes. `bars` tells which panels are lattices of bars.
divide <- function(si, pieces, counts, rope_count, bars, chains) {
  panels <- si$panels
  next_id <- 0L
  take <- function(n) {
    ids <- next_id + seq_len(n)
    next_id <<- next_id + n
    ids
  }
  point_id <- take(length(si$points))
  names(point_id) <- names(si$points)

  fractions <- lapply(seq_len(4L * length(panels)), edge_fractions, pieces = pieces, counts = counts)
  edge_nodes <- vector("list", 4L * length(panels))
  grids <- vector("list", length(panels))
  a <- b <- list()
  same <- function(x, y) {
    a[[length(a) + 1L]] <<- x
    b[[length(b) + 1L]] <<- y
  }
  for (p in seq_along(panels)) {
    e <- 4L * (p - 1L)
    if (bars[p]) {
      for (k in 1:4) edge_nodes[[e + k]] <- take(length(fractions[[e + k]]))
      ends <- function(k) edge_nodes[[e + k]][c(1L, length(edge_nodes[[e + k]]))]
      same(ends(1)[1], ends(3)[1])
      same(ends(1)[2], ends(4)[1])
      same(ends(2)[1], ends(3)[2])
      same(ends(2)[2], ends(4)[2])
    } else {
      columns <- length(fractions[[e + 1L]])
      rows <- length(fractions[[e + 3L]])
      grid <- matrix(take(columns * rows), columns, rows)
      grids[[p]] <- grid
      edge_nodes[[e + 1L]] <- grid[, 1L]
      edge_nodes[[e + 2L]] <- grid[, rows]
      edge_nodes[[e + 3L]] <- grid[1L, ]
      edge_nodes[[e + 4L]] <- grid[columns, ]
    }
  }
  on_chain <- function(chain) {
    nodes <- lapply(seq_along(chain$edge), function(k) {
      e <- chain$edge[k]
      f <- fractions[[e]]
      lo <- min(chain$from[k], chain$to[k])
      hi <- max(chain$from[k], chain$to[k])
      inside <- which(f > lo - break_tolerance & f < hi + break_tolerance)
      if (chain$from[k] > chain$to[k]) inside <- rev(inside)
      list(node = edge_nodes[[e]][inside],
           at = chain$start[k] + (f[inside] - chain$from[k]) / (chain$to[k] - chain$from[k]) *
             (chain$end[k] - chain$start[k]))
    })
    # Where one edge of a chain ends and the next begins there are two names for one node.
    joints <- seq_len(length(nodes) - 1L)
    for (k in joints) same(nodes[[k]]$node[length(nodes[[k]]$node)], nodes[[k + 1L]]$node[1L])
    list(
      node = c(nodes[[1]]$node, unlist(lapply(nodes[-1], function(n) n$node[-1L]))),
      at = c(nodes[[1]]$at, unlist(lapply(nodes[-1], function(n) n$at[-1L])))
    )
  }
  for (seam in chains$joined) {
    first <- on_chain(seam[[1]])$node
    for (chain in seam[-1]) same(first, on_chain(chain)$node)
  }

  held_edges <- lapply(chains$held, function(held) {
    run <- on_chain(held$chain)
    same(run$node[c(1L, length(run$node))], unname(point_id[held$between]))
    c(run, held["between"])
  })

  ropes <- lapply(seq_along(si$ropes), function(r) {
    rope <- si$ropes[[r]]
    if (!is.null(rope$along)) {
      return(on_chain(chains$laced[[names(si$ropes)[r]]]))
    }
    ids <- take(rope_count[r] + 1L)
    list(node = ids, at = seq(0, 1, length.out = length(ids)))
  })
  names(ropes) <- names(si$ropes)

  place <- function(text) {
    ref <- parse_place(text)
    if (ref$kind == "point") return(point_id[[ref$name]])
    if (ref$kind == "panel") {
      e <- 4L * (match(ref$name, names(panels)) - 1L)
      nodes <- edge_nodes[[e + if (startsWith(ref$place, "upper")) 1L else 2L]]
      return(if (endsWith(ref$place, "left")) nodes[1L] else nodes[length(nodes)])
    }
    rope <- ropes[[ref$name]]
    switch(ref$place,
      start = rope$node[1L],
      end = rope$node[length(rope$node)],
      middle = rope$node[which.min(abs(rope$at - 0.5))]
    )
  }
  for (r in names(ropes)) {
    rope <- si$ropes[[r]]
    if (is.null(rope$along)) {
      same(ropes[[r]]$node[1L], place(rope$from))
      same(ropes[[r]]$node[length(ropes[[r]]$node)], place(rope$to))
    }
  }
  for (name in names(si$points)) {
    ref <- si$points[[name]]$at
    if (!is.null(ref)) same(point_id[[name]], place(ref))
  }
  for (gather in chains$gathered) {
    target <- place(gather$at)
    for (chain in gather$chains) {
      node <- on_chain(chain)$node
      same(node, rep(target, length(node)))
    }
  }
  label <- joined_labels(next_id, unlist(a), unlist(b))
  number <- match(label, unique(label))
  renumber <- function(x) {
    if (is.matrix(x)) matrix(number[x], nrow(x), ncol(x)) else number[x]
  }
  list(
    nodes = max(number, 0L),
    points = setNames(number[point_id], names(point_id)),
    fractions = fractions,
    edge_nodes = lapply(edge_nodes, renumber),
    grids = lapply(grids, function(g) if (is.null(g)) NULL else renumber(g)),
    ropes = lapply(ropes, function(r) list(node = renumber(r$node), at = r$at)),
    held_edges = lapply(held_edges, function(edge) {
      edge$node <- renumber(edge$node)
      edge
    }),
    laced = function(chain) {
      found <- on_chain(chain)
      list(node = renumber(found$node), at = found$at)
    },
    place = function(text) number[place(text)]
  )
}
