# A square net that all net programs can run, compared with an independent implementation of its
# equations knot by knot.

# Drag of water with velocity u (n x 2 or n x 3 rows) on one metre of cylinders. Their diameter is d
# and their unit vectors are t. C_n = 1.2 on d and C_t = 0.01 on pi d.
cylinder_drag <- function(t, u, d) {
  along <- rowSums(u * t) * t
  normal <- u - along
  0.5 * 1025 * d * (1.2 * sqrt(rowSums(normal^2)) * normal +
    0.01 * pi * sqrt(rowSums(along^2)) * along)
}

# The force balance of a square net of n x n knots 0.5 m apart with a fixed upper row. Knots are
# numbered along each row, from the upper edge down. Returns functions of the knots' positions (n^2
# x 3): the net force on every free knot (N, a row each), its derivative, and the free knots.
square_net_balance <- function(n) {
  knot <- matrix(seq_len(n * n), n, n)
  # bars down, and across below the upper edge
  from <- c(knot[, -n], knot[-n, -1])
  to <- c(knot[, -1], knot[-1, -1])
  free <- as.vector(knot[, -1])
  start <- stop <- matrix(0, n * n, length(from))
  start[cbind(from, seq_along(from))] <- stop[cbind(to, seq_along(to))] <- 1
  load <- matrix(0, n * n, 3)
  load[, 3] <- -9.81 * 0.25 * (0.014326 - 1025 * pi / 4 * 0.004^2) * rowSums(start + stop)
  load[knot[, n], 3] <- load[knot[, n], 3] - 9.81 * (1 - 1025 * 1.274e-4)
  # for every bar along e: its tension on its first knot, and half its drag
  bar_force <- function(e) {
    long <- sqrt(rowSums(e^2))
    list(
      pull = 12e3 * pmax(0, long / 0.5 - 1) * e / long,
      drag = 0.25 * cylinder_drag(e / long, cbind(0.5, 0 * long, 0 * long), 0.004)
    )
  }
  list(
    free = free,
    force = function(x) {
      f <- bar_force(x[to, ] - x[from, ])
      ((start - stop) %*% f$pull + (start + stop) %*% f$drag + load)[free, ]
    },
    slope = function(x) {
      e <- x[to, ] - x[from, ]
      f <- bar_force(e)
      by <- lapply(1:3, function(k) {
        moved <- e
        moved[, k] <- moved[, k] + 1e-7
        g <- bar_force(moved)
        do.call(rbind, lapply(1:3, function(i) {
          pull <- (g$pull - f$pull)[, i] / 1e-7
          drag <- (g$drag - f$drag)[, i] / 1e-7
          (((start - stop) %*% diag(pull) + (start + stop) %*% diag(drag)) %*% t(stop - start))[
            free, free]
        }))
      })
      do.call(cbind, by)
    }
  )
}

# Positions of the knots (n^2 x 3), starting flat, upright and at rest, by Newton's method with a
# growing pseudo-time step.
solve_square_net <- function(n) {
  balance <- square_net_balance(n)
  free <- balance$free
  x <- cbind(0, rep((seq_len(n) - (n + 1) / 2) / 2, n), rep(-10 - (seq_len(n) - 1) / 2, each = n))
  pseudo_step <- 1e-3
  before <- Inf
  for (iteration in 1:300) {
    net <- balance$force(x)
    now <- max(abs(net))
    if (now < 1e-8) return(x)
    pseudo_step <- pseudo_step * (if (now < before) 1.5 else 0.5)
    before <- now
    step <- solve(diag(1 / pseudo_step, length(net)) - balance$slope(x), as.vector(net))
    x[free, ] <- x[free, ] + step * min(1, 0.25 / max(abs(step)))
  }
  stop("the net written by hand does not settle")
}

# plan: name of a plan of a square net with 8 x 8 knots.
square_net <- function(n, plan = "square_net") {
  half <- (n - 1) / 4
  update(read_gear(test_path("plans", paste0(plan, ".yaml"))),
    panels.net.meshes = list(upper = n - 1, lower = n - 1, deep = n - 1),
    panels.net.columns = n - 1, pieces.sinkers.number = n,
    points.port.position = c(0, -half, -10), points.starboard.position = c(0, half, -10)
  )
}

# Positions of a state's knots, numbered as above.
knots_of <- function(state) {
  drawn <- panel_of(state, "net")
  t(state$position[, drawn$node[order(round(drawn$j), round(drawn$i))]])
}
