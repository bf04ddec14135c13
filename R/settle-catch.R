# The front of a catch that is given by its volume: settles with the front at one row of meshes
# after another until the netting behind it encloses the volume.

# Share of the volume within which it is met.
catch_tolerance <- 1e-6

# A front within this of one that is settled, in the logarithm of meshes, is settled from there.
near_front <- 0.2

# solve: function(lattice, from) that settles, from its own start or from a report of itself.
# Returns list(lattice = with the front that was found, report = what `solve` returned for that,
# with the steps and factorisations of all tries).
settle_catch <- function(si, lattice, solve) {
  wanted <- log(si$catch$volume)
  # Fronts known to enclose too little and too much, in the logarithms of meshes and of volume.
  low <- high <- before <- NULL
  front <- log(lattice$catch$blocked)
  end <- log(si$catch$deep)
  iterations <- factorisations <- 0L
  for (try in seq_len(40L)) {
    lattice <- set_catch_front(lattice, exp(front))
    # From the first start: a shape settled far off leads the path astray. From near by: slack
    # netting before the front may balance in several ways, and the volume is to follow one of them.
    near <- !is.null(before) && abs(front - before$front) < near_front
    for (from in list(if (near) before$report, NULL)) {
      report <- solve(lattice, from)
      iterations <- iterations + report$iterations
      factorisations <- factorisations + report$factorisations
      if (report$converged || is.null(from)) break
    }
    report$iterations <- iterations
    report$factorisations <- factorisations
    found <- list(lattice = lattice, report = report)
    if (!report$converged) return(found)
    volume <- catch_volume(lattice, matrix(report$position, 3L))
    off <- if (volume > 0) log(volume) - wanted else -Inf
    if (abs(off) < catch_tolerance) return(found)
    here <- list(front = front, off = off, report = report)
    if (off < 0 && front >= end) abort_catch_volume(si, volume)
    if (off < 0) low <- here else high <- here
    front <- next_front(here, before, low, high, end)
    before <- here
  }
  found$report$converged <- FALSE
  found
}

# Whether netting holds another catch than before. Netting ahead of a catch has several balances,
# and which of them steps from a state lead to depends on its catch: the one that is found from
# nothing is taken from every start.
has_other_catch <- function(si, before) {
  held <- function(si) unlist(si$catch[c("blocked", "volume")])
  any(held(si) != held(before), na.rm = TRUE)
}

# The volume grows with a power of the meshes behind the front that changes slowly: a secant through
# the last two fronts, or that of a power of 1 from the first, kept between the fronts known.
next_front <- function(here, before, low, high, end) {
  slope <- 1
  if (!is.null(before)) slope <- (here$off - before$off) / (here$front - before$front)
  guess <- here$front - here$off / slope
  most <- if (is.null(high)) min(here$front + 1, end) else high$front
  least <- if (is.null(low)) here$front - 1 else low$front
  inside <- is.finite(guess) && guess > least && guess < most
  if (inside) return(guess)
  if (is.null(low)) least else if (is.null(high)) most else (least + most) / 2
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
