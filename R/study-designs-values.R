#' Define ranges and distributions of fields
#'
#' `value_range()` and `normal_value()` describe the values of a plan field in a study, for
#' [designs()], [calibrate()] and [optimise_gear()].
#'
#' @param low,high Ends of the range: text with a unit such as `"3 knot"`, objects of the package
#'   units, or numbers in SI. In `normal_value()` they truncate the distribution (default: not
#'   truncated).
#' @param mean,sd Mean and standard deviation of the normal distribution before truncation, in units
#'   of one dimension.
#' @param log `TRUE` if equal ratios are equally likely. Default `FALSE`: equal differences are
#'   equally likely.
#' @param whole `TRUE` if values are whole numbers, such as counts of meshes and floats. Default
#'   `FALSE`.
#' @return An object of class `codend_distribution`. Wrong arguments raise an error of class
#'   `codend_error_argument`.
#' @seealso [designs()], [vary()], [calibrate()].
#' @name codend_distributions
#' @examples
#' value_range("3 knot", "5 knot")
#' value_range(40, 120, whole = TRUE)
#' normal_value("600 m", "20 m", low = "550 m")
NULL

#' @rdname codend_distributions
#' @export
value_range <- function(low, high, log = FALSE, whole = FALSE) {
  check_given("low", "high")
  ends <- numbers_in_one_unit(list(low = low, high = high))
  if (ends$value[1L] >= ends$value[2L]) {
    abort_argument("{.arg low} is {.val {low}} and {.arg high} is {.val {high}}; {.arg low} must be
      smaller.")
  }
  check_truth(log, "log")
  check_truth(whole, "whole")
  if (log && ends$value[1L] <= 0) {
    abort_argument("{.arg low} is {.val {low}}; with {.arg log} it must be above 0.")
  }
  new_distribution("between", ends$value, ends$unit, ends$value, whole, log = log)
}

#' @rdname codend_distributions
#' @export
normal_value <- function(mean, sd, low = NULL, high = NULL, whole = FALSE) {
  check_given("mean", "sd")
  given <- Filter(Negate(is.null), list(mean = mean, sd = sd, low = low, high = high))
  numbers <- numbers_in_one_unit(given)
  value <- setNames(numbers$value, names(given))
  check_truth(whole, "whole")
  if (value[["sd"]] <= 0) abort_argument("{.arg sd} is {.val {sd}}; it must be above 0.")
  ends <- c(-Inf, Inf)
  if (!is.null(low)) ends[1L] <- value[["low"]]
  if (!is.null(high)) ends[2L] <- value[["high"]]
  shares <- stats::pnorm(ends, value[["mean"]], value[["sd"]])
  if (diff(shares) < 1e-6) {
    abort_argument("{.arg low} and {.arg high} contain less than a millionth of the normal
      distribution; widen them.")
  }
  new_distribution("normal", unname(value[c("mean", "sd")]), numbers$unit, ends, whole)
}

new_distribution <- function(kind, numbers, unit, ends, whole, log = FALSE) {
  structure(
    list(kind = kind, numbers = numbers, unit = unit, ends = ends, whole = whole, log = log),
    class = "codend_distribution"
  )
}

is_distribution <- function(value) inherits(value, "codend_distribution")

# Returns list(value, unit ("" for bare numbers)) in the unit of the first quantity.
numbers_in_one_unit <- function(given) {
  split <- lapply(names(given), function(name) {
    value <- given_value(given[[name]], name)
    number <- is.numeric(value) && length(value) == 1L && is.finite(value)
    parts <- if (number) c(value, "") else if (is_text(value)) split_quantity(value)
    if (is.null(parts)) {
      abort_argument("{.arg {name}} is {describe_value(value)}; it must be one number, or a string
        such as {.val 3 knot}.")
    }
    unit <- plain_unit(parts[2L])
    dimension <- if (nzchar(unit)) quantity_dimension(paste(1, unit)) else ""
    if (is.na(dimension)) {
      abort_argument("{.arg {name}} is {.val {value}}, whose unit is unknown.")
    }
    list(value = as.double(parts[1L]), unit = unit, dimension = dimension)
  })
  dimension <- vapply(split, `[[`, "", "dimension")
  if (length(unique(dimension)) > 1L) {
    odd <- names(given)[dimension != dimension[1L]][1L]
    first <- names(given)[1L]
    abort_argument("{.arg {odd}} is {.val {given[[odd]]}}, but {.arg {first}} is
      {.val {given[[1]]}}; they must have the same dimension, both with units or both without.")
  }
  unit <- split[[1L]]$unit
  factor <- function(one) if (nzchar(unit)) plan_units[[dimension[1L]]][[one$unit]] else 1
  value <- vapply(split, function(one) {
    if (one$unit == unit) one$value else one$value * factor(one) / factor(split[[1L]])
  }, 0)
  list(value = value, unit = unit)
}

# Returns numbers in the unit of a distribution, as values of a plan.
numbers_in_units <- function(numbers, of) {
  if (!nzchar(of$unit)) return(as.list(numbers))
  as.list(paste(with_plain_numbers(vapply(numbers, format, "", digits = 15)), of$unit))
}

# Returns quantiles at probabilities `share`.
quantile_numbers <- function(of, share) {
  if (of$whole) {
    ends <- c(ceiling(of$ends[1L]), floor(of$ends[2L]))
    if (of$kind == "between") {
      # Half a unit at both ends makes the first and last number as likely as the others.
      wide <- if (of$log) log(ends + c(-0.5, 0.5)) else ends + c(-0.5, 0.5)
      value <- wide[1L] + share * diff(wide)
      value <- round(if (of$log) exp(value) else value)
    } else {
      value <- round(normal_quantile(of, share))
    }
    return(pmin(pmax(value, ends[1L]), ends[2L]))
  }
  value <- if (of$kind == "normal") {
    normal_quantile(of, share)
  } else if (of$log) {
    of$ends[1L] * (of$ends[2L] / of$ends[1L])^share
  } else {
    of$ends[1L] + share * diff(of$ends)
  }
  pmin(pmax(signif(value, 6), of$ends[1L]), of$ends[2L])
}

# Probabilities are limited to 1e-6 and 1 - 1e-6, so that all values are finite.
normal_quantile <- function(of, share) {
  shares <- stats::pnorm(of$ends, of$numbers[1L], of$numbers[2L])
  share <- pmin(pmax(shares[1L] + share * diff(shares), 1e-6), 1 - 1e-6)
  stats::qnorm(share, of$numbers[1L], of$numbers[2L])
}

#' @export
format.codend_distribution <- function(x, ...) {
  shown <- function(number) {
    trimws(paste(with_plain_numbers(format(number, digits = 15)), x$unit))
  }
  ends <- x$ends
  said <- if (x$kind != "normal") paste("between", shown(ends[1L]), "and", shown(ends[2L])) else {
    paste0("normal, mean ", shown(x$numbers[1L]), ", standard deviation ", shown(x$numbers[2L]),
      if (is.finite(ends[1L])) paste0(", at least ", shown(ends[1L])),
      if (is.finite(ends[2L])) paste0(", at most ", shown(ends[2L])))
  }
  paste0(said, if (x$log) ", equal ratios", if (x$whole) ", whole numbers")
}

#' @export
print.codend_distribution <- function(x, ...) {
  cat(format(x), "\n", sep = "")
  invisible(x)
}
