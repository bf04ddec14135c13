# Five crude starts of any gear.
#
# Start 1 is the crude layout of the lattice as it is. Starts 2 to 5 are that layout, bent: three
# waves, whose lengths are a half, a quarter and an eighth of the gear's size, move every point in a
# direction of their own by up to 1.6 % of their length, so that lines change their lengths and
# directions by up to a tenth for each wave. A wave knows places and no nodes, so a start is the
# same shape however fine the lattice. Directions and phases come from R's generator, seeded by the
# number of the start. Supports stay where the plan puts them.

starts <- 1:5

# position: 3 x n (m). Returns the same, bent.
bend <- function(position, start) {
  if (start == 1L) return(position)
  set.seed(start, kind = "Mersenne-Twister", normal.kind = "Inversion", sample.kind = "Rejection")
  unit <- function() {
    v <- stats::rnorm(3)
    v / sqrt(sum(v^2))
  }
  bent <- position
  for (length in max(apply(position, 1, function(x) diff(range(x)))) / c(2, 4, 8)) {
    along <- as.vector(unit() %*% position)
    push <- unit()
    phase <- stats::runif(1, 0, 2 * pi)
    bent <- bent + 0.1 * length / (2 * pi) * outer(push, sin(2 * pi * along / length + phase))
  }
  bent
}

# From here on, every crude layout of this R process is start number `start`. settle() has no
# argument for this, which nobody but a bench would use.
use_start <- function(start) replace_layout(function(position) bend(position, start))

crude_lattice <- codend:::build_lattice

# From here on, every crude layout of this R process goes through `change` (3 x n to 3 x n, m); what
# is held stays.
replace_layout <- function(change) {
  changed <- function(si, nodes = 1500, netting = NULL, from = NULL) {
    lattice <- crude_lattice(si, nodes, netting, from)
    free <- !lattice$engine$held
    if (is.null(from)) lattice$start[, free] <- change(lattice$start)[, free]
    lattice
  }
  utils::assignInNamespace("build_lattice", changed, "codend")
}
