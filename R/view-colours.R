# Colours of tension. Both palettes darken steadily, so they survive grey printing and colour
# blindness: warm for ropes, cool for netting.

slack_colour <- "#BDC3CA"

tension_palette <- function(kind) {
  # The lightest tenth or two would vanish on white paper.
  trimmed <- function(name, from) utils::tail(grDevices::hcl.colors(256L, name, rev = TRUE), -from)
  if (kind == "rope") trimmed("Inferno", 60L) else trimmed("Viridis", 40L)
}

# How tension (N) becomes colour, or NULL where nothing carries any.
#
# The scale starts at zero and is even; where most lines carry less than a tenth of the largest
# tension (netting of fine and coarse twine) it is logarithmic over at most three decades.
# Returns list(colours, log, limits (N), unit, per_unit (N), ticks (in that unit)).
tension_scale <- function(tension, kind) {
  taut <- tension[tension > 0]
  if (!length(taut)) return(NULL)
  top <- max(taut)
  logarithmic <- stats::median(taut) < top / 10
  per_unit <- if (top >= 1000) 1000 else 1
  if (logarithmic) {
    bottom <- max(stats::quantile(taut, 0.02, names = FALSE), top / 1000)
    limits <- c(bottom, top)
    ticks <- grDevices::axisTicks(log10(limits / per_unit), log = TRUE, nint = 5)
  } else {
    ticks <- pretty(c(0, top / per_unit), 5)
    limits <- c(0, max(ticks) * per_unit)
  }
  ticks <- ticks[ticks * per_unit >= limits[1] * 0.999 & ticks * per_unit <= limits[2] * 1.001]
  list(
    colours = tension_palette(kind), log = logarithmic, limits = limits,
    unit = if (per_unit == 1000) "kN" else "N", per_unit = per_unit, ticks = ticks
  )
}

# Where tensions (N) lie on a scale, 0..1.
scale_share <- function(scale, tension) {
  turn <- if (scale$log) log else identity
  low <- turn(scale$limits[1])
  pmin(pmax((turn(pmax(tension, scale$limits[1])) - low) / (turn(scale$limits[2]) - low), 0), 1)
}

tension_colours <- function(scale, tension) {
  colours <- rep(slack_colour, length(tension))
  taut <- tension > 0
  if (!any(taut)) return(colours)
  n <- length(scale$colours)
  colours[taut] <- scale$colours[1L + round(scale_share(scale, tension[taut]) * (n - 1L))]
  colours
}

tick_labels <- function(scale) format(scale$ticks, trim = TRUE, drop0trailing = TRUE, digits = 3)
