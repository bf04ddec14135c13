# The catch: which part of the netting around it lies behind its front, as pressure on triangles of
# its cells, or of the sheets between its bars, and the volume that it encloses.
#
# A ring of n straight cells encloses less than the circle of its girth: its area is less by
# n tan(pi / n) / pi. Pressure and volume count with the circle's.

# Adds to a lattice `catch`: list(cell = of every triangle that it may lie against (NA: of a sheet),
# node = 3 x these, depth, across = 3 x these, meshes from the lower edge and along it, real = share
# of each that is real, weight = the same signed, with the circle's share: negative where its normal
# points inward), or nothing; and to its engine the pressure, behind the front that the plan gives
# or a first guess.
add_catch <- function(si, lattice) {
  lattice$engine$pressure <- list(
    node = integer(), weight = numeric(),
    drag_coefficient = first_of(si$catch$drag_coefficient, 0)
  )
  if (is.null(si$catch)) return(lattice)
  cells <- lattice$engine$cells
  sheets <- lattice$sheets
  part <- length(si$ropes) + match(si$catch$panels, names(si$panels))
  some <- which(lattice$cell_part %in% part)
  other <- which(sheets$part %in% part)
  panel <- c(lattice$cell_part[some], sheets$part[other])
  orientation <- vapply(si$panels, `[[`, "", "orientation")[panel - length(si$ropes)]
  at <- Map(cbind, cell_twine_places(cells, some), cell_twine_places(sheets, other))
  corner <- cbind(cell_corners(lattice, some), matrix(sheets$node, 4L)[, other, drop = FALSE])
  multiplicity <- c(cells$multiplicity[some], rep(1, length(other)))
  v <- at$v * rep(ifelse(orientation == "hexagonal_turned", -1, 1), each = 4L)
  square <- matrix(rep(orientation == "square", each = 4L), 4L)
  depth <- si$catch$deep - ifelse(square, v, (at$u + v) / 2)
  across <- ifelse(square, at$u, (at$u - v) / 2)
  round <- circle_share(around_at(si, colMeans(depth)) / (apply(across, 2L, max) -
    apply(across, 2L, min)))
  triangles <- cell_triangles(has_three_corners(corner))
  place <- triangles$corner + 4L * rep(triangles$cell - 1L, each = 3L)
  panel <- panel[triangles$cell]
  lattice$catch <- list(
    cell = c(some, rep(NA, length(other)))[triangles$cell],
    node = matrix(corner[place], 3L), depth = matrix(depth[place], 3L),
    across = matrix(across[place], 3L), real = multiplicity[triangles$cell] * triangles$weight,
    weight = (multiplicity * round)[triangles$cell] * triangles$weight
  )
  # Panels are laid out round the catch from the start, whichever way round.
  outward <- panel_volumes(lattice, lattice$start, panel)
  if (any(outward == 0)) {
    abort_plan(
      "The netting around the catch encloses nothing; all panels in `catch.panels` must be joined.",
      "catch.panels", si$catch$panels
    )
  }
  lattice$catch$weight <- lattice$catch$weight * sign(outward)
  guess <- if (is.na(si$catch$blocked)) 0.3 * si$catch$deep else si$catch$blocked
  set_catch_front(lattice, guess)
}

# Meshes around the catch so many meshes (depth) from the lower edges of its panels.
around_at <- function(si, depth) {
  panels <- si$panels[si$catch$panels]
  sum_of <- function(edge) sum(vapply(panels, `[[`, 0, edge))
  sum_of("lower") + (sum_of("upper") - sum_of("lower")) * depth / si$catch$deep
}

# Area of a circle over that of a polygon of n equal sides with its girth.
circle_share <- function(n) {
  n <- pmax(n, 3)
  n * tan(pi / n) / pi
}

# The start with the netting around the catch as a bag that hangs open at the nominal ratio and
# closes over its last third: from a slender cone the solver may pull its twines through each other.
round_start <- function(si, lattice) {
  start <- lattice$start
  free <- !lattice$engine$held
  node <- as.vector(lattice$catch$node)
  # points tied between nodes follow them
  first <- !duplicated(node) & node <= ncol(start)
  depth <- round(as.vector(lattice$catch$depth)[first], 6)
  node <- node[first]
  around <- sum(vapply(si$panels[si$catch$panels], function(p) p$upper * mesh_unit(p), 0))
  radius <- nominal_hanging_ratio * around / (2 * pi)
  for (row in split(seq_along(node), depth)) {
    ring <- node[row]
    left <- depth[row[1]] / si$catch$deep
    closing <- max(0, 1 - 3 * left)
    share <- min(1, 3 * (1 - left))
    middle <- rowMeans(start[, ring, drop = FALSE])
    out <- start[, ring, drop = FALSE] - middle
    size <- mean(sqrt(colSums(out^2)))
    wanted <- share * radius * sqrt(1 - closing^2) + (1 - share) * size
    if (size == 0 || wanted <= size) next
    moved <- middle + out * (wanted / size)
    start[, ring[free[ring]]] <- moved[, free[ring]]
  }
  start
}

# The volume (m3) between each triangle's whole panel and the middle of all, by triangle.
panel_volumes <- function(lattice, position, panel) {
  position <- lattice_points(lattice, position)
  middle <- rowMeans(position[, as.vector(lattice$catch$node), drop = FALSE])
  corner <- function(k) position[, lattice$catch$node[k, ], drop = FALSE] - middle
  volume <- triple_product(corner(1L), corner(2L), corner(3L)) / 6 * lattice$catch$weight
  unname(rowsum(volume, panel)[as.character(panel), 1])
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
