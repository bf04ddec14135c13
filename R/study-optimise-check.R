# First-order conditions of an optimum.

# Evaluates the Karush-Kuhn-Tucker conditions at a tried point. Returns list(left, price, at).
# `left`: largest remaining derivative of the objective by a scaled field, as a fraction of the
# objective. `price`: multiplier of each condition, 0 if inactive. `at`: "lower", "upper" or "" by
# field.
optimality_of <- function(task, tried, held = integer()) {
  values <- tried$values
  n <- length(tried$scaled)
  at <- range_ends(tried$scaled)
  ended <- which(at != "" & !seq_len(n) %in% held)
  ends <- diag(ifelse(at == "upper", 1, -1), n)[ended, , drop = FALSE]
  active <- which(values$equal | values$gap > -active_share)
  rows <- rbind(values$gap_slope[active, , drop = FALSE], ends)
  signed <- c(values$equal[active], rep(FALSE, nrow(ends)))
  free <- setdiff(seq_len(n), held)
  weights <- least_weights(rows[, free, drop = FALSE], values$objective_gradient[free], signed)
  rest <- values$objective_gradient[free]
  if (length(weights)) rest <- rest + drop(weights %*% rows[, free, drop = FALSE])
  price <- numeric(length(values$gap))
  price[active] <- weights[seq_along(active)]
  list(left = max(0, abs(rest)), price = price, at = at)
}

# Returns the weights w that minimise |slope + w rows|, with w >= 0 unless `signed`.
least_weights <- function(rows, slope, signed) {
  if (!nrow(rows)) return(numeric())
  size <- sqrt(rowSums(rows^2))
  size[size == 0] <- 1
  rows <- rows / size
  least_quadratic(numeric(nrow(rows)), tcrossprod(rows), drop(rows %*% slope),
    lower = ifelse(signed, -Inf, 0), value = sum(slope^2) / 2) / size
}

# Returns the x that minimises x'Ax / 2 + b'x + value within limits, by iterations from `start`.
# value: at x = 0; the iterations stop at relative changes of the sum.
least_quadratic <- function(start, a, b, lower, upper = Inf, value = 0) {
  stats::nlminb(
    start, function(x) sum(x * (a %*% x)) / 2 + sum(b * x) + value,
    function(x) drop(a %*% x) + b, function(x) a,
    lower = lower, upper = upper, control = list(rel.tol = 1e-14, x.tol = 1e-12)
  )$par
}
