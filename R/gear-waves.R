# Breaking limit (Miche 1944): largest wave height as a fraction of wavelength times tanh(number *
# depth). In deep water the tanh is 1.
breaking_share <- 0.142

# Returns list(height, period, spectrum as given; amplitude (m), frequency (1/s), phase, toward
# (rad) of each regular wave; depth (m, 0: deep), rising (s)).
si_waves <- function(waves, seabed) {
  depth <- first_of(first_of(waves$depth, seabed$depth), 0)
  number <- engine_wave_number(2 * pi / waves$period, depth)
  most <- breaking_share * 2 * pi / number * if (depth > 0) tanh(number * depth) else 1
  if (waves$height > most) {
    abort_field("water.waves.height", waves$height, sprintf(
      "at most %s, the breaking height for this period", format_si(signif(most, 3), "length")
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

# Returns the energy density of a spectrum, without normalisation. `share`: frequency over peak
# frequency. After Pierson and Moskowitz (1964), with the peak of Hasselmann et al. (1973, JONSWAP),
# as in DNV-RP-C205, 3.5.5.
spectrum_density <- function(share, peakedness) {
  width <- ifelse(share <= 1, 0.07, 0.09)
  share^-5 * exp(-1.25 * share^-4) * peakedness^exp(-(share - 1)^2 / (2 * width^2))
}

# Range of frequencies over the peak frequency. Only 0.1 % of the energy is outside it.
spectrum_range <- c(0.4, 6)

# Returns regular waves of equal energy. Median frequencies of bands avoid a repeating pattern.
spectrum_parts <- function(waves) {
  n <- waves$components
  peakedness <- if (waves$spectrum == "jonswap") waves$peakedness else 1
  share <- seq(spectrum_range[1], spectrum_range[2], by = 1e-3)
  density <- spectrum_density(share, peakedness)
  below <- c(0, cumsum((density[-1] + density[-length(density)]) / 2))
  middle <- (seq_len(n) - 0.5) / n
  found <- stats::approx(below / below[length(below)], share, middle, ties = "ordered")$y
  list(
    # n waves of 1/2 a^2 each; the surface has the variance H^2/16.
    amplitude = rep(waves$height / sqrt(8 * n), n), frequency = 2 * pi / waves$period * found,
    phase = 2 * pi * drawn_numbers(waves$seed, n)
  )
}

# Returns random numbers (0 to 1) that are identical on all machines: the minimal standard generator
# (Park and Miller, Communications of the ACM 31, 1988) without its first ten numbers.
drawn_numbers <- function(seed, n) {
  out <- numeric(n + 10L)
  state <- seed
  for (k in seq_along(out)) {
    state <- (16807 * state) %% 2147483647
    out[k] <- state / 2147483647
  }
  out[-(1:10)]
}

# Returns the engine's waves, with time 0 at the start of a tow.
engine_waves <- function(waves) {
  if (is.null(waves)) return(NULL)
  c(waves[c("amplitude", "frequency", "phase", "toward", "depth", "rising")], list(time = 0))
}

# Returns the waves seen from a vessel: time (s), place (x, y over ground, m), course (rad).
waves_from_vessel <- function(waves, time, place, course) {
  if (is.null(waves)) return(NULL)
  depth <- waves$depth
  number <- engine_wave_number(waves$frequency, depth)
  waves$phase <- waves$phase +
    number * (cos(waves$toward) * place[1] + sin(waves$toward) * place[2])
  # The axes turn clockwise with the vessel, so directions turn the other way.
  waves$toward <- waves$toward + course
  waves$time <- time
  waves
}
