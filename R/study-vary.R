#' Settle a gear in many variations
#'
#' Settles a gear once for every value, or every combination of values, of some of its plan's
#' fields: at several speeds, with several lengths of warp, several boards. Each variation starts
#' from the shape of the nearest that has settled, and anew where that does not lead to balance.
#'
#' @param gear A gear, from [read_gear()] or the constructors, or the name or file of a plan.
#' @param ... Values by the path of their field, as in [update()][update.codend_gear]:
#'   `towing.speed = c("3 knot", "4 knot")`. Several fields are combined in every way, the first
#'   changing fastest. Fields that change together go as columns of a data frame without a name,
#'   such as [designs()]; what is missing there stays as in the plan. All plans are checked before
#'   anything is computed.
#' @param nodes,netting As in [settle()].
#' @return A data frame of class `codend_variations` with a row per variation:
#'
#'   - the fields, by their path with their unit added (`towing.speed_knot`): the unit in which all
#'     values were given, else the SI unit;
#'   - `settled`, and `problem`: where a gear did not settle, why;
#'   - `warning`: what [settle()] warned of, such as a stalled board;
#'   - the [measures()], `NA` where the gear did not settle or has no such measure.
#'
#'   A wrong field or value is an error of class `codend_error_plan`, wrong arguments are one of
#'   class `codend_error_argument`. A gear that does not settle is no error.
#' @seealso [plot.codend_variations()]
#' @export
#' @examples
#' found <- vary("towed_cable", towing.speed = paste(3:6, "knot"))
#' found[c("towing.speed_knot", "total_drag_kN")]
#' plot(found)
vary <- function(gear, ..., nodes = 1500, netting = NULL) {
  if (is.character(gear)) gear <- read_gear(gear)
  check_settle_arguments(gear, nodes, netting)
  axes <- design_axes(list(...))
  place <- do.call(expand.grid, lapply(axes, function(axis) seq_len(nrow(axis))))
  gears <- lapply(seq_len(nrow(place)), function(row) {
    fields <- lapply(seq_along(axes), function(k) design_fields(axes[[k]], place[row, k]))
    do.call(update, c(list(gear), do.call(c, fields)))
  })
  for (one in gears) check_lattice_size(gear_si(one), nodes, netting)
  found <- vary_settle(gears, as.matrix(place), nodes, netting)
  columns <- lapply(axes, field_columns, gear)
  fields <- do.call(cbind, lapply(seq_along(axes), function(k) {
    columns[[k]]$values[place[[k]], , drop = FALSE]
  }))
  known <- unique(unlist(lapply(found, function(one) names(one$measures))))
  units <- unlist(lapply(found, function(one) attr(one$measures, "unit")))[known]
  measured <- lapply(setNames(known, known), function(name) {
    vapply(found, function(one) {
      if (name %in% names(one$measures)) one$measures[[name]] else NA_real_
    }, 0)
  })
  text <- function(what) vapply(found, function(one) first_of(one[[what]], NA_character_), "")
  table <- data.frame(
    fields, settled = is.na(text("problem")), problem = text("problem"), warning = text("warning"),
    measured, row.names = NULL, check.names = FALSE
  )
  structure(table, class = c("codend_variations", "data.frame"), gear_name = gear$plan$name,
    unit = c(unlist(lapply(columns, `[[`, "unit")), units))
}

# Settles gears that lie on a grid, each from the nearest that has settled. place: a row per gear,
# its whole numbers along every axis, the first changing fastest.
vary_settle <- function(gears, place, nodes, netting) {
  # No neighbour along an axis lies further back than the rows between them.
  reach <- prod(apply(place, 2L, max)[-ncol(place)])
  states <- vector("list", length(gears))
  show <- vary_progress(length(gears))
  lapply(seq_along(gears), function(k) {
    near <- which(lengths(states) > 0L)
    steps <- colSums(abs(t(place[near, , drop = FALSE]) - place[k, ]))
    from <- if (length(near)) states[[near[which.min(steps)]]]
    one <- settle_one(gears[[k]], nodes, netting, from)
    states[k] <<- list(one$state)
    if (k > reach) states[k - reach] <<- list(NULL)
    show(k)
    one[c("measures", "problem", "warning")]
  })
}

settle_one <- function(gear, nodes, netting, from) {
  warned <- NULL
  tryCatch(
    withCallingHandlers(
      {
        state <- settle(gear, nodes, netting, from)
        list(state = state, measures = measures(state), warning = warned)
      },
      codend_warning = function(w) {
        warned <<- paste(c(warned, plain_message(w)), collapse = " ")
        invokeRestart("muffleWarning")
      }
    ),
    codend_error_not_converged = function(e) list(problem = plain_message(e), warning = warned)
  )
}

# A function(done) that shows a bar once a study has run for two seconds.
vary_progress <- function(total) {
  if (!cli::is_dynamic_tty() || total < 2L) return(function(done) NULL)
  begun <- proc.time()[["elapsed"]]
  bar <- NULL
  frame <- parent.frame()
  function(done) {
    if (is.null(bar)) {
      if (proc.time()[["elapsed"]] - begun < 2) return(NULL)
      bar <<- cli::cli_progress_bar(
        total = total, .envir = frame,
        format = "{cli::pb_bar} {cli::pb_current} of {cli::pb_total} settled, {cli::pb_eta} left"
      )
    }
    cli::cli_progress_update(set = done, id = bar, .envir = frame)
  }
}

# Fields as columns whose names end in their unit: list(values = data frame, unit by column).
field_columns <- function(axis, gear) {
  columns <- lapply(names(axis), function(path) field_column(axis[[path]], path, gear))
  unit <- vapply(columns, `[[`, "", "unit")
  names <- with_unit(names(axis), unit)
  list(
    values = setNames(data.frame(lapply(columns, `[[`, "value")), names),
    unit = setNames(unit, names)
  )
}

field_column <- function(values, path, gear) {
  path <- paths_of(path)[1L]
  dimension <- field_dimension(gear, path)
  # as in the plan
  values[is.na(values)] <- first_of(plan_field(gear$plan, path)$value, NA)
  if (is.na(dimension)) return(list(value = values, unit = ""))
  split <- if (is.character(values)) lapply(values, split_quantity)
  units <- unique(vapply(split, function(text) plain_unit(text[2L]), ""))
  if (length(units) == 1L && nzchar(units)) {
    value <- as.double(vapply(split, `[[`, "", 1L))
  } else {
    value <- vapply(values, quantity_si, 0, dimension = dimension, USE.NAMES = FALSE)
    units <- names(plan_units[[dimension]])[1L]
    # a bare number has no unit
    if (dimension == "number") units <- ""
  }
  list(value = value, unit = units)
}

# The dimension of a quantity in a plan by its path, or NA.
field_dimension <- function(gear, path) {
  node <- path_node(gear$plan, path)
  if (node$shape == "any") {
    node <- first_of(Filter(function(choice) choice$shape == "quantity", node$choices)[1L][[1L]],
      node)
  }
  first_of(node[["x-dimension"]], NA_character_)
}
