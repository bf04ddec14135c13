# Returns the cutting rates of a panel's left and right edges, and TRUE if they are equal.
panel_rates <- function(panel) {
  loss <- panel$upper - panel$lower
  rate <- function(share) cutting_rate(loss * share, panel$deep, panel$orientation)
  c(left = rate(panel$taper_left), right = rate(panel$taper_right))
}
