# Colours of tension: warm for ropes, cool for netting. Both palettes darken steadily for grey print
# and colour-blind readers. All colours, including slack, contrast at least 3 to 1 with the viewer's
# water and sea bed and with white paper (WCAG 2.2, success criterion 1.4.11).

# Slack lines are important, so their colour differs strongly from both palettes.
slack_colour <- "#D6006E"

# Used by the viewer for dashed slack lines among taut lines.
muted_slack_colour <- "#7E5E78"

# Returns the legend of the slack colour for the tensions of lines, or NULL if no line is slack.
slack_text <- function(tension) {
  if (any(tension < 0)) "slack or in compression" else if (any(tension == 0)) "slack"
}

tension_palette <- function(kind) tension_palettes[[if (kind == "rope") "rope" else "netting"]]

# Computed once, because Lab interpolation is slow.
tension_palettes <- lapply(list(
  rope = c("#B84A00", "#982500", "#6A0E12", "#2B0508"),
  netting = c("#0A766C", "#17629E", "#3A3C93", "#2A0F4F")
), function(stops) grDevices::colorRampPalette(stops, space = "Lab")(216L))

# Returns the scale that maps tension (N) to colour, or NULL if no line is taut.
#
# The scale is linear from zero. If the median is below a tenth of the maximum (netting of fine and
# coarse twine) it is logarithmic over at most three decades. Returns list(colours, log, limits (N),
# unit, per_unit (N), ticks (in that unit)).
tension_scale <- function(tension, kind) {
  taut <- tension[tension > 0]
  if (!length(taut)) return(NULL)
  top <- max(taut)
  unit <- if (top >= unit_size("kN")) "kN" else "N"
  per_unit <- unit_size(unit)
  scale <- list(
    colours = tension_palette(kind), log = stats::median(taut) < top / 10,
    unit = unit, per_unit = per_unit
  )
  if (scale$log) {
    scale$limits <- c(max(stats::quantile(taut, 0.02, names = FALSE), top / 1000), top)
    scale$ticks <- decade_ticks(scale)
  } else {
    scale$ticks <- pretty(c(0, top / per_unit), 5)
    scale$limits <- c(0, max(scale$ticks) * per_unit)
  }
  scale
}

# Returns ticks of a logarithmic scale, as many as their labels allow.
decade_ticks <- function(scale) {
  limits <- scale$limits / scale$per_unit
  decades <- 10^seq(floor(log10(limits[1])), floor(log10(limits[2])))
  for (digits in list(c(1, 2, 5), c(1, 3))) {
    ticks <- as.vector(outer(digits, decades))
    ticks <- ticks[ticks >= limits[1] & ticks <= limits[2]]
    if (all(diff(scale_share(scale, ticks * scale$per_unit)) >= 0.11)) break
  }
  ticks
}

# Returns the positions of tensions (N) on a scale, 0 to 1.
scale_share <- function(scale, tension) {
  turn <- if (scale$log) log else identity
  low <- turn(scale$limits[1])
  pmin(pmax((turn(pmax(tension, scale$limits[1])) - low) / (turn(scale$limits[2]) - low), 0), 1)
}

tension_colours <- function(scale, tension) {
  c(slack_colour, scale$colours)[1L + colour_numbers(scale, tension)]
}

# Returns the indices of tensions (N) into a scale's colours, at most 255; 0 means slack.
colour_numbers <- function(scale, tension) {
  numbers <- integer(length(tension))
  taut <- tension > 0
  if (!any(taut)) return(numbers)
  numbers[taut] <- 1L + as.integer(
    round(scale_share(scale, tension[taut]) * (length(scale$colours) - 1L))
  )
  numbers
}

scale_heading <- function(scale, kind) {
  paste0(
    first_of(scale$words, if (kind == "rope") "Tension of ropes" else "Tension of one twine"),
    if (!is.null(scale)) paste0(" (", scale$unit, ")")
  )
}

tick_labels <- function(scale) format(scale$ticks, trim = TRUE, drop0trailing = TRUE, digits = 3)

# Colours of series, from dark to light. Any two differ by at least 11 in lightness (CIE L*, for
# grey prints). In colour (CIE Lab) they differ by at least 24 with normal sight, deuteranopia,
# protanopia or tritanopia. The lightest contrasts 2.7 to 1 with white.
series_palette <- c("#1E2500", "#71056D", "#006F50", "#AB7000", "#00AAD8")

series_colours <- function(n) {
  most <- length(series_palette)
  if (n <= 1L) return(series_palette[3L][seq_len(n)])
  if (n <= most) return(series_palette[round(seq(1, most, length.out = n))])
  rep_len(series_palette, n)
}
