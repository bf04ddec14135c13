# Derivatives of measures by fields of a plan, near a settled state. Sensitivities, uncertainties,
# optimisation and calibration take them from here.
#
# A tangent is the derivative at the state: iterations with the factors of the state's matrix keep
# gears that differ little from it in equilibrium (src/engine/measure/near_gear.hpp). A secant is
# the slope to a gear that is settled at another value of the field.

# Share of a field by which the derivatives of the engine's numbers are computed, and of secants.
number_share <- 1e-6
secant_share <- 0.01
# How a tangent is computed: `shares` of the field's value that are tried in turn, as large as the
# tangent holds, since tensions of stiff ropes are differences of positions, which round;
# `renewals`, how often the matrix is factorised again at each; `steps`, most iterations with one
# matrix; `tolerance`, the net force over the largest tension that remains; `closes_in`, whether
# iterations go on while they improve; `reach`, the share of the field over which counts of
# elements change.
exact_tangent <- list(
  shares = c(1e-4, 1e-5, 1e-6, 1e-5), renewals = c(0L, 0L, 0L, 3L), steps = 20L,
  tolerance = 1e-11, closes_in = TRUE, reach = secant_share
)
# A budget of uncertainty needs a few digits; its reach is how uncertain the field is.
quick_tangent <- list(
  shares = 1e-5, renewals = 0L, steps = 2L, tolerance = 1e-8, closes_in = FALSE
)
# Of a slope, what two one-sided slopes at the state or the secants' mean may differ by, and what
# the secants from each other; and the least slope, as an elasticity, that this is a share of.
kink_share <- 0.005
most_bend <- 0.2
least_elasticity <- 0.01
# How many times as much a slope may change as its field of whole numbers, to be a curve's.
most_curvature <- 3

# What all fields share: the state, and where steps of its factors hold it in balance what is near
# to it (src/engine/measure/near_gear.hpp) with its numbers, and its measures there. base: of
# state_values().
tangent_work <- function(state, base = state_values(state)) {
  asked <- state$lattice$counts$asked
  si <- state$si
  work <- list(
    state = state, nodes = asked$nodes,
    netting = Find(function(netting) identical(panels_of_bars(si, netting), asked$bars),
      list(NULL, "bars", "cells")),
    cost = new.env(parent = emptyenv())
  )
  work$measures <- names(base$values)
  work$units <- setNames(measure_units(base$kinds), work$measures)
  work$values <- shown_numbers(base$values, work$units)
  kinds <- measured_kinds(si)
  work$place <- match(work$measures, names(kinds))
  work$unit <- vapply(measure_units(kinds[work$place]), unit_size, 0)
  work$asked <- questions_of(si, state$lattice, asked_of(si))
  work$cost$factorisations <- 0L
  # A catch given by its volume moves its front with the shape.
  if (is.null(si$catch) || is.na(si$catch$volume)) {
    work$own <- list(
      si = si, gear = gear_numbers(si, work$netting), model = model_numbers(si)
    )
    work$numbers <- near_numbers(work, si)
    found <- engine_near_gear(
      work$numbers, state$lattice$counts[lattice_counts], as.double(state_points(state)),
      as.double(state$lattice$mesh$wake)
    )
    work$cost$factorisations <- 1L
    if (!is.null(found)) {
      work$near <- found$near
      work$values <- near_shown(found$measures, work)
    }
  }
  work
}

# All numbers of a gear like the state's, as the engine has them together. by: its multipliers.
near_numbers <- function(work, si, by = unlist(si$multipliers)) {
  own <- list(
    gear = gear_numbers(si, work$netting, work$own), model = model_numbers(si, work$own)
  )
  c(multiplied_numbers(own, si, by), list(
    questions = near_questions(work, si),
    blocked = if (is.null(si$catch)) 0 else
      first_of(si$catch$blocked[!is.na(si$catch$blocked)], work$state$lattice$catch$blocked),
    volume = 0
  ))
}

# The state's questions but for the numbers in them.
near_questions <- function(work, si) {
  asked <- c("measures", "vessel", "towing", "share_places")
  if (identical(si[asked], work$state$si[asked])) return(work$asked)
  questions_of(si, work$state$lattice, asked_of(si))
}

# Measures as they are shown, from the engine's.
near_shown <- function(values, work) setNames(values[work$place] / work$unit, work$measures)

# Numbers with a field changed by a share, or NULL where the plan does not allow it.
field_numbers <- function(work, field, share) {
  if (!is.null(field$multiplier)) {
    by <- unlist(work$own$si$multipliers)
    by[field$multiplier] <- changed_number(by[[field$multiplier]], share)
    if (by[field$multiplier] < 0) return(NULL)
    return(near_numbers(work, work$own$si, by))
  }
  gear <- work$state$gear
  si <- tryCatch(
    check_whole(
      scaled_plan(gear$plan, field, share), gear_checked(gear), joined = share != number_share
    )$si,
    codend_error_plan = function(e) NULL
  )
  if (!is.null(si)) near_numbers(work, si)
}

# The same a little changed, by which the engine finds how they change: multipliers, in which
# numbers are linear, by their own value.
little_share <- function(field) if (is.null(field$multiplier)) number_share else 1

# Changes of measures, without jumps, to the gears in equilibrium with a field changed by a share
# and by as much the other way, list(up, down), or NULL. numbers: with its little_share(), `little`;
# how: see exact_tangent, with one of its shares and renewals.
near_changes <- function(work, numbers, little, how, share, renewals) {
  found <- engine_near_changes(work$near, numbers, share / little, how$tolerance, how$steps,
    renewals, how$closes_in, how$reach / share)
  work$cost$factorisations <- work$cost$factorisations + found$factorisations
  if (length(found$down)) lapply(found[c("up", "down")], near_shown, work = work)
}

values_at <- function(work, gear, si, lattice, position) {
  found <- state_values(new_state(gear, si, lattice, position, work$state$report))
  shown_numbers(found$values, measure_units(found$kinds))[work$measures]
}

# A field's slopes by its share: list(slope, below, above, smooth), each by measure.
field_slopes <- function(work, field, secants) {
  found <- if (!field$whole) tangent_slopes(work, field)
  if (is.null(found)) {
    step <- if (field$whole) 1 / abs(field$value) else secant_share
    sides <- secant_slopes(work, field, step)
    return(slopes_of_secants(work, sides, if (field$whole) step else 0))
  }
  if (secants) {
    sides <- secant_slopes(work, field, secant_share)
    found[names(sides)] <- sides
    scale <- slope_scale(work, found$slope)
    off <- abs((sides$below + sides$above) / 2 - found$slope) / scale
    bend <- abs(sides$above - sides$below) / scale
    # what does not settle on both sides is not smooth
    found$smooth <- found$smooth & !is.na(off) & off <= kink_share & bend <= most_bend
  }
  found
}

# What slopes differ by is told as a share of this; no measure is without one.
slope_scale <- function(work, slope) {
  pmax(abs(slope), least_elasticity * abs(work$values), .Machine$double.xmin)
}

# The tangent over the largest share at which iterations lead to equilibrium on both sides:
# list(slope, turn, the difference of the slopes to both sides, below, above, smooth), each by
# measure; NULL where there is none.
tangent_slopes <- function(work, field, how = exact_tangent) {
  little <- little_share(field)
  numbers <- if (!is.null(work$near)) field_numbers(work, field, little)
  if (is.null(numbers)) return(NULL)
  for (k in seq_along(how$shares)) {
    share <- how$shares[k]
    sides <- if (identical(numbers, work$numbers)) {
      list(up = 0 * work$values, down = 0 * work$values)
    } else {
      near_changes(work, numbers, little, how, share, how$renewals[k])
    }
    if (!is.null(sides)) break
  }
  if (is.null(sides)) return(NULL)
  slope <- (sides$up - sides$down) / (2 * share)
  # where a kink lies at the state itself, slopes on both sides differ
  turn <- abs(sides$up + sides$down) / share
  list(
    slope = slope, turn = turn, below = NA * slope, above = NA * slope,
    smooth = turn <= kink_share * slope_scale(work, slope)
  )
}

# By gears settled at both sides: list(below, above). both: whether one is of no use alone.
secant_slopes <- function(work, field, step, both = FALSE) {
  side <- function(way) {
    change <- settled_change(work, field, way * step)
    if (is.null(change)) NA * work$values else way * change / step
  }
  below <- side(-1)
  list(below = below, above = if (both && anyNA(below)) NA * below else side(1))
}

# Change of measures to the gear with a field changed by a share, settled from the state on its
# lattice, or NULL.
settled_change <- function(work, field, share) {
  if (is.null(work$near)) {
    gear <- scaled_gear(work$state$gear, field, share)
    values <- if (!is.null(gear)) settled_values(work, gear)
    return(if (!is.null(values)) values - work$values)
  }
  numbers <- field_numbers(work, field, share)
  if (is.null(numbers)) return(NULL)
  found <- engine_near_settled(work$near, numbers, settle_tolerance, settle_iterations)
  work$cost$factorisations <- work$cost$factorisations + found$factorisations
  if (length(found$change)) near_shown(found$change, work)
}

# Measures of a gear settled from the state on its lattice, or NULL.
settled_values <- function(work, gear) {
  si <- gear_si(gear)
  if (!is.null(odd_parts(si, work$state))) return(NULL)
  shape <- state_shape(work$state)
  found <- settle_numbers(
    si, work$nodes, work$netting, shape, FALSE, function(iteration, residual) NULL
  )
  work$cost$factorisations <- work$cost$factorisations + found$report$factorisations
  if (!found$report$converged || !settled_alike(found$lattice, shape)) return(NULL)
  values_at(work, gear, si, found$lattice, found$position)
}

# The slope between two secants, or one. curvature: by which share of it they may differ if the
# field is of whole numbers, else 0: nothing is called smooth.
slopes_of_secants <- function(work, sides, curvature) {
  slope <- (sides$below + sides$above) / 2
  one <- ifelse(is.na(sides$below), sides$above, sides$below)
  smooth <- abs(sides$above - sides$below) <= most_curvature * curvature * slope_scale(work, slope)
  slope <- ifelse(is.na(slope), one, slope)
  list(slope = slope, below = sides$below, above = sides$above, smooth = smooth & !is.na(smooth))
}
