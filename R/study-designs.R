#' Create the designs of a study
#'
#' `designs()` creates a table of designs for [vary()]: a grid, a sample of ranges and
#' distributions, one field at a time, or a table of your own. Equal seeds give equal tables, and
#' the random numbers of the session stay unchanged.
#'
#' @details
#' Values of `how`:
#'
#' - `"grid"`: every combination; the first field changes fastest. A range has `number` (default 5)
#'   evenly spaced values, including both ends. A normal distribution has the medians of `number`
#'   equally likely parts.
#' - `"random"`: `number` random draws.
#' - `"latin"`: a Latin hypercube with one value of each field in every `1/number` of its
#'   distribution. It needs the package lhs.
#' - `"sobol"`: a Sobol' sequence with Owen's scrambling. It covers all fields jointly and evenly,
#'   best if `number` is a power of 2. It needs the package spacefillr, and so does `"indices"`.
#' - `"indices"`: samples for Sobol' indices. There are two samples of `number` designs, and copies
#'   of the first with each field from the second. The total is `number` times (fields plus 2).
#' - `"one_at_a_time"`: the plan as it is, then each field alone at its values. Ranges are treated
#'   as in a grid.
#' - `"table"`: the rows of a data frame.
#'
#' More rules:
#'
#' - A missing value (`NA`) keeps the value of the plan.
#' - A name with several paths gives these fields one value:
#'   `"ropes.port.length + ropes.starboard.length"`.
#' - Drawn values are rounded to six digits.
#' - Given values, such as `c("500 m", "600 m")`, are equally likely in a sample.
#'
#' @param ... Fields by path: values as in [update()][update.codend_gear], a distribution such as
#'   [value_range()]`("3 knot", "5 knot")`, or unnamed data frames of fields that change together.
#'   Your own table is a single data frame or the path of a CSV file.
#' @param how The method, see details. `NULL` (default) selects `"table"` for a single data frame or
#'   file, `"sobol"` if there is a distribution, else `"grid"`.
#' @param number Number of draws (required), or of values per range (default 5).
#' @param seed A whole number. Default 1.
#' @return A data frame of class `codend_designs`: one row per design, one column per field, with
#'   values as in a plan. Wrong arguments raise an error of class `codend_error_argument`. A missing
#'   package raises `codend_error_package`. [vary()] checks fields and values, because it knows the
#'   gear.
#' @references I. M. Sobol' (1967), USSR Computational Mathematics and Mathematical Physics 7:86.
#'   A. B. Owen (1995), in Monte Carlo and Quasi-Monte Carlo Methods in Scientific Computing, 299.
#'   M. D. McKay, R. J. Beckman, W. J. Conover (1979), Technometrics 21:239. A. Saltelli et al.
#'   (2010), Computer Physics Communications 181:259.
#' @seealso [vary()], [value_range()], [normal_value()].
#' @export
#' @examples
#' designs(towing.speed = c("3 knot", "4 knot"), ropes.cable.length = c("500 m", "700 m"))
#' if (requireNamespace("spacefillr", quietly = TRUE)) {
#'   designs(towing.speed = value_range("3 knot", "5 knot"),
#'     ropes.cable.length = normal_value("600 m", "20 m"), how = "sobol", number = 8)
#' }
designs <- function(..., how = NULL, number = NULL, seed = 1) {
  given <- list(...)
  alone <- length(given) == 1L && is.null(names(given))
  if (alone && is_text(given[[1L]])) given[[1L]] <- read_designs(given[[1L]])
  ways <- c("grid", "random", "latin", "sobol", "one_at_a_time", "indices", "table")
  if (!is.null(how)) how <- chosen(how, ways)
  axes <- design_axes(given)
  drawn <- vapply(axes, function(axis) is_distribution(axis[[1L]]), NA)
  if (is.null(how)) {
    how <- if (any(drawn)) "sobol" else if (alone && is.data.frame(given[[1L]])) "table" else "grid"
  }
  check_count("seed", seed, -2^31 + 1)
  number <- designs_number(how, number, any(drawn))
  if (how == "table" && !(alone && is.data.frame(given[[1L]]))) {
    abort_argument("{.arg how} is {.val table}, which needs one data frame or CSV file.")
  }
  shares <- switch(how,
    table = cbind(seq_len(nrow(axes[[1L]]))),
    grid = grid_of(lapply(axes, axis_levels, number)),
    one_at_a_time = one_at_a_time(lapply(axes, axis_levels, number)),
    indices = pick_freeze(sobol_points(number, 2L * length(axes), seed)),
    random = with_seed(seed, matrix(stats::runif(number * length(axes)), number)),
    latin = {
      check_package("lhs", "A Latin hypercube")
      with_seed(seed, lhs::randomLHS(number, length(axes)))
    },
    sobol = sobol_points(number, length(axes), seed)
  )
  columns <- lapply(seq_along(axes), function(k) {
    place <- shares[, k]
    if (how %in% c("grid", "one_at_a_time") && drawn[k]) {
      levels <- axis_levels(axes[[k]], number)
      place <- levels[place]
    } else if (!how %in% c("grid", "one_at_a_time", "table") && !drawn[k]) {
      rows <- nrow(axes[[k]])
      place <- pmin(floor(place * rows) + 1, rows)
    }
    axis_values(axes[[k]], place)
  })
  new_designs(do.call(cbind, columns), how, number, seed, axes)
}

new_designs <- function(table, how, number, seed, axes) {
  structure(
    table, class = c("codend_designs", "data.frame"), row.names = seq_len(nrow(table)), how = how,
    number = number_of(number),
    seed = if (!how %in% c("grid", "one_at_a_time", "table")) as.double(seed),
    distributions = unlist(lapply(axes, function(axis) {
      if (is_distribution(axis[[1L]])) setNames(format(axis[[1L]]), names(axis))
    })),
    factors = vapply(axes, function(axis) paste(names(axis), collapse = ", "), "")
  )
}

designs_number <- function(how, number, drawn) {
  if (!is.null(number)) check_count("number", number)
  if (how == "table") return(NULL)
  if (how %in% c("grid", "one_at_a_time")) {
    if (!drawn) return(NULL)
    number <- first_of(number, 5)
    check_count("number", number, 2)
  } else if (is.null(number)) {
    abort_argument("{.arg number} is missing; it must be the number of designs.")
  }
  number
}

# Reads designs from a CSV file. An empty cell keeps the value of the plan.
read_designs <- function(file) {
  check_file_exists(file)
  table <- tryCatch(
    utils::read.csv(file, check.names = FALSE, na.strings = c("NA", ""), strip.white = TRUE,
      stringsAsFactors = FALSE, encoding = "UTF-8"),
    error = function(e) {
      abort_file(file, "could not be read as CSV: {why}", why = conditionMessage(e))
    }
  )
  # `write_csv()` puts an apostrophe before text that a spreadsheet would run as a formula.
  table[] <- lapply(table, function(values) {
    if (is.character(values)) sub("^'(?=[=+@-])", "", values, perl = TRUE) else values
  })
  table
}

# ---- axes ----------------------------------------------------------------------------------------

# Returns the independent axes: data frames of fields that change together, or lists with one
# distribution.
design_axes <- function(given) {
  if (!length(given)) abort_argument("Give at least one field with its values.")
  paths <- names(given)
  if (is.null(paths)) paths <- character(length(given))
  axes <- lapply(seq_along(given), function(k) design_axis(given[[k]], paths[k]))
  fields <- unlist(lapply(axes, function(axis) unlist(lapply(names(axis), paths_of))))
  if (anyDuplicated(fields)) {
    twice <- fields[duplicated(fields)][1L]
    abort_argument("{.arg {twice}} is given twice.")
  }
  axes
}

design_axis <- function(values, path) {
  if (is.data.frame(values)) {
    if (nzchar(path)) {
      abort_argument("A data frame of fields that change together must have no name; remove
        {.arg {path}}.")
    }
    values[] <- Map(given_value, values, names(values))
  } else {
    if (!nzchar(path)) {
      abort_argument("Every field needs its path as a name, such as {.code towing.speed = 1:3}.")
    }
    if (is_distribution(values)) return(setNames(list(values), path))
    values <- given_value(values, path)
    if (is.null(values) || !is.atomic(values)) {
      abort_argument("{.arg {path}} must be a vector of numbers or strings, or a distribution such
        as {.code value_range(\"3 knot\", \"5 knot\")}.")
    }
    values <- setNames(data.frame(values), path)
    if (anyNA(values)) values <- values[0L, , drop = FALSE]
  }
  values[] <- lapply(values, plain_column)
  if (!nrow(values) || !length(values)) {
    name <- if (length(values)) names(values)[1L] else "designs"
    abort_argument("{.arg {name}} must have at least one value and no missing values.")
  }
  wrong <- names(values)[!nzchar(names(values)) | vapply(values, is.list, NA)]
  if (length(wrong)) {
    abort_argument("{.arg {wrong[1]}} must be a column of numbers or strings with a path as its
      name.")
  }
  values
}

# Returns text or doubles, so that designs from R and from a file are identical.
plain_column <- function(column) {
  if (is.list(column)) return(column)
  if (is.logical(column)) return(c("no", "yes")[column + 1L])
  if (is.numeric(column)) as.double(column) else as.character(column)
}

paths_of <- function(name) trimws(strsplit(name, "+", fixed = TRUE)[[1L]])

# Returns the values of one design by path. A missing value keeps the value of the plan.
design_fields <- function(designs, row) {
  values <- lapply(designs, `[[`, row)
  values <- values[!vapply(values, is.na, NA)]
  do.call(c, lapply(names(values), function(name) {
    paths <- paths_of(name)
    setNames(rep(values[name], length(paths)), paths)
  }))
}

# Returns grid positions on an axis: row numbers of values, or probabilities.
axis_levels <- function(axis, number) {
  one <- axis[[1L]]
  if (!is_distribution(one)) return(seq_len(nrow(axis)))
  shares <- if (one$kind == "between") {
    seq(0, 1, length.out = number)
  } else {
    (seq_len(number) - 0.5) / number
  }
  # Rounding to whole numbers can repeat a value.
  shares[!duplicated(quantile_numbers(one, shares))]
}

# Returns a data frame of the values of an axis: plan text with a unit, or numbers. place: row
# numbers or probabilities. NA stays NA.
axis_values <- function(axis, place) {
  of <- axis[[1L]]
  if (!is_distribution(of)) return(axis[place, , drop = FALSE])
  value <- quantile_numbers(of, place)
  if (nzchar(of$unit)) {
    value <- ifelse(is.na(value), NA_character_, unlist(numbers_in_units(value, of)))
  }
  setNames(data.frame(value), names(axis))
}

# ---- sampling ------------------------------------------------------------------------------------

# Returns a matrix of levels, designs x axes. The first axis changes fastest.
grid_of <- function(levels) {
  size <- prod(lengths(levels))
  if (size > 1e6) abort_argument("The grid has {size} designs; it must have at most a million.")
  as.matrix(do.call(expand.grid, lapply(levels, seq_along)))
}

# Returns a matrix like `grid_of()`. NA keeps the value of the plan.
one_at_a_time <- function(levels) {
  rows <- matrix(NA_integer_, 1L + sum(lengths(levels)), length(levels))
  row <- 1L
  for (k in seq_along(levels)) {
    at <- row + seq_along(levels[[k]])
    rows[at, k] <- seq_along(levels[[k]])
    row <- row + length(levels[[k]])
  }
  rows
}

sobol_points <- function(number, width, seed) {
  check_package("spacefillr", "A Sobol' sequence")
  points <- spacefillr::generate_sobol_owen_set(number, width, seed = seed)
  pmin(pmax(points, 0), 1 - 2^-24)
}

# Returns A, B, and A with each column from B (Saltelli et al. 2010). points: A and B side by side.
pick_freeze <- function(points) {
  width <- ncol(points) / 2L
  first <- points[, seq_len(width), drop = FALSE]
  second <- points[, width + seq_len(width), drop = FALSE]
  mixed <- lapply(seq_len(width), function(k) {
    one <- first
    one[, k] <- second[, k]
    one
  })
  do.call(rbind, c(list(first, second), mixed))
}

# Evaluates an expression with `seed`, then restores the random numbers of the session.
with_seed <- function(seed, expression) {
  world <- globalenv()
  before <- get0(".Random.seed", world, inherits = FALSE)
  kinds <- RNGkind()
  on.exit({
    do.call(RNGkind, as.list(kinds))
    if (is.null(before)) {
      rm(".Random.seed", envir = world)
    } else {
      assign(".Random.seed", before, world)
    }
  })
  set.seed(seed, "Mersenne-Twister", "Inversion", "Rejection")
  force(expression)
}

# ---- printing ------------------------------------------------------------------------------------

#' @export
print.codend_designs <- function(x, n = 10, ...) {
  ways <- c(
    grid = "every combination", random = "drawn at random", latin = "Latin hypercube",
    sobol = "Sobol' sequence", one_at_a_time = "one field at a time",
    indices = "for Sobol' indices", table = "table"
  )
  how <- attr(x, "how")
  seed <- attr(x, "seed")
  cat(nrow(x), if (nrow(x) == 1L) " design" else " designs", " of ", ncol(x),
    if (ncol(x) == 1L) " field" else " fields", if (!is.null(how)) paste0(", ", ways[[how]]),
    if (!is.null(seed)) paste0(", seed ", seed), "\n", sep = "")
  distributions <- attr(x, "distributions")
  for (name in intersect(names(distributions), names(x))) {
    cat("  ", name, " ", distributions[[name]], "\n", sep = "")
  }
  shown <- utils::head(as.data.frame(unclass(x), check.names = FALSE), n)
  shown[] <- lapply(shown, function(column) {
    ifelse(is.na(column), "as in the plan", as.character(column))
  })
  print(shown, ...)
  if (nrow(x) > n) cat("  and ", nrow(x) - n, " more\n", sep = "")
  invisible(x)
}
