# Sheets between equivalent bars, on which netting of bars has what cells have as a whole: drag as a
# screen or blended, a catch's pressure, the couples of stiff knots.

# Adds sheets to those panels of bars that need them: triangles between the rows of their knots,
# which end on the panel's sides.
#
# panels: the table of panels of bars; numbers, parts: which panels and parts of the gear they are;
# points: as bar_points(), id: their numbers; lambda: of every panel.
add_bar_sheets <- function(build, panels, numbers, parts, division, points, id, lambda) {
  rows <- at_least_one(round((2 - is_square(panels)) * panels$deep / lambda))
  row <- points$j * (rows / panels$deep)[points$panel]
  some <- which(
    panels$sheets[points$panel] & abs(row - round(row)) < 1e-6
  )
  if (!length(some)) return(invisible())
  known <- list(panel = points$panel[some], row = as.integer(round(row[some])),
    i = points$i[some], id = id[some])
  known <- sided_rows(build, panels, numbers, rows, known, division)
  order <- order(known$panel, known$row, known$s)
  known <- lapply(known, `[`, order)
  facets <- row_facets(known$panel, known$row, known$s)
  j <- known$row * (panels$deep / rows)[known$panel]
  square <- is_square(panels)[known$panel]
  u <- matrix((known$i + j * !square)[facets], 3L)
  v <- matrix((j - known$i * !square)[facets], 3L)
  bars <- triangle_area(u, v)
  panel <- known$panel[facets[1L, ]]
  kept <- which(bars > 1e-9 * (lambda^2)[panel])
  facets <- facets[c(1:3, 3L), kept, drop = FALSE]
  u <- u[c(1:3, 3L), kept, drop = FALSE]
  v <- v[c(1:3, 3L), kept, drop = FALSE]
  panel <- panel[kept]
  build$add("sheets",
    node = known$id[facets], twine = as.vector(rbind(as.vector(u), as.vector(v))),
    height = surface_height(twine_width(panels)[panel], (lambda * panels$mesh_size / 2)[panel]),
    part = parts[panel]
  )
}

# Rows of knots with an end on either side of their panel: list(panel, row, i, id, s = fraction of
# the panel's width).
sided_rows <- function(build, panels, numbers, rows, known, division) {
  of <- sort(unique(known$panel))
  panel <- rep.int(of, rows[of] + 1L)
  row <- sequence(rows[of] + 1L) - 1L
  shape <- pick_panels(panels, panel, side_fields)
  depth <- row / rows[panel]
  left <- panel_left(shape, depth * shape$deep)
  right <- panel_right(shape, depth * shape$deep)
  at <- match(
    known$panel * (max(rows) + 2) + known$row, panel * (max(rows) + 2) + row
  )
  width <- pmax(right - left, 1e-9)
  s <- pmin(pmax((known$i - left[at]) / width[at], 0), 1)
  ends <- function(share, side, place) {
    open <- setdiff(seq_along(panel), at[abs(s - share) < 1e-6])
    list(
      panel = panel[open], row = row[open], i = place[open],
      id = edge_points(build, division, 4L * (numbers[panel[open]] - 1L) + side, depth[open]),
      s = rep(share, length(open))
    )
  }
  groups <- list(c(known, list(s = s)), ends(0, 3L, left), ends(1, 4L, right))
  lapply(c(panel = "panel", row = "row", i = "i", id = "id", s = "s"), function(field) {
    unlist(lapply(groups, `[[`, field), use.names = FALSE)
  })
}

# Facets (3 x n) between the places of each row (in order of s) and the next one of the same panel.
# In the order of s each place of two rows makes one with the last ones met of its own and of the
# other row.
row_facets <- function(panel, row, s) {
  number <- cumsum(c(TRUE, diff(panel) != 0 | diff(row) != 0))
  of <- panel[!duplicated(number)]
  # strips between two rows, by the number of the upper one
  has_lower <- c(of[-1L] == of[-length(of)], FALSE)
  has_upper <- c(FALSE, has_lower[-length(of)])
  upper <- which(has_lower[number])
  lower <- which(has_upper[number])
  all <- c(upper, lower)
  strip <- c(number[upper], number[lower] - 1L)
  order <- order(strip, s[all])
  is_upper <- (seq_along(all) <= length(upper))[order]
  strip <- strip[order]
  all <- all[order]
  place <- seq_along(all)
  # the last place of a row before each, in its strip; 0: none
  first <- place[match(strip, strip)]
  last <- function(mine) {
    found <- c(0L, cummax(place * mine))[place]
    found * (found >= first)
  }
  before_upper <- last(is_upper)
  before_lower <- last(!is_upper)
  some <- which(before_upper > 0L & before_lower > 0L)
  rbind(all[before_upper[some]], all[before_lower[some]], all[some])
}

# Points at these fractions of edges: their nodes, or points tied between two of them.
edge_points <- function(build, division, edge, at) {
  order <- order(edge)
  edge <- edge[order]
  at <- pmin(pmax(at[order], 0), 1)
  cell <- cell_of(at, edge, division)
  low <- division$fraction[cell]
  share <- (at - low) / (division$fraction[cell + 1L] - low)
  first <- division$edge_node[cell]
  second <- division$edge_node[cell + 1L]
  whole <- share < 1e-6 | share > 1 - 1e-6 | first == second
  found <- first
  beyond <- share > 0.5
  found[beyond] <- second[beyond]
  found[!whole] <- build$tie(first[!whole], second[!whole], share[!whole])
  found[order] <- found
  found
}
