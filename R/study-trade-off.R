#' The trade-off of two objectives
#'
#' What one objective costs in another: the curve of gears of which none is better in both, such as
#' drag against headline height. Each end is the best for one objective alone, and of gears as good
#' in that to 0.1 % the best for the other. Between them the first objective is made as small as it
#' gets while the second is held at values evenly between its ends (the epsilon constraint method,
#' Haimes, Lasdon and Wismer 1971, IEEE Transactions on Systems, Man and Cybernetics 1:296), each
#' found from the one before.
#'
#' @inheritParams optimise_gear
#' @param minimise A list of the two objectives, each as `minimise` of [optimise_gear()], by the
#'   names that they are to have: `list(drag = ~ total_drag_kN, height = ~ -headline_height_m)`.
#' @param points How many gears, 3 or more, the ends among them.
#' @param most Settled gears at most, for each point.
#' @return A data frame of class `codend_trade_off` with a row per gear, from the best for the first
#'   objective to the best for the second: the two objectives under their names, a column per field
#'   that changes, whether conditions are `kept` and whether it is `optimal`, as [optimise_gear()]
#'   reports. The attribute `optima` has what [optimise_gear()] returns for each. Wrong arguments
#'   are an error of class `codend_error_argument`.
#' @seealso [codend_charts]
#' @export
#' @examplesIf requireNamespace("nloptr", quietly = TRUE)
#' found <- trade_off("towed_cable",
#'   minimise = list(drag = ~ total_drag_kN, depth = ~ -body_depth_m),
#'   change = list(ropes.cable.length = c("600 m", "1200 m")), points = 4
#' )
#' found
trade_off <- function(gear, minimise, keep = NULL, change, points = 7, nodes = 1500, netting = NULL,
                      most = 100) {
  check_given("gear", "minimise", "change")
  named <- is.list(minimise) && length(minimise) == 2L && !is.null(names(minimise)) &&
    all(nzchar(names(minimise))) && !anyDuplicated(names(minimise))
  if (!named) {
    abort_argument("{.arg minimise} must be two objectives by their names, such as
      {.code list(drag = ~ total_drag, height = ~ -headline_height)}.")
  }
  check_count("points", points)
  if (points < 3) abort_argument("{.arg points} is {.val {points}}; it must be 3 or more.")
  check_count("most", most)
  tasks <- lapply(minimise, function(aim) {
    new_task(gear, aim, keep, change, nodes, netting)
  })
  ends <- lapply(1:2, function(k) {
    alone <- finish_optimum(tasks[[k]], list(find_optimum(tasks[[k]], tasks[[k]]$first, most)))
    # of gears that are as good in this aim, the best in the other
    limit <- aim_of(tasks[[k]], alone) + end_share * tasks[[k]]$size
    optimum_within(tasks[[3L - k]], tasks[[k]]$aim, limit, alone, most)
  })
  # the second aim at both ends
  second <- vapply(ends, function(end) aim_of(tasks[[2L]], end), 0)
  limits <- seq(second[1L], second[2L], length.out = points)[-c(1L, points)]
  near <- ends[[1L]]
  between <- lapply(limits, function(limit) {
    near <<- optimum_within(tasks[[1L]], tasks[[2L]]$aim, limit, near, most)
    near
  })
  optima <- c(ends[1L], between, ends[2L])
  fields <- do.call(rbind, lapply(optima, function(one) one$fields$value))
  colnames(fields) <- with_unit(near$fields$field,
    vapply(near$fields$unit, plain_unit, "", USE.NAMES = FALSE))
  aims <- lapply(tasks, function(task) {
    vapply(optima, function(one) aim_of(task, one), 0, USE.NAMES = FALSE)
  })
  table <- data.frame(
    aims, fields, kept = vapply(optima, function(one) all(one$keep$holds), NA),
    optimal = vapply(optima, `[[`, NA, "optimal"), row.names = NULL, check.names = FALSE
  )
  structure(table, class = c("codend_trade_off", "data.frame"), optima = unname(optima),
    aims = vapply(tasks, function(task) task$aim$text, ""), gear_name = near$gear$plan$name)
}

# By which share of an aim the ends of a trade-off may miss its least value.
end_share <- 1e-3

# The optimum of a task with another aim at most at a limit, from an optimum near it.
optimum_within <- function(task, aim, limit, near, most) {
  task <- with_limit(task, aim, limit)
  base <- list(values = near$fields$value, gear = near$gear, state = near$state)
  place <- points_scaled(task$points, near$fields$value)
  finish_optimum(task, list(find_optimum(task, place, most, from = base)))
}

aim_of <- function(task, optimum) {
  point <- list(values = optimum$fields$value, measures = measures(optimum$state))
  evaluate_formula(task$aim, formula_point(task$points, point, task$words))$value
}

# A task with one more condition: that another aim is at most a limit.
with_limit <- function(task, aim, limit) {
  constant <- list(text = format(limit), call = limit, names = character(), slopes = list())
  condition <- list(text = paste(aim$text, "<=", four_figures(limit)), left = aim, right = constant,
    way = 1, equal = FALSE)
  task$keep <- c(task$keep, list(condition))
  task$limits <- c(task$limits, max(abs(limit), .Machine$double.xmin))
  task$of <- unique(c(task$of, task$words$column[task$words$name %in% aim$names]))
  task$history <- new.env(parent = emptyenv())
  task$history$rows <- list()
  task
}

#' @export
print.codend_trade_off <- function(x, ...) {
  shown <- as.data.frame(unclass(x), check.names = FALSE)
  attributes(shown)[c("optima", "aims", "gear_name")] <- NULL
  cat("Trade-off of \"", attr(x, "gear_name"), "\": ", paste(attr(x, "aims"), collapse = " and "),
    "\n", sep = "")
  numbers <- vapply(shown, is.double, NA)
  shown[numbers] <- lapply(shown[numbers], signif, 5)
  print(shown, row.names = FALSE)
  invisible(x)
}

# Numbers to four figures, each by itself.
four_figures <- function(x) {
  with_plain_numbers(vapply(x, function(one) format(signif(one, 4), digits = 6), ""))
}
