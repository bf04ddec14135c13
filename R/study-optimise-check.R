# Whether what a search found is an optimum.

# A condition nearer to its limit than this share of it is at it, a field nearer to an end of its
# range than this share of that.
active_share <- 1e-3

# The conditions of Karush, Kuhn and Tucker at a tried point: list(left, price (a weight for each
# condition, 0 where it is not at its limit), at ("lower", "upper" or "" by field)). left: the
# largest slope of the aim, as a share of itself, by any scaled field, that no weight holds.
optimality_of <- function(task, tried, held = integer()) {
  values <- tried$values
  n <- length(tried$scaled)
  at <- character(n)
  at[tried$scaled <= active_share] <- "lower"
  at[tried$scaled >= 1 - active_share] <- "upper"
  ended <- which(at != "" & !seq_len(n) %in% held)
  ends <- diag(ifelse(at == "upper", 1, -1), n)[ended, , drop = FALSE]
  active <- which(values$equal | values$gap > -active_share)
  rows <- rbind(values$gap_slope[active, , drop = FALSE], ends)
  signed <- c(values$equal[active], rep(FALSE, nrow(ends)))
  free <- setdiff(seq_len(n), held)
  weights <- least_weights(rows[, free, drop = FALSE], values$aim_slope[free], signed)
  rest <- values$aim_slope[free]
  if (length(weights)) rest <- rest + drop(weights %*% rows[, free, drop = FALSE])
  price <- numeric(length(values$gap))
  price[active] <- weights[seq_along(active)]
  list(left = max(0, abs(rest)), price = price, at = at)
}

# Weights w of rows, at least 0 where not signed, for the least |slope + w rows|.
least_weights <- function(rows, slope, signed) {
  if (!nrow(rows)) return(numeric())
  size <- sqrt(rowSums(rows^2))
  size[size == 0] <- 1
  rows <- rows / size
  products <- rows %*% t(rows)
  along <- drop(rows %*% slope)
  found <- stats::nlminb(
    numeric(nrow(rows)),
    function(w) sum(w * (products %*% w)) / 2 + sum(w * along) + sum(slope^2) / 2,
    function(w) drop(products %*% w) + along,
    function(w) products,
    lower = ifelse(signed, -Inf, 0), control = list(rel.tol = 1e-14, x.tol = 1e-12)
  )
  found$par / size
}
