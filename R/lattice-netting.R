# Netting as elements: cells of a panel's grid, or equivalent bars on its twines. Both put the
# same twine, knots, mass and projected area into the water, and both meet at the panel's edges.
#
# Mesh coordinates of a panel: i meshes across (from the left end of the upper edge), j meshes deep.
# Twine coordinates: diamond and turned meshes u = i + j, v = j - i; square meshes u = i, v = j; one
# unit is one bar.
#
# Functions take several panels as a table (see panel_table()) and make the elements of one panel
# after the other.

# Cells of panels whose nodes lie at these fractions across and deep. Those of hexagonal netting are
# halved along a diagonal, and where a panel ends in a point cells have three corners: these have
# their last corner twice.
#
# across, deep: list(fraction, count), the fractions of all panels and how many each has.
# Returns list(panel, cell = its upper left corner's place in the panel's grid, corner = 4 x cells,
# places in the panels' grids, one grid after the other, in order around the cell, u, v = twine
# coordinates there, rest = length of these twines' bars, straight = that of straight bars, or 0,
# multiplicity, bars = number of bars of one family inside, side = on which side of the panel's
# middle line it lies, -1, 0 or 1).
cell_elements <- function(panels, across, deep) {
  columns <- across$count
  rows <- deep$count
  nodes <- columns * rows
  at <- rep.int(seq_along(columns), nodes)
  k <- sequence(nodes) - 1L
  column <- k %% columns[at]
  row <- k %/% columns[at]
  shape <- pick_panels(panels, at, side_fields)
  j <- deep$fraction[(cumsum(rows) - rows)[at] + row + 1L] * shape$deep
  left <- panel_left(shape, j)
  i <- left + across$fraction[(cumsum(columns) - columns)[at] + column + 1L] *
    (panel_right(shape, j) - left)
  square <- is_square(panels)[at]
  u <- i + j * !square
  v <- j - i * !square
  # The straight bars of turned hexagons run from one twine to the other the opposite way.
  v <- v * ifelse(panels$orientation == "hexagonal_turned", -1, 1)[at]

  a <- which(column < columns[at] - 1L & row < rows[at] - 1L)
  below <- a + columns[at[a]]
  whole <- rbind(a, a + 1L, below + 1L, below, deparse.level = 0L)
  side <- sign(2L * column[a] + 2L - columns[at[a]])
  hexagonal <- panels$straight_bar[at[a]] > 0
  found <- join_cells(list(
    list(corner = whole[, !hexagonal, drop = FALSE], side = side[!hexagonal],
      first = a[!hexagonal], multiplicity = rep(1, sum(!hexagonal))),
    half_cells(whole[, hexagonal, drop = FALSE], side[hexagonal])
  ))
  u <- matrix(u[found$corner], 4L)
  v <- matrix(v[found$corner], 4L)
  # The two upper corners are one where a panel begins in a point.
  wide <- function(p, q) (u[p, ] - u[q, ])^2 + (v[p, ] - v[q, ])^2
  longest <- pmax(wide(1L, 2L), wide(2L, 3L), wide(3L, 4L), wide(4L, 1L))
  begins <- wide(1L, 2L) < 1e-18 * longest
  turn <- function(x) {
    x[, begins] <- x[c(3L, 4L, 1L, 2L), begins]
    x
  }
  u <- turn(u)
  v <- turn(v)
  corner <- turn(found$corner)
  ends <- wide(3L, 4L) < 1e-18 * longest
  u[4L, ends] <- u[3L, ends]
  v[4L, ends] <- v[3L, ends]
  corner[4L, ends] <- corner[3L, ends]
  bars <- cell_area(u, v) * found$multiplicity
  panel <- at[found$first]
  kept <- order(panel)
  largest <- vapply(split_runs(bars[kept], tabulate(panel, length(columns))), max, 0)
  kept <- kept[(bars > 1e-9 * largest[panel])[kept]]
  list(
    panel = panel[kept], cell = k[found$first[kept]] + 1L,
    corner = corner[, kept, drop = FALSE], u = u[, kept, drop = FALSE],
    v = v[, kept, drop = FALSE],
    rest = (panels$mesh_size / 2 - panels$straight_bar)[panel[kept]],
    straight = panels$straight_bar[panel[kept]], multiplicity = found$multiplicity[kept],
    bars = bars[kept], side = found$side[kept]
  )
}

# Cells halved along a diagonal, which changes sides at the panel's middle line, so that a panel's
# mirror image is divided as its mirror image; in a middle column both diagonals have half weight.
half_cells <- function(corner, side) {
  falling <- side <= 0
  rising <- side >= 0
  halves <- function(some, places) {
    list(
      corner = corner[c(places, places[3L]), some, drop = FALSE], side = side[some],
      first = corner[1L, some], multiplicity = 1 - 0.5 * (side[some] == 0)
    )
  }
  join_cells(list(
    halves(falling, c(1L, 2L, 3L)), halves(falling, c(1L, 3L, 4L)),
    halves(rising, c(1L, 2L, 4L)), halves(rising, c(2L, 3L, 4L))
  ))
}

# Groups of cells as one: each list(corner, side, first = upper left corner, multiplicity).
join_cells <- function(groups) {
  list(
    corner = do.call(cbind, lapply(groups, `[[`, "corner")),
    side = unlist(lapply(groups, `[[`, "side")), first = unlist(lapply(groups, `[[`, "first")),
    multiplicity = unlist(lapply(groups, `[[`, "multiplicity"))
  )
}

# Equivalent bars of panels. Knots lie lambda bars apart along the twines. Twines end where they
# cross an edge, and what lies on an edge is tied to the edge's nodes; there are no knots within a
# quarter of an equivalent mesh of an edge but where a twine runs nearly along it, and these are
# moved onto it. Multiplicities are scaled to the panel's exact length of twine.
#
# Returns list(points, bars), see bar_points() and split_bars().
bar_elements <- function(panels, grouping) {
  rows <- at_least_one(round((2 - is_square(panels)) * panels$deep / grouping$lambda))
  knots <- knot_rows(panels, grouping$lambda, rows)
  twines <- knot_twines(knots, is_square(panels), rows)
  lambda <- grouping$lambda
  panel <- seq_along(rows)

  cut <- cut_twines(knots, twines)
  whole <- twines$from_kept & twines$to_kept & !cut$instead
  from <- twines$from[whole]
  to <- twines$to[whole]
  # A twine on an edge, but for the upper and lower edge of diamond netting, belongs half to each
  # neighbour.
  ends_row <- is_square(panels)[knots$panel] & (knots$row == 0L | knots$row == rows[knots$panel])
  along_edge <- (knots$edge[from] == knots$edge[to] & knots$edge[from] > 0L) |
    (ends_row[from] & knots$row[from] == knots$row[to])

  # Knots and cut ends of each panel follow each other.
  kept <- which(knots$kept)
  number <- cumsum(knots$kept)
  of_points <- c(knots$panel[kept], knots$panel[cut$inner])
  first <- c(number[from], number[cut$inner])
  second <- c(number[to], length(kept) + seq_along(cut$inner))
  used <- logical(length(of_points))
  used[first] <- used[second] <- TRUE
  order <- order(of_points)
  order <- order[used[order]]
  place <- integer(length(used))
  place[order] <- seq_along(order)
  points <- bar_points(panels, list(
    panel = of_points[order], i = c(knots$i[kept], cut$i)[order],
    j = c(knots$j[kept], cut$j)[order], edge = c(knots$edge[kept], cut$edge)[order]
  ))

  of_bars <- c(knots$panel[from], knots$panel[cut$inner])
  rest <- c(rep.int(1, length(from)), cut$share) * lambda[of_bars] * panels$mesh_size[of_bars] / 2
  multiplicity <- lambda[of_bars] * c(1 - 0.5 * along_edge, rep.int(1, length(cut$share)))
  order <- order(of_bars)
  of_bars <- of_bars[order]
  rest <- rest[order]
  multiplicity <- multiplicity[order]
  exact <- 2 * panel_bars(panels) * panels$mesh_size / 2
  built <- vapply(split_runs(multiplicity * rest, tabulate(of_bars, length(rows))), sum, 0)
  multiplicity <- multiplicity * exact[of_bars] / built[of_bars]
  list(points = points, bars = split_bars(
    points, of_bars, place[first[order]], place[second[order]], rest, multiplicity,
    grouping$segments
  ))
}

# Gears whose twine alone differs have them in common.
bar_elements_again <- remembered(bar_elements)

# All knots that may lie in a panel, row by row, with two beyond the panel at both ends of a row.
#
# Returns list(panel, row (0 at the upper edge), shift = of a row by half a mesh, i, at = i before
# it was moved, j, left, right = i of the panel's sides there, edge = 3 or 4 where moved onto a
# side, kept; width, first = of every panel, knots in a row and knots before its first).
knot_rows <- function(panels, lambda, rows) {
  # A knot at the left end of the upper edge, or midway where that fits the width better.
  meshes <- round(panels$upper / lambda)
  half <- abs(panels$upper / lambda - meshes) < 1e-6 & meshes %% 2 == 1
  centre <- panels$upper / 2 + half * lambda / 2
  low <- panel_left(panels, panels$deep)
  low[low > 0] <- 0
  high <- panel_right(panels, panels$deep)
  beyond <- high < panels$upper
  high[beyond] <- panels$upper[beyond]
  begin <- floor((low - centre) / lambda) - 2
  width <- as.integer(ceiling((high - centre) / lambda) + 3 - begin)
  size <- width * (rows + 1L)

  panel <- rep.int(seq_along(rows), size)
  k <- sequence(size) - 1L
  row <- k %/% width[panel]
  shift <- row %% 2L * !is_square(panels)[panel]
  i <- centre[panel] + lambda[panel] * (begin[panel] + k %% width[panel] + shift / 2)
  j <- row * (panels$deep / rows)[panel]
  shape <- pick_panels(panels, panel, side_fields)
  left <- panel_left(shape, j)
  right <- panel_right(shape, j)
  from_left <- i - left
  from_right <- right - i
  near <- (lambda / 4 + 1e-9)[panel]
  # The twines of the first and the last row of diamonds end there, not at a side.
  ends <- !is_square(panels)[panel] & (row == 0L | row == rows[panel])
  on_left <- abs(from_left) <= near & !(ends & from_left > 1e-9 * near)
  on_right <- abs(from_right) <= near & !(ends & from_right > 1e-9 * near) & !on_left
  at <- i
  i[on_left] <- left[on_left]
  i[on_right] <- right[on_right]
  list(
    panel = panel, row = row, shift = shift, i = i, at = at, j = j, left = left, right = right,
    edge = 3L * on_left + 4L * on_right, kept = from_left >= -near & from_right >= -near,
    width = width, first = cumsum(size) - size
  )
}

# Twines between knots of which one at least is kept: they run to the next row, those of square
# meshes also along the row; first those of one family, then of the other. No knot is kept at the
# ends of a row, so none has a neighbour in another row.
knot_twines <- function(knots, square, rows) {
  number <- length(knots$panel)
  down <- seq_len(number)
  below <- down + knots$width[knots$panel] + knots$shift
  other <- below - 1L
  along <- square[knots$panel]
  other[along] <- down[along] + 1L
  last_row <- knots$row == rows[knots$panel]
  kept <- c(knots$kept, logical(max(knots$width, 0L) + 1L))
  # Knots of the last row have none below.
  u <- which(!last_row & (knots$kept | kept[below]))
  v <- which((along | !last_row) & (knots$kept | kept[other]))
  from <- c(u, v)
  to <- c(below[u], other[v])
  list(from = from, to = to, from_kept = knots$kept[from], to_kept = kept[to])
}

# Twines that end on a side: those that leave over it, cut where they meet it, and those whose last
# knot is near it, cut there or drawn out to it along the twine, so that lengths are exact. A twine
# that runs nearly along the side keeps its knot, moved onto the side.
#
# Returns list(inner = the knot inside, i, j, edge = where the end lies, share = of the twine that
# is left, instead = which of all twines are so ended at a knot that is kept).
cut_twines <- function(knots, twines) {
  leaves <- twines$from_kept != twines$to_kept
  both <- twines$from_kept & twines$to_kept
  nears <- both & (knots$edge[twines$from] > 0L) != (knots$edge[twines$to] > 0L)
  some <- which(leaves | nears)
  starts <- ifelse(leaves, twines$from_kept, knots$edge[twines$from] == 0L)[some]
  inner <- ifelse(starts, twines$from[some], twines$to[some])
  outer <- ifelse(starts, twines$to[some], twines$from[some])
  side <- knots$edge[outer]
  beyond <- 4L - (knots$at[outer] < knots$left[outer])
  side[side == 0L] <- beyond[side == 0L]
  gap <- function(k) {
    ifelse(side == 3L, knots$at[k] - knots$left[k], knots$right[k] - knots$at[k])
  }
  inside <- gap(inner)
  share <- inside / (inside - gap(outer))
  kept <- nears[some]
  # what lies on the side is a knot of it
  ended <- knots$edge[inner] == 0L & (!kept | (abs(gap(outer)) > 1e-9 * inside &
    is.finite(share) & share > 0.45 & share < 1.55))
  instead <- logical(length(leaves))
  instead[some[ended & kept]] <- TRUE
  inner <- inner[ended]
  outer <- outer[ended]
  share <- share[ended]
  list(
    inner = inner, share = share, edge = side[ended],
    i = knots$at[inner] + share * (knots$at[outer] - knots$at[inner]),
    j = knots$j[inner] + share * (knots$j[outer] - knots$j[inner]), instead = instead
  )
}

# Knots and cut ends with the edge that each lies on (0: none), its fraction along that edge, and
# how many knots of the plan it stands for.
bar_points <- function(panels, points) {
  deep <- panels$deep[points$panel]
  points$edge[points$edge == 0L & points$j <= 1e-9 * deep] <- 1L
  points$edge[points$edge == 0L & points$j >= deep * (1 - 1e-9)] <- 2L
  points$fraction <- points$j / deep
  ends <- which(points$edge <= 2L)
  shape <- pick_panels(panels, points$panel[ends], side_fields)
  left <- panel_left(shape, points$j[ends])
  across <- panel_right(shape, points$j[ends]) - left
  across[across < 1e-300] <- 1e-300
  points$fraction[ends] <- (points$i[ends] - left) / across
  # A knot on an edge belongs half to the neighbour.
  weight <- 1 - 0.5 * (points$edge > 0L)
  all <- sum_by(weight, points$panel, length(panels$deep))
  points$knots <- panel_bars(panels)[points$panel] * weight / all[points$panel]
  points
}

# Bars cut into equal segments by points of their own (the middles of the mesh bars).
#
# segments: of every panel.
# Returns list(panel, ends = first and second end of each bar, numbers of points or, negative, of
# those between, rest, multiplicity, between = list(panel, i, j)).
split_bars <- function(points, panel, first, second, rest, multiplicity, segments) {
  of_bar <- segments[panel]
  inner <- of_bar - 1L
  bar <- rep.int(seq_along(panel), inner)
  share <- sequence(inner) / of_bar[bar]
  between <- function(x) (1 - share) * x[first[bar]] + share * x[second[bar]]
  part <- rep.int(seq_along(panel), of_bar)
  step <- sequence(of_bar)
  before <- (cumsum(inner) - inner)[part]
  from <- -(before + step - 1L)
  begins <- step == 1L
  from[begins] <- first[part[begins]]
  to <- -(before + step)
  finishes <- step == of_bar[part]
  to[finishes] <- second[part[finishes]]
  list(
    panel = panel[part], ends = as.vector(rbind(from, to)), rest = (rest / of_bar)[part],
    multiplicity = multiplicity[part],
    between = list(panel = panel[bar], i = between(points$i), j = between(points$j))
  )
}
