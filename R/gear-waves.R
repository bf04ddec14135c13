# Waves: what a plan says of them as a sum of regular ones.

# Share of its length that a wave's height may reach in deep water before it breaks, and the same of
# the depth's tanh in all water (Miche 1944).
breaking_share <- 0.142

# List(height, period, spectrum = as given; amplitude (m), frequency (1/s), phase, toward (rad) = of
# every regular wave; depth (m, 0: deep), rising (s)).
si_waves <- function(waves, seabed) {
  depth <- first_of(first_of(waves$depth, seabed$depth), 0)
  number <- engine_wave_number(2 * pi / waves$period, depth)
  most <- breaking_share * 2 * pi / number * if (depth > 0) tanh(number * depth) else 1
  if (waves$height > most) {
    abort_field("water.waves.height", waves$height, sprintf(
      "at most %s, where waves of this period break", format_si(signif(most, 3), "length")
    ))
  }
  parts <- if (waves$spectrum == "regular") {
    list(amplitude = waves$height / 2, frequency = 2 * pi / waves$period, phase = 0)
  } else {
    spectrum_parts(waves)
  }
  c(
    waves[c("height", "period", "spectrum")], parts,
    list(
      toward = rep(waves$toward, length(parts$amplitude)), depth = depth,
      rising = first_of(waves$rising, 3 * waves$period)
    )
  )
}

# Density of energy of a spectrum by frequency over that of its peak, of any size: after Pierson and
# Moskowitz (1964), and with a peak after Hasselmann et al. (1973, JONSWAP), as in DNV-RP-C205,
# 3.5.5.
spectrum_density <- function(share, peakedness) {
  width <- ifelse(share <= 1, 0.07, 0.09)
  share^-5 * exp(-1.25 * share^-4) * peakedness^exp(-(share - 1)^2 / (2 * width^2))
}

# Frequencies over the peak's within which a spectrum is cut: beyond lies 0.1 % of its energy.
spectrum_range <- c(0.4, 6)

# Regular waves that share a spectrum's energy equally, each with the frequency in the middle of its
# share; so their pattern does not come again.
spectrum_parts <- function(waves) {
  n <- waves$components
  peakedness <- if (waves$spectrum == "jonswap") waves$peakedness else 1
  share <- seq(spectrum_range[1], spectrum_range[2], by = 1e-3)
  density <- spectrum_density(share, peakedness)
  below <- c(0, cumsum((density[-1] + density[-length(density)]) / 2))
  middle <- (seq_len(n) - 0.5) / n
  found <- stats::approx(below / below[length(below)], share, middle, ties = "ordered")$y
  list(
    # of n waves with 1/2 a^2 each, of a surface whose variance is H^2/16
    amplitude = rep(waves$height / sqrt(8 * n), n), frequency = 2 * pi / waves$period * found,
    phase = 2 * pi * drawn_numbers(waves$seed, n)
  )
}

# Numbers between 0 and 1, the same on every machine and in every version of R: the minimal standard
# generator (Park and Miller, Communications of the ACM 31, 1988), after its first ten.
drawn_numbers <- function(seed, n) {
  out <- numeric(n + 10L)
  state <- seed
  for (k in seq_along(out)) {
    state <- (16807 * state) %% 2147483647
    out[k] <- state / 2147483647
  }
  out[-(1:10)]
}

# The engine's waves, with the clock at the start of a tow: until then the water is still.
engine_waves <- function(waves) {
  if (is.null(waves)) return(NULL)
  c(waves[c("amplitude", "frequency", "phase", "toward", "depth", "rising")], list(time = 0))
}

# The same at a time (s) as seen from a vessel that is at a place over the ground (x, y, m) on a
# course (rad).
waves_from_vessel <- function(waves, time, place, course) {
  if (is.null(waves)) return(NULL)
  depth <- waves$depth
  number <- engine_wave_number(waves$frequency, depth)
  waves$phase <- waves$phase +
    number * (cos(waves$toward) * place[1] + sin(waves$toward) * place[2])
  # axes that turn with the vessel, clockwise from above, see directions turned the other way
  waves$toward <- waves$toward + course
  waves$time <- time
  waves
}
