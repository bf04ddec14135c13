#' Find causes of the misfit of a calibration
#'
#' `explain_misfit()` ranks possible causes of the remaining differences between a calibrated gear
#' and its hauls: inputs of the plan and conditions. It also ranks further measurements by how much
#' they would improve the calibration.
#'
#' @details
#' Each input is ranked by a score test at the calibrated gear. The score is the fall of the sum of
#' squared standardised residuals if the input were fitted too.
#'
#' - The test is linear and uses the sensitivities of the matched measures.
#' - Each input is assumed to lie within `spread` of its value. An input that would need a larger
#'   change explains little.
#' - An input with the same effect as the calibrated fields cannot be distinguished from them: its
#'   `own` is near 0.
#'
#' @param calibration A calibration, from [calibrate()].
#' @param fields Inputs to test, like `fields` of [sensitivities()]. `NULL` (default) selects up to
#'   24 lengths, masses, areas, buoyancies, diameters and coefficients of the plan.
#' @param spread Assumed standard deviation of the inputs, as a fraction of their values. Default
#'   0.2.
#' @param sensor Assumed error of an additional sensor, as a fraction of its measured value. Default
#'   0.02.
#' @param cases Largest number of settings in the data to analyse, evenly spaced. Default 8. Each
#'   setting needs the sensitivities to all inputs.
#' @return An object of class `codend_explanation`, a list of data frames, the most important row
#'   first:
#'
#'   - `inputs`: one row per input. `field`, `value` and `unit` identify it. `step` (in `unit`) and
#'     `percent` are the change that the residuals indicate. `fall` is the fraction by which the
#'     squared residuals fall, and `p` the probability of such a fall by chance. `own` is the
#'     fraction of the effect that the calibrated fields cannot reproduce.
#'   - `trends`: one row per match and condition. Columns: `match`, `condition` (a numeric column of
#'     the data), `correlation` of the residuals with it, and `p`.
#'   - `measurements`: one row per measure. `gain` is the factor by which the standard errors of the
#'     fields (geometric mean) would shrink with this measure in all hauls, with the error `sensor`.
#'     `matched` is `TRUE` if it is already matched. The table is empty if no field is free.
#'
#'   Wrong arguments raise an error of class `codend_error_argument`.
#' @seealso [calibrate()], [sensitivities()], [uncertainty()].
#' @export
#' @examples
#' runs <- data.frame(towing.speed = 2:6 / 2, Drag = c(1.9, 3.2, 5, 7.4, 10.2))
#' fit <- calibrate("towed_cable", runs,
#'   change = list(ropes.cable.diameter = c("10 mm", "30 mm")), match = Drag ~ total_drag_kN)
#' explain_misfit(fit, fields = c("pieces.sphere.mass", "pieces.sphere.drag_coefficient"))
explain_misfit <- function(calibration, fields = NULL, spread = 0.2, sensor = 0.02, cases = 8) {
  check_given("calibration")
  check_is_calibration(calibration)
  check_count("cases", cases)
  check_fraction(spread, "spread")
  check_fraction(sensor, "sensor")
  found <- explained_cases(calibration, explained_inputs(calibration, fields), cases)
  structure(
    list(
      inputs = explain_inputs(calibration, found, spread), trends = explain_trends(calibration),
      measurements = explain_measurements(calibration, found, sensor)
    ),
    class = "codend_explanation", gear_name = calibration$gear$plan$name
  )
}

# Default inputs: the last parts of their paths, and their largest number.
input_fields <- c("length", "mass", "area", "buoyancy", "diameter", "lift_coefficient",
  "drag_coefficient", "drag_area", "friction", "density", "normal", "tangential")
most_inputs <- 24L

explained_inputs <- function(fit, fields) {
  taken <- c(unlist(lapply(fit$task$points$fields, `[[`, "paths")), fit$conditions)
  if (!is.null(fields)) {
    found <- sensitivity_fields(fit$gear, fields)
    both <- intersect(unlist(lapply(found, `[[`, "paths")), taken)
    if (length(both)) {
      abort_argument("{.arg fields} has {.field {both[1]}}, but the calibration already uses this
        field.")
    }
    return(lapply(found, `[[`, "paths"))
  }
  found <- sensitivity_fields(fit$gear, "all")
  keep <- vapply(found, function(field) {
    !field$whole && !any(field$paths %in% taken) &&
      sub(".*[.]", "", field$paths[1L]) %in% input_fields
  }, NA)
  utils::head(lapply(found[keep], `[[`, "paths"), most_inputs)
}

# Returns a list per analysed case: rows (of the data), case, point, fields (measures x scaled
# fields), inputs (measures x relative inputs), value, unit.
explained_cases <- function(fit, inputs, most) {
  task <- fit$task
  at <- cases_at(task, fit$scaled, slopes = FALSE)
  usable <- which(!vapply(at$points, is.null, NA))
  chosen <- usable[evenly(length(usable), most)]
  lapply(chosen, function(k) {
    point <- at$points[[k]]
    all <- names(point$measures)
    case <- list(rows = which(task$case_of == k), case = k, point = point,
      fields = clear(point_derivatives(task$cases[[k]], point, all)))
    if (!length(inputs)) return(case)
    slopes <- sensitivities(point$state, NULL, inputs, secants = FALSE)
    first <- !duplicated(slopes$field)
    by <- matrix(slopes$derivative * slopes$value, length(all),
      dimnames = list(all, slopes$field[first]))
    c(case, list(inputs = clear(by), value = slopes$value[first], unit = slopes$unit[first]))
  })
}

clear <- function(slopes) replace(slopes, !is.finite(slopes), 0)

# Returns the derivatives of a matched formula in one case. slopes: derivatives of measures (rows).
matched_derivatives <- function(task, case, one, slopes) {
  at <- formula_point(task$cases[[case$case]], case$point, task$words)
  rows <- match(task$words$column, rownames(slopes))
  at$slopes <- slopes[rows, , drop = FALSE] * task$words$factor
  rownames(at$slopes) <- task$words$name
  evaluate_formula(one$formula, at)$slope
}

explain_inputs <- function(fit, cases, spread) {
  none <- data.frame(field = character(), value = numeric(), unit = character(), step = numeric(),
    percent = numeric(), fall = numeric(), p = numeric(), own = numeric())
  if (!length(cases) || is.null(cases[[1L]]$inputs)) return(none)
  task <- fit$task
  rows <- lapply(seq_along(task$match), function(k) {
    one <- task$match[[k]]
    error <- fit$match$error[k]
    known <- fit$matched[fit$matched$match == one$text, ]
    do.call(rbind, lapply(cases, function(case) {
      here <- known[known$row %in% case$rows, ]
      if (!nrow(here)) return(NULL)
      by <- c(matched_derivatives(task, case, one, case$fields),
        matched_derivatives(task, case, one, case$inputs))
      cbind(here$standardised, matrix(by / error, nrow(here), length(by), byrow = TRUE))
    }))
  })
  table <- do.call(rbind, rows)
  n <- length(task$points$fields)
  free <- which(fit$fields$at == "")
  residual <- table[, 1L]
  known <- table[, 1L + free, drop = FALSE]
  effects <- table[, -seq_len(1L + n), drop = FALSE]
  # Remove the part that the calibrated fields can explain.
  rest <- effects
  if (length(free)) {
    residual <- qr.resid(qr(known), residual)
    rest <- qr.resid(qr(known), effects)
  }
  told <- colSums(rest^2)
  # The prior penalises an input that would have to change by much more than `spread`.
  size <- told + 1 / spread^2
  whole <- colSums(effects^2)
  own <- ifelse(whole > 0, told / whole, 0)
  share <- drop(crossprod(rest, residual)) / size
  fall <- pmin(1, share^2 * size / sum(residual^2))
  freedom <- max(1, length(residual) - length(free) - 1)
  found <- data.frame(
    field = colnames(cases[[1L]]$inputs), value = cases[[1L]]$value, unit = cases[[1L]]$unit,
    step = share * cases[[1L]]$value, percent = 100 * share, fall = fall,
    p = stats::pf(fall / pmax(1 - fall, 1e-300) * freedom, 1, freedom, lower.tail = FALSE),
    own = own
  )
  table_rows(found, order(-found$fall))
}

explain_trends <- function(fit) {
  data <- fit$task$data
  numbers <- lapply(names(data), function(name) {
    column <- data[[name]]
    if (is.factor(column)) column <- as.character(column)
    if (is.character(column) && name %in% fit$conditions) {
      column <- field_column(column, name, fit$gear)$value
    }
    if (is.numeric(column)) as.double(column)
  })
  names(numbers) <- names(data)
  used <- unique(unlist(lapply(fit$task$match, function(one) all.vars(str2lang(one$text)))))
  numbers <- Filter(Negate(is.null), numbers[setdiff(names(numbers), used)])
  found <- do.call(rbind, lapply(fit$match$text, function(text) {
    rows <- fit$matched[fit$matched$match == text, ]
    do.call(rbind, lapply(names(numbers), function(name) {
      x <- numbers[[name]][rows$row]
      good <- is.finite(x)
      if (sum(good) < 4L || stats::sd(x[good]) == 0 || stats::sd(rows$residual[good]) == 0) {
        return(NULL)
      }
      test <- stats::cor.test(x[good], rows$residual[good])
      data.frame(match = text, condition = name, correlation = unname(test$estimate),
        p = test$p.value)
    }))
  }))
  if (is.null(found)) {
    return(data.frame(match = character(), condition = character(), correlation = numeric(),
      p = numeric()))
  }
  table_rows(found, order(found$p))
}

explain_measurements <- function(fit, cases, sensor) {
  free <- which(fit$fields$at == "" & is.finite(fit$fields$error))
  none <- data.frame(measure = character(), gain = numeric(), matched = logical())
  if (!length(free) || !length(cases)) return(none)
  width <- fit$task$points$width[free]
  known <- solve(fit$covariance[free, free, drop = FALSE] / outer(width, width))
  measures <- rownames(cases[[1L]]$fields)
  hauls <- nrow(fit$task$data) / length(unlist(lapply(cases, `[[`, "rows")))
  gain <- vapply(measures, function(name) {
    more <- Reduce(`+`, lapply(cases, function(case) {
      size <- sensor * abs(case$point$measures[[name]])
      if (size == 0) return(0 * known)
      length(case$rows) * tcrossprod(case$fields[name, free]) / size^2
    }))
    # A larger log-determinant means a smaller confidence region.
    volume <- function(information) as.double(determinant(information)$modulus)
    exp((volume(known + hauls * more) - volume(known)) / (2 * length(free)))
  }, 0)
  words <- fit$task$words
  found <- data.frame(measure = measures, gain = gain,
    matched = measures %in% formula_measures(words, lapply(fit$task$match, `[[`, "formula")))
  table_rows(found, order(-found$gain))
}

#' @export
print.codend_explanation <- function(x, ...) {
  cat("Likely causes of the misfit of \"", attr(x, "gear_name"), "\"\n", sep = "")
  telling <- utils::head(x$inputs[x$inputs$fall > 0, ], 6L)
  if (nrow(telling)) {
    cat("\nInputs\n")
    cat_columns(list(
      paste0("  ", telling$field), with_plain_numbers(sprintf("%+.0f %%", telling$percent)),
      with_plain_numbers(sprintf("explains %.0f %% of the squares", 100 * telling$fall)),
      paste("p", sensitivity_digits(signif(telling$p, 2))),
      ifelse(telling$own < 0.05, "hardly distinct from the calibrated fields", "")
    ), left = c(1L, 5L))
  }
  trends <- x$trends[x$trends$p < 0.05, ]
  if (nrow(trends)) {
    cat("\nResiduals correlate with\n")
    cat(paste0("  ", trends$match, " with ", trends$condition, ", correlation ",
      with_plain_numbers(sprintf("%+.2f", trends$correlation)), "\n"), sep = "")
  }
  best <- utils::head(x$measurements[!x$measurements$matched & x$measurements$gain > 1.01, ], 5L)
  if (nrow(best)) {
    cat("\nNext measurement: factor by which errors of the fields decrease\n")
    cat(paste0("  ", best$measure, "  ", sensitivity_digits(signif(best$gain, 3)), "\n"), sep = "")
  }
  invisible(x)
}
