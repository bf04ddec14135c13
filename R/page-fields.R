# The controls of the flume tank for fields of a plan.

# A control is list(help, paths (fields that change together), must (allowed values, in words),
# required (TRUE if the plan must give the field), kind, value). The page adds a label. Further
# elements depend on the kind.
#   `number`: unit (as displayed), factor (to SI), dimension (or NULL), whole, and the slider's low,
#   high and step. If a draft has no number here, `typed` replaces the value.
#   `choice`: choices.
#   `truth`: a logical value.
#   `word`: a string, with `suggest` (strings to choose from).
#   `yaml`: any other value, as YAML on one line.

# Returns the controls at the top of the form, with labels: empty without one, and in English for
# `usual` fields. marked: paths that the user added; paths that are not in the plan are skipped.
plan_controls <- function(plan, marked = list()) {
  labels <- first_of(names(marked), character(length(marked)))
  asked <- Map(list, label = labels, paths = marked, usual = FALSE)
  seen <- vapply(asked, function(ask) ask$paths[1], "")
  usual <- Filter(function(ask) !ask$paths[1] %in% seen, usual_of_plan(plan))
  controls <- lapply(unname(c(lapply(usual, c, usual = TRUE), asked)), function(ask) {
    found <- lapply(ask$paths, function(path) plan_field(plan, path))
    if (any(vapply(found, is.null, NA))) return(NULL)
    control <- simple_control(ask$paths, found[[1]])
    if (!is.null(control)) c(ask[c("label", "usual")], control)
  })
  Filter(Negate(is.null), controls)
}

# Returns NULL for a field that is not a number, a choice or a logical value.
simple_control <- function(paths, field) {
  if (is.null(field$node)) return(NULL)
  control <- new_control(paths, field)
  if (control$kind %in% c("number", "choice", "truth")) control
}

# field: list(node, value, given) from plan_field().
new_control <- function(paths, field, required = TRUE) {
  node <- field$node
  about <- list(
    paths = I(as.character(paths)), help = first_of(schema_description(node$description), ""),
    must = describe(node), required = required
  )
  value <- first_of(field$value, FALSE)
  c(about, if (is_number_node(node)) {
    number_control(field)
  } else if (node$shape == "boolean" && (is.logical(value) || value %in% names(truth_words))) {
    list(kind = "truth", value = check_boolean(value, node, ""))
  } else if (node$shape == "string" && !is.null(node$enum)) {
    list(kind = "choice", value = first_of(field$value, ""), choices = I(node$enum))
  } else if (node$shape == "string") {
    suggest <- I(as.character(suggestions(paths[1])))
    list(kind = "word", value = first_of(field$value, ""), suggest = suggest)
  } else {
    list(kind = "yaml", value = if (is.null(field$value)) "" else yaml_inline(field$value))
  })
}

is_number_node <- function(node) node$shape %in% c("quantity", "number", "integer")

# Returns strings that users often enter in a text field, or NULL.
suggestions <- function(path) {
  if (grepl("(^|[.])material$", path)) c(names(material_abbreviations), rownames(gear_materials))
}

# A field without a value has the first unit of its dimension.
number_control <- function(field) {
  node <- field$node
  dimension <- node[["x-dimension"]]
  value <- field$value
  quantity <- if (is_text(value)) split_quantity(value) else if (is.numeric(value)) c(value, "")
  known <- names(plan_units[[first_of(dimension, "number")]])
  odd <- !is.null(value) && (is.null(quantity) || !plain_unit(quantity[2]) %in% c("", known))
  if (odd) quantity <- NULL
  number <- if (is.null(quantity)) NA else as.double(quantity[1])
  unit <- first_of(quantity[2], "")
  if (identical(dimension, "number") && !nzchar(unit)) dimension <- NULL
  if (is.null(dimension)) unit <- "" else if (!nzchar(unit)) {
    unit <- names(plan_units[[dimension]])[1]
  }
  factor <- if (is.null(dimension)) 1 else plan_units[[dimension]][[plain_unit(unit)]]
  c(
    list(
      kind = "number", value = number, unit = unit, factor = factor, dimension = dimension,
      whole = node$shape == "integer", typed = if (odd) paste(unlist(value), collapse = " ")
    ),
    if (!is.na(number)) control_range(number, node, factor)
  )
}

# Factors to SI by dimension and unit, with one spelling per unit.
offered_units <- function() {
  lapply(plan_units, function(units) as.list(units[!duplicated(units)]))
}

# Returns 0.5 to 1.5 times the value, in round steps and within the limits of the schema.
control_range <- function(value, node, factor) {
  ends <- if (value == 0) c(0, 1) else range(c(0.5, 1.5) * value)
  step <- round_step(diff(ends) / 80)
  if (node$shape == "integer") step <- max(1, round(step))
  ends <- c(floor(ends[1] / step), ceiling(ends[2] / step)) * step
  least <- if (is.null(node$minimum)) -Inf else node$minimum / factor
  if (!is.null(node$exclusiveMinimum)) {
    bound <- node$exclusiveMinimum / factor
    least <- max(least, if (bound == 0) step else bound + step)
  }
  most <- if (is.null(node$maximum)) Inf else node$maximum / factor
  list(low = signif(max(ends[1], least), 10), high = signif(min(ends[2], most), 10), step = step)
}

# Returns the paths of all fields that simple_control() supports.
markable_fields <- function(plan) {
  Filter(function(path) {
    field <- plan_field(plan, path)
    !is.null(field) && !is.null(simple_control(path, field))
  }, given_paths(plan))
}

# Throws an error unless the plan has each marked field and a control for it. Returns a list.
check_marked <- function(marked, plan) {
  texts <- is.character(marked) ||
    (is.list(marked) && all(vapply(marked, is.character, NA)) && all(lengths(marked) > 0))
  if (!texts || anyNA(unlist(marked))) {
    abort_argument(
      "{.arg fields} must be paths of plan fields, such as {.val towing.speed}, or a list of such
      paths that change together."
    )
  }
  for (path in unlist(marked)) {
    field <- plan_field(plan, path)
    if (is.null(field)) {
      near <- nearest(path, markable_fields(plan))
      suggestion <- if (length(near)) paste0("; did you mean \"", near, "\"?") else "."
      abort_argument("{.arg fields} has {.val {path}}, but this plan does not have that
        field{suggestion}")
    }
    if (is.null(simple_control(path, field))) {
      abort_argument(
        "{.arg fields} has {.val {path}}, but the flume tank has no control for that field. Use
        fields with one number, one choice, or yes and no."
      )
    }
  }
  as.list(marked)
}

# Units that a user may choose, by dimension. The first unit is codend's default.
preferred_units <- list(
  length = c("m", "fathom", "ft"), force = c("kN", "tf", "lbf"), speed = c("m/s", "knot")
)

# Returns the plan field of a part or support. The fallback for a support is a rope that ends there.
clicked_field <- function(gear, name) {
  path <- finding_field(gear$plan, name, NULL)
  if (!is.na(path)) return(path)
  ends_there <- Filter(function(rope) name %in% c(rope$from, rope$to), gear_si(gear)$ropes)
  if (!length(ends_there)) return(NA_character_)
  finding_field(gear$plan, names(ends_there)[1L], NULL)
}
