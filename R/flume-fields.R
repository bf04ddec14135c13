# The fields of a plan as the flume tank's controls.

# A control is a list of label, help, paths (fields that change together), must (what the schema
# allows, in words), required (whether the plan must give it), kind and value, by kind
#   number  unit (as shown), factor (to SI), dimension (NULL without units), low, high and step (of
#           the slider, in the unit), whole; `typed` in place of the value where a draft has what is
#           no number
#   choice  choices
#   truth
#   word    a text, with `suggest`: texts to choose from, if any
#   yaml    anything else, as a plan writes it on one line

# The controls that a page begins with.
#
# marked: paths that the user asks for beside the usual ones; those that the plan lacks are left
# out. say: as of new_say().
plan_controls <- function(plan, marked = list(), say = new_say()) {
  usual <- lapply(usual_of_plan(plan), function(ask) {
    ask$label <- said_label(say, ask$label, ask$paths[1])
    ask
  })
  asked <- Map(list, label = marked_labels(marked, say), paths = marked)
  seen <- vapply(asked, function(ask) ask$paths[1], "")
  usual <- Filter(function(ask) !ask$paths[1] %in% seen, usual)
  controls <- lapply(unname(c(usual, asked)), function(ask) {
    found <- lapply(ask$paths, function(path) plan_field(plan, path))
    if (any(vapply(found, is.null, NA))) return(NULL)
    simple_control(ask$label, ask$paths, found[[1]])
  })
  Filter(Negate(is.null), controls)
}

# "otter_boards.lift_coefficient" becomes "Otter boards: lift coefficient", unless it has a name.
marked_labels <- function(marked, say) {
  given <- names(marked)
  if (is.null(given)) given <- character(length(marked))
  vapply(seq_along(marked), function(k) {
    if (nzchar(given[k])) given[k] else said_path(say, marked[[k]][1])
  }, "")
}

# A control of a field that is a number, a choice or a truth value, or NULL.
simple_control <- function(label, paths, field) {
  if (is.null(field$node)) return(NULL)
  control <- new_control(label, paths, field)
  if (control$kind %in% c("number", "choice", "truth")) control
}

# The control of any field: list(node, value, given) of plan_field().
new_control <- function(label, paths, field, required = TRUE) {
  node <- field$node
  about <- list(
    label = label, paths = I(as.character(paths)), help = first_of(node$description, ""),
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

# Words that a field of any text is often given.
suggestions <- function(path) {
  if (grepl("(^|[.])material$", path)) c(names(material_abbreviations), rownames(gear_materials))
}

# A number as the plan gives it, in its own unit; without a value in the first of its units.
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

# Factors to SI by dimension and unit, one spelling each: what a page offers beside a number.
offered_units <- function() {
  lapply(plan_units, function(units) as.list(units[!duplicated(units)]))
}

# From half to one and a half times the value, as far as the schema allows, in round steps.
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

# 1, 2 or 5 times a power of ten, not below x.
round_step <- function(x) {
  power <- 10^floor(log10(x))
  power * c(1, 2, 5, 10)[which(c(1, 2, 5, 10) * power >= x * (1 - 1e-9))[1]]
}

# Paths of all fields of a plan that can have a slider, a choice or a tick.
markable_fields <- function(plan) {
  Filter(function(path) {
    field <- plan_field(plan, path)
    !is.null(field) && !is.null(simple_control("", path, field))
  }, given_paths(plan))
}

# Stops unless every marked field is one that this plan has and a control can show.
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
      abort_argument("{.arg fields} holds {.val {path}}, which this plan does not have{suggestion}")
    }
    if (is.null(simple_control("", path, field))) {
      abort_argument(
        "{.arg fields} holds {.val {path}}, which is no single number, choice or yes or no; the
        flume tank has no control for it."
      )
    }
  }
  as.list(marked)
}
