# A square net of n x n knots in a current that starts. Its reference solution is
# references/net-in-starting-current.csv.

started_net <- function(n) {
  half <- (n - 1) / 4
  update(read_gear(test_path("plans", "net_in_starting_current.yaml")),
    panels.net.meshes = list(upper = n - 1, lower = n - 1, deep = n - 1),
    panels.net.columns = n - 1, pieces.sinkers.number = n,
    points.port.position = c(0, -half, -10), points.starboard.position = c(0, half, -10)
  )
}

# Compared values: twenty nodes, twenty bars and the largest tension. Returns a data frame of n,
# time (s), kind ("x", "y", "z", m, or "tension", "largest_tension", N), number (of the node or bar)
# and value.
started_net_rows <- function(n, found) {
  some <- function(most) unique(round(seq(1, most, length.out = 20)))
  node <- some(dim(found$position)[2])
  bar <- some(nrow(found$bar_tension))
  late <- which(found$time > 0)
  of <- function(kind, number, value) {
    data.frame(n = n, time = rep(found$time[late], each = length(number)), kind = kind,
      number = number, value = as.vector(value))
  }
  rbind(
    of("x", node, found$position[1, node, late]), of("y", node, found$position[2, node, late]),
    of("z", node, found$position[3, node, late]),
    of("tension", bar, found$bar_tension[bar, late]),
    of("largest_tension", 0, apply(found$bar_tension[, late], 2, max))
  )
}
