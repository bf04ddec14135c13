#' Compute the trade-off between two objectives
#'
#' `trade_off()` computes the Pareto front of two objectives, such as drag and headline height. No
#' other gear is better in both objectives than a gear on the front.
#'
#' @details
#' - Each end of the front is the best gear for a single objective. Among gears within 0.1 % of the
#'   best, it is the best for the other objective.
#' - Between the ends, the first objective is minimised while the second is limited to evenly spaced
#'   values. This is the epsilon constraint method (Haimes, Lasdon and Wismer 1971, IEEE
#'   Transactions on Systems, Man and Cybernetics 1:296). Each search starts from the previous gear.
#'
#' @inheritParams optimise_gear
#' @param minimise A named list of two objectives, each like `minimise` of [optimise_gear()]:
#'   `list(drag = ~ total_drag_kN, height = ~ -headline_height_m)`.
#' @param points Number of gears on the front, including both ends, at least 3. Default 7.
#' @param max_solves Largest number of settled gears for each point. Default 100.
#' @return A data frame of class `codend_trade_off`: one row per gear, from the best for the first
#'   objective to the best for the second. Columns: both objectives under their names, each changed
#'   field with its unit, `kept` (`TRUE` if the conditions hold) and `optimal`. The attribute
#'   `optima` is a list with the result of [optimise_gear()] for each row. Wrong arguments raise an
#'   error of class `codend_error_argument`.
#' @seealso [optimise_gear()], [codend_charts].
#' @export
#' @examplesIf requireNamespace("nloptr", quietly = TRUE)
#' found <- trade_off("towed_cable",
#'   minimise = list(drag = ~ total_drag_kN, depth = ~ -body_depth_m),
#'   change = list(ropes.cable.length = c("600 m", "1200 m")), points = 4
#' )
#' found
trade_off <- function(gear, minimise, keep = NULL, change, points = 7, nodes = NULL,
                      netting = NULL, accuracy = NULL, max_solves = 100, file = NULL) {
  check_given("gear", "minimise", "change")
  two <- is.list(minimise) && length(minimise) == 2L && is_named(minimise)
  if (!two || anyDuplicated(names(minimise))) {
    abort_argument("{.arg minimise} must be two objectives by their names, such as
      {.code list(drag = ~ total_drag, height = ~ -headline_height)}.")
  }
  check_count("points", points)
  if (points < 3) abort_argument("{.arg points} is {.val {points}}; it must be 3 or more.")
  check_count("max_solves", max_solves)
  tasks <- lapply(minimise, function(objective) {
    new_task(gear, objective, keep, change, nodes, netting, accuracy, file)
  })
  tasks[[2L]]$points$shared$record <- tasks[[1L]]$points$shared$record
  ends <- lapply(1:2, function(k) {
    run <- find_optimum(tasks[[k]], tasks[[k]]$first, max_solves)
    alone <- finish_optimum(tasks[[k]], list(run))
    # Among gears that are equally good in this objective, select the best in the other. A loss of a
    # thousandth of the initial value is permitted.
    limit <- objective_of(tasks[[k]], alone) + 1e-3 * tasks[[k]]$size
    optimum_within(tasks[[3L - k]], tasks[[k]]$objective, limit, alone, max_solves)
  })
  second <- vapply(ends, function(end) objective_of(tasks[[2L]], end), 0)
  limits <- seq(second[1L], second[2L], length.out = points)[-c(1L, points)]
  near <- ends[[1L]]
  between <- lapply(limits, function(limit) {
    near <<- optimum_within(tasks[[1L]], tasks[[2L]]$objective, limit, near, max_solves)
    near
  })
  optima <- c(ends[1L], between, ends[2L])
  fields <- do.call(rbind, lapply(optima, function(one) one$fields$value))
  colnames(fields) <- with_unit(near$fields$field,
    vapply(near$fields$unit, plain_unit, "", USE.NAMES = FALSE))
  aims <- lapply(tasks, function(task) {
    vapply(optima, function(one) objective_of(task, one), 0, USE.NAMES = FALSE)
  })
  table <- data.frame(
    aims, fields, kept = vapply(optima, function(one) all(one$keep$holds), NA),
    optimal = vapply(optima, `[[`, NA, "optimal"), row.names = NULL, check.names = FALSE
  )
  structure(table, class = c("codend_trade_off", "data.frame"), optima = unname(optima),
    objectives = vapply(tasks, function(task) task$objective$text, ""),
      gear_name = near$gear$plan$name)
}

# Optimises a task with another objective limited to `limit`, from the optimum `near`.
optimum_within <- function(task, objective, limit, near, most) {
  # The last digits of a settled gear depend on its start, but a resumed search repeats all limits.
  limit <- signif(limit, 6L)
  constant <- list(text = format(limit), call = limit, names = character(), slopes = list())
  condition <- list(text = paste(objective$text, "<=", four_figures(limit)), left = objective,
    right = constant, way = 1, equal = FALSE)
  task$keep <- c(task$keep, list(condition))
  task$limits <- c(task$limits, max(abs(limit), .Machine$double.xmin))
  task$of <- union(task$of, formula_measures(task$words, list(objective)))
  task$history <- new_search_history()
  base <- list(values = near$fields$value, gear = near$gear, state = near$state)
  place <- points_scaled(task$points, near$fields$value)
  finish_optimum(task, list(find_optimum(task, place, most, from = base)))
}

objective_of <- function(task, optimum) {
  point <- list(values = optimum$fields$value, measures = measures(optimum$state))
  evaluate_formula(task$objective, formula_point(task$points, point, task$words))$value
}

#' @rdname trade_off
#' @param x A trade-off.
#' @param n Number of gears to print. Default 20. `Inf` prints all gears and fields.
#' @param ... Not used.
#' @export
print.codend_trade_off <- function(x, n = most_rows, ...) {
  check_rows(n)
  objectives <- attr(x, "objectives")
  cat_wrapped("Trade-off of \"", attr(x, "gear_name"), "\" between ",
    paste(objectives, collapse = " and "), indent = 0L)
  table <- as.data.frame(utils::head(x, n), wide = TRUE)
  note <- paste0(ifelse(table$kept, "", "conditions not met "),
    ifelse(table$optimal, "", "not shown to be optimal"))
  fields <- setdiff(names(table), c(names(objectives), "kept", "optimal"))
  units <- vapply(attr(x, "optima")[[1L]]$fields$unit, plain_unit, "", USE.NAMES = FALSE)
  printed <- printed_unit(units)
  table[fields] <- Map(`*`, table[fields], unit_ratio(units, printed))
  done <- cat_headed(c(
    lapply(names(objectives), function(name) headed(name, "", certain_figures(table[[name]]))),
    if (any(nzchar(note))) list(headed("", NULL, note)),
    Map(function(name, unit, shown) {
      headed(label_of(name, unit), shown, certain_figures(table[[name]]))
    }, fields, units, printed)
  ), 2L + any(nzchar(note)), is.infinite(n))
  cat_more(c(gear = nrow(x) - nrow(table), field = length(fields) - done))
  invisible(x)
}
