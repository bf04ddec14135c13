# The catch: which part of the netting around it lies behind its front, as pressure on triangles of
# its cells, or of the sheets between its bars, and the volume that it encloses.
#
# A ring of n straight cells encloses less than the circle of its girth: its area is less by
# n tan(pi / n) / pi. Pressure and volume count with the circle's.

# Adds to a lattice `catch`: list(cell = of every triangle that it may lie against (NA: of a sheet),
# node = 3 x these, depth, across = 3 x these, meshes from the lower edge and along it, real = share
# of each that is real, weight = the same signed, with the circle's share: negative where its normal
# points inward), or nothing; and to its engine the pressure, behind the front that the plan gives
# or a first guess. bag: what the engine found of it.
add_catch <- function(si, lattice, bag) {
  lattice$engine$pressure <- list(
    node = integer(), weight = numeric(),
    drag_coefficient = first_of(si$catch$drag_coefficient, 0)
  )
  if (is.null(si$catch)) return(lattice)
  if (!bag$encloses) {
    abort_plan(
      "The netting around the catch encloses nothing; all panels in `catch.panels` must be joined.",
      "catch.panels", si$catch$panels
    )
  }
  lattice$catch <- c(
    list(cell = replace(bag$cell, bag$cell == 0L, NA)),
    lapply(bag[c("node", "depth", "across")], matrix, 3L), bag[c("real", "weight")]
  )
  set_catch_front(lattice, if (is.na(si$catch$blocked)) 0.3 * si$catch$deep else si$catch$blocked)
}

triple_product <- function(a, b, c) {
  a[1, ] * (b[2, ] * c[3, ] - b[3, ] * c[2, ]) + a[2, ] * (b[3, ] * c[1, ] - b[1, ] * c[3, ]) +
    a[3, ] * (b[1, ] * c[2, ] - b[2, ] * c[1, ])
}

# The lattice with the catch's front `blocked` meshes from the lower edges.
set_catch_front <- function(lattice, blocked) {
  held <- lattice$catch
  pieces <- covered_pieces(behind_front(held$depth, blocked))
  weight <- matrix(0, ncol(held$depth), 3L)
  sums <- rowsum(
    pieces$share / 3 * (pieces$corner[[1]] + pieces$corner[[2]] + pieces$corner[[3]]),
    pieces$triangle
  )
  weight[as.integer(rownames(sums)), ] <- sums
  lattice$engine$pressure$node <- as.vector(held$node)
  lattice$engine$pressure$weight <- as.vector(t(weight * held$weight))
  lattice$catch$blocked <- blocked
  lattice
}

# Meshes from the front back, with rows of nodes that only rounding keeps off the front on it.
behind_front <- function(depth, blocked) {
  inside <- blocked - depth
  inside[abs(inside) < 1e-9 * max(depth)] <- 0
  inside
}

# The parts of triangles where a quantity that is linear inside, `inside` (3 x triangles) at the
# corners, is positive, cut into triangles.
#
# Returns list(triangle, share = of the whole triangle's area, corner = three matrices with a row of
# weights of the triangle's corners each, front = for each of these whether it lies where the
# quantity is 0).
covered_pieces <- function(inside) {
  whole <- which(colSums(inside >= 0) == 3L)
  found <- list(list(whole, c(1L, 2L, 3L), c(1L, 2L, 3L)))
  for (k in 1:3) {
    l <- k %% 3L + 1L
    m <- l %% 3L + 1L
    tip <- which(inside[k, ] >= 0 & inside[l, ] < 0 & inside[m, ] < 0 & inside[k, ] > 0)
    base <- which(inside[k, ] < 0 & inside[l, ] >= 0 & inside[m, ] >= 0)
    # Corners as pairs between which each lies.
    found <- c(found, list(
      list(tip, c(k, k, k), c(k, l, m)),
      list(base, c(l, m, k), c(l, m, l)), list(base, c(m, k, k), c(m, m, l))
    ))
  }
  one <- diag(3)
  corner <- front <- list()
  for (k in 1:3) {
    corner[[k]] <- do.call(rbind, lapply(found, function(f) {
      from <- f[[2]][k]
      to <- f[[3]][k]
      a <- inside[from, f[[1]]]
      b <- inside[to, f[[1]]]
      s <- if (from == to) 0 * a else a / (a - b)
      outer(1 - s, one[from, ]) + outer(s, one[to, ])
    }))
    front[[k]] <- unlist(lapply(found, function(f) {
      rep(f[[2]][k] != f[[3]][k], length(f[[1]])) |
        (f[[2]][k] == f[[3]][k] & inside[f[[2]][k], f[[1]]] == 0)
    }))
  }
  share <- triple_product(t(corner[[1]]), t(corner[[2]]), t(corner[[3]]))
  list(triangle = unlist(lapply(found, `[[`, 1L)), share = abs(share), corner = corner,
    front = front)
}

# Volume (m3) that netting behind the catch's front encloses with a front drawn from its edge to the
# edge's middle.
catch_volume <- function(lattice, position) {
  held <- lattice$catch
  position <- lattice_points(lattice, position)
  pieces <- covered_pieces(behind_front(held$depth, held$blocked))
  corner <- piece_corners(held, pieces, position)
  edge <- do.call(cbind, Map(function(x, on) x[, on, drop = FALSE], corner, pieces$front))
  middle <- rowMeans(edge)
  volume <- triple_product(corner[[1]] - middle, corner[[2]] - middle, corner[[3]] - middle) / 6
  sum(volume * held$weight[pieces$triangle]) + bulge_volume(held, pieces, corner, position)
}

# Area (m2) of the netting behind the catch's front.
catch_surface <- function(lattice, position) {
  held <- lattice$catch
  pieces <- covered_pieces(behind_front(held$depth, held$blocked))
  corner <- piece_corners(held, pieces, lattice_points(lattice, position))
  sum(triangle_sizes(corner) * held$real[pieces$triangle])
}

# Places of the corners of pieces of a catch's triangles: three matrices, 3 x pieces.
piece_corners <- function(held, pieces, position) {
  node <- held$node[, pieces$triangle, drop = FALSE]
  lapply(pieces$corner, function(corner) {
    weigh <- function(k) position[, node[k, ], drop = FALSE] * rep(corner[, k], each = 3L)
    weigh(1L) + weigh(2L) + weigh(3L)
  })
}

triangle_sizes <- function(corner) {
  sqrt(colSums(cross_columns(corner[[2]] - corner[[1]], corner[[3]] - corner[[1]])^2)) / 2
}

cross_columns <- function(a, b) {
  rbind(
    a[2, ] * b[3, ] - a[3, ] * b[2, ], a[3, ] * b[1, ] - a[1, ] * b[3, ],
    a[1, ] * b[2, ] - a[2, ] * b[1, ]
  )
}

# Volume (m3) between flat pieces and netting that is curved lengthwise; around, the circle's share
# counts it. A piece of area A under a surface with sags s at the middles of its sides has
# A sum(s) / 3 between, and a side e has s = II(e, e) / 8, with the change of the surface's normal
# along a triangle's sides as its second form II. Half of it is missing: netting keeps its length,
# so that its chords lie outside of the arc as far as inside, as those of a polygon with a circle's
# girth.
bulge_volume <- function(held, pieces, corner, position) {
  place <- function(k) position[, held$node[k, ], drop = FALSE]
  at <- lapply(1:3, place)
  out <- cross_columns(at[[2]] - at[[1]], at[[3]] - at[[1]]) *
    rep(sign(held$weight) * held$real, each = 3L)
  node <- as.vector(t(held$node))
  used <- sort(unique(node))
  own <- matrix(match(held$node, used), 3L)
  normal <- rowsum(rbind(t(out), t(out), t(out)), node)
  long <- sqrt(rowSums(normal^2))
  # where netting is gathered it has a tip, not a normal
  tip <- long < least_agreement * rowsum(rep(sqrt(colSums(out^2)), 3L), node)[, 1L]
  normal <- t(normal / long)
  form <- function(i, j) {
    colSums((normal[, own[j, ], drop = FALSE] - normal[, own[i, ], drop = FALSE]) *
      (at[[j]] - at[[i]]))
  }
  first <- form(1L, 2L)
  second <- form(1L, 3L)
  mixed <- (first + second - form(2L, 3L)) / 2
  step <- function(x, k) x[k, ] - x[1L, ]
  twice <- step(held$depth, 2L) * step(held$across, 3L) -
    step(held$depth, 3L) * step(held$across, 2L)
  a <- step(held$across, 3L) / twice
  b <- -step(held$across, 2L) / twice
  lengthwise <- a^2 * first + b^2 * second + 2 * a * b * mixed
  lengthwise[colSums(matrix(tip[own], 3L)) > 0 | !is.finite(lengthwise)] <- 0
  of <- pieces$triangle
  depth <- lapply(pieces$corner, function(corner) {
    rowSums(corner * t(held$depth)[of, , drop = FALSE])
  })
  sides <- (depth[[2]] - depth[[1]])^2 + (depth[[3]] - depth[[2]])^2 + (depth[[1]] - depth[[3]])^2
  sum(triangle_sizes(corner) * held$real[of] * lengthwise[of] * sides) / 24 / 2
}

# Length of the sum of normals around a node over that of all, below which they point all ways.
least_agreement <- 0.8
