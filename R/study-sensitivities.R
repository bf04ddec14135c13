#' Compute sensitivities of measures to fields of the plan
#'
#' `sensitivities()` computes how every measure of a gear in equilibrium ([settle()]) changes with
#' fields of its plan, such as lengths, areas and masses. The derivatives are exact, and a single
#' matrix factorisation serves all fields.
#'
#' @details
#' # Derivatives
#' At a settled shape `x` the net forces `F(x, p)` are zero. A small change of a field `p` therefore
#' moves the shape by `J dx/dp = dF/dp` with `J = -dF/dx` (implicit function theorem).
#'
#' - The field changes by 1e-4 of its value in both directions, or by 1e-5 or 1e-6 if twines go
#'   slack in between.
#' - Iterations with the factorised matrix bring both shapes and their wakes to equilibrium, within
#'   rounding. Wakes come from the netting that is upstream at the state.
#' - If all step sizes fail, the matrix is factorised again.
#' - The result agrees with differences between settled shapes to 1e-6 if the response is smooth.
#'
#' # Kinks
#' The response of a gear can have kinks: netting goes slack, ropes touch the seabed, or a board's
#' table of coefficients has a corner. The gear is therefore also settled with 1 % less and 1 % more
#' of each field, starting from this state. `smooth` is `TRUE` if three differences are small, as
#' fractions of the tangent:
#'
#' - less than 0.5 % between the mean of both secants and the tangent;
#' - less than 20 % between the secants;
#' - less than 0.5 % between the tangents on both sides at the state itself.
#'
#' An elasticity below 0.01 counts as 0.01 in these fractions.
#'
#' # Special cases
#' - Counts of parts, such as slack netting or rope on the seabed, change in steps. Their derivative
#'   counts the lines and contacts that reach zero force within 1 % of the field.
#' - Iterations can fail, for example with much slack netting, or the field cannot increase. The
#'   mean of the secants is then returned. It is not `smooth` unless both secants are identical.
#' - A field of whole numbers has the mean of the secants to one less and one more. It is `smooth`
#'   if the relative difference between the secants is at most three times the relative step.
#'
#' @param state A settled state, from [settle()].
#' @param of Names of measures, as in [measures()], with or without unit. Default `NULL`: all.
#' @param fields Numeric fields by path, as in [update()][update.codend_gear]. A list item with
#'   several paths changes these fields together. `NULL` (default) selects up to 12 common fields.
#'   `"all"` selects every number except the settings of the mesh.
#' @param secants `FALSE` skips the settled gears, which take longer than the tangents. `smooth`
#'   then describes the state itself only. Default `TRUE`.
#' @return A data frame of class `codend_sensitivities`, one row per measure and field:
#'
#'   - `measure`, `field`: names; several paths are joined by ` + `.
#'   - `value`, `unit`: value of the field and its unit in the plan (SI unit of a bare number).
#'   - `derivative`, `derivative_unit`: change of the measure per unit of the field.
#'   - `elasticity`: change of the measure in percent per percent of the field; `NA` if the measure
#'     is 0.
#'   - `secant_below`, `secant_above`: secants to 1 % less and 1 % more (whole numbers: one less and
#'     one more). They are `NA` if not requested, not settled, or on a different mesh.
#'   - `smooth`: `TRUE` without a kink, see the section on kinks.
#'
#'   The attribute `factorisations` counts the matrix factorisations. A field must be a number of
#'   the plan other than 0, and not only a setting of the mesh (`segments`, `columns`). Other fields
#'   and wrong arguments raise an error of class `codend_error_argument`.
#'
#'   `print()` returns `x`, invisibly. It prints a table of elasticities above 0.01, with fields in
#'   rows and the main measures in columns.
#' @seealso [vary()] for large changes, [uncertainty()], [codend_charts].
#' @export
#' @examples
#' found <- sensitivities(settle("towed_cable"), fields = c("towing.speed", "ropes.cable.length"))
#' found[found$measure == "total_drag_kN", ]
sensitivities <- function(state, of = NULL, fields = NULL, secants = TRUE) {
  check_given("state")
  check_is_settled(state)
  check_truth(secants, "secants")
  base <- state_values(state)
  of <- chosen_measures(of, names(base$values))
  fields <- sensitivity_fields(state$gear, fields)
  work <- tangent_work(state, base)
  found <- lapply(fields, function(field) lapply(field_sensitivities(work, field, secants), `[`,
    of))
  each <- function(name, as) rep(vapply(fields, `[[`, as, name), each = length(of))
  all <- function(name) unlist(lapply(found, `[[`, name), use.names = FALSE)
  value <- each("value", 0)
  unit <- each("unit", "")
  change <- all("slope")
  values <- unname(work$values[of])
  structure(
    data.frame(
      measure = of, field = each("name", ""), value = value, unit = unit,
        derivative = change / value,
      derivative_unit = derivative_units(work$units[of], unit),
      elasticity = change / ifelse(values == 0, NA_real_, values),
      secant_below = all("below") / value, secant_above = all("above") / value,
      smooth = all("smooth")
    ),
    class = c("codend_sensitivities", "data.frame"),
    gear_name = state$gear$plan$name, conditions = state_conditions(state),
    main = printed_names(base),
    measure_unit = work$units,
    factorisations = work$cost$factorisations
  )
}

# Default fields: their number, and the last parts of the paths that follow the usual fields.
most_sensitivity_fields <- 12L
telling_fields <- c("length", "mass", "area", "buoyancy", "lift_coefficient", "drag_area")

# Fields that set the mesh of a part, not its properties.
dividing_fields <- c("segments", "bar_segments", "columns", "rows")

# ---- fields --------------------------------------------------------------------------------------

# Returns a list per field: name, paths, value, unit, whole.
sensitivity_fields <- function(gear, fields) {
  if (is.null(fields) || identical(fields, "all")) {
    every <- as.list(given_paths(gear$plan))
    if (is.null(fields)) {
      last <- vapply(every, function(path) sub(".*[.]", "", path), "")
      every <- every[last %in% telling_fields]
    }
    groups <- unique(c(unname(lapply(usual_of_plan(gear$plan), `[[`, "paths")), every))
    found <- Filter(is.list, lapply(groups, function(paths) sensitivity_field(gear, paths)))
    # Other counts, and counts of meshes, would change the mesh of the model.
    found <- Filter(function(field) {
      if (field$whole) grepl("[.]number$", field$name) else !grepl("[.]meshes[.]", field$name)
    }, found)
    seen <- character()
    found <- Filter(function(field) {
      fresh <- !any(field$paths %in% seen)
      seen <<- c(seen, field$paths)
      fresh
    }, found)
    if (!length(found)) abort_argument("The plan has no numeric field.")
    return(if (is.null(fields)) utils::head(found, most_sensitivity_fields) else found)
  }
  groups <- as.list(fields)
  if (!length(groups) || !all(vapply(groups, is.character, NA)) || !all(lengths(groups) > 0L) ||
    anyNA(unlist(groups))) {
    abort_argument("{.arg fields} must be paths of plan fields, such as {.val towing.speed}, or a
      list of such paths that change together.")
  }
  lapply(groups, function(paths) {
    found <- sensitivity_field(gear, paths)
    if (is.list(found)) return(found)
    path <- paste(paths, collapse = " + ")
    abort_argument("{.arg fields} has {.val {path}}, which {found}.")
  })
}

# Returns a field for sensitivities, or text with the reason why it has none.
sensitivity_field <- function(gear, paths) {
  numbers <- lapply(paths, function(path) field_number(gear$plan, path))
  wrong <- Filter(is.character, numbers)
  if (length(wrong)) return(wrong[[1L]])
  first <- numbers[[1L]]
  if (first$value == 0) return("is 0: sensitivities need a nonzero value")
  if (any(sub(".*[.]", "", paths) %in% dividing_fields)) {
    return("only sets the mesh of the model: its sensitivity would be a discretisation error")
  }
  alike <- vapply(numbers, function(number) identical(number, first), NA)
  if (!all(alike)) return("has fields with different values: they cannot change together")
  c(list(name = paste(paths, collapse = " + "), paths = paths), first)
}

# Returns list(value, unit, whole), or text with the reason why the field has no number.
field_number <- function(plan, path) {
  field <- plan_field(plan, path)
  if (is.null(field)) return("this plan does not have")
  if (is.null(field$node) || !field$node$shape %in% c("quantity", "number", "integer")) {
    return("is not a single number")
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

scaled_plan <- function(plan, field, share) {
  for (k in seq_along(field$paths)) {
    # Fields with different values change by the same fraction.
    one <- if (is.null(field$parts)) field else field$parts[[k]]
    text <- field_text(changed_number(one$value, share), one)
    plan <- set_plan_field(plan, field$paths[k], text)
  }
  plan
}

# Returns the gear with this change, or NULL if the plan does not allow it.
scaled_gear <- function(gear, field, share) {
  tryCatch(
    as_gear(scaled_plan(gear$plan, field, share), file = gear$file, like = gear,
      changed = changed_steps(gear, field$paths)),
    codend_error_plan = function(e) NULL
  )
}
