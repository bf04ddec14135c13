#' Designs of a study
#'
#' A table of designs that [vary()] settles: every combination of values, a sample of ranges and
#' distributions, one field at a time, or a table of one's own. The same `seed` gives the same
#' table, and the session's own random numbers stay as they are.
#'
#' @details
#' What `how` may be:
#'
#' - `"grid"`: every combination, the first field changing fastest. Ranges have `number` values (5),
#'   evenly spaced and the ends among them; normal distributions the middles of as many equal
#'   shares.
#' - `"random"`: `number` draws.
#' - `"latin"`: a Latin hypercube, in which each field is once in every `1/number` of its
#'   distribution. Takes the package lhs.
#' - `"sobol"`: a Sobol' sequence, scrambled after Owen: spread evenly in all fields together, best
#'   where `number` is a power of 2. Takes the package spacefillr, as does the next.
#' - `"indices"`: for Sobol' indices: two samples of `number` designs, and the first again with each
#'   field from the second; `number` times fields plus 2 in all.
#' - `"one_at_a_time"`: the plan as it is, then each field alone at its values; ranges as in a grid.
#' - `"table"`: the rows of a data frame.
#'
#' A field that is not to change in a design is missing there (`NA`): it stays as in the plan.
#' A name may hold several paths, `"ropes.port.length + ropes.starboard.length"`: these fields have
#' one value.
#'
#' Drawn values are rounded to six figures.
#'
#' @param ... Fields by their path in the plan, with values as in [update()][update.codend_gear],
#'   such as `c("500 m", "600 m")`, which are equally likely where they are drawn, or a
#'   distribution, such as [value_range()]`("3 knot", "5 knot")`. Columns of a data frame without a
#'   name change together. A table of one's own is one such data frame, or the path of a CSV file.
#' @param how How designs are chosen, see below. `NULL` is `"table"` for one data frame or file,
#'   `"grid"` where all is values and `"sobol"` where there is a distribution.
#' @param number How many designs are drawn, or how many values each range has.
#' @param seed A whole number.
#' @return A data frame of class `codend_designs` with a row per design and a column per field, in
#'   the words of the plan. Wrong arguments are an error of class `codend_error_argument`; a package
#'   that is not installed is one of class `codend_error_package`. Fields and values are checked by
#'   [vary()], which knows the gear.
#' @references I. M. Sobol' (1967), USSR Computational Mathematics and Mathematical Physics 7:86.
#'   A. B. Owen (1995), in Monte Carlo and Quasi-Monte Carlo Methods in Scientific Computing, 299.
#'   M. D. McKay, R. J. Beckman, W. J. Conover (1979), Technometrics 21:239. A. Saltelli et al.
#'   (2010), Computer Physics Communications 181:259.
#' @seealso [vary()], [value_range()] and [normal_value()].
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
    abort_argument("{.arg how} is {.val table}, which takes one data frame or CSV file.")
  }
  shares <- switch(how,
    table = cbind(seq_len(nrow(axes[[1L]]))),
    grid = grid_of(lapply(axes, axis_levels, number)),
    one_at_a_time = one_at_a_time(lapply(axes, axis_levels, number)),
    indices = pick_freeze(sobol_points(number, 2L * length(axes), seed)),
    design_points(how, number, length(axes), seed)
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
  if (how == "table") return(NULL)
  if (how %in% c("grid", "one_at_a_time")) {
    if (!drawn) return(NULL)
    number <- first_of(number, 5)
    check_count("number", number, 2)
  } else {
    if (is.null(number)) abort_argument("{.arg number} must say how many designs are drawn.")
    check_count("number", number, 1)
  }
  number
}

# A table from a CSV file; what is empty stays as in the plan.
read_designs <- function(file) {
  check_file_exists(file)
  table <- tryCatch(
    utils::read.csv(file, check.names = FALSE, na.strings = c("NA", ""), strip.white = TRUE,
      stringsAsFactors = FALSE, encoding = "UTF-8"),
    error = function(e) {
      abort_file(file, "could not be read as CSV: {why}", why = conditionMessage(e))
    }
  )
  # as write_csv() writes what a spreadsheet would run
  table[] <- lapply(table, function(values) {
    if (is.character(values)) sub("^'(?=[=+@-])", "", values, perl = TRUE) else values
  })
  table
}

# ---- axes ----------------------------------------------------------------------------------------

# What changes independently: data frames whose columns are fields that change together, or lists of
# one distribution by its field.
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
      abort_argument("A data frame of fields that change together has no name, not {.arg {path}}.")
    }
    values <- as.data.frame(
      given_value(unclass(values), path), check.names = FALSE, stringsAsFactors = FALSE
    )
  } else {
    if (!nzchar(path)) {
      abort_argument("Every field must be named by its path, such as {.code towing.speed = 1:3}.")
    }
    if (is_distribution(values)) return(setNames(list(values), path))
    values <- given_value(values, path)
    if (is.null(values) || !is.atomic(values)) {
      abort_argument("{.arg {path}} must be a vector of numbers or texts, or a distribution such as
        {.code value_range(\"3 knot\", \"5 knot\")}.")
    }
    values <- setNames(data.frame(values), path)
    if (anyNA(values)) values <- values[0L, , drop = FALSE]
  }
  values[] <- lapply(values, plain_column)
  if (!nrow(values) || !length(values)) {
    name <- if (length(values)) names(values)[1L] else "designs"
    abort_argument("{.arg {name}} must have at least one value and none missing.")
  }
  wrong <- names(values)[!nzchar(names(values)) | vapply(values, is.list, NA)]
  if (length(wrong)) {
    abort_argument("{.arg {wrong[1]}} must be a column of numbers or texts, named by its path.")
  }
  values
}

# Values as a plan has them: texts or doubles, the same from R and from a file.
plain_column <- function(column) {
  if (is.list(column)) return(column)
  if (is.logical(column)) return(c("no", "yes")[column + 1L])
  if (is.numeric(column)) as.double(column) else as.character(column)
}

# The paths of a column: several are joined by " + ".
paths_of <- function(name) trimws(strsplit(name, "+", fixed = TRUE)[[1L]])

# The fields of one row of designs, by their paths; what is missing stays as in the plan.
design_fields <- function(designs, row) {
  values <- lapply(designs, `[[`, row)
  values <- values[!vapply(values, is.na, NA)]
  do.call(c, lapply(names(values), function(name) {
    paths <- paths_of(name)
    setNames(rep(values[name], length(paths)), paths)
  }))
}

# Places of an axis in a grid: rows of values, or shares of a distribution.
axis_levels <- function(axis, number) {
  one <- axis[[1L]]
  if (!is_distribution(one)) return(seq_len(nrow(axis)))
  shares <- if (one$kind == "between") {
    seq(0, 1, length.out = number)
  } else {
    (seq_len(number) - 0.5) / number
  }
  # whole numbers may come twice
  shares[!duplicated(quantile_numbers(one, shares))]
}

# The values of an axis at rows, or at shares of its distribution, as a data frame.
axis_values <- function(axis, place) {
  if (is_distribution(axis[[1L]])) {
    return(setNames(data.frame(quantile_values(axis[[1L]], place)), names(axis)))
  }
  axis[place, , drop = FALSE]
}

# ---- ways to choose ------------------------------------------------------------------------------

# A row per design: which level of every axis, the first changing fastest.
grid_of <- function(levels) {
  size <- prod(lengths(levels))
  if (size > 1e6) abort_argument("The grid has {size} designs; a million is the most.")
  as.matrix(do.call(expand.grid, lapply(levels, seq_along)))
}

# NA: as in the plan.
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

# Points in the unit cube, a row each.
design_points <- function(how, number, width, seed) {
  switch(how,
    random = with_seed(seed, matrix(stats::runif(number * width), number)),
    latin = {
      check_package("lhs", "A Latin hypercube")
      with_seed(seed, lhs::randomLHS(number, width))
    },
    sobol = sobol_points(number, width, seed)
  )
}

sobol_points <- function(number, width, seed) {
  check_package("spacefillr", "A Sobol' sequence")
  points <- spacefillr::generate_sobol_owen_set(number, width, seed = seed)
  pmin(pmax(points, 0), 1 - 2^-24)
}

# The samples A and B that lie side by side, and A with each column from B (Saltelli et al. 2010).
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

# The value of an expression whose random numbers come from `seed`, whatever generator the session
# uses; that goes on as if nothing had been drawn.
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

# ---- as text -------------------------------------------------------------------------------------

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
