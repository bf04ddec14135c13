#' Find the gear that does best
#'
#' Changes fields of a plan within their ranges until a measure, or a formula of measures, is as
#' small as it gets while conditions hold: least drag per swept width, least fuel per catch, the
#' largest volume of a cage in a current.
#'
#' Every step settles the gear from the nearest shape that is known and takes its exact
#' [sensitivities()]; the steps are those of sequential quadratic programming (SLSQP of NLopt, Kraft
#' 1994, ACM Transactions on Mathematical Software 20:262). It stops on small changes, which is no
#' sign of an optimum by itself. So what it finds is checked against the conditions of Karush, Kuhn
#' and Tucker: the sensitivities of the objective must be balanced by those of conditions at their
#' limit and of fields at the end of their range, with weights of the right sign. What is left,
#' `optimality`, is how much the objective would still gain, as a share of itself, per whole range
#' of a field; above 0.002 the search goes on from there. Where it cannot, because the answer has a
#' kink (netting that goes slack, ropes that come to lie on the sea bed), `smooth` says so.
#'
#' A coarse model of the gear, with few nodes, is wrong by a few percent, and conditions that hold
#' on it may fail on a finer one. So the optimum is settled with as many nodes as leave an error of
#' at most `accuracy`, up to seven times those of the search. The difference between both models, in
#' measures and in their sensitivities, corrects the coarse one, and the search goes on until both
#' agree (first-order model management, Alexandrov and Lewis 2001, Optimization and Engineering
#' 2:413). All results are those of the fine model, also for the gear as it was. The objective and
#' each condition have an estimated `error`; a condition at its limit holds to within that. To be
#' sure of it, give the limit plus twice the error.
#'
#' Whole numbers, such as of floats, are free at first: measures follow their slopes between two
#' numbers. Then they are rounded, up and down for the most telling two and to the nearest for the
#' others; the other fields are found again next to each choice, and the best that settles and keeps
#' the conditions is taken. One optimum of several is found, a local one; `starts` tries from other
#' places. It is never worse than the gear as it was.
#'
#' @param gear A gear, from [read_gear()] or the constructors, or the name or file of a plan.
#' @param minimise The name of a measure, or a formula of [measures()]:
#'   `~ total_drag / door_spread`. A measure is in the unit that its name ends in, or without that
#'   unit in its name in SI. Put a
#'   minus before what is to be large. A field that changes may be there by its path, in SI.
#' @param keep Conditions, a formula or a list of them: `~ headline_height >= "5 m"`,
#'   `~ door_spread <= 80 & total_drag_kN <= 40`, with `>=`, `<=` or `==`. A limit is a number, or
#'   text with a unit next to measures named without theirs, or a variable that holds either.
#'   `~ lower(net_mouth_height, 0.9) >= "4 m"` keeps what holds with a probability of 90 %, and
#'   `upper()` likewise: the measure less, or more, its standard uncertainty times Student's t. It
#'   is found once, by [uncertainty()] of the gear as it is, and taken as the same share of the
#'   measure in every design.
#' @param change The fields that may change, by their paths as in [update()][update.codend_gear],
#'   with the ends of their ranges: `list(warps.length = c("300 m", "600 m"))` or [value_range()]
#'   them.
#'   Fields that change together are joined: `"ropes.a.length + ropes.b.length"`. The gear's own
#'   value lies within.
#' @param nodes,netting Of the model that the search steps with, as in [settle()].
#' @param accuracy Discretisation error of the objective and the conditions, as a share of the
#'   objective and of the limits: where it is larger with `nodes`, the search ends with more nodes.
#'   `NULL` stays with `nodes` and reports the error.
#' @param starts From how many places to begin: the gear's own, and others spread over the ranges.
#'   `NULL` begins from the gear's own and, where that search ends at a kink, from two others. From
#'   the best end at a kink a search without slopes, over both sides of every field (COBYLA of
#'   NLopt, Powell 1994), goes on.
#' @param most Settled gears at most, for each start.
#' @return An object of class `codend_optimum`, a list of
#'
#'   - `gear` and `state`: the best found, [update()][update.codend_gear]d and settled;
#'   - `aim`: its `text`, its value in the gear as it was (`begun`) and now (`value`), `saving`,
#'     the share by which it fell, and the discretisation `error` of the value;
#'   - `fields`: a data frame with `field`, `unit`, `begun`, `value`, `lower`, `upper` and `at`
#'     (`"lower"`, `"upper"` or empty: the end of the range that it lies at);
#'   - `keep`: a data frame with each condition's `text`, the two sides' values `left` and `right`
#'     in SI (or the units of the names), whether it `holds` (to 1e-4 of the limit), whether it is
#'     `active`, its `price`: by how many percent the objective would fall were the limit 1 %
#'     looser, the estimated `error` of the difference of both sides, and whether it is `sure`: also
#'     kept were the measures off by twice their errors;
#'   - `nodes` of its model, and `accuracy`: the largest of these errors, as a share;
#'   - `optimality` and whether the optimum is `optimal` (below 0.002) and `smooth`;
#'   - `kinks`: a data frame of measures in the objective and the conditions whose sensitivities to
#'     a field differ on its two sides there, or are only known from settled gears;
#'   - `history`: a data frame of all points, with fields, the objective, `worst`, by which share of
#'     its limit the worst condition fails, whether all are `kept`, and gears settled until then;
#'     its attribute `gaps` has the same share of every condition, negative where it is kept;
#'   - `starts`: a data frame of where each start ended; `settles`, gears settled in all; `ended`,
#'     why the search from the best start ended.
#'
#'   Wrong arguments are an error of class `codend_error_argument`, a wrong field one of class
#'   `codend_error_plan`. Where no gear that settles keeps the conditions, the nearest is returned
#'   with a warning of class `codend_warning_conditions_not_kept`.
#' @seealso [trade_off()] for two objectives, [codend_charts], [sensitivities()].
#' @export
#' @examplesIf requireNamespace("nloptr", quietly = TRUE)
#' # The cable that holds its sphere 450 m deep with the least drag by speed
#' found <- optimise_gear("towed_cable",
#'   minimise = ~ total_drag / towing.speed,
#'   keep = ~ body_depth >= "450 m",
#'   change = list(ropes.cable.length = c("600 m", "1200 m"), towing.speed = c("3 knot", "5 knot"))
#' )
#' found
optimise_gear <- function(gear, minimise, keep = NULL, change, nodes = 1500, netting = NULL,
                          accuracy = "1 %", starts = NULL, most = 200) {
  check_given("gear", "minimise", "change")
  if (!is.null(accuracy)) accuracy <- accuracy_share(accuracy)
  task <- new_task(gear, minimise, keep, change, nodes, netting)
  if (!is.null(starts)) check_count("starts", starts)
  check_count("most", most)
  dimensions <- length(task$points$fields)
  places <- rbind(task$first, spread_points(max(starts, kinked_starts) - 1, dimensions))
  runs <- lapply(seq_len(max(starts, 1)), function(k) find_optimum(task, places[k, ], most))
  if (is_kinked(task, runs)) {
    if (is.null(starts)) {
      others <- seq_len(kinked_starts)[-1L]
      runs <- c(runs, lapply(others, function(k) find_optimum(task, places[k, ], most)))
    }
    runs <- leave_kink(task, runs, most)
  }
  finish_optimum(task, runs, accuracy)
}

# Starts where nobody gives a number and the first search ends at a kink.
kinked_starts <- 3L
# Gears settled at most to leave one, and how far from it, as a share of the ranges.
settles_kink <- 40L
kink_reach <- 0.15

# The best of some searches, or NULL.
best_run <- function(runs) {
  kept <- Filter(function(run) !is.null(run$best), runs)
  if (!length(kept)) return(NULL)
  best <- kept[[1L]]
  for (run in kept[-1L]) if (is_better(run$best$values, best$best$values)) best <- run
  best
}

# Whether the best of some searches is no optimum by its slopes, or lies where measures bend.
is_kinked <- function(task, runs) {
  best <- best_run(runs)
  if (is.null(best)) return(FALSE)
  optimality_of(task, best$best)$left > most_optimality || nrow(kinks_at(task, best$best)) > 0L
}

# Searches on from the best of some searches without slopes, which at a kink are those of one side:
# by linear models over both sides of every field (COBYLA of NLopt; Powell 1994), and with slopes
# again from where that leads. Returns the searches with the best one gone on with.
leave_kink <- function(task, runs, most) {
  at_best <- which(vapply(runs, identical, NA, best_run(runs)))[1L]
  from <- runs[[at_best]]$best
  search <- new.env(parent = emptyenv())
  search$tried <- list(from)
  search$near <- from$point
  search$best <- from
  begun <- task$points$count$settles
  at <- function(x) try_point(task, search, x)
  equal <- vapply(task$keep, `[[`, NA, "equal")
  gaps <- function(which) if (any(which)) function(x) at(x)$gap[which]
  tryCatch(
    nloptr::nloptr(
      from$scaled, function(x) min(at(x)$scaled, 1e6),
      lb = pmax(from$scaled - kink_reach, 0), ub = pmin(from$scaled + kink_reach, 1),
      eval_g_ineq = gaps(!equal), eval_g_eq = gaps(equal),
      opts = list(
        algorithm = "NLOPT_LN_COBYLA", xtol_abs = rep(1e-3, length(from$scaled)), ftol_rel = 1e-5,
        maxeval = settles_kink
      )
    ),
    codend_error_no_place = function(e) NULL
  )
  run <- find_optimum(task, search$best$scaled, most, from = search$best$point)
  if (is.null(run$best) || is_better(search$best$values, run$best$values)) run$best <- search$best
  run$settles <- runs[[at_best]]$settles + task$points$count$settles - begun
  if (is_better(run$best$values, from$values)) runs[[at_best]] <- run
  runs
}

# What is looked for: list(points, words, aim, keep, of (measures needed), base (the gear settled as
# it is), first (its scaled fields), size (of the aim), limits (sizes of the conditions), history).
new_task <- function(gear, minimise, keep, change, nodes, netting) {
  if (is.character(gear)) gear <- read_gear(gear)
  check_settle_arguments(gear, nodes, netting)
  check_package("nloptr", "An optimum")
  fields <- free_fields(gear, change)
  points <- new_points(gear, fields, nodes, netting)
  base <- settled_state(gear, nodes, netting, NULL)
  points$count$settles <- 1L
  base <- list(values = own_values(fields), gear = gear, state = base, measures = measures(base))
  words <- formula_words(base$measures)
  if (has_bounds(keep) || has_bounds(minimise)) words <- words_with_bounds(words, base$state)
  paths <- vapply(fields, function(field) field$paths[1L], "")
  aim <- read_formula(minimise, "minimise", words, paths)
  conditions <- if (is.null(keep)) list() else read_conditions(keep, words, paths)
  named <- lapply(conditions, function(one) c(one$left$names, one$right$names))
  named <- c(aim$names, unlist(named))
  task <- list(
    points = points, words = words, aim = aim, keep = conditions, base = base,
    of = unique(words$column[words$name %in% named]),
    first = points_scaled(points, base$values), history = new.env(parent = emptyenv())
  )
  task$history$rows <- list()
  at <- formula_point(points, base, words)
  value <- evaluate_formula(aim, at)$value
  if (!is.finite(value)) {
    abort_argument("{.arg minimise} is {.code {aim$text}}, which is {value} in the gear as it is.")
  }
  if (!length(aim$names)) {
    abort_argument("{.arg minimise} is {.code {aim$text}}, in which there is nothing that changes.")
  }
  task$size <- max(abs(value), .Machine$double.xmin)
  task$limits <- vapply(conditions, function(one) {
    sides <- c(evaluate_formula(one$left, at)$value, evaluate_formula(one$right, at)$value)
    if (!all(is.finite(sides))) {
      abort_argument("{.arg keep} has {.code {one$text}}, whose sides are {.val {sides}} in the gear
        as it is.")
    }
    # a limit is the side that changes less: the constant
    fixed <- !c(length(one$left$names), length(one$right$names))
    limit <- if (any(fixed)) abs(sides[fixed]) else 0
    if (limit > 0) limit else max(abs(sides), .Machine$double.xmin)
  }, 0)
  task
}

# Aim and conditions at a point, scaled: list(aim, worst, gap (at most 0 where kept; of equal
# conditions 0), with their slopes where the point has them).
task_values <- function(task, point, slopes = NULL, exact = point$values) {
  at <- formula_point(task$points, point, task$words, slopes, exact)
  aim <- evaluate_formula(task$aim, at)
  sides <- lapply(task$keep, function(one) {
    left <- evaluate_formula(one$left, at)
    right <- evaluate_formula(one$right, at)
    list(
      gap = one$way * (left$value - right$value),
      slope = if (!is.null(slopes)) one$way * (left$slope - right$slope),
      left = left$value, right = right$value
    )
  })
  gap <- vapply(sides, `[[`, 0, "gap") / task$limits
  equal <- vapply(task$keep, `[[`, NA, "equal")
  rows <- lapply(seq_along(sides), function(k) sides[[k]]$slope / task$limits[k])
  list(
    aim = aim$value, scaled = aim$value / task$size, aim_slope = aim$slope / task$size, gap = gap,
    gap_slope = do.call(rbind, rows), worst = max(0, gap, abs(gap[equal])), equal = equal,
    left = vapply(sides, `[[`, 0, "left"), right = vapply(sides, `[[`, 0, "right")
  )
}

# By which share of its limit a condition may fail.
keep_tolerance <- 1e-4
# Share of the aim, per range of a field, that an optimum leaves.
most_optimality <- 2e-3
# Searches begun again where one ends short of that.
most_searches <- 3L

# Searches from a place of scaled fields, no further from it than `reach`. held: fields (by number)
# that stay. Returns list(best (a tried point: point, values, scaled), ended, settles).
find_optimum <- function(task, place, most, held = integer(), from = task$base, reach = 1) {
  search <- new.env(parent = emptyenv())
  search$tried <- list()
  search$near <- from
  begun <- task$points$count$settles
  ended <- ""
  search$lower <- pmax(place - reach, 0)
  search$upper <- pmin(place + reach, 1)
  for (again in seq_len(most_searches)) {
    if (again > 1L) place <- search$best$scaled
    before <- search$best
    ended <- run_slsqp(task, search, place, held, begun + most)
    if (is.null(search$best)) break
    if (optimality_of(task, search$best, held)$left <= most_optimality) break
    if (task$points$count$settles >= begun + most) break
    if (identical(before$scaled, search$best$scaled)) break
  }
  list(best = search$best, ended = ended, settles = task$points$count$settles - begun)
}

run_slsqp <- function(task, search, place, held, most) {
  dimensions <- length(task$points$fields)
  free <- setdiff(seq_len(dimensions), held)
  try_point(task, search, place)
  if (!length(free)) return("all fields are held")
  at <- function(x) {
    # where conditions cannot be kept a newer NLopt goes on to no place at all
    if (anyNA(x)) abort_as("no_place", "There is no place to try.", envir = environment())
    try_point(task, search, replace(place, free, x))
  }
  equal <- vapply(task$keep, `[[`, NA, "equal")
  conditions <- function(which) {
    if (!any(which)) return(NULL)
    function(x) {
      found <- at(x)
      list(constraints = found$gap[which], jacobian = found$gap_slope[which, free, drop = FALSE])
    }
  }
  each <- 1 + 2 * sum(whole_fields(task$points$fields[free]))
  run <- function() nloptr::nloptr(
    place[free],
    function(x) {
      found <- at(x)
      list(objective = found$scaled, gradient = found$aim_slope[free])
    },
    lb = search$lower[free], ub = search$upper[free],
    eval_g_ineq = conditions(!equal), eval_g_eq = conditions(equal),
    opts = list(
      algorithm = "NLOPT_LD_SLSQP", ftol_rel = 1e-6, xtol_abs = rep(1e-4, length(free)),
      maxeval = max(1, floor((most - task$points$count$settles) / each)),
      tol_constraints_ineq = rep(keep_tolerance / 2, sum(!equal)),
      tol_constraints_eq = rep(keep_tolerance / 2, sum(equal))
    )
  )
  message <- tryCatch(run()$message, codend_error_no_place = function(e) "NLOPT_FAILURE:")
  tolower(sub("^NLOPT_([A-Z_]+):.*", "\\1", message))
}

# The values and slopes at scaled fields, settled where they are not known yet: what task_values()
# returns. Where the gear does not settle the aim is infinite, which shortens the step.
try_point <- function(task, search, scaled) {
  for (one in search$tried) {
    if (max(abs(one$scaled - scaled)) <= same_place) return(one$values)
  }
  near <- search$near
  exact <- points_values(task$points, scaled)
  point <- settle_point(task$points, exact, near$state)
  if (is.null(point)) {
    failed <- first_of(search$last, list(
      aim_slope = numeric(length(scaled)), gap = rep(1, length(task$keep)),
      gap_slope = matrix(0, length(task$keep), length(scaled))
    ))
    failed$scaled <- Inf
    return(failed)
  }
  slopes <- corrected_slopes(task$points, known_slopes(task$points, point, task$of))
  values <- task_values(task, point, slopes, exact)
  tried <- list(scaled = scaled, point = point, values = values)
  search$tried <- c(search$tried, list(tried))
  search$near <- point
  search$last <- values
  if (is.null(search$best) || is_better(values, search$best$values)) search$best <- tried
  add_history(task, tried)
  values
}

# Scaled fields nearer to one another than this are one place: the optimiser comes back to it with
# other rounding.
same_place <- 1e-9

# Whether values are better: kept conditions first, then the aim with what it gains by the little
# that conditions may fail taken back.
is_better <- function(one, than) {
  kept <- one$worst <= keep_tolerance
  if (kept != (than$worst <= keep_tolerance)) return(kept)
  if (!kept) return(one$worst < than$worst)
  one$scaled + most_price * one$worst < than$scaled + most_price * than$worst
}

# The largest price of a condition, percent of the aim per percent of its limit, that is seen to.
most_price <- 20

add_history <- function(task, tried) {
  row <- list(
    values = tried$point$values, aim = tried$values$aim, worst = tried$values$worst,
    gap = tried$values$gap, settles = task$points$count$settles
  )
  task$history$rows <- c(task$history$rows, list(row))
}
