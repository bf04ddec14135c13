# A square net of n x n knots in a current that starts. Its reference solution is
# references/net-in-starting-current.csv.

started_net <- function(n) square_net(n, "net_in_starting_current")

started_net_rows <- function(n, found) {
  some <- function(most) unique(round(seq(1, most, length.out = 20)))
  node <- some(dim(found$position)[2])
  motion_rows(list(n = n), found, c("x", "y", "z"), node, some(nrow(found$bar_tension)))
}
