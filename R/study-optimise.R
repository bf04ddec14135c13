#' Optimise a gear
#'
#' `optimise_gear()` changes fields of a plan within their ranges to minimise a measure, or a
#' formula of measures, under conditions. Examples are the drag per swept width, the fuel per catch,
#' or minus the volume of a cage in a current.
#'
#' @details
#' # Method
#' - Every step settles the gear ([settle()]) from the nearest known shape and computes its exact
#'   [sensitivities()].
#' - The steps are sequential quadratic programming (SLSQP of NLopt; Kraft 1994, ACM Transactions on
#'   Mathematical Software 20:262).
#' - The result is a local optimum and never worse than the initial gear. Use `starts` to search
#'   from other values.
#'
#' # Check of the optimum
#' Small steps do not prove an optimum, so the result is checked against the Karush-Kuhn-Tucker
#' conditions. The sensitivities of the objective must balance the weighted sensitivities of active
#' conditions and of fields at an end of their range. `optimality` is the remaining gain of the
#' objective, as a fraction of the objective, per range of a field. Above 0.002 the search continues
#' from there, unless there is a kink.
#'
#' # Kinks
#' The response of a gear has kinks: netting goes slack, or ropes touch the seabed. If the best
#' search ends at a kink, a search without derivatives continues over both sides of every field
#' (COBYLA of NLopt, Powell 1994). `smooth` is `FALSE` if the result still lies at a kink.
#'
#' # Discretisation
#' The gear as given is settled first, as by [settle()] with the same arguments, on up to 3 meshes.
#' Its number of nodes is the one of the results. With `nodes` alone, all gears have this number.
#' Otherwise the search has 1,500 nodes (or `nodes`). If the results need more, conditions that hold
#' in the search can fail on the finer mesh:
#'
#' - The optimum is also settled on the finer mesh.
#' - The difference between both meshes, in measures and sensitivities, corrects the coarse mesh.
#'   The search continues until both meshes agree. This is first-order model management (Alexandrov
#'   and Lewis 2001, Optimization and Engineering 2:413).
#' - All results are from the finer mesh, also for the initial gear.
#' - Cost: usually 10 to 40 settled gears on the coarse mesh and 2 to 6 on the finer one.
#' - The objective and each condition have an estimated `error`. An active condition holds within
#'   this error; to be sure, give the limit plus twice the error.
#'
#' # Workers and resuming
#' - Workers of the package future, such as `future::plan("multisession")`, share the starts. The
#'   results are the same for any number of workers.
#' - Every step prints a message. Use `suppressMessages()` or `options(codend.steps = FALSE)` to
#'   omit it. If the package progressr is loaded, it reports the progress too.
#' - With `file`, every settled gear is recorded. The same call continues after an interruption: it
#'   repeats the steps and reads recorded gears instead of settling them. Calls with other
#'   objectives and conditions also use them.
#'
#' # Whole numbers
#' Whole numbers, such as counts of floats, are continuous at first: measures follow their
#' derivatives between two numbers. The two most important ones are then rounded up and down, and
#' the others to the nearest number. The other fields are optimised again for each choice. The best
#' choice that settles and meets the conditions is returned.
#'
#' # Conditions with a probability
#' `~ lower(net_mouth_height, 0.9) >= "4 m"` is met with a probability of 90 %. `upper()` is the
#' equivalent for upper limits. The bound is the measure minus (or plus) its standard uncertainty
#' times Student's t. [uncertainty()] computes this uncertainty once, for the initial gear, and it
#' is the same fraction of the measure in every design.
#'
#' @param gear A gear, from [read_gear()] or the constructors, or the name or file of a plan.
#' @param minimise The name of a measure, or a formula of [measures()] and changed fields (by path,
#'   in SI): `~ total_drag / door_spread`. A measure without a unit in its name is in SI. Put a
#'   minus sign before a measure to maximise it.
#' @param keep Conditions: a formula or a list of formulas with `>=`, `<=` or `==`, such as
#'   `~ door_spread <= 80 & total_drag_kN <= 40`. A limit is a number, text with a unit (for a
#'   measure named without its unit), or a variable with such a value.
#' @param change The fields to change: a list of ranges or [value_range()] by path, such as
#'   `list(warps.length = c("300 m", "600 m"))`. Join fields that change together:
#'   `"ropes.a.length + ropes.b.length"`. The range must contain the gear's value.
#' @param nodes,netting,accuracy As in [settle()], for the gear as given. Its number of nodes is
#'   used for the results. See the section on discretisation.
#' @param starts Number of starts: the gear's own values and others spread over the ranges. `NULL`
#'   (default) uses the gear's own values, and two more if the search ends at a kink.
#' @param max_solves Largest number of settled gears for each start. Default 200.
#' @param file Path of a file that records settled gears, to resume after an interruption. Default
#'   `NULL`: no record. See the section on resuming.
#' @return An object of class `codend_optimum`, a list:
#'
#'   - `gear`, `state`: the best gear and its settled state.
#'   - `objective`: the objective, a list. `text` is its formula, `begun` and `value` are its
#'     initial and final values. `saving` is the relative decrease, and `error` the discretisation
#'     error of the value.
#'   - `fields`: a data frame, one row per field, in the unit `unit` of the plan. Columns: `field`,
#'     `unit`, `begun`, `value`, `lower`, `upper` and `at`. `at` is `"lower"` or `"upper"` at an end
#'     of the range, else empty.
#'   - `keep`: a data frame, one row per condition. `text` is its formula, `left` and `right` are
#'     the values of both sides (SI or the unit in the name). `holds` is `TRUE` if it is met (within
#'     1e-4 of the limit), `active` if it is at its limit. `price` is the percentage by which the
#'     objective would fall with a limit 1 % looser. `error` is the error of the difference between
#'     both sides. `sure` is `TRUE` if the condition holds with twice this error.
#'   - `nodes`: number of nodes of its mesh. `accuracy`: the largest error, as a fraction.
#'   - `optimality`, and `optimal` (`TRUE` if all conditions hold and `optimality` is below 0.002).
#'   - `smooth`: `TRUE` without kinks. `kinks`: a data frame of measures in the objective and
#'     conditions whose sensitivities differ on both sides of a field. It includes sensitivities
#'     that only settled gears can give.
#'   - `history`: a data frame, one row per tried point: fields, objective (`objective`), `worst`
#'     (largest violation, as a fraction of the limit), `kept` (`TRUE` if all conditions hold),
#'     `n_solves`. Its attribute `gaps` has the violation of every condition, negative if it is met.
#'   - `starts`: a data frame of the end points (`objective`, `worst`, `n_solves`, `ended`), one
#'     row per start. `n_solves`: total number of settled gears. `ended`: the reason why the best
#'     search ended.
#'
#'   Wrong arguments raise an error of class `codend_error_argument`, a wrong field raises
#'   `codend_error_plan`. If no settled gear meets the conditions, the nearest gear is returned with
#'   a warning of class `codend_warning_conditions_not_kept`.
#' @seealso [trade_off()] for two objectives, [sensitivities()], [codend_charts];
#'   `vignette("optimise-a-trawl", package = "codend")`.
#' @export
#' @examplesIf requireNamespace("nloptr", quietly = TRUE)
#' # The cable that holds its sphere 450 m deep with the least drag by speed
#' found <- optimise_gear("towed_cable",
#'   minimise = ~ total_drag / towing.speed,
#'   keep = ~ body_depth >= "450 m",
#'   change = list(ropes.cable.length = c("600 m", "1200 m"), towing.speed = c("3 knot", "5 knot"))
#' )
#' found
optimise_gear <- function(gear, minimise, keep = NULL, change, nodes = NULL, netting = NULL,
                          accuracy = NULL, starts = NULL, max_solves = 200, file = NULL) {
  check_given("gear", "minimise", "change")
  task <- new_task(gear, minimise, keep, change, nodes, netting, accuracy, file)
  task$steps <- new_steps(max_solves)
  if (!is.null(starts)) check_count("starts", starts)
  check_count("max_solves", max_solves)
  dimensions <- length(task$points$fields)
  places <- rbind(task$first, spread_points(max(starts, kinked_starts) - 1, dimensions))
  runs <- search_starts(task, places[seq_len(max(starts, 1)), , drop = FALSE], max_solves)
  best <- best_run(runs)$best
  kinked <- !is.null(best) &&
    (optimality_of(task, best)$left > most_optimality || nrow(kinks_at(task, best)) > 0L)
  if (kinked) {
    if (is.null(starts)) {
      others <- seq_len(kinked_starts)[-1L]
      runs <- c(runs, search_starts(task, places[others, , drop = FALSE], max_solves))
    }
    runs <- leave_kink(task, runs, max_solves)
  }
  finish_optimum(task, runs)
}

# Searches from each row of `places`, on workers if there are any. Returns the searches.
search_starts <- function(task, places, most) {
  found <- on_workers("search_start", asplit(places, 1L), seq_len(nrow(places)), task, most)
  count <- task$points$count
  lapply(found, function(one) {
    rows <- lapply(one$history, function(row) {
      row$n_solves <- row$n_solves + count$n_solves
      row
    })
    task$history$rows <- c(task$history$rows, rows)
    count$n_solves <- count$n_solves + one$count$n_solves
    count$slopes <- count$slopes + one$count$slopes
    one$run
  })
}

# Returns list(run (from `find_optimum()`), history, count) of one search.
search_start <- function(place, number, task, most) {
  task$history <- new_search_history()
  task$points$count <- new_count()
  run <- find_optimum(task, as.double(place), most)
  list(run = run, history = task$history$rows, count = as.list(task$points$count))
}

# Number of starts if `starts` is NULL and the first search ends at a kink.
kinked_starts <- 3L
# Limits of the search that leaves a kink: settled gears, and distance as a fraction of the ranges.
solves_at_kink <- 40L
kink_reach <- 0.15

# Returns the search with the best point, or NULL.
best_run <- function(runs) {
  kept <- Filter(function(run) !is.null(run$best), runs)
  if (!length(kept)) return(NULL)
  best <- kept[[1L]]
  for (run in kept[-1L]) if (is_better(run$best$values, best$best$values)) best <- run
  best
}

# Continues the best search without derivatives, which describe only one side of a kink. COBYLA of
# NLopt (Powell 1994) fits linear models over both sides of every field. A search with derivatives
# follows. Returns `runs` with the improved search.
leave_kink <- function(task, runs, most) {
  at_best <- which(vapply(runs, identical, NA, best_run(runs)))[1L]
  from <- runs[[at_best]]$best
  search <- new.env(parent = emptyenv())
  search$tried <- list(from)
  search$near <- from$point
  search$best <- from
  begun <- task$points$count$n_solves
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
        maxeval = solves_at_kink
      )
    ),
    codend_error_no_place = function(e) NULL
  )
  run <- find_optimum(task, search$best$scaled, most, from = search$best$point)
  if (is.null(run$best) || is_better(search$best$values, run$best$values)) run$best <- search$best
  run$n_solves <- runs[[at_best]]$n_solves + task$points$count$n_solves - begun
  if (is_better(run$best$values, from$values)) runs[[at_best]] <- run
  runs
}

# Returns the task: list(points, words, aim (objective), keep (conditions), base (settled initial
# gear), fine (the same on the mesh of the results, or NULL), of (measures needed), first (scaled
# initial fields), history, size and limits (magnitudes)).
new_task <- function(gear, minimise, keep, change, nodes, netting, accuracy, file = NULL) {
  if (is.character(gear)) gear <- read_gear(gear)
  check_settle_arguments(gear, nodes, netting)
  check_package("nloptr", "An optimum")
  fields <- free_fields(gear, change)
  states <- first_states(gear, nodes, netting, accuracy)
  points <- new_points(gear, fields, nodes_of(states$coarse), netting, states, file)
  points$count$n_solves <- length(states)
  first <- lapply(states, function(state) {
    list(values = own_values(fields), gear = gear, state = state, measures = measures(state))
  })
  base <- first$coarse
  words <- formula_names(base$measures)
  if (has_bounds(keep) || has_bounds(minimise)) words <- text_with_bounds(words, base$state)
  paths <- vapply(fields, function(field) field$paths[1L], "")
  objective <- read_formula(minimise, "minimise", words, paths)
  conditions <- if (is.null(keep)) list() else read_conditions(keep, words, paths)
  sides <- c(lapply(conditions, `[[`, "left"), lapply(conditions, `[[`, "right"))
  task <- list(
    points = points, words = words, objective = objective, keep = conditions, base = base,
    fine = first$fine,
    of = formula_measures(words, c(list(objective), sides)),
    first = points_scaled(points, base$values), history = new_search_history()
  )
  at <- formula_point(points, base, words)
  value <- evaluate_formula(objective, at)$value
  if (!is.finite(value)) {
    abort_argument("{.arg minimise} is {.code {objective$text}}, which is {value} for the initial
      gear.")
  }
  if (!length(objective$names)) {
    abort_argument("{.arg minimise} is {.code {objective$text}}, which does not depend on the
      changed fields.")
  }
  task$size <- max(abs(value), .Machine$double.xmin)
  task$limits <- vapply(conditions, function(one) {
    sides <- c(evaluate_formula(one$left, at)$value, evaluate_formula(one$right, at)$value)
    if (!all(is.finite(sides))) {
      abort_argument("{.arg keep} has {.code {one$text}}; its sides are {.val {sides}} for the
        initial gear but must be finite.")
    }
    # The limit is the constant side, if there is one.
    fixed <- !c(length(one$left$names), length(one$right$names))
    limit <- if (any(fixed)) abs(sides[fixed]) else 0
    if (limit > 0) limit else max(abs(sides), .Machine$double.xmin)
  }, 0)
  task
}

# Returns the objective and conditions at a point, scaled, with gradients if `slopes` is given.
# `gap`: at most 0 if the condition is met, 0 for an equality. `worst`: largest violation.
task_values <- function(task, point, slopes = NULL, exact = point$values) {
  at <- formula_point(task$points, point, task$words, slopes, exact)
  objective <- evaluate_formula(task$objective, at)
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
    objective = objective$value, scaled = objective$value / task$size,
      objective_gradient = objective$slope / task$size, gap = gap,
    gap_slope = do.call(rbind, rows), worst = max(0, gap, abs(gap[equal])), equal = equal,
    left = vapply(sides, `[[`, 0, "left"), right = vapply(sides, `[[`, 0, "right")
  )
}

# Permitted violation of a condition, as a fraction of its limit.
keep_tolerance <- 1e-4
# Largest `left` (see `optimality_of()`) at an optimum.
most_optimality <- 2e-3
# Largest number of searches per start. A search that misses `most_optimality` is restarted.
most_searches <- 3L

# Searches from the scaled fields `place`, within `reach`. held: numbers of fixed fields. Returns
# list(best (list(scaled, point, values), or NULL), ended, settles).
find_optimum <- function(task, place, most, held = integer(), from = task$base, reach = 1) {
  search <- new.env(parent = emptyenv())
  search$tried <- list()
  search$near <- from
  begun <- task$points$count$n_solves
  ended <- ""
  search$lower <- pmax(place - reach, 0)
  search$upper <- pmin(place + reach, 1)
  for (again in seq_len(most_searches)) {
    if (again > 1L) place <- search$best$scaled
    before <- search$best
    ended <- run_slsqp(task, search, place, held, begun + most)
    if (is.null(search$best)) break
    if (optimality_of(task, search$best, held)$left <= most_optimality) break
    if (task$points$count$n_solves >= begun + most) break
    if (identical(before$scaled, search$best$scaled)) break
  }
  list(best = search$best, ended = ended, n_solves = task$points$count$n_solves - begun)
}

run_slsqp <- function(task, search, place, held, most) {
  dimensions <- length(task$points$fields)
  free <- setdiff(seq_len(dimensions), held)
  try_point(task, search, place)
  if (!length(free)) return("all fields are fixed")
  at <- function(x) {
    # If the conditions cannot be met, newer versions of NLopt try NaN.
    if (anyNA(x)) abort_as("no_place", "There is no point to try.", envir = environment())
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
      list(objective = found$scaled, gradient = found$objective_gradient[free])
    },
    lb = search$lower[free], ub = search$upper[free],
    eval_g_ineq = conditions(!equal), eval_g_eq = conditions(equal),
    opts = list(
      algorithm = "NLOPT_LD_SLSQP", ftol_rel = 1e-6, xtol_abs = rep(1e-4, length(free)),
      maxeval = max(1, floor((most - task$points$count$n_solves) / each)),
      tol_constraints_ineq = rep(keep_tolerance / 2, sum(!equal)),
      tol_constraints_eq = rep(keep_tolerance / 2, sum(equal))
    )
  )
  message <- tryCatch(run()$message, codend_error_no_place = function(e) "NLOPT_FAILURE:")
  tolower(sub("^NLOPT_([A-Z_]+):.*", "\\1", message))
}

# Returns `task_values()` at scaled fields. An infinite objective (not settled) shortens the step.
try_point <- function(task, search, scaled) {
  for (one in search$tried) {
    if (max(abs(one$scaled - scaled)) <= same_place) return(one$values)
  }
  near <- search$near
  exact <- points_values(task$points, scaled)
  point <- settle_point(task$points, exact, near$state)
  if (is.null(point)) {
    failed <- first_of(search$last, list(
      objective_gradient = numeric(length(scaled)), gap = rep(1, length(task$keep)),
      gap_slope = matrix(0, length(task$keep), length(scaled))
    ))
    failed$scaled <- Inf
    return(failed)
  }
  slopes <- corrected_derivatives(task$points, known_derivatives(task$points, point, task$of))
  values <- task_values(task, point, slopes, exact)
  tried <- list(scaled = scaled, point = point, values = values)
  search$tried <- c(search$tried, list(tried))
  search$near <- point
  search$last <- values
  if (is.null(search$best) || is_better(values, search$best$values)) search$best <- tried
  add_history(task, tried)
  report_step(task$steps, task$objective$text, values$objective, scaled)
  values
}

# Points within this distance (scaled fields) are identical: the optimiser rounds.
same_place <- 1e-9

# Met conditions come first, then the objective with a penalty for permitted violations.
is_better <- function(one, than) {
  kept <- one$worst <= keep_tolerance
  if (kept != (than$worst <= keep_tolerance)) return(kept)
  if (!kept) return(one$worst < than$worst)
  one$scaled + most_price * one$worst < than$scaled + most_price * than$worst
}

# Penalty of a violation: percent of the objective per percent of the limit.
most_price <- 20

new_search_history <- function() list2env(list(rows = list()), parent = emptyenv())

add_history <- function(task, tried) {
  row <- list(
    values = tried$point$values, objective = tried$values$objective, worst = tried$values$worst,
    gap = tried$values$gap, n_solves = task$points$count$n_solves
  )
  task$history$rows <- c(task$history$rows, list(row))
}
