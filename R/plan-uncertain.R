# Uncertainties of a plan's numbers. A file has `{value: 4 mm, uncertainty: 10 %}`, `{range: [3.8
# mm, 4.2 mm]}` or paths in `uncertain`. A tree has plain numbers and `uncertain`.

# Returns a tree with plain numbers and their uncertainties under `uncertain`.
split_uncertain <- function(tree) {
  found <- list()
  walk <- function(value, path) {
    if (is_uncertain(value)) {
      number <- uncertain_number(value, path)
      found[[path]] <<- number$said
      return(number$value)
    }
    if (!is.list(value)) return(value)
    changed <- FALSE
    for (k in seq_along(value)) {
      one <- value[[k]]
      if (!is.list(one)) next
      step <- if (is.null(names(value))) as.character(k) else names(value)[k]
      new <- walk(one, join(path, step))
      if (!identical(new, one)) {
        value[[k]] <- new
        changed <- TRUE
      }
    }
    if (changed && is.null(names(value))) plain_tree(value) else value
  }
  plan <- walk(tree, "")
  if (length(found)) plan$uncertain[names(found)] <- found
  plan
}

# Returns the tree in the form of a file: numbers together with their uncertainties.
join_uncertain <- function(plan) {
  said <- plan$uncertain
  plan$uncertain <- NULL
  left <- list()
  for (path in names(said)) {
    value <- at_path(plan, path_steps(path))
    joined <- if (is.null(value)) NULL else {
      ends <- strsplit(said[[path]], " to ", fixed = TRUE)[[1L]]
      if (length(ends) == 2L) list(value = value, range = ends) else
        list(value = value, uncertainty = said[[path]])
    }
    if (is.null(joined)) left[path] <- said[path] else {
      plan <- put_at(plan, path_steps(path), joined)
    }
  }
  if (length(left)) plan$uncertain <- left
  plan
}

is_uncertain <- function(value) {
  is_map(value) && length(value) > 0L &&
    all(names(value) %in% c("value", "uncertainty", "range")) &&
    any(c("uncertainty", "range") %in% names(value))
}

# Returns the plain `value` of an uncertain number, and its uncertainty `said` as a string.
uncertain_number <- function(map, path) {
  allowed <- paste(
    "a `value` with an `uncertainty` such as 10 % or 0.2 m, or a `range` such as [4 m, 5 m]"
  )
  if (!is.null(map$range)) {
    ends <- unlist(map$range)
    if (length(ends) != 2L || !is.null(map$uncertainty)) abort_field(path, map, allowed)
    value <- map$value
    ends <- translated_text(ends)
    if (is.null(value)) {
      parts <- lapply(ends, split_quantity)
      if (any(lengths(parts) != 2L) || !identical(parts[[1L]][2L], parts[[2L]][2L])) {
        abort_field(path, map, "two numbers with the same unit, or given with a `value`")
      }
      middle <- mean(vapply(parts, function(part) as.double(part[1L]), 0))
      unit <- parts[[1L]][2L]
      value <- if (nzchar(unit)) paste(translated_text(middle), unit) else middle
    }
    return(list(value = value, said = paste(ends, collapse = " to ")))
  }
  said <- map$uncertainty
  if (is.null(map$value) || length(said) != 1L || is.list(said)) abort_field(path, map, allowed)
  list(value = map$value, said = translated_text(said))
}

translated_text <- function(said) {
  with_plain_numbers(vapply(said, format, "", digits = 15, USE.NAMES = FALSE))
}

at_path <- function(tree, steps) {
  for (step in steps) {
    key <- if (is.null(names(tree))) suppressWarnings(as.integer(step)) else step
    if (is.na(key) || (is.numeric(key) && (key < 1L || key > length(tree)))) return(NULL)
    if (is.character(key) && !key %in% names(tree)) return(NULL)
    tree <- tree[[key]]
  }
  tree
}

put_at <- function(tree, steps, value) {
  tree <- as.list(tree)
  key <- if (is.null(names(tree))) as.integer(steps[1L]) else steps[1L]
  tree[[key]] <- if (length(steps) == 1L) value else put_at(tree[[key]], steps[-1L], value)
  tree
}

# Returns the distribution of a number as c(share, off, uniform), or NA if `said` cannot be parsed.
# `value`: the number in SI; `dimension`: as in plan_units.
#   share: standard uncertainty as a fraction of the value, or of 1 if the value is 0
#   off: mean minus value, as such a fraction
#   uniform: 1 for a range, a uniform distribution (standard uncertainty: half of the range over
#     sqrt(3), JCGM 100:2008, 4.3.7); 0 for a normal distribution
# A percentage of 0 is 0.
number_distribution <- function(said, value, dimension) {
  size <- function(text) {
    parts <- split_quantity(text)
    if (is.null(parts)) return(NA_real_)
    if (!nzchar(parts[2L])) return(as.double(parts[1L]))
    if (parts[2L] %in% names(plan_units$number) && dimension != "number") return(NA_real_)
    suppressWarnings(as.double(tryCatch(quantity_si(text, dimension), error = function(e) NA)))
  }
  ends <- strsplit(said, " to ", fixed = TRUE)[[1L]]
  if (length(ends) == 2L) {
    ends <- vapply(ends, size, 0)
    # Range ends may have fewer digits than the value.
    slack <- 1e-9 * max(abs(ends))
    if (is.na(slack) || ends[1L] > value + slack || ends[2L] < value - slack) return(NA_real_)
    whole <- whole_of(value)
    return(c(diff(ends) / 2 / sqrt(3) / whole, (mean(ends) - value) / whole, 1))
  }
  parts <- split_quantity(said)
  share <- if (!is.null(parts) && parts[2L] %in% names(plan_units$number)) {
    if (value == 0) 0 else quantity_si(said, "number")
  } else {
    size(said) / whole_of(value)
  }
  c(share, 0, 0)
}

# Returns the reference of a relative change: the number itself, or 1 if it is 0.
whole_of <- function(value) if (value == 0) 1 else abs(value)

changed_number <- function(value, share) if (value == 0) share else value * (1 + share)

# Returns the distribution that a plan states for a number (see number_distribution()); NULL if the
# path does not have a valid number.
stated_distribution <- function(plan, path) {
  field <- plan_field(plan, path)
  shape <- field$node$shape
  chosen <- !is.null(field$node$enum) || !is.null(field$node$const)
  if (chosen || !isTRUE(shape %in% c("quantity", "number", "integer"))) return(NULL)
  dimension <- first_of(field$node[["x-dimension"]], "number")
  value <- if (is.character(field$value)) quantity_si(field$value, dimension) else field$value
  if (isTRUE(is.finite(value))) number_distribution(plan$uncertain[[path]], value, dimension)
}

# Returns the distributions of uncertain numbers in a plan: a data frame with a row per path and the
# columns share, off and uniform (see number_distribution()). Invalid entries throw an error.
uncertain_numbers <- function(plan) {
  said <- plan$uncertain
  found <- vapply(names(said), function(path) {
    here <- paste0("uncertain.", path)
    distribution <- stated_distribution(plan, path)
    if (is.null(distribution)) abort_field(here, said[[path]], "given for a number of the plan")
    if (!all(is.finite(distribution)) || distribution[1L] < 0) {
      abort_field(here, said[[path]], paste0(
        "a standard uncertainty such as 10 % or one in the unit of the field, or a range from a ",
        "smaller to a larger number that contains the value ",
        format(at_path(plan, path_steps(path))), ", such as 4 m to 5 m"
      ))
    }
    distribution
  }, c(share = 0, off = 0, uniform = 0))
  as.data.frame(t(matrix(found, 3L, dimnames = list(c("share", "off", "uniform"), names(said)))))
}

# Returns a plan without uncertainties of numbers that a change has removed, and without ranges that
# do not contain a changed number.
without_gone <- function(plan, before) {
  said <- plan$uncertain
  gone <- vapply(names(said), function(path) {
    steps <- path_steps(path)
    now <- at_path(plan, steps)
    then <- at_path(before, steps)
    if (is.null(now)) return(!is.null(then))
    kept <- identical(said[[path]], before$uncertain[[path]])
    if (!kept || is.list(now) || identical(now, then)) return(FALSE)
    # An invalid number gets its own error later.
    anyNA(tryCatch(stated_distribution(plan, path), codend_error_plan = function(e) NULL))
  }, NA)
  if (any(gone)) plan$uncertain <- plan$uncertain[!gone]
  if (any(gone) && !length(plan$uncertain)) plan$uncertain <- NULL
  plan
}
