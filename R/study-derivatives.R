# Derivatives of measures by fields of a plan at a settled state, for sensitivities, uncertainties,
# optimisation and calibration.
#
# A tangent is the derivative at the state. Iterations with the factorised matrix of the state bring
# slightly changed gears to equilibrium (src/engine/measure/near_gear.hpp). A secant uses a gear
# that is settled at another value of the field.

# Relative steps of a field: for derivatives of the engine's inputs, and for secants.
number_share <- 1e-6
secant_share <- 0.01
# Settings of a tangent:
#   `shares`: relative steps of the field, tried in sequence. Large steps are better, because
#     tensions of stiff ropes are differences of rounded positions.
#   `renewals`: number of further factorisations for each step.
#   `steps`: largest number of iterations with one matrix.
#   `tolerance`: remaining net force over the largest tension.
#   `closes_in`: TRUE to iterate as long as the residual falls.
#   `reach`: relative change of the field over which counts of elements change.
exact_tangent <- list(
  shares = c(1e-4, 1e-5, 1e-6, 1e-5), renewals = c(0L, 0L, 0L, 3L), steps = 20L,
  tolerance = 1e-11, closes_in = TRUE, reach = secant_share
)
# A search needs four digits.
search_tangent <- utils::modifyList(exact_tangent, list(tolerance = 1e-9, closes_in = FALSE))
# An uncertainty budget needs few digits. Its `reach` is the relative uncertainty of the field.
quick_tangent <- list(
  shares = 1e-5, renewals = 0L, steps = 2L, tolerance = 1e-8, closes_in = FALSE
)
# Limits of `smooth`, as fractions of the derivative: `kink_share` for one-sided derivatives and for
# the mean of both secants, `most_bend` for the two secants. The derivative counts as at least
# `least_elasticity`.
kink_share <- 0.005
most_bend <- 0.2
least_elasticity <- 0.01
# For whole numbers: largest relative change of the derivative over the relative step of the field.
most_curvature <- 3

# Returns the argument `netting` that gives the elements of a state.
requested_netting <- function(state) {
  bars <- state$mesh$counts$asked$bars
  Find(function(netting) identical(panels_of_bars(state$si, netting), bars),
    list(NULL, "bars", "cells"))
}

# `near`: the factorised equilibrium, absent if iterations fail. base: from `state_values()`.
tangent_work <- function(state, base = state_values(state)) {
  asked <- state$mesh$counts$asked
  si <- state$si
  work <- list(
    state = state, nodes = asked$nodes,
    netting = requested_netting(state),
    cost = new.env(parent = emptyenv())
  )
  work$measures <- names(base$values)
  work$units <- setNames(measure_units(base$kinds), work$measures)
  work$values <- numbers_in_display_units(base$values, work$units)
  kinds <- measured_kinds(si)
  work$place <- match(work$measures, names(kinds))
  work$unit <- vapply(measure_units(kinds[work$place]), unit_size, 0)
  work$asked <- questions_of(si, state$mesh, measure_request(si))
  work$cost$factorisations <- 0L
  # There is no tangent for a catch given by volume, because its front moves with the shape.
  if (is.null(si$catch) || is.na(si$catch$volume)) {
    work$own <- list(
      si = si, gear = gear_numbers(si, work$netting), model = model_numbers(si)
    )
    work$numbers <- near_numbers(work, si)
    found <- engine_near_gear(
      work$numbers, state$mesh$counts[mesh_counts], as.double(state_points(state)),
      as.double(state$mesh$model$wake)
    )
    work$cost$factorisations <- 1L
    if (!is.null(found)) {
      work$near <- found$near
      work$values <- in_display_units(found$measures, work)
    }
  }
  work
}

# Returns all inputs of the engine for a gear like the state's. by: its multipliers.
near_numbers <- function(work, si, by = unlist(si$multipliers)) {
  own <- list(
    gear = gear_numbers(si, work$netting, work$own), model = model_numbers(si, work$own)
  )
  # Reuses the measure requests of the state unless their values changed.
  asked <- c("measures", "vessel", "towing", "share_places")
  c(multiplied_numbers(own, si, by), list(
    questions = if (identical(si[asked], work$state$si[asked])) work$asked else {
      questions_of(si, work$state$mesh, measure_request(si))
    },
    blocked = if (is.null(si$catch)) 0 else
      first_of(si$catch$blocked[!is.na(si$catch$blocked)], work$state$mesh$catch$blocked),
    volume = 0
  ))
}

in_display_units <- function(values, work) setNames(values[work$place] / work$unit, work$measures)

# Returns inputs with a field changed by a fraction, or NULL if the plan does not allow it.
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

values_at <- function(work, gear, si, mesh, position) {
  found <- state_values(new_state(gear, si, mesh, position, work$state$report))
  numbers_in_display_units(found$values, measure_units(found$kinds))[work$measures]
}

# Returns list(slope, below, above, smooth) by measure: derivatives by relative changes of a field.
field_sensitivities <- function(work, field, secants, how = exact_tangent) {
  found <- if (!field$whole) tangent_derivatives(work, field, how)
  if (is.null(found)) {
    step <- if (field$whole) 1 / abs(field$value) else secant_share
    sides <- secant_derivatives(work, field, step)
    return(derivatives_of_secants(work, sides, if (field$whole) step else 0))
  }
  if (secants) {
    sides <- secant_derivatives(work, field, secant_share)
    found[names(sides)] <- sides
    scale <- sensitivity_scale(work, found$slope)
    off <- abs((sides$below + sides$above) / 2 - found$slope) / scale
    bend <- abs(sides$above - sides$below) / scale
    # A measure is not smooth if a side does not settle.
    found$smooth <- found$smooth & !is.na(off) & off <= kink_share & bend <= most_bend
  }
  found
}

# Returns the positive scale for differences of derivatives.
sensitivity_scale <- function(work, slope) {
  pmax(abs(slope), least_elasticity * abs(work$values), .Machine$double.xmin)
}

# Returns the tangent with the first step that reaches equilibrium on both sides, or NULL:
# list(slope, turn, below, above, smooth) by measure. turn: difference of the one-sided derivatives.
tangent_derivatives <- function(work, field, how = exact_tangent) {
  # Inputs are linear in multipliers, so their step can be 1.
  little <- if (is.null(field$multiplier)) number_share else 1
  numbers <- if (!is.null(work$near)) field_numbers(work, field, little)
  if (is.null(numbers)) return(NULL)
  for (k in seq_along(how$shares)) {
    share <- how$shares[k]
    sides <- list(up = 0 * work$values, down = 0 * work$values)
    if (identical(numbers, work$numbers)) break
    found <- engine_near_changes(work$near, numbers, share / little, how$tolerance, how$steps,
      how$renewals[k], how$closes_in, how$reach / share)
    work$cost$factorisations <- work$cost$factorisations + found$factorisations
    # Changes of measures, without jumps, with the field changed by +share and -share.
    sides <- if (length(found$down)) lapply(found[c("up", "down")], in_display_units, work = work)
    if (!is.null(sides)) break
  }
  if (is.null(sides)) return(NULL)
  slope <- (sides$up - sides$down) / (2 * share)
  # At a kink, the one-sided derivatives differ.
  turn <- abs(sides$up + sides$down) / share
  list(
    slope = slope, turn = turn, below = NA * slope, above = NA * slope,
    smooth = turn <= kink_share * sensitivity_scale(work, slope)
  )
}

# Returns derivatives from gears settled on both sides.
secant_derivatives <- function(work, field, step) {
  side <- function(way) {
    change <- settled_change(work, field, way * step)
    if (is.null(change)) NA * work$values else way * change / step
  }
  list(below = side(-1), above = side(1))
}

# Returns the change of measures with a field changed by a fraction, on the state's mesh, or NULL.
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
  if (length(found$change)) in_display_units(found$change, work)
}

# Returns the measures of a gear settled from the state on its mesh, or NULL.
settled_values <- function(work, gear) {
  found <- settle_on_mesh(work$state, gear, work$nodes, work$netting)
  if (is.null(found)) return(NULL)
  work$cost$factorisations <- work$cost$factorisations + found$report$factorisations
  if (found$usable) values_at(work, gear, found$si, found$mesh, found$position)
}

# Settles a changed gear on the mesh of a state, from its shape. Returns the result of
# settle_numbers(), the gear's numbers `si`, and `usable`: TRUE if it converged on the same mesh.
# Returns NULL if the gear has other parts.
settle_on_mesh <- function(state, gear, nodes, netting) {
  si <- gear_si(gear)
  if (!is.null(odd_parts(si, state))) return(NULL)
  shape <- state_shape(state)
  found <- settle_numbers(si, nodes, netting, shape, FALSE, function(iteration, residual) NULL)
  usable <- found$report$converged && has_same_mesh(found$mesh, shape)
  c(found, list(si = si, usable = usable))
}

# Returns derivatives from two secants, or from one. curvature: relative step of a whole-number
# field, else 0. With 0, a measure is smooth only if both secants are identical.
derivatives_of_secants <- function(work, sides, curvature) {
  slope <- (sides$below + sides$above) / 2
  one <- ifelse(is.na(sides$below), sides$above, sides$below)
  smooth <- abs(sides$above - sides$below) <= most_curvature * curvature * sensitivity_scale(work,
    slope)
  slope <- ifelse(is.na(slope), one, slope)
  list(slope = slope, below = sides$below, above = sides$above, smooth = smooth & !is.na(smooth))
}
