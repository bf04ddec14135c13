# The front of a catch that is given by its volume: settles with the front at one row of meshes after
# another until the netting behind it encloses the volume.

# Share of the volume within which it is met.
catch_tolerance <- 1e-6

# solve: function(lattice, start) that settles; returns what it returns for the front that was found,
# with the steps and factorisations of all tries.
settle_catch <- function(si, lattice, solve) {
  wanted <- log(si$catch$volume)
  # Fronts known to enclose too little and too much, in the logarithms of meshes and of volume.
  low <- high <- NULL
  front <- log(lattice$catch$blocked)
  end <- log(si$catch$deep)
  start <- lattice$start
  iterations <- factorisations <- 0L
  for (try in seq_len(40L)) {
    found <- solve(set_catch_front(lattice, exp(front)), start)
    iterations <- iterations + found$iterations
    factorisations <- factorisations + found$factorisations
    found$iterations <- iterations
    found$factorisations <- factorisations
    if (!found$converged) return(found)
    start <- matrix(found$position, 3L)
    volume <- catch_volume(found$lattice, start)
    off <- if (volume > 0) log(volume) - wanted else -Inf
    if (abs(off) < catch_tolerance) return(found)
    here <- list(front = front, off = off)
    if (off < 0 && front >= end) abort_catch_volume(si, volume)
    if (off < 0) low <- here else high <- here
    front <- next_front(here, low, high, end)
  }
  found$converged <- FALSE
  found
}

# The volume grows with a power of the meshes behind the front that changes slowly: a secant between
# the fronts known, kept inside them; one of about 1 where only one is known.
next_front <- function(here, low, high, end) {
  if (is.null(low) || is.null(high) || !is.finite(low$off)) {
    step <- if (is.finite(here$off)) here$off else -1
    guess <- here$front - min(max(step, -1), 1) * 1.1
    if (!is.null(low) && !is.null(high)) guess <- (low$front + high$front) / 2
    return(min(guess, end))
  }
  share <- low$off / (low$off - high$off)
  low$front + share * (high$front - low$front)
}

abort_catch_volume <- function(si, volume) {
  abort_plan(
    sprintf(
      "Plan field `catch` is %s; the netting of `catch.panels` holds %s when full.",
      format_si(si$catch$volume, "volume"), format_si(signif(volume, 4), "volume")
    ),
    "catch", si$catch$volume
  )
}
