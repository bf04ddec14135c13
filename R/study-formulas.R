# Formulas of measures: what is minimised and kept by optimise_gear(), and matched by calibrate(). A
# measure is named as measures() has it, and is then a number in the unit that its name ends in, or
# without that unit, and is then SI as texts with units are: `~ headline_height >= "5 m"`. Fields
# that may change stand by their paths, in the plan's unit of SI.

# What formulas may name: a data frame with name, column (of measures()), unit, size of 1 of it as
# it is computed (SI for names with a unit) and whether the name ends in a unit.
formula_words <- function(values) {
  unit <- attr(values, "unit")[names(values)]
  bare <- nzchar(unit)
  size <- vapply(unit, function(one) if (nzchar(one)) unit_size(one) else 1, 0)
  plain <- names(values)
  plain[bare] <- substring(plain[bare], 1L, nchar(plain[bare]) - nchar(unit_suffix(unit[bare])) - 1)
  rbind(
    data.frame(name = names(values), column = names(values), unit = unname(unit), factor = 1,
      ends = bare, row.names = NULL),
    data.frame(name = plain, column = names(values), unit = unname(unit), factor = unname(size),
      ends = FALSE, row.names = NULL)[bare & !plain %in% names(values), ]
  )
}

# A measure, or an expression of measures, made ready: list(text, call, names, slopes (calls by
# name)). given: text or a one-sided formula; what: the argument's name, for errors; paths: of
# fields that it may name.
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

# within: where values stand that are named and are neither measures nor fields.
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
      abort_argument("{.arg {what}} has {.val {leaf}} in {.code {text}}, which is no number with a
        unit that plans know.")
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
    abort_argument("{.arg {what}} names {.val {wrong[1]}} in {.code {text}}, which is no measure of
      this gear and no field that changes.{hint} Measures: {.val {words$name[words$ends]}}.")
  }
  if (length(dimensions) && any(words$ends[match(named, words$name)] %in% TRUE)) {
    abort_argument("{.arg {what}} has a text with a unit in {.code {text}} next to a measure whose
      name ends in one. Leave the unit out of the name, or write a number.")
  }
  # nothing else is ever called
  used <- setdiff(all.names(call, unique = TRUE), named)
  other <- setdiff(used, formula_functions)
  if (length(other)) {
    abort_argument("{.arg {what}} is {.code {text}}, where {.code {other[1]}} is not known: use
      + - * / ^, sqrt, exp, log, sin, cos and tan.")
  }
  slopes <- lapply(setNames(named, named), function(name) {
    tryCatch(stats::D(call, name), error = function(e) {
      abort_argument("{.arg {what}} is {.code {text}}, whose derivative is not known: use + - * / ^,
        sqrt, exp, log, sin, cos and tan.")
    })
  })
  list(text = text, call = call, names = named, slopes = slopes, dimensions = dimensions)
}

formula_functions <- c("+", "-", "*", "/", "^", "(", "sqrt", "exp", "log", "sin", "cos", "tan")

# A call with a function of its leaves in their place.
walk_call <- function(call, leaf) {
  if (!is.call(call)) return(leaf(call))
  call[-1L] <- lapply(as.list(call)[-1L], walk_call, leaf)
  call
}

# Conditions to keep, as differences that are at most 0, or are 0: lists of text, name, left, right
# (as read_formula() has them), way (1: left at most right, -1: at least) and equal.
read_conditions <- function(keep, words, paths) {
  if (inherits(keep, "formula")) keep <- list(keep)
  if (!is.list(keep)) {
    abort_argument("{.arg keep} must be formulas such as {.code ~ headline_height >= \"5 m\"}.")
  }
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
      abort_argument("{.arg keep} has {.code {text}}, which names no measure.")
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

# A limit with a unit stands beside a measure without one in its name, and of its dimension.
check_dimensions <- function(one, other, text, words) {
  if (!length(one$dimensions) || !is.name(other$call)) return(invisible(NULL))
  row <- words[match(other$text, words$name), ]
  if (isTRUE(row$ends)) {
    abort_argument("{.arg keep} has {.code {text}}, a text with a unit next to a measure whose name
      ends in one. Leave the unit out of the name, or write a number.")
  }
  if (is.na(row$unit) || length(one$dimensions) != 1L) return(invisible(NULL))
  holds <- Filter(function(name) row$unit %in% names(plan_units[[name]]), names(plan_units))
  if (!length(holds) || one$dimensions %in% holds) return(invisible(NULL))
  abort_argument("{.arg keep} has {.code {text}}, where {.field {other$text}} is in {row$unit}.")
}

# The value of an expression at measures and fields, with its slopes by free fields. at: list(values
# (of words, by name), slopes (a matrix of them by free fields)).
evaluate_formula <- function(formula, at) {
  known <- as.list(at$values[formula$names])
  # NaN is told by who asks
  value <- suppressWarnings(as.double(eval(formula$call, known)))
  slope <- if (!is.null(at$slopes)) {
    parts <- lapply(formula$names, function(name) {
      eval(formula$slopes[[name]], known) * at$slopes[name, ]
    })
    Reduce(`+`, parts, numeric(ncol(at$slopes)))
  }
  list(value = value, slope = slope)
}

# Returns given values in the unit of a formula: bare numbers as they are, quantities with a unit in
# the unit that ends the name of its only measure, else in SI; numeric() if they are neither.
# text: their name in errors.
formula_numbers <- function(values, formula, words, text) {
  values <- given_value(values, text)
  if (is.numeric(values)) return(as.double(values))
  if (!is.character(values)) return(numeric())
  measured <- words[match(formula$names, words$name), ]
  alone <- is.name(formula$call)
  if (!alone && any(measured$ends)) {
    abort_argument("{.code {text}} has a unit, and {.code {formula$text}} names a measure with a
      unit at its end. Leave the unit out of the name, or give numbers.")
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

# lower(measure, probability) and upper() in a formula: the measure times 1 less, or more, its
# relative standard uncertainty times the quantile. words$share: of every measure, where bounds are
# known.
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
    abort_argument("{.arg {what}} has {.code {text}}; bounds are for what
      {.fn optimise_gear} keeps.")
  }
  reach <- stats::qt(level, pmax(1, words$freedom[row])) * words$share[row]
  sign <- if (identical(as.character(head), "lower")) -1 else 1
  call("*", call[[2L]], 1 + sign * reach)
}

# Whether a formula has bounds.
has_bounds <- function(keep) {
  formulas <- if (inherits(keep, "formula")) list(keep) else keep
  any(vapply(formulas, function(one) {
    inherits(one, "formula") && any(c("lower", "upper") %in% all.names(one))
  }, NA))
}
