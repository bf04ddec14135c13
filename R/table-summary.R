#' Summarise a state
#'
#' Lists the measures of a settled gear, its drag by component, the highest tensions, slack netting
#' and the balance of all forces.
#'
#' @param object A state, from [settle()].
#' @param uncertainty Result of [uncertainty()] to show with the measures. `NULL` (default) shows
#'   only the estimated discretisation error.
#' @param ... Not used.
#' @return A list of class `codend_summary`:
#'
#'   - `name` and `conditions` (strings);
#'   - `measures`: named numbers ([measures()]);
#'   - `findings`: warnings ([findings()]);
#'   - `drag`: data frame by part (see [as.data.frame.codend_state()]);
#'   - `drag_totals`: the same by `group` (netting, ropes, otter boards, catch, fittings, sea bed,
#'     loads, out of water, inertia, total). The total drag is the measure `total_drag_kN`;
#'   - `tangential`: sensitivity of total drag, see below;
#'   - `tensions`: data frame by rope and panel, see below;
#'   - `slack`: data frame by panel: `twine_m` (length of twine) and `slack_percent` (percentage
#'     without tension);
#'   - `boards`: data frame by free otter board ([as.data.frame()][as.data.frame.codend_state]);
#'   - `reactions`: data frame by support;
#'   - `balance`: data frame of the sums of `reactions`, `hydrodynamic` forces, `weight_in_water`
#'     and of all forces without a part ([as.data.frame.codend_state()]), and their `remainder`, kN;
#'   - `report`: the solver's report, with `nodes`, `bars` and `cells`;
#'   - `uncertainty`: the argument, if given.
#'
#' @section Tangential drag:
#' `tangential` is total drag (kN) with the tangential and skin coefficients of all twines and ropes
#' `halved`, as `settled` and `doubled`. These coefficients are the largest uncertainty of a trawl's
#' drag, because published values differ by factors. The drag is evaluated at the settled shape,
#' although other coefficients would change the shape.
#'
#' @section Tensions:
#' The values are for one line:
#'
#' - `max_kN`, `mean_kN`, and `most_loaded_kN`, the mean over the most loaded tenth of its length.
#'   At a point load on netting, `max_kN` grows with mesh refinement;
#' - `strength_kN`: breaking load; `strength_percent`: largest tension as a percentage of the
#'   breaking load. Both are `NA` if the breaking load is unknown.
#'
#' @seealso [settle()], [measures()], [findings()], [uncertainty()]; [report()] for a page to print.
#' @examples
#' summary(settle("towed_cable"))
#' @export
summary.codend_state <- function(object, uncertainty = NULL, ...) {
  check_is_uncertainty(uncertainty)
  model <- object$mesh$model
  drag <- drag_table(object)
  structure(
    c(list(
      name = object$si$name, conditions = conditions_text(object$si, object$gear$plan),
      measures = measures(object), findings = findings(object),
      drag = drag, drag_totals = drag_totals(drag),
      tangential = tangential_sensitivity(object),
      tensions = tension_table(object), slack = slack_table(object),
      boards = board_table(object), reactions = reaction_table(object),
      balance = balance_table(object),
      report = c(object$report, list(
        nodes = model$nodes, bars = length(model$bars$rest),
        cells = length(model$cells$rest)
      ))
    ), if (!is.null(uncertainty)) list(uncertainty = uncertainty)),
    class = "codend_summary"
  )
}

#' @rdname summary.codend_state
#' @param x A summary.
#' @param n Largest number of printed lines. `Inf` prints all measures and tables.
#' @export
print.codend_summary <- function(x, n = 30, ...) {
  cat(format(x, n = n), sep = "\n")
  invisible(x)
}

#' @export
format.codend_summary <- function(x, n = Inf, ...) with_plain_numbers(summary_lines(x, n))

# Omits sections that do not fit in `n` lines. The first ones are cut.
summary_lines <- function(x, n) {
  cut <- function(lines) if (is.finite(n)) limited_lines(lines, 9) else lines
  shown <- if (is.finite(n)) printed_measures(x$measures) else names(x$measures)
  omitted <- length(x$measures) - length(shown)
  of_kind <- function(kind) x$tensions[x$tensions$kind == kind, ]
  section <- function(title, lines) if (length(lines)) c("", bold(title), lines)
  sections <- list(
    section("Measures", c(
      measure_lines(x$measures[shown]), if (omitted) paste("  ... and", omitted, "more"),
      accuracy_line(x$measures, x$report)
    )),
    section("Uncertainty: interval of the true value, and sources in % of the variance",
      if (!is.null(x$uncertainty)) cut(format(x$uncertainty))),
    section("Warnings", cut(finding_lines(x$findings))),
    section("Drag by component", column_lines(drag_columns(x$drag_totals, x$drag_totals$group))),
    section("Total drag with tangential coefficients halved and doubled, at this shape",
      tangential_lines(x$tangential)),
    section("Largest drag",
      column_lines(drag_part_columns(x$drag, x$drag_totals, listed_parts))),
    section("Otter boards", column_lines(board_columns(x$boards))),
    section("Ropes", column_lines(rope_columns(of_kind("rope"), listed_parts)[-c(2L, 4L)])),
    section("Netting", column_lines(netting_columns(of_kind("netting"), x$slack, listed_parts))),
    section("Force balance", column_lines(balance_columns(x$balance))),
    section("Solution", report_lines(x$report))
  )
  sections <- Filter(length, sections)
  fits <- cumsum(lengths(sections)) <= n - 4
  c(
    bold(x$name), x$conditions, unlist(sections[fits]),
    if (!all(fits)) c("", sprintf("  ... and %d more sections: print(x, n = Inf)", sum(!fits)))
  )
}

check_is_uncertainty <- function(uncertainty) {
  if (!is.null(uncertainty) && !inherits(uncertainty, "codend_uncertainty")) {
    abort_argument("{.arg uncertainty} must be a result of {.fn uncertainty}.")
  }
}

# Largest number of rows in the tables of a print.
listed_parts <- 6L

measure_lines <- function(measures) {
  measures <- in_preferred_units(measures)
  said <- measure_labels(measures)
  values <- align_points(figures(plain_measures(measures), attr(measures, "error")))
  error <- ifelse(nzchar(said$error), paste("computed to", said$error), "")
  align_columns(list(said$words, values, said$unit, error), left = c(1L, 3L, 4L))
}

# Returns the lines of columns (see table-columns.R), NULL without rows.
column_lines <- function(columns) {
  if (!length(columns[[1L]])) return(NULL)
  align_columns(Map(c, trimws(names(columns)), columns), which(startsWith(names(columns), " ")))
}

report_lines <- function(report) {
  c(
    sprintf("  %d nodes, %d bars, %d netting cells", report$nodes, report$bars,
      report$cells),
    sprintf(
      "  %s in %d iterations: largest residual force %.1e of the largest tension; %.2f CPU seconds",
      if (report$converged) "Settled" else "Not settled", report$iterations, report$residual,
      report$cpu_seconds
    )
  )
}

tangential_lines <- function(sensitivity) {
  drag <- unlist(sensitivity)
  # The section is empty if no coefficient is tangential.
  if (max(drag) - min(drag) <= 1e-6 * max(abs(drag))) return(NULL)
  share <- formatC(100 * (drag / drag[["settled"]] - 1), format = "f", digits = 1, flag = "+")
  align_columns(list(
    c("halved", "doubled"),
    paste(printed_figures(drag[c("halved", "doubled")], "kN"), printed_unit("kN")),
    paste0(share[c(1, 3)], " %")
  ))
}
