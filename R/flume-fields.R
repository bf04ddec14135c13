# The fields of a plan that the flume tank shows as controls.

# The controls of a plan: a named list by id of lists of id, label, help, paths (fields that change
# together), kind ("number", "choice" or "truth"), value (number, text or truth value), and of
# numbers unit (as shown), units (factors to SI by name, NULL where it has none), low, high and step
# (of the slider, in the unit) and whole; of choices `choices`.
#
# marked: paths that the user asks for beside the usual ones; those that the plan lacks are left
# out.
plan_controls <- function(plan, marked = list()) {
  usual <- usual_of_plan(plan)
  asked <- Map(list, label = marked_labels(marked), paths = marked)
  seen <- vapply(asked, function(ask) ask$paths[1], "")
  usual <- Filter(function(ask) !ask$paths[1] %in% seen, usual)
  controls <- lapply(unname(c(usual, asked)), function(ask) {
    found <- lapply(ask$paths, function(path) plan_field(plan, path))
    if (any(vapply(found, is.null, NA))) return(NULL)
    new_control(ask$label, ask$paths, found[[1]])
  })
  controls <- Filter(Negate(is.null), controls)
  ids <- sprintf("control_%d", seq_along(controls))
  stats::setNames(Map(function(control, id) c(list(id = id), control), controls, ids), ids)
}

# "otter_boards.lift_coefficient" becomes "Otter boards: lift coefficient", unless it has a name.
marked_labels <- function(marked) {
  given <- names(marked)
  if (is.null(given)) given <- character(length(marked))
  vapply(seq_along(marked), function(k) {
    if (nzchar(given[k])) given[k] else path_words(marked[[k]][1])
  }, "")
}

path_words <- function(path) {
  if (path %in% names(usual_fields)) return(usual_fields[[path]])
  words <- gsub("_", " ", strsplit(path, ".", fixed = TRUE)[[1]])
  last <- length(words)
  text <- if (last == 1L) words else paste0(paste(words[-last], collapse = " "), ": ", words[last])
  paste0(toupper(substr(text, 1, 1)), substring(text, 2))
}

# A control of a field, or NULL for fields that are no single number, choice or truth value.
new_control <- function(label, paths, field) {
  node <- field$node
  about <- list(label = label, paths = paths, help = first_of(node$description, ""))
  if (is.null(node)) return(NULL)
  if (node$shape %in% c("quantity", "number", "integer")) return(c(about, number_control(field)))
  if (node$shape == "boolean") {
    return(c(about, list(kind = "truth", value = check_boolean(field$value, node, ""))))
  }
  if (node$shape == "string" && !is.null(node$enum)) {
    return(c(about, list(kind = "choice", value = field$value, choices = node$enum)))
  }
  NULL
}

number_control <- function(field) {
  node <- field$node
  dimension <- node[["x-dimension"]]
  quantity <- if (is.character(field$value)) split_quantity(field$value) else c(field$value, "")
  value <- as.double(quantity[1])
  units <- control_units(dimension, quantity[2])
  unit <- if (is.null(units)) "" else names(units)[1]
  range <- control_range(value, node, if (is.null(units)) 1 else units[[1]])
  c(
    list(
      kind = "number", value = value, unit = unit, units = units, whole = node$shape == "integer"
    ),
    range
  )
}

# Factors to SI of a dimension's units, one spelling each, the plan's own first; NULL where it has
# none.
control_units <- function(dimension, own) {
  if (is.null(dimension) || dimension == "number" && !nzchar(own)) return(NULL)
  factors <- plan_units[[dimension]]
  own <- if (nzchar(own)) own else names(factors)[1]
  factor <- factors[[plain_unit(own)]]
  others <- factors[!duplicated(factors) & factors != factor]
  c(stats::setNames(factor, own), others)
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

# What a plan's field becomes by what a control sends: `given` comes from a browser, and may be
# anything. A number with a unit becomes text such as "4.8 knot".
control_value <- function(control, given) {
  refuse <- function(must) abort_field(control$paths[1], given$value, must)
  value <- given$value
  if (control$kind == "truth") {
    if (!is.logical(value) || length(value) != 1L || is.na(value)) refuse("yes or no")
    return(value)
  }
  if (control$kind == "choice") {
    if (!is_text(value) || !value %in% control$choices) {
      refuse(paste("one of", word_list(control$choices)))
    }
    return(value)
  }
  if (!is.numeric(value) || length(value) != 1L || !is.finite(value)) refuse("a number")
  if (is.null(control$units)) return(as.double(value))
  if (!is_text(given$unit) || !given$unit %in% names(control$units)) {
    refuse(paste("in one of these units:", word_list(names(control$units))))
  }
  paste(shortest_decimal(as.double(value)), given$unit)
}

# The gear with what the controls say: values = list by control id of list(value, unit).
apply_controls <- function(gear, controls, values) {
  plan <- gear$plan
  for (id in intersect(names(values), names(controls))) {
    value <- control_value(controls[[id]], as.list(values[[id]]))
    for (path in controls[[id]]$paths) plan <- set_plan_field(plan, path, value)
  }
  as_gear(plan, file = gear$file, like = gear)
}

# The id of the control that a plan's wrong field belongs to, or NULL.
control_of_path <- function(controls, path) {
  if (is.null(path)) return(NULL)
  own <- function(control) any(control$paths == path)
  # A wrong field of what a short form stands for is named by the part that it became.
  found <- names(Filter(own, controls))
  if (length(found)) found[1] else NULL
}

# Paths of all fields of a plan that can have a control, for the user to mark.
markable_fields <- function(plan) {
  Filter(function(path) {
    field <- plan_field(plan, path)
    !is.null(field) && !is.null(new_control("", path, field))
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
    if (is.null(new_control("", path, field))) {
      abort_argument(
        "{.arg fields} holds {.val {path}}, which is no single number, choice or yes or no; the
        flume tank has no control for it."
      )
    }
  }
  as.list(marked)
}
