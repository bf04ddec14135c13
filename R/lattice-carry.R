# Carries a shape from one lattice to another of the same parts: to a finer division, or to a design
# with other lengths. Every node goes where its place on its rope or panel is on the old shape.

# Places at these fractions of runs of nodes (edges or ropes): list(from, to, share).
along_runs <- function(at, run, runs) {
  cell <- cell_of(at, run, runs)
  low <- runs$fraction[cell]
  high <- runs$fraction[cell + 1L]
  share <- (at - low) / (high - low)
  share[at <= low] <- 0
  share[at >= high] <- 1
  list(from = runs$node[cell], to = runs$node[cell + 1L], share = share)
}

between_places <- function(place, on) {
  from <- place[, on$from, drop = FALSE]
  to <- place[, on$to, drop = FALSE]
  found <- from + (to - from) * rep(on$share, each = 3L)
  found[, on$share == 1] <- to[, on$share == 1]
  found
}

# Where the nodes of panels lie on them: list(node, panel, s, t), s and t fractions across and deep.
panel_places <- function(panels, division, drawn) {
  bars <- vapply(drawn, function(panel) panel$netting == "bars", NA)
  on_grids <- grid_places(division)
  if (!any(bars)) return(on_grids)

  edge <- rep.int(seq_along(division$count), division$count)
  panel <- (edge - 1L) %/% 4L + 1L
  of_bars <- bars[panel]
  side <- ((edge - 1L) %% 4L + 1L)[of_bars]
  f <- division$fraction[of_bars]
  on_edges <- list(
    node = division$edge_node[of_bars], panel = panel[of_bars],
    s = ifelse(side <= 2L, f, side - 3), t = ifelse(side <= 2L, side - 1, f)
  )

  inside <- bar_places(panels, which(bars), drawn)
  own <- inside$node > division$nodes
  mapply(c, on_grids, on_edges, lapply(inside[names(on_grids)], `[`, own), SIMPLIFY = FALSE)
}

# The same of the nodes of grids alone, the panels of cells.
grid_places <- function(division) {
  size <- lengths(division$grids)
  panel <- rep.int(seq_along(size), size)
  columns <- division$count[4L * panel - 3L]
  k <- sequence(size) - 1L
  list(
    node = as.integer(unlist(division$grids)), panel = panel,
    s = division$fraction[division$before[4L * panel - 3L] + k %% columns + 1L],
    t = division$fraction[division$before[4L * panel - 1L] + k %/% columns + 1L]
  )
}

# The same of all knots and middles of bars of these panels, with their mesh coordinates i and j.
bar_places <- function(panels, numbers, drawn) {
  field <- function(name) unlist(lapply(drawn[numbers], `[[`, name), use.names = FALSE)
  panel <- rep.int(numbers, lengths(lapply(drawn[numbers], `[[`, "node")))
  j <- field("j")
  shape <- pick_panels(panels, panel, side_fields)
  left <- panel_left(shape, j)
  width <- panel_right(shape, j) - left
  width[width < 1e-9] <- 1e-9
  s <- (field("i") - left) / width
  list(
    node = field("node"), panel = panel, s = pmin(pmax(s, 0), 1), t = j / shape$deep,
    i = field("i"), j = j
  )
}

# The shape of panels as rows of places, each running from the left edge to the right edge: the rows
# of a grid, or those of knots.
#
# Returns list(panel, t = of every row, row, s = of every place, x = 3 x places), rows and places in
# order.
panel_rows <- function(panels, from, position) {
  rows <- row_places(panels, from[c("nodes", "division", "panels")])
  c(rows[c("panel", "t", "row", "s")], list(x = between_places(position, rows)))
}

# The same without the shape: x is told by `from`, `to` and `share`, see between_places().
# lattice: list(nodes, division, panels).
row_places <- function(panels, lattice) {
  bars <- which(vapply(lattice$panels, function(panel) panel$netting == "bars", NA))
  grid <- grid_places(lattice$division)
  parts <- c(
    list(c(grid[c("panel", "s", "t")], on_nodes(grid$node))),
    if (length(bars)) bar_rows(panels, bars, lattice)
  )
  fields <- c("panel", "s", "t", "from", "to", "share")
  all <- lapply(setNames(nm = fields), function(field) unlist(lapply(parts, `[[`, field)))
  order <- order(all$panel, all$t, all$s)
  row <- cumsum(c(TRUE, diff((2 * all$panel + all$t)[order]) > 1e-9))
  first <- !duplicated(row)
  list(
    panel = all$panel[order][first], t = all$t[order][first], row = row, s = all$s[order],
    from = all$from[order], to = all$to[order], share = all$share[order]
  )
}

# Places on nodes themselves, as between_places() takes them.
on_nodes <- function(node) list(from = node, to = node, share = numeric(length(node)))

# Places on the rows of panels of bars, in no order: knots between the edges, then the ends of their
# rows on the left and the right edge, then all of the upper and the lower edge.
bar_rows <- function(panels, numbers, lattice) {
  division <- lattice$division
  lambda <- vapply(lattice$panels[numbers], `[[`, 0, "lambda", USE.NAMES = FALSE)
  own <- pick_panels(panels, numbers)
  rows <- at_least_one(round((2 - is_square(own)) * own$deep / lambda))

  knots <- bar_places(panels, numbers, lattice$panels)
  of_knots <- rows[match(knots$panel, numbers)]
  row <- round(knots$t * of_knots)
  inner <- abs(knots$t * of_knots - row) < 1e-6 & row > 0 & row < of_knots
  between <- c(
    list(panel = knots$panel[inner], s = knots$s[inner], t = (row / of_knots)[inner]),
    on_nodes(point_number(knots$node[inner], lattice$nodes))
  )

  edges <- c(list(node = division$edge_node), division[c("fraction", "count", "before")])
  panel <- rep.int(numbers, rows - 1L)
  t <- sequence(rows - 1L) / rep.int(rows, rows - 1L)
  sides <- lapply(3:4, function(side) {
    c(
      list(panel = panel, s = rep(side - 3, length(t)), t = t),
      along_runs(t, 4L * (panel - 1L) + side, edges)
    )
  })
  edge <- rep.int(seq_along(division$count), division$count)
  ends <- lapply(1:2, function(side) {
    on <- which(edge %in% (4L * (numbers - 1L) + side))
    c(
      list(
        panel = (edge[on] - 1L) %/% 4L + 1L, s = division$fraction[on],
        t = rep(side - 1, length(on))
      ),
      on_nodes(division$edge_node[on])
    )
  })
  c(list(between), sides, ends)
}

# Values at places of panels: straight along rows, then between rows. rows: see panel_rows(), its
# panels being whatever `places` names so; beyond the outermost rows and places their values hold.
on_rows <- function(places, rows) values_on_rows(rows$x, rows_at(places, rows))

# Where these places lie among rows: along the row before and the one after them the places on both
# sides with the share of the way (before, after), and the share of the way between the rows.
rows_at <- function(places, rows) {
  row <- between_values(places$panel, places$t, rows$panel, rows$t)
  along <- function(row) between_values(row, places$s, rows$row, rows$s)
  list(before = along(row$low), after = along(row$high), share = row$share)
}

# x: values at the places of rows, a column each; at: see rows_at().
values_on_rows <- function(x, at) {
  each <- nrow(x)
  along <- function(on) {
    low <- x[, on$low, drop = FALSE]
    low + (x[, on$high, drop = FALSE] - low) * rep(on$share, each = each)
  }
  first <- along(at$before)
  first + (along(at$after) - first) * rep(at$share, each = each)
}

# The values (0 to 1) of a group next to x in it: list(low, high = their numbers, share of the way).
# groups, values: in order, groups as whole numbers of which each that is asked for is there.
between_values <- function(group, x, groups, values) {
  low <- findInterval(2 * group + x, 2 * groups + values)
  low <- pmax(low, match(group, groups))
  high <- pmin(low + 1L, length(groups))
  beyond <- groups[high] != group
  high[beyond] <- low[beyond]
  width <- values[high] - values[low]
  share <- pmin(pmax((x - values[low]) / pmax(width, 1e-12), 0), 1)
  list(low = low, high = high, share = share)
}

# Which of all nodes on edges begins the stretch between two nodes of its edge that each x (fraction
# of the edge) lies in.
cell_of <- function(x, edge, on) {
  cell <- on$before[edge] + 1L
  # Edges of one stretch need no search.
  many <- which(on$count[edge] > 2L)
  if (!length(many)) return(cell)
  ends <- seq_along(on$fraction)
  order <- order(
    c(rep.int(seq_along(on$count), on$count), edge[many]), c(on$fraction, x[many]),
    rep.int(0:1, c(length(ends), length(many)))
  )
  reached <- integer(length(order))
  reached[order] <- cumsum(order <= length(ends))
  found <- reached[-ends]
  last <- (on$before + on$count - 1L)[edge[many]]
  beyond <- found > last
  found[beyond] <- last[beyond]
  sooner <- found < cell[many]
  found[sooner] <- cell[many][sooner]
  cell[many] <- found
  cell
}

# What is larger than any lattice stays a whole number.
at_least_one <- function(x) as.integer(pmin(pmax(x, 1), most_nodes))
