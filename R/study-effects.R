#' Analyse the effects of fields in a study
#'
#' `effects()` computes how strongly each field of a study changes each measure. It returns main
#' effects, effects of pairs of fields, or Sobol' indices with confidence intervals.
#'
#' @details
#' # Main effects and pairs
#' - A main effect is the mean of a measure over the designs with one value of a field. A field with
#'   more than `groups` values is divided into `groups` groups of equal size. Its `spread` is the
#'   largest minus the smallest mean.
#' - A pair effect is the mean of a pair of groups minus the main effects of both fields. Its
#'   `spread` is the root mean square, weighted by the number of designs.
#' - In a grid, these are the effects of an analysis of variance. In other samples the fields are
#'   correlated by chance, and less so with more designs.
#'
#' # Sobol' indices
#' - An index is a fraction of the variance of a measure over the designs. `first` is the fraction
#'   that a field alone explains. `total` is the fraction that remains if all other fields are known
#'   (Sobol' 2001).
#' - The estimators are b and f in table 2 of Saltelli et al. (2010); f is Jansen's. The intervals
#'   are bootstrap intervals over base samples.
#' - A small index can be negative. If a design did not settle, its entire group of designs is left
#'   out.
#'
#' @param object Variations, from [vary()] or [read_result()]. Indices need designs from
#'   [designs()]`(how = "indices")`.
#' @param what `"fields"` (default): main effects. `"pairs"`: effects of pairs of fields.
#'   `"indices"`: Sobol' indices.
#' @param measures Names of measures, as in [measures()]. Default `NULL`: all that change.
#' @param groups Number of groups of a field with many values, for main effects and pairs. Default
#'   5.
#' @param confidence Probability of the intervals of indices. Default 0.9.
#' @param resamples Number of bootstrap samples for these intervals. Default 1000.
#' @param seed Seed of the bootstrap. The random numbers of the session stay unchanged.
#' @param ... Not used.
#' @return A data frame that [plot()][codend_charts] draws. Its columns depend on `what`:
#'
#'   - `"fields"`: `field`, `level` (mean of the group's values, or their text), `measure`, `value`
#'     (mean of the measure), `unit`, `designs` (count) and `spread`.
#'   - `"pairs"`: `field`, `other`, `measure`, `spread` and `unit`, the largest first. The attribute
#'     `means` has the means of all pairs of groups.
#'   - `"indices"`: `field`, `index` (`"first"` or `"total"`), `measure`, `value`, the ends `lower`
#'     and `upper` of its interval, and `designs` (number of base samples).
#'
#'   `print()` returns `x`, invisibly.
#'
#'   Designs that did not settle are left out with a warning of class `codend_warning_study`. Wrong
#'   arguments raise an error of class `codend_error_argument`.
#' @references I. M. Sobol' (2001), Mathematics and Computers in Simulation 55:271. A. Saltelli et
#'   al. (2010), Computer Physics Communications 181:259. M. J. W. Jansen (1999), Computer Physics
#'   Communications 117:35.
#' @seealso [vary()], [designs()], [codend_charts].
#' @examples
#' found <- vary("towed_cable", towing.speed = paste(3:5, "knot"),
#'   ropes.cable.length = c("400 m", "700 m"))
#' effects(found, "total_drag_kN")
#' effects(found, "total_drag_kN", what = "pairs")
#' @importFrom stats effects
#' @export
effects.codend_variations <- function(object, measures = NULL,
                                      what = c("fields", "pairs", "indices"), groups = 5,
                                      confidence = 0.9, resamples = 1000, seed = 1, ...) {
  switch(chosen(what, c("fields", "pairs", "indices")),
    fields = main_effects(object, measures, groups),
    pairs = pair_effects(object, measures, groups),
    indices = sobol_indices(object, measures, confidence, resamples, seed)
  )
}

main_effects <- function(x, measures, groups) {
  study <- effects_study(x, measures, groups)
  rows <- lapply(study$measures, function(name) {
    do.call(rbind, lapply(study$fields, function(field) {
      group <- study$group[[field]]
      mean <- as.vector(tapply(study$x[[name]], group, mean))
      data.frame(
        field = field, level = group_values(study, field), measure = name, value = mean,
        unit = variations_unit(x, name), designs = as.vector(table(group)),
        spread = diff(range(mean)), row.names = NULL
      )
    }))
  })
  # If one field is text, `rbind()` converts the whole column to text.
  structure(do.call(rbind, rows), class = c("codend_effects", "data.frame"),
    gear_name = attr(x, "gear_name"), unit = attr(x, "unit"), main = attr(x, "main"))
}

pair_effects <- function(x, measures, groups) {
  study <- effects_study(x, measures, groups)
  if (length(study$fields) < 2L) {
    abort_argument("{.arg object} must have at least two fields with different values.")
  }
  pairs <- utils::combn(study$fields, 2L, simplify = FALSE)
  rows <- lapply(study$measures, function(name) {
    value <- study$x[[name]]
    own <- lapply(study$group, function(group) {
      as.vector(tapply(value, group, mean))[group] - mean(value)
    })
    found <- do.call(rbind, lapply(pairs, function(pair) {
      both <- interaction(study$group[[pair[1L]]], study$group[[pair[2L]]], drop = TRUE)
      beyond <- as.vector(tapply(value, both, mean))[both] - mean(value) - own[[pair[1L]]] -
        own[[pair[2L]]]
      data.frame(
        field = pair[1L], other = pair[2L], measure = name, spread = sqrt(mean(beyond^2)),
        unit = variations_unit(x, name)
      )
    }))
    found[order(-found$spread), ]
  })
  found <- table_rows(do.call(rbind, rows))
  means <- do.call(rbind, lapply(study$measures, function(name) {
    do.call(rbind, lapply(pairs, pair_means, study = study, name = name))
  }))
  structure(found, class = c("codend_pair_effects", "data.frame"), means = means,
    gear_name = attr(x, "gear_name"), unit = attr(x, "unit"), main = attr(x, "main"))
}

# Returns means by pairs of groups: measure, field, other, value, other_value (text), mean.
pair_means <- function(study, name, pair) {
  one <- study$group[[pair[1L]]]
  two <- study$group[[pair[2L]]]
  mean <- tapply(study$x[[name]], list(one, two), mean)
  place <- which(!is.na(mean), arr.ind = TRUE)
  data.frame(
    measure = name, field = pair[1L], other = pair[2L],
    value = as.character(group_values(study, pair[1L]))[place[, 1L]],
    other_value = as.character(group_values(study, pair[2L]))[place[, 2L]],
    mean = mean[place], row.names = NULL
  )
}

# Returns the label of each group: the mean of its values, or its text.
group_values <- function(study, field) {
  values <- split(study$x[[field]], study$group[[field]])
  unname(if (is.numeric(study$x[[field]])) vapply(values, mean, 0) else {
    vapply(values, `[[`, "", 1L)
  })
}

sobol_indices <- function(x, measures, confidence, resamples, seed) {
  study <- attr(x, "study")
  if (!identical(study$how, "indices")) {
    abort_argument("{.arg object} must be a study of {.code designs(how = \"indices\")}.")
  }
  check_fraction(confidence, "confidence", below = 1)
  check_count("resamples", resamples, 10)
  measures <- changing_measures(x, measures)
  report_unsettled(x)
  base <- study$number
  fields <- study$factors
  rows <- lapply(measures, function(name) {
    value <- rep(NA_real_, study$designs)
    value[study$design] <- x[[name]]
    value <- matrix(value, base)
    value <- value[stats::complete.cases(value), , drop = FALSE]
    if (nrow(value) < 4L) {
      abort_argument("Fewer than 4 complete groups of designs have the measure {.val {name}}; add
        designs.")
    }
    found <- index_estimates(value)
    drawn <- with_seed(seed, vapply(seq_len(resamples), function(k) {
      index_estimates(value[sample.int(nrow(value), replace = TRUE), , drop = FALSE])
    }, found))
    ends <- apply(drawn, 1:2, stats::quantile, c(1 - confidence, 1 + confidence) / 2, na.rm = TRUE)
    data.frame(
      field = fields, index = rep(c("first", "total"), each = length(fields)), measure = name,
      value = as.vector(found), lower = as.vector(ends[1L, , ]), upper = as.vector(ends[2L, , ]),
      designs = nrow(value), row.names = NULL
    )
  })
  structure(do.call(rbind, rows), class = c("codend_sobol_indices", "data.frame"),
    gear_name = attr(x, "gear_name"), confidence = confidence, main = attr(x, "main"),
    measure_unit = vapply(setNames(nm = measures), variations_unit, "", x = x))
}

# Returns first-order and total indices (columns) by field. value: a row per base sample; columns A,
# B and A with each field from B.
index_estimates <- function(value) {
  first <- value[, 1L]
  second <- value[, 2L]
  mixed <- value[, -(1:2), drop = FALSE]
  variance <- stats::var(c(first, second))
  # Subtracting the mean keeps the expected value and reduces rounding errors.
  second <- second - mean(c(value[, 1L], value[, 2L]))
  cbind(
    colMeans(second * (mixed - first)) / variance,
    colMeans((mixed - first)^2) / 2 / variance
  )
}

# ---- shared --------------------------------------------------------------------------------------

# Returns list(x (settled rows), fields (changing ones), measures, group (by field and row)).
effects_study <- function(x, measures, groups) {
  check_count("groups", groups, 2)
  measures <- changing_measures(x, measures)
  report_unsettled(x)
  table <- as.data.frame(x, wide = TRUE)
  rows <- table[table$settled & stats::complete.cases(table[measures]), ]
  fields <- Filter(function(field) length(unique(rows[[field]])) > 1L, variations_fields(x))
  if (!length(fields)) {
    abort_argument("No field of {.arg object} changes among the settled designs.")
  }
  group <- lapply(setNames(fields, fields), function(field) {
    value <- rows[[field]]
    if (!is.numeric(value)) return(match(value, unique(value)))
    values <- sort(unique(value))
    if (length(values) <= groups) return(match(value, values))
    as.integer(ceiling(rank(value, ties.method = "first") / length(value) * groups))
  })
  list(x = rows, fields = fields, measures = measures, group = group)
}

changing_measures <- function(x, measures) {
  known <- variations_measures(x)
  if (!is.null(measures)) return(chosen_measures(measures, known))
  Filter(function(name) {
    value <- x[[name]][!is.na(x[[name]])]
    length(value) > 1L && diff(range(value)) > 1e-9 * max(abs(value))
  }, known)
}

report_unsettled <- function(x) {
  failed <- sum(!x$settled)
  if (failed) {
    warn_as("study", "{failed} of {nrow(x)} design{?s} did not settle and {?is/are} omitted.")
  }
}

#' @export
summary.codend_variations <- function(object, ...) {
  known <- if (nrow(object)) changing_measures(object, NULL) else character()
  study <- attr(object, "study")
  error <- errors_by_design(object)
  table <- do.call(rbind, lapply(known, function(name) {
    value <- object[[name]]
    data.frame(
      measure = name, unit = variations_unit(object, name), least = min(value, na.rm = TRUE),
      median = stats::median(value, na.rm = TRUE), largest = max(value, na.rm = TRUE),
      error = stats::median(as.double(error[[name]]), na.rm = TRUE), row.names = NULL
    )
  }))
  structure(
    list(
      name = attr(object, "gear_name"), designs = first_of(study$designs, nrow(object)),
      done = nrow(object), settled = sum(object$settled), warned = sum(!is.na(object$warning)),
      measures = table, main = attr(object, "main"),
      problems = counted_problems(object$problem)
    ),
    class = "codend_study_summary"
  )
}

#' @export
print.codend_study_summary <- function(x, n = most_rows, ...) {
  check_rows(n)
  cat(x$designs, " designs of \"", x$name, "\": ", x$done, " done, ", x$settled, " settled, ",
    x$warned, " with a warning\n", sep = "")
  cat_study_measures(x, n)
  cat_counted_problems(x$problems)
  invisible(x)
}

cat_study_measures <- function(x, n) {
  if (is.null(x$measures)) return(invisible())
  shown <- x$measures$measure
  if (is.finite(n)) shown <- some_measures(structure(list(), main = x$main), shown)
  table <- printed_rows(x$measures[match(shown, x$measures$measure), ])
  columns <- c("least", "median", "largest", "error")
  cat_columns(c(list(c("", label_of(table$measure, table$unit))),
    Map(c, columns, lapply(table[columns], figures)), list(c("", table$unit))), left = c(1L, 6L))
  cat_more(c(measure = nrow(x$measures) - nrow(table)))
}
