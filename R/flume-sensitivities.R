# Sensitivities of the measures of the design on screen. The slow worker computes them for one
# field, or for the fields that users change first.

# `said`: paths of one control, which change together, or NULL for the fields that users change
# first.
requested_sensitivities <- function(state, said) {
  if (is.null(said)) return(sensitivities(state))
  sensitivities(state, fields = list(requested_field(state$gear$plan, said)$paths))
}

# Returns a list by field: paths, value, unit, an increase to start with, and for each measure its
# change per unit of the field.
sensitivities_message <- function(slopes) {
  lapply(unique(slopes$field), function(field) {
    rows <- slopes[slopes$field == field & is.finite(slopes$derivative), ]
    unit <- sensitivity_units(rows)
    value <- rows$value[1L]
    whole <- grepl("[.]number$", field)
    list(
      paths = I(strsplit(field, " + ", fixed = TRUE)[[1L]]), value = value, unit = rows$unit[1L],
      more = if (whole) max(1, round_step(abs(value) / 4)) else round_step(abs(value) / 20),
      measures = I(label_of(rows$measure, unit)),
      units = I(unit), slope = I(rows$derivative), below = I(rows$secant_below),
      above = I(rows$secant_above), smooth = I(rows$smooth), elasticity = I(rows$elasticity)
    )
  })
}

sensitivity_units <- function(rows) sub(" per [^ ]*$", "", rows$derivative_unit)
