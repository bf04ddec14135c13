#' Settle a gear in many designs
#'
#' `vary()` settles a gear, that is, solves its static equilibrium, once for every design of a
#' study. Designs are all combinations of field values or a table from [designs()]. With a `store`
#' on disk, an interrupted study can continue.
#'
#' @details
#' # Initial state
#' The gear itself is settled first, as by [settle()] with the same arguments. All designs have its
#' number of nodes, so a design equal to the gear has the same measures. Every design starts from
#' this state, never from another design. If this start does not converge, the design is settled
#' from scratch. Results are therefore identical for any number of workers, any order and after
#' interruptions. Processors of other kinds may round differently.
#'
#' # Where it runs
#' A study runs in this session, unless the package future has another plan:
#'
#' - `future::plan("multisession")` uses all cores of this machine.
#' - `future::plan(future.batchtools::batchtools_slurm, template =
#'   "slurm.tmpl")` submits jobs to a cluster. It needs a `store` in a folder that all machines can
#'   access.
#'
#' If the login node of the cluster has no R, run [run_study()] from a shell in a job array.
#'
#' - Designs are distributed in rotation, so that tasks take equally long. A cluster task takes
#'   about a minute.
#' - A task receives only the path of the store, and no other object of the session.
#' - If a worker ends, another worker continues its task. A design that ended two workers counts as
#'   not settled.
#' - Jobs reported as expired are checked in the store before they run again.
#' - A progress bar appears after two seconds. If the package progressr is loaded, it reports the
#'   progress instead.
#'
#' # The store
#' - Each finished run is a separate file, written atomically. The files of a finished task are
#'   merged into one.
#' - [read_result()] reads finished designs while others run; its `summary()` shows the progress.
#' - A worker that is killed loses only its current run.
#' - The same call of `vary()` continues with missing designs. A simultaneous call in another
#'   process shares the work.
#' - The base state is stored as in [write_result()], which needs the package RNetCDF. Without
#'   `store`, a study in several processes uses the temporary folder of the session.
#'
#' @param gear A gear, from [read_gear()] or the constructors, or the name or file of a plan.
#' @param ... Designs from [designs()], or values by path: `towing.speed = paste(3:4, "knot")` or
#'   `towing.speed_knot = 3:4`.
#'   All their combinations are settled; the first field changes fastest. An unnamed data frame has
#'   fields that change together; `NA` keeps the value of the plan.
#' @param nodes,netting,accuracy As in [settle()], for the gear as given. By default this gear is
#'   settled on up to 3 meshes, for an error of 1 %. Each design is one more solve.
#' @param store Path of a folder for the study. It is created, or continued if it contains the same
#'   study. Default `NULL`: no store.
#' @param tasks Number of tasks for the workers. Default `NULL`: automatic. 0 only creates the
#'   `store`, for [run_study()].
#' @return A data frame of class `codend_variations`, one row per design:
#'
#'   - the fields, named by path and unit (`towing.speed_knot`). The unit is the one common to all
#'     given values, else the SI unit.
#'   - the [measures()], `NA` if the gear did not settle or lacks the measure. Their
#'     estimated errors are a column of the long table. As a fraction, an error equals the error of
#'     the gear itself.
#'   - `settled`: `TRUE` if the gear settled. `problem`: otherwise the reason, such as inconsistent
#'     plan values or no convergence.
#'   - `warning`: text of warnings from [settle()], such as a stalled board.
#'
#'   `as.data.frame()` returns a long table, a row per design and measure ([codend_tidy]). `print()`
#'   returns `x`, invisibly.
#'   A wrong field or value raises an error of class `codend_error_plan` that names the design,
#'   before any gear is settled. Wrong arguments raise `codend_error_argument`. A design that does
#'   not settle does not raise an error.
#' @seealso [designs()], [effects()][effects.codend_variations], [run_study()], [read_result()],
#'   [codend_charts].
#' @export
#' @examples
#' found <- vary("towed_cable", towing.speed = paste(3:6, "knot"))
#' found[c("towing.speed_knot", "total_drag_kN")]
vary <- function(gear, ..., nodes = NULL, netting = NULL, accuracy = NULL, store = NULL,
                 tasks = NULL) {
  check_given("gear")
  study <- new_study(gear, list(...), nodes, netting, accuracy)
  if (!is.null(tasks)) check_count("tasks", tasks, 0)
  only_create <- identical(as.double(tasks), 0)
  if (only_create && is.null(store)) {
    abort_argument("With {.code tasks = 0}, {.arg store} must be the path of a new folder.")
  }
  if (is.null(store) && !is.null(future_workers())) {
    if (future_cluster()) {
      abort_argument("On a cluster, {.arg store} must be a folder on a file system that all
        machines share.")
    }
    store <- tempfile("study-")
    on.exit(unlink(store, recursive = TRUE))
  }
  if (!is.null(store)) {
    open_or_create(study, store)
    if (!only_create) vary_stored(store, tasks)
    return(read_study(store))
  }
  base <- settle_first(study)$state
  show <- study_progress(nrow(study$designs))
  rows <- vapply(seq_len(nrow(study$designs)), function(k) {
    row <- run_design(study, base, k)
    show(k)
    row
  }, "")
  study_table(study, read_rows(rows))
}

# Returns a checked study: list(gear, designs, nodes, netting, accuracy (a fraction)).
# given: designs as in `vary()`.
new_study <- function(gear, given, nodes, netting, accuracy = NULL) {
  if (is.character(gear)) gear <- read_gear(gear)
  check_settle_arguments(gear, nodes, netting)
  designs <- columns_by_path(combined_designs(given), gear, "designs")
  check_designs(designs, gear)
  note_bare_numbers(gear$plan, designs[!grepl("+", names(designs), fixed = TRUE)])
  list(
    gear = gear, designs = designs, nodes = number_of(nodes), netting = netting,
    accuracy = accuracy_share(accuracy)
  )
}

# Returns the given designs, or every combination of several axes.
combined_designs <- function(given) {
  if (!is.null(names(given))) names(given)[names(given) == "designs"] <- ""
  if (length(given) == 1L && inherits(given[[1L]], "codend_designs")) {
    design_axes(unname(given))
    return(given[[1L]])
  }
  drawn <- names(given)[vapply(given, is_distribution, NA)]
  if (length(drawn)) {
    abort_argument("{.arg {drawn[1]}} is a distribution; use {.fn designs} to draw values.")
  }
  axes <- design_axes(given)
  place <- grid_of(lapply(axes, function(axis) seq_len(nrow(axis))))
  table <- do.call(cbind, lapply(seq_along(axes), function(k) {
    axes[[k]][place[, k], , drop = FALSE]
  }))
  new_designs(table, if (length(axes) == 1L) "table" else "grid", NULL, NULL, axes)
}

# Stops at the first unknown field or invalid value. Each design checks its combination of values.
check_designs <- function(designs, gear) {
  for (name in names(designs)) {
    values <- designs[[name]]
    given <- which(!is.na(values))
    for (path in paths_of(name)) {
      for (k in given[values_to_check(values[given])]) {
        tryCatch(
          {
            set_plan_field(gear$plan, path, values[[k]])
            node <- path_node(gear$plan, path)
            if (is.null(node)) abort_unknown("", path, character())
            check_field(values[[k]], node, path)
          },
          codend_error_plan = function(e) {
            abort_plan(paste0("Design ", k, ": ", conditionMessage(e)), e$path, e$value)
          }
        )
      }
    }
  }
}

# Returns indices of values that suffice for a check: the ends per unit, and everything else.
values_to_check <- function(values) {
  places <- which(!duplicated(values))
  if (length(places) < 100L) return(places)
  values <- values[places]
  number <- if (is.numeric(values)) values else {
    suppressWarnings(as.double(sub(quantity_pattern, "\\1", values, perl = TRUE)))
  }
  unit <- if (is.numeric(values)) rep("", length(values)) else {
    sub(quantity_pattern, "\\2", values, perl = TRUE)
  }
  odd <- which(!is.finite(number))
  ends <- unlist(lapply(split(which(is.finite(number)), unit[is.finite(number)]), function(rows) {
    whole <- number[rows] == round(number[rows])
    # A field can require whole numbers.
    unlist(lapply(split(rows, whole), function(some) {
      some[c(which.min(number[some]), which.max(number[some]))]
    }))
  }))
  sort(places[unique(c(odd, ends))])
}

# ---- one run -------------------------------------------------------------------------------------

# Settles design k. Returns its row as text. mark: MARK of the store, or NULL.
run_design <- function(study, base, k, mark = NULL) {
  # Messages must be identical on all machines.
  kept <- options(cli.unicode = FALSE, cli.num_colors = 1L, OutDec = ".", scipen = 0, digits = 7)
  on.exit(options(kept))
  fields <- design_fields(study$designs, k)
  found <- tryCatch(
    {
      gear <- with_fields(study$gear, fields)
      from <- if (!is.null(base) && is.null(odd_parts(gear_si(gear), base))) base
      nodes <- if (is.null(base)) requested_nodes(gear, study$nodes) else nodes_of(base)
      settle_one(gear, nodes, study$netting, from)
    },
    error = function(e) list(problem = plain_message(e))
  )
  row_text(k, found, mark)
}

# Settles the gear of a study as given, the initial state of every design.
settle_first <- function(study) {
  settle_one(study$gear, study$nodes, study$netting, NULL, study$accuracy)
}

settle_one <- function(gear, nodes, netting, from, accuracy = NULL) {
  warned <- NULL
  tryCatch(
    withCallingHandlers(
      {
        state <- settle(gear, nodes, netting, from, accuracy)
        list(state = state, measures = measures(state), warning = warned)
      },
      codend_warning = function(w) {
        warned <<- paste(c(warned, plain_message(w)), collapse = " ")
        invokeRestart("muffleWarning")
      }
    ),
    error = function(e) list(problem = plain_message(e), warning = warned)
  )
}

# ---- rows ----------------------------------------------------------------------------------------

# Returns a row as one line of JSON, with exact numbers.
row_text <- function(design, found, mark = NULL) {
  text <- function(value) {
    if (is.null(value)) return("null")
    as.character(jsonlite::toJSON(enc2utf8(value), auto_unbox = TRUE))
  }
  values <- plain_measures(found$measures)
  number <- function(x) ifelse(is.finite(x), sprintf("%.17g", x), "null")
  units <- attr(found$measures, "unit")
  parts <- if (length(values)) {
    sprintf("%s:[%s,%s,%s]", vapply(names(units), text, ""), number(values),
      vapply(units, text, ""), number(unname(attr(found$measures, "error"))))
  }
  main <- vapply(if (length(values)) printed_measures(found$measures), text, "")
  entries <- c(
    sprintf("\"design\":%d", as.integer(design)),
    if (!is.null(mark)) sprintf("\"study\":\"%s\"", mark),
    sprintf("\"problem\":%s,\"warning\":%s", text(found$problem), text(found$warning)),
    sprintf("\"main\":[%s]", paste(main, collapse = ",")),
    sprintf("\"measures\":{%s}", paste(parts, collapse = ","))
  )
  row <- sprintf("{%s}", paste(entries, collapse = ","))
  if (is.null(mark)) row else sealed_json(row)
}

# Returns list(design, problem, warning, measures and error (rows x measures), unit, main (names of
# the main measures)), sorted.
read_rows <- function(text) {
  rows <- lapply(text, jsonlite::fromJSON, simplifyVector = FALSE)
  design <- vapply(rows, function(row) as.integer(row$design), 0L)
  rows <- rows[order(design)]
  said <- function(what) vapply(rows, function(row) first_of(row[[what]], NA_character_), "")
  known <- unique(unlist(lapply(rows, function(row) names(row$measures))))
  values <- matrix(NA_real_, length(rows), length(known), dimnames = list(NULL, known))
  errors <- values
  unit <- setNames(character(length(known)), known)
  for (k in seq_along(rows)) {
    for (name in names(rows[[k]]$measures)) {
      part <- rows[[k]]$measures[[name]]
      if (!is.null(part[[1L]])) values[k, name] <- as.double(part[[1L]])
      unit[[name]] <- part[[2L]]
      # Compatibility: old stores lack errors.
      if (length(part) > 2L && !is.null(part[[3L]])) errors[k, name] <- as.double(part[[3L]])
    }
  }
  list(
    design = sort(design), problem = said("problem"), warning = said("warning"), measures = values,
    error = errors, unit = unit, main = as.character(unique(unlist(lapply(rows, `[[`, "main"))))
  )
}

# Returns the result of `vary()` for the finished rows.
study_table <- function(study, rows) {
  designs <- study$designs
  fields <- field_columns(designs, study$gear)
  values <- fields$values[rows$design, , drop = FALSE]
  with_designs <- function(...) data.frame(values, ..., row.names = NULL, check.names = FALSE)
  structure(
    with_designs(rows$measures, settled = is.na(rows$problem), problem = rows$problem,
      warning = rows$warning),
    class = c("codend_variations", "data.frame"), gear_name = study$gear$plan$name,
    unit = c(fields$unit, rows$unit), fields = names(values), main = rows$main,
    errors = with_designs(rows$error), study = list(
      how = attr(designs, "how"), number = attr(designs, "number"), design = rows$design,
      designs = nrow(designs), factors = attr(designs, "factors")
    )
  )
}

# Returns a function(done) that shows a progress bar after two seconds, or reports to progressr.
study_progress <- function(total, done = 0L, frame = parent.frame()) {
  report <- progressr_steps(total, done, frame)
  if (!is.null(report)) return(report)
  if (!cli::is_dynamic_tty() || total < 2L) return(function(now) NULL)
  begun <- proc.time()[["elapsed"]]
  bar <- NULL
  function(now) {
    if (is.null(bar)) {
      if (proc.time()[["elapsed"]] - begun < 2) return(NULL)
      bar <<- cli::cli_progress_bar(
        total = total, .envir = frame,
        format = "{cli::pb_bar} {cli::pb_current} of {cli::pb_total} settled, {cli::pb_eta} left"
      )
    }
    cli::cli_progress_update(set = now, id = bar, .envir = frame)
  }
}

# ---- fields as columns ---------------------------------------------------------------------------

# Returns list(values (data frame), unit (by column)). Column names end in their unit.
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
  if (anyNA(values)) {
    own <- plan_field(gear$plan, path)$value
    if (is.atomic(own) && length(own) == 1L) values[is.na(values)] <- own
  }
  if (is.na(dimension)) return(list(value = values, unit = ""))
  text <- is.character(values)
  units <- if (text) {
    found <- sub(quantity_pattern, "\\2", values[!is.na(values)], perl = TRUE)
    unique(vapply(unique(found), plain_unit, ""))
  } else {
    ""
  }
  if (length(units) == 1L && nzchar(units)) {
    value <- as.double(sub(quantity_pattern, "\\1", values, perl = TRUE))
  } else {
    value <- vapply(values, function(one) {
      if (is.na(one)) NA_real_ else quantity_si(one, dimension)
    }, 0, USE.NAMES = FALSE)
    units <- names(plan_units[[dimension]])[1L]
    # A bare number is dimensionless.
    if (dimension == "number") units <- ""
  }
  list(value = value, unit = units)
}

# Returns a table with its columns of fields named by path: `towing.speed_knot` of numbers becomes
# `towing.speed` of text in knot. `name`: argument in errors.
columns_by_path <- function(table, gear, name) {
  old <- names(table)
  table <- with_named_units(table, function(column) {
    field_dimension(gear, paths_of(column)[1L])
  }, name)
  if (!is.null(attr(table, "factors"))) {
    factors <- strsplit(attr(table, "factors"), ", ", fixed = TRUE)
    attr(table, "factors") <- vapply(factors, function(axis) {
      paste(names(table)[match(axis, old)], collapse = ", ")
    }, "")
  }
  table
}

# Returns the dimension of a plan field, or NA.
field_dimension <- function(gear, path) {
  node <- path_node(gear$plan, path)
  if (is.null(node)) return(NA_character_)
  if (node$shape == "any") {
    node <- first_of(Filter(function(choice) choice$shape == "quantity", node$choices)[1L][[1L]],
      node)
  }
  first_of(node[["x-dimension"]], NA_character_)
}
