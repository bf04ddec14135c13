#' Sensitivities of measures to fields of the plan
#'
#' How every measure of a settled gear changes with fields of its plan: which lengths, areas and
#' masses matter, and how much. The derivatives are exact, and one matrix is factorised for all of
#' them.
#'
#' At a settled shape `x` the net forces `F(x, p)` vanish, so that a small change of a field `p`
#' moves it by `J dx/dp = dF/dp` with `J = -dF/dx` (implicit function theorem). Values of the field
#' 1e-4 smaller and larger are compared (1e-5 or 1e-6, where twines go slack on the way), and steps
#' of the same factors go on until both shapes are in balance to rounding, their wakes too, of the
#' netting that is upstream at the state; where none of these are found the matrix is made again.
#' They agree with differences of settled shapes to 1e-6 where these are smooth.
#'
#' A gear's answer may have kinks: netting goes slack, ropes come to lie on the sea bed, a board's
#' table of coefficients turns. So the gear is also settled at 1 % less and 1 % more of each field,
#' from this state, and these two secants are given next to the tangent. `smooth` reports whether
#' the tangent holds that far: whether the secants' mean is within 0.5 % of it, the secants differ
#' by less than a fifth of it and the tangents on both sides at the state itself by 0.5 %. (Of an
#' elasticity below 0.01, by these shares of that.) What counts parts of the gear, slack netting
#' and rope on the bed, moves by steps: its slope is by the lines and contacts that 1 % takes to
#' zero force. Where such steps do not lead to balance, as with much slack netting, or the field
#' cannot be larger, the secants' mean is given and not called smooth. Of fields of whole numbers
#' it is the mean of the secants to one less and one more, smooth where these differ by no more
#' than three times as much as the field, as shares.
#'
#' @param state A settled state, from [settle()].
#' @param of Names of measures, as [measures()] has them; all when `NULL`.
#' @param to Fields of numbers by their paths, as in [update()][update.codend_gear]. An item of a
#'   list may hold several paths, of parts that are alike: their fields change together. `NULL`
#'   takes those that people change first, a dozen at most; `"all"` every number that the plan
#'   gives next to those that divide it into meshes and segments.
#' @param secants Whether to settle for secants, which takes longer than the tangents. Without them
#'   `smooth` speaks of the state itself alone.
#' @return A data frame of class `codend_sensitivities` with a row per measure and field:
#'
#'   - `measure`, and the `field` by its path (several are joined by ` + `);
#'   - `value` of the field with its `unit` in the plan (the SI unit of a bare number);
#'   - `slope`, in `slope_unit`: the measure's change per unit of the field;
#'   - `elasticity`: the measure's change in percent per percent of the field; `NA` where the
#'     measure is 0;
#'   - `secant_below` and `secant_above`: secants to 1 % less and 1 % more of the field (of whole
#'     numbers: one less and one more); `NA` where they were not wanted, do not settle or need
#'     other nodes;
#'   - `smooth`, as above.
#'
#'   The attribute `factorisations` counts what it cost. A field that the plan has not, that is no
#'   number, that is 0 or that only divides the gear for its computation (`segments`, `columns`) is
#'   an error of class `codend_error_argument`, as are other wrong arguments.
#' @seealso [codend_charts], [vary()] for large changes.
#' @export
#' @examples
#' found <- sensitivities(settle("towed_cable"), to = c("towing.speed", "ropes.cable.length"))
#' found[found$measure == "total_drag_kN", ]
#' found[found$measure == "total_drag_kN", ]
sensitivities <- function(state, of = NULL, to = NULL, secants = TRUE) {
  check_given("state")
  check_is_settled(state)
  check_truth(secants, "secants")
  base <- state_values(state)
  of <- chosen_some(of, names(base$values))
  fields <- slope_fields(state$gear, to)
  work <- tangent_work(state, base)
  found <- lapply(fields, function(field) lapply(field_slopes(work, field, secants), `[`, of))
  each <- function(name, as) rep(vapply(fields, `[[`, as, name), each = length(of))
  all <- function(name) unlist(lapply(found, `[[`, name), use.names = FALSE)
  value <- each("value", 0)
  unit <- each("unit", "")
  change <- all("slope")
  values <- unname(work$values[of])
  structure(
    data.frame(
      measure = of, field = each("name", ""), value = value, unit = unit, slope = change / value,
      slope_unit = paste(work$units[of], "per", ifelse(nzchar(unit), unit, "1")),
      elasticity = change / ifelse(values == 0, NA_real_, values),
      secant_below = all("below") / value, secant_above = all("above") / value,
      smooth = all("smooth")
    ),
    class = c("codend_sensitivities", "data.frame"),
    gear_name = state$gear$plan$name, conditions = state_conditions(state),
    measure_unit = work$units, factorisations = work$cost$factorisations
  )
}

# Shares of a field's value: of the tangent, as large as it holds (tensions of stiff ropes are
# differences of positions, which round), with how often the matrix is made again there; of secants.
tangent_shares <- c(1e-4, 1e-5, 1e-6, 1e-5)
tangent_renewals <- c(0L, 0L, 0L, 3L)
# By which the engine's numbers are found to change with a field.
number_share <- 1e-6
secant_share <- 0.01
# Steps of one matrix at most, and the net force over the largest tension that they end at.
chord_steps <- 20L
chord_tolerance <- 1e-11
# Of a slope, what two one-sided slopes at the state or the secants' mean may differ by, and what
# the secants from each other; and the least slope, as an elasticity, that this is a share of.
kink_share <- 0.005
most_bend <- 0.2
least_elasticity <- 0.01
# Fields that are taken where none are asked for, and how those begin that are not among the usual.
most_slope_fields <- 12L
telling_fields <- c("length", "mass", "area", "buoyancy", "lift_coefficient", "drag_area")

# Fields that say how finely a part is divided, not what it is.
dividing_fields <- c("segments", "bar_segments", "columns", "rows")

# ---- fields --------------------------------------------------------------------------------------

# The fields asked for: lists of name, paths, value, unit and whole.
slope_fields <- function(gear, to) {
  if (is.null(to) || identical(to, "all")) {
    every <- as.list(given_paths(gear$plan))
    if (is.null(to)) {
      last <- vapply(every, function(path) sub(".*[.]", "", path), "")
      every <- every[last %in% telling_fields]
    }
    groups <- unique(c(unname(lapply(usual_of_plan(gear$plan), `[[`, "paths")), every))
    found <- Filter(is.list, lapply(groups, function(paths) slope_field(gear, paths)))
    # other counts divide the gear otherwise
    found <- Filter(function(field) {
      if (field$whole) grepl("[.]number$", field$name) else !grepl("[.]meshes[.]", field$name)
    }, found)
    seen <- character()
    found <- Filter(function(field) {
      fresh <- !any(field$paths %in% seen)
      seen <<- c(seen, field$paths)
      fresh
    }, found)
    if (!length(found)) abort_argument("The plan gives no field of a number.")
    return(if (is.null(to)) utils::head(found, most_slope_fields) else found)
  }
  groups <- as.list(to)
  if (!length(groups) || !all(vapply(groups, is.character, NA)) || !all(lengths(groups) > 0L) ||
    anyNA(unlist(groups))) {
    abort_argument("{.arg to} must be paths of plan fields, such as {.val towing.speed}, or a
      list of such paths that change together.")
  }
  lapply(groups, function(paths) {
    found <- slope_field(gear, paths)
    if (is.list(found)) return(found)
    path <- paste(paths, collapse = " + ")
    abort_argument("{.arg to} holds {.val {path}}, which {found}.")
  })
}

# A field as slopes need it, or in words why it has none.
slope_field <- function(gear, paths) {
  numbers <- lapply(paths, function(path) field_number(gear$plan, path))
  wrong <- Filter(is.character, numbers)
  if (length(wrong)) return(wrong[[1L]])
  first <- numbers[[1L]]
  if (first$value == 0) return("is 0: a sensitivity is by shares of a value")
  if (any(sub(".*[.]", "", paths) %in% dividing_fields)) {
    return("only divides the gear for its computation: a sensitivity would be of its error")
  }
  alike <- vapply(numbers, function(number) identical(number, first), NA)
  if (!all(alike)) return("has fields with different values: they do not change together")
  c(list(name = paste(paths, collapse = " + "), paths = paths), first)
}

# The number of a field: list(value, unit, whole), or in words why it is none.
field_number <- function(plan, path) {
  field <- plan_field(plan, path)
  if (is.null(field)) return("this plan does not have")
  if (is.null(field$node) || !field$node$shape %in% c("quantity", "number", "integer")) {
    return("is no single number")
  }
  if (is.character(field$value)) {
    parts <- split_quantity(field$value)
    return(list(value = as.double(parts[1L]), unit = trimws(parts[2L]), whole = FALSE))
  }
  dimension <- first_of(field$node[["x-dimension"]], "number")
  list(
    value = as.double(field$value),
    unit = if (dimension == "number") "" else names(plan_units[[dimension]])[1L],
    whole = field$node$shape == "integer"
  )
}

# The plan with a field changed by a share of its value.
scaled_plan <- function(plan, field, share) {
  for (k in seq_along(field$paths)) {
    # fields of different values change by the same share
    one <- if (is.null(field$parts)) field else field$parts[[k]]
    text <- field_text(changed_number(one$value, share), one)
    plan <- set_plan_field(plan, field$paths[k], text)
  }
  plan
}

# The gear with such a change, or NULL where the plan does not allow it.
scaled_gear <- function(gear, field, share) {
  tryCatch(
    as_gear(scaled_plan(gear$plan, field, share), file = gear$file, like = gear,
      changed = changed_steps(gear, field$paths)),
    codend_error_plan = function(e) NULL
  )
}

# ---- slopes --------------------------------------------------------------------------------------

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
      as.double(state$lattice$engine$wake)
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

# Changes of measures, without jumps, to the gears in balance with a field changed by a share and by
# as much the other way, list(up, down), or NULL. numbers: with its little_share(), `little`; reach:
# the share over which what counts elements changes.
near_changes <- function(work, numbers, little, share, renewals = 0L, reach = secant_share,
                         tolerance = chord_tolerance, steps = chord_steps, closes_in = TRUE) {
  found <- engine_near_changes(work$near, numbers, share / little, tolerance, steps, renewals,
    closes_in, reach / share)
  work$cost$factorisations <- work$cost$factorisations + found$factorisations
  if (length(found$down)) lapply(found[c("up", "down")], near_shown, work = work)
}

values_at <- function(work, gear, si, lattice, position) {
  found <- state_values(new_state(gear, si, lattice, position, work$state$report))
  shown_numbers(found$values, measure_units(found$kinds))[work$measures]
}

# A field's slopes by its share: list(slope, below, above, smooth), each by measure.
field_slopes <- function(work, field, secants) {
  found <- if (!is.null(work$near) && !field$whole) tangent_slopes(work, field)
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

# By the tangent, over the largest share at which steps of the factors lead to balance on both
# sides; NULL where there is none.
tangent_slopes <- function(work, field) {
  little <- little_share(field)
  numbers <- field_numbers(work, field, little)
  if (is.null(numbers)) return(NULL)
  for (k in seq_along(tangent_shares)) {
    share <- tangent_shares[k]
    sides <- near_changes(work, numbers, little, share, tangent_renewals[k])
    if (!is.null(sides)) break
  }
  if (is.null(sides)) return(NULL)
  slope <- (sides$up - sides$down) / (2 * share)
  # where a kink lies at the state itself, slopes on both sides differ
  turn <- abs(sides$up + sides$down) / share
  list(
    slope = slope, below = NA * slope, above = NA * slope,
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

# How many times as much a slope may change as its field, to be a curve's.
most_curvature <- 3
