# Formulas of measures: objectives and conditions of `optimise_gear()`, matches of `calibrate()`. A
# measure with a unit at the end of its name is a number in that unit. Without the unit it is in SI
# and can be compared with text: `~ headline_height >= "5 m"`. Changed fields are named by their
# paths and are in SI.

# Returns a data frame of the names for formulas. Columns: name, column (of `measures()`), unit,
# factor (SI per unit; 1 for names with a unit), ends (TRUE for names with a unit).
formula_names <- function(values) {
  unit <- attr(values, "unit")[names(values)]
  bare <- nzchar(unit)
  size <- vapply(unit, function(one) if (nzchar(one)) unit_size(one) else 1, 0)
  plain <- without_unit(names(values), unit)
  rbind(
    data.frame(name = names(values), column = names(values), unit = unname(unit), factor = 1,
      ends = bare, row.names = NULL),
    data.frame(name = plain, column = names(values), unit = unname(unit), factor = unname(size),
      ends = FALSE, row.names = NULL)[bare & !plain %in% names(values), ]
  )
}

# Parses the name of a measure or a one-sided formula. Returns list(text, call, names, slopes
# (derivatives by name), dimensions). `what`: argument name for errors. `paths`: fields that the
# formula can name.
read_formula <- function(given, what, words, paths = character()) {
  if (is_text(given)) {
    call <- as.name(given)
  } else if (inherits(given, "formula") && length(given) == 2L) {
    call <- given[[2L]]
  } else {
    abort_argument("{.arg {what}} must be the name of a measure or a formula of measures, such as
      {.code ~ total_drag / door_spread}.")
  }
  within <- if (inherits(given, "formula")) environment(given)
  ready_expression(call, what, words, paths, within)
}

# `within`: environment of other variables in the call.
ready_expression <- function(call, what, words, paths, within = NULL) {
  call <- with_bounds(call, words, what, within)
  call <- walk_call(call, function(leaf) {
    name <- if (is.name(leaf)) as.character(leaf) else return(leaf)
    if (name %in% c(words$name, paths) || is.null(within)) return(leaf)
    value <- given_value(get0(name, within), name)
    good <- is_text(value) || (is.numeric(value) && length(value) == 1L && is.finite(value))
    if (good) unname(value) else leaf
  })
  text <- paste(trimws(deparse(call, width.cutoff = 500L)), collapse = " ")
  dimensions <- character()
  call <- walk_call(call, function(leaf) {
    if (!is.character(leaf)) return(leaf)
    dimension <- quantity_dimension(leaf)
    if (is.na(dimension)) {
      abort_argument("{.arg {what}} has {.val {leaf}} in {.code {text}}, which is not a number with
        a unit of plans.")
    }
    dimensions <<- c(dimensions, dimension)
    quantity_si(leaf, dimension)
  })
  named <- all.vars(call)
  known <- c(words$name, paths)
  wrong <- setdiff(named, known)
  if (length(wrong)) {
    near <- nearest(wrong[1L], known)
    hint <- if (length(near)) paste0(" Did you mean ", near, "?") else ""
    abort_argument("{.arg {what}} uses {.val {wrong[1]}} in {.code {text}}, which is neither a
      measure of this gear nor a changed field.{hint} Measures: {.val {words$name[words$ends]}}.")
  }
  if (length(dimensions) && any(words$ends[match(named, words$name)] %in% TRUE)) {
    abort_argument("{.arg {what}} has a string with a unit in {.code {text}} next to a measure with
      a unit in its name. Remove the unit from the name, or write a number.")
  }
  # Only these functions are ever evaluated.
  used <- setdiff(all.names(call, unique = TRUE), named)
  other <- setdiff(used, formula_functions)
  if (length(other)) {
    hint <- if (other[1L] == "abs") " For a required value of a measure, use {.fn find_value}."
    abort_argument(paste0("{.arg {what}} is {.code {text}}, but {.code {other[1]}} is not
      supported: use + - * / ^, sqrt, exp, log, sin, cos and tan.", hint))
  }
  slopes <- lapply(setNames(named, named), function(name) {
    tryCatch(stats::D(call, name), error = function(e) {
      abort_argument("{.arg {what}} is {.code {text}}, but its derivative is not supported: use
        + - * / ^, sqrt, exp, log, sin, cos and tan.")
    })
  })
  list(text = text, call = call, names = named, slopes = slopes, dimensions = dimensions)
}

# Returns the columns of the measures in formulas.
formula_measures <- function(words, formulas) {
  unique(words$column[words$name %in% unlist(lapply(formulas, `[[`, "names"))])
}

formula_functions <- c("+", "-", "*", "/", "^", "(", "sqrt", "exp", "log", "sin", "cos", "tan")

# Applies a function to each leaf of a call.
walk_call <- function(call, leaf) {
  if (!is.call(call)) return(leaf(call))
  call[-1L] <- lapply(as.list(call)[-1L], walk_call, leaf)
  call
}

# Parses conditions. Returns a list per condition: text, left and right (from `ready_expression()`),
# way, equal. `way`: 1 if left is at most right, -1 if it is at least right.
read_conditions <- function(keep, words, paths) {
  if (inherits(keep, "formula") || !is.list(keep)) keep <- list(keep)
  calls <- lapply(keep, function(one) {
    if (!inherits(one, "formula") || length(one) != 2L) {
      abort_argument("{.arg keep} must be formulas such as {.code ~ headline_height >= \"5 m\"}.")
    }
    lapply(split_and(one[[2L]]), function(call) list(call = call, within = environment(one)))
  })
  lapply(unlist(calls, recursive = FALSE), function(one) {
    call <- one$call
    text <- paste(trimws(deparse(call, width.cutoff = 500L)), collapse = " ")
    sign <- if (is.call(call)) as.character(call[[1L]]) else ""
    if (!sign %in% c("<=", ">=", "<", ">", "==")) {
      abort_argument("{.arg keep} has {.code {text}}; it must compare with >=, <= or ==.")
    }
    left <- ready_expression(call[[2L]], "keep", words, paths, one$within)
    right <- ready_expression(call[[3L]], "keep", words, paths, one$within)
    check_dimensions(left, right, text, words)
    check_dimensions(right, left, text, words)
    if (!length(c(left$names, right$names))) {
      abort_argument("{.arg keep} has {.code {text}} without a measure; compare a measure with a
        limit.")
    }
    list(text = text, left = left, right = right, way = if (sign %in% c("<=", "<")) 1 else -1,
      equal = sign == "==")
  })
}

split_and <- function(call) {
  if (is.call(call) && identical(call[[1L]], as.name("("))) return(split_and(call[[2L]]))
  if (is.call(call) && as.character(call[[1L]]) %in% c("&", "&&")) {
    return(c(split_and(call[[2L]]), split_and(call[[3L]])))
  }
  list(call)
}

# A limit with a unit needs a measure of its dimension, named without a unit.
check_dimensions <- function(one, other, text, words) {
  if (!length(one$dimensions) || !is.name(other$call)) return(invisible(NULL))
  row <- words[match(other$text, words$name), ]
  if (isTRUE(row$ends)) {
    abort_argument("{.arg keep} has {.code {text}}, a string with a unit next to a measure with a
      unit in its name. Remove the unit from the name, or write a number.")
  }
  if (is.na(row$unit) || length(one$dimensions) != 1L) return(invisible(NULL))
  holds <- Filter(function(name) row$unit %in% names(plan_units[[name]]), names(plan_units))
  if (!length(holds) || one$dimensions %in% holds) return(invisible(NULL))
  abort_argument("{.arg keep} has {.code {text}}, but {.field {other$text}} is in {row$unit}.")
}

# Returns list(value, slope (by free field)). `at`: list(values, slopes (names x free fields, or
# NULL)).
evaluate_formula <- function(formula, at) {
  known <- as.list(at$values[formula$names])
  # The caller reports NaN.
  value <- suppressWarnings(as.double(eval(formula$call, known)))
  slope <- if (!is.null(at$slopes)) {
    parts <- lapply(formula$names, function(name) {
      eval(formula$slopes[[name]], known) * at$slopes[name, ]
    })
    Reduce(`+`, parts, numeric(ncol(at$slopes)))
  }
  list(value = value, slope = slope)
}

# Converts values to the unit of a formula. Bare numbers stay unchanged. Quantities are converted to
# the unit in the name of the only measure, else to SI. Returns numeric() for other types.
formula_numbers <- function(values, formula, words, text) {
  values <- given_value(values, text)
  if (is.numeric(values)) return(as.double(values))
  if (!is.character(values)) return(numeric())
  measured <- words[match(formula$names, words$name), ]
  alone <- is.name(formula$call)
  if (!alone && any(measured$ends)) {
    abort_argument("{.code {text}} has a unit, but so has the name of the measure in
      {.code {formula$text}}. Remove the unit from the name, or give numbers.")
  }
  vapply(values, function(value) {
    if (is.na(value)) return(NA_real_)
    dimension <- quantity_dimension(value)
    if (is.na(dimension) || (alone && !measured$unit %in% names(plan_units[[dimension]]))) {
      abort_argument("{.code {text}} is {value}, which does not convert to the unit of
        {.code {formula$text}}{if (alone) paste(':', measured$unit)}.")
    }
    quantity_si(value, dimension) / if (isTRUE(measured$ends)) unit_size(measured$unit) else 1
  }, 0, USE.NAMES = FALSE)
}

# Replaces `lower(measure, probability)` by `measure * (1 - t * share)`; `upper()` adds instead.
# `t`: Student's t quantile. `share`: relative standard uncertainty (`words$share`, NULL if
# unknown).
with_bounds <- function(call, words, what, within = NULL) {
  if (!is.call(call)) return(call)
  head <- call[[1L]]
  if (!(is.name(head) && as.character(head) %in% c("lower", "upper"))) {
    call[-1L] <- lapply(as.list(call)[-1L], with_bounds, words, what, within)
    return(call)
  }
  text <- paste(deparse(call), collapse = " ")
  level <- 0.9
  if (length(call) > 2L) level <- tryCatch(eval(call[[3L]], within), error = function(e) NULL)
  name <- if (length(call) > 1L && is.name(call[[2L]])) as.character(call[[2L]])
  row <- if (!is.null(name)) match(name, words$name)
  good <- length(call) <= 3L && isTRUE(!is.na(row)) && is.numeric(level) && length(level) == 1L &&
    isTRUE(level > 0.5 && level < 1)
  if (!good) {
    abort_argument("{.arg {what}} has {.code {text}}; it must be a measure of this gear and a
      probability above 0.5, such as {.code lower(net_mouth_height, 0.9)}.")
  }
  if (is.null(words$share)) {
    abort_argument("{.arg {what}} has {.code {text}}; bounds work only in {.arg keep} of
      {.fn optimise_gear}.")
  }
  reach <- stats::qt(level, pmax(1, words$freedom[row])) * words$share[row]
  sign <- if (identical(as.character(head), "lower")) -1 else 1
  call("*", call[[2L]], 1 + sign * reach)
}

has_bounds <- function(keep) {
  formulas <- if (inherits(keep, "formula")) list(keep) else keep
  any(vapply(formulas, function(one) {
    inherits(one, "formula") && any(c("lower", "upper") %in% all.names(one))
  }, NA))
}
