# Returns the cutting rates of a panel's left and right edges, and TRUE if they are equal.
panel_rates <- function(panel) {
  rate <- function(lost) cutting_rate(lost, panel$deep, panel$orientation)
  c(left = rate(panel$lost_left), right = rate(panel$lost_right))
}
