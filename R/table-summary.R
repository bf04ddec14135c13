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
  section <- function(title, lines) if (length(lines)) c("", bold(title), lines)
  sections <- list(
    section("Measures", c(
      measure_lines(x$measures[shown]), if (omitted) paste("  ... and", omitted, "more"),
      accuracy_line(x$measures, x$report)
    )),
    section("Uncertainty: interval of the true value, and sources in % of the variance",
      if (!is.null(x$uncertainty)) cut(format(x$uncertainty))),
    section("Warnings", cut(finding_lines(x$findings))),
    section("Drag by component", drag_lines(x$drag_totals)),
    section("Total drag with tangential coefficients halved and doubled, at this shape",
      tangential_lines(x$tangential)),
    section("Largest drag", largest_drag_lines(x$drag)),
    section("Otter boards", board_lines(x$boards)),
    section("Highest rope tensions", rope_tension_lines(x$tensions)),
    section("Highest twine tensions", twine_tension_lines(x$tensions)),
    section("Slack netting", slack_lines(x$slack)),
    section("Force balance", balance_lines(x$balance)),
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

listed_parts <- 6L

measure_lines <- function(measures) {
  measures <- in_preferred_units(measures)
  said <- measure_labels(measures)
  values <- align_points(figures(plain_measures(measures), attr(measures, "error")))
  align_columns(list(said$words, values, said$unit, computed_to(said$error)),
    left = c(1L, 3L, 4L))
}

forces_text <- function(kilonewtons) paste(printed_figures(kilonewtons, "kN"), printed_unit("kN"))

# Returns the column of a table of forces, with its heading.
force_column <- function(name, kilonewtons) {
  c(paste(name, printed_unit("kN")), printed_figures(kilonewtons, "kN"))
}

drag_lines <- function(totals) {
  align_columns(list(
    c("", totals$group),
    force_column("drag", totals$drag_kN),
    c("share %", share_text(totals$drag_kN, totals$drag_kN[nrow(totals)])),
    force_column("side", totals$side_kN),
    force_column("lift", totals$lift_kN),
    force_column("weight in water", totals$weight_in_water_kN)
  ))
}

# Groups a table by role, with names such as "warp, 2 ropes" or "cable".
by_role <- function(table) {
  name <- ifelse(is.na(table$role), table$part, gsub("_", " ", table$role))
  groups <- split(table, paste(table$kind, name))
  words <- c(rope = "ropes", netting = "panels", piece = "pieces")
  setNames(groups, vapply(groups, function(group) {
    n <- nrow(group)
    if (is.na(group$role[1])) return(group$part[1])
    paste0(gsub("_", " ", group$role[1]), if (n > 1) paste0(", ", n, " ", words[[group$kind[1]]]))
  }, ""))
}

largest_groups <- function(table, value) {
  groups <- by_role(table)
  values <- vapply(groups, value, 0)
  first <- utils::head(order(-values), listed_parts)
  first <- first[values[first] > 0]
  list(groups = groups[first], values = values[first])
}

largest_drag_lines <- function(drag) {
  most <- largest_groups(drag, function(group) sum(group$drag_kN))
  if (length(most$groups) < 2L) return(NULL)
  align_columns(list(names(most$groups), forces_text(most$values)))
}

rope_tension_lines <- function(tensions) {
  most <- largest_groups(tensions[tensions$kind == "rope", ], function(group) max(group$max_kN))
  if (!length(most$groups)) return(NULL)
  highest <- do.call(rbind, lapply(most$groups, function(g) g[which.max(g$max_kN), ]))
  percent <- formatC(highest$strength_percent, format = "f", digits = 1)
  share <- paste(percent, "% of breaking load")
  share[is.na(highest$strength_percent)] <- ""
  align_columns(list(
    names(most$groups), forces_text(most$values), share
  ))
}

twine_tension_lines <- function(tensions) {
  highest <- function(group) from_unit(max(group$most_loaded_kN), "kN")
  most <- largest_groups(tensions[tensions$kind == "netting", ], highest)
  if (!length(most$groups)) return(NULL)
  mean <- vapply(most$groups, function(group) from_unit(max(group$mean_kN), "kN"), 0)
  align_columns(list(
    c("", names(most$groups)), c("mean N", column_figures(mean)),
    c("most loaded tenth N", column_figures(most$values))
  ))
}

slack_lines <- function(slack) {
  if (!nrow(slack)) return(NULL)
  share <- function(panels) stats::weighted.mean(panels$slack_percent, panels$twine_m)
  percent <- function(x) paste(formatC(x, format = "f", digits = 1), "%")
  if (share(slack) == 0) return("  All twine carries tension.")
  most <- largest_groups(cbind(slack, kind = "netting"), share)
  c(
    paste(
      " ", percent(share(slack)),
      "of all twine carries no tension; slack netting may move."
    ),
    align_columns(list(names(most$groups), percent(most$values)))
  )
}

balance_lines <- function(balance) {
  remainder <- balance$force == "remainder"
  shown <- function(column) {
    forces <- in_unit(from_unit(balance[[column]], "kN"), printed_unit("kN"))
    c(column_figures(forces[!remainder]), formatC(forces[remainder], format = "e", digits = 1))
  }
  align_columns(list(
    c(printed_unit("kN"), gsub("_", " ", balance$force)),
    c("x (aft)", shown("x_kN")), c("y (starboard)", shown("y_kN")), c("z (up)", shown("z_kN"))
  ))
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

board_lines <- function(boards) {
  if (!nrow(boards)) return(NULL)
  align_columns(list(
    c("", boards$board), c("attack deg", column_figures(boards$attack_deg)),
    c("heel deg", column_figures(boards$heel_deg)), c("trim deg", column_figures(boards$trim_deg)),
    force_column("lift", boards$lift_kN), force_column("drag", boards$drag_kN),
    c("", boards$condition)
  ), left = c(1L, 7L))
}

tangential_lines <- function(sensitivity) {
  drag <- unlist(sensitivity)
  # The section is empty if no coefficient is tangential.
  if (max(drag) - min(drag) <= 1e-6 * max(abs(drag))) return(NULL)
  share <- formatC(100 * (drag / drag[["settled"]] - 1), format = "f", digits = 1, flag = "+")
  align_columns(list(
    c("halved", "doubled"), forces_text(drag[c("halved", "doubled")]),
    paste0(share[c(1, 3)], " %")
  ))
}
