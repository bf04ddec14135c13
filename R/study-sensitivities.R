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
