# Measures of the design on screen against one field. The slow worker settles one value after the
# other from the state on screen, like vary(). It answers other requests in between.

most_varied <- 41L

# Checks a request: `said` = list(paths (fields that change together), unit, from, to (as typed, a
# bare number in `unit`), number (of values)). Returns list(paths, unit, values, now (value of the
# first field)), with values in this unit.
varied_field <- function(plan, said) {
  asked <- requested_field(plan, said$paths)
  paths <- asked$paths
  path <- paths[1L]
  field <- asked$field
  dimension <- field$node[["x-dimension"]]
  unit <- if (is.null(dimension)) "" else first_of(said$unit, "")
  units <- plan_units[[first_of(dimension, "number")]]
  if (nzchar(unit) && !(is_text(unit) && plain_unit(unit) %in% names(units))) {
    abort_argument("The unit does not fit the field {.val {path}}.")
  }
  per_unit <- if (nzchar(unit)) units[[plain_unit(unit)]] else 1
  end <- function(given) {
    value <- quantity_si(edit_value(plan, path, list(value = given, unit = unit)), dimension)
    if (!is.finite(value)) abort_field(path, given, "a number")
    value / per_unit
  }
  ends <- c(end(said$from), end(said$to))
  if (ends[1L] == ends[2L]) abort_field(path, said$to, "different from the first value")
  number <- as.list(said)$number
  if (!is.numeric(number) || length(number) != 1L || !number %in% 2:most_varied) {
    abort_argument("The number of values must be from 2 to {most_varied}.")
  }
  values <- seq(ends[1L], ends[2L], length.out = number)
  if (field$node$shape == "integer") values <- unique(round(values))
  list(
    paths = paths, unit = unit, values = signif(values, 10L),
    now = quantity_si(field$value, dimension) / per_unit
  )
}

# `said`: list(design, paths, unit, value, nodes).
varied_measures <- function(state, said) {
  edits <- rep(list(list(value = said$value, unit = said$unit)), length(said$paths))
  design <- said$design
  design$plan <- edited_plan(design$plan, stats::setNames(edits, said$paths))$plan
  gear <- gear_of_design(design, state$gear)
  measures(settle_noted(gear, said$nodes, state)$state)
}

# Returns the results so far with the columns of vary(). varied: from varied_field(), and `found`
# with the measures or the error message for each value.
varied_table <- function(varied) {
  settled <- vapply(varied$found, is.numeric, NA)
  names <- unique(unlist(lapply(varied$found[settled], names)))
  column <- paste0(varied$paths[1L], if (nzchar(varied$unit)) "_", varied$unit)
  values <- vapply(names, function(name) {
    vapply(varied$found, function(one) {
      if (is.numeric(one) && name %in% names(one)) one[[name]] else NA_real_
    }, 0)
  }, numeric(length(varied$found)))
  problem <- vapply(varied$found, function(one) if (is.numeric(one)) "" else one, "")
  data.frame(
    stats::setNames(list(varied$values[seq_along(varied$found)]), column), settled = settled,
    problem = problem, matrix(values, length(varied$found), dimnames = list(NULL, names)),
    check.names = FALSE
  )
}

# Returns the results for the page, with key measures first.
varied_message <- function(varied) {
  table <- varied_table(varied)
  settled <- varied$found[table$settled]
  units <- unlist(lapply(settled, attr, "unit"))
  names <- setdiff(names(table)[-1L], c("settled", "problem"))
  names <- union(key_names(names), names)
  list(
    path = varied$paths[1L], unit = varied$unit, now = varied$now, of = length(varied$values),
    range = I(range(varied$values)),
    values = I(varied$values[seq_along(varied$found)]), problems = I(table$problem),
    measures = lapply(names, function(name) {
      error <- vapply(varied$found, function(one) {
        if (is.numeric(one)) first_of(attr(one, "error")[name], NA_real_) else NA_real_
      }, 0)
      list(
        words = label_of(name, units[[name]]), unit = units[[name]],
        values = I(table[[name]]), errors = I(unname(error))
      )
    })
  )
}

# Handles requests, as in varied_field().
flume_varies <- function(page) {
  tank <- page$tank
  turn <- 0L  # number of the last request
  stop_varying <- function(...) {
    turn <<- turn + 1L
    if (!is.null(tank$varied)) show_varied(page, FALSE)
  }
  start_varying <- function(given) {
    varied <- NULL
    good <- page$trying("vary", varied <- varied_field(tank$gear$plan, as.list(given)))
    if (!good) return()
    turn <<- turn + 1L
    mine <- turn
    opened <- tank$turn
    tank$varied <- c(varied, list(name = tank$gear$plan$name, found = list()))
    request <- tank$request("vary", c(
      varied[c("paths", "unit")], list(design = design_of(tank$gear))
    ))
    request$said$nodes <- request$nodes
    go_on <- function() {
      if (tank$turn != opened) return(stop_varying())
      k <- length(tank$varied$found) + 1L
      show_varied(page)
      if (k > length(varied$values)) return()
      request$said$value <- varied$values[k]
      page$clerk$ask("vary", function() if (mine == turn) request, function(answer) {
        if (page$closed() || mine != turn || is.null(answer)) return()
        if (isTRUE(answer$problem$cancelled)) return(stop_varying())
        tank$varied$found[[k]] <- first_of(answer$found, answer$problem$message)
        go_on()
      })
    }
    go_on()
  }
  list(vary_wanted = start_varying, vary_stop = stop_varying)
}

show_varied <- function(
  page, running = length(page$tank$varied$found) < length(page$tank$varied$values)
) {
  tank <- page$tank
  page$said("flume_varied", running = running, varied = varied_message(tank$varied))
}
