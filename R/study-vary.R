#' Settle a gear in many designs
#'
#' Settles a gear once for every design: at several speeds, with several lengths of warp, several
#' boards; for every combination of some fields' values, or a table of [designs()]. One after
#' another, on all cores or on a cluster, as [future::plan()] says, and into a folder on disk, a
#' `store`, from which a study that was stopped goes on.
#'
#' @details
#' # What a run begins with
#' The gear itself is settled first, and every design from that state, never from a neighbour's;
#' anew where that does not lead to balance. So results are the same to the last bit on any number
#' of workers, in any order, stopped and gone on with or not; on machines of one kind, since
#' processors of other kinds may round otherwise.
#'
#' # Where it runs
#' In this session, unless the package future has another plan:
#'
#' - `future::plan("multisession")`: on all cores of this machine;
#' - `future::plan(future.batchtools::batchtools_slurm, template = "slurm.tmpl")`: as jobs of a
#'   cluster, which takes a `store` in a folder that all its machines see.
#'
#' Without R on the machine where jobs are handed in, a job array runs [run_study()] from a shell:
#' see there.
#'
#' Designs are dealt out in turn, so that tasks take alike long; a task of a cluster is made to take
#' about a minute. Nothing of the session goes along with a task but the store's path. Where a
#' worker ends, its task goes on elsewhere; a design that ended two workers is reported as not
#' settled. Jobs that are said to have expired are looked up in the store before they are run again.
#'
#' # The store
#' Each run is a file of its own in the store, written whole, when it is done; those of a whole task
#' are gathered in one. So the progress of a study is seen from anywhere ([study_status()]), what is
#' done can be read while the rest runs ([read_study()]), and a worker that is killed loses the run
#' that it was at. The same call of `vary()` again goes on with what is not done; at the same time
#' in another process it shares the work. The base state is
#' in the store as [write_result()] has it, which takes the package RNetCDF. Without `store` a
#' study in several processes has one in the session's temporary folder.
#'
#' Progress is shown by a bar after two seconds, or by what the package progressr is set to use.
#'
#' @param gear A gear, from [read_gear()] or the constructors, or the name or file of a plan.
#' @param ... Designs, from [designs()], or values by the path of their field, as in
#'   [update()][update.codend_gear]: `towing.speed = c("3 knot", "4 knot")`. Several fields are
#'   combined in every way, the first changing fastest. Fields that change together go as columns of
#'   a data frame without a name; what is missing there stays as in the plan.
#' @param nodes,netting As in [settle()].
#' @param store A folder for the study, which is made, or one of the same study that goes on. `NULL`
#'   keeps nothing.
#' @param tasks In how many tasks the designs are dealt out to workers; `NULL` chooses.
#' @return A data frame of class `codend_variations` with a row per design:
#'
#'   - the fields, by their path with their unit added (`towing.speed_knot`): the unit in which all
#'     values were given, else the SI unit;
#'   - `settled`, and `problem`: where there is no settled gear, why: values that do not go
#'     together in a plan, or no balance;
#'   - the estimated error of every measure, under `error.` and its name (`error.total_drag_kN`):
#'     that of the gear itself, as a share (see [measures()]);
#'   - `warning`: what [settle()] warned of, such as a stalled board;
#'   - the [measures()], `NA` where the gear did not settle or has no such measure.
#'
#'   A wrong field, or a value that its field does not take, is an error of class
#'   `codend_error_plan` that names the design, before anything is computed; wrong arguments are one
#'   of class `codend_error_argument`. A design that does not settle is no error.
#' @seealso [designs()], [codend_charts], [study_status()], [read_study()]
#' @export
#' @examples
#' found <- vary("towed_cable", towing.speed = paste(3:6, "knot"))
#' found[c("towing.speed_knot", "total_drag_kN")]
vary <- function(gear, ..., nodes = 1500, netting = NULL, store = NULL, tasks = NULL) {
  check_given("gear")
  study <- new_study(gear, list(...), nodes, netting)
  if (!is.null(tasks)) check_count("tasks", tasks, 1)
  if (!is.null(store)) {
    open_or_create(study, store)
    vary_stored(store, tasks)
    return(read_study(store))
  }
  if (!is.null(future_workers())) {
    if (future_cluster()) {
      abort_argument("On a cluster {.arg store} must be a folder that all its machines see.")
    }
    check_netcdf()
    store <- tempfile("study-")
    on.exit(unlink(store, recursive = TRUE))
    create_store(study, store)
    vary_stored(store, tasks)
    return(read_study(store))
  }
  # NULL where the gear does not settle
  base <- settle_one(study$gear, study$nodes, study$netting, NULL)$state
  show <- study_progress(nrow(study$designs))
  rows <- vapply(seq_len(nrow(study$designs)), function(k) {
    row <- run_design(study, base, k)
    show(k)
    row
  }, "")
  study_table(study, read_rows(rows))
}

# A study: list(gear, designs, nodes, netting), checked. given: as vary() takes designs.
new_study <- function(gear, given, nodes, netting) {
  if (is.character(gear)) gear <- read_gear(gear)
  check_settle_arguments(gear, nodes, netting)
  designs <- combined_designs(given)
  check_designs(designs, gear)
  list(gear = gear, designs = designs, nodes = as.double(nodes), netting = netting)
}

# Designs as given, or every combination of several axes.
combined_designs <- function(given) {
  if (!is.null(names(given))) names(given)[names(given) == "designs"] <- ""
  if (length(given) == 1L && inherits(given[[1L]], "codend_designs")) {
    design_axes(unname(given))
    return(given[[1L]])
  }
  drawn <- names(given)[vapply(given, is_distribution, NA)]
  if (length(drawn)) {
    abort_argument("{.arg {drawn[1]}} is a distribution, of which {.fn designs} draws.")
  }
  axes <- design_axes(given)
  place <- grid_of(lapply(axes, function(axis) seq_len(nrow(axis))))
  table <- do.call(cbind, lapply(seq_along(axes), function(k) {
    axes[[k]][place[, k], , drop = FALSE]
  }))
  new_designs(table, if (length(axes) == 1L) "table" else "grid", NULL, NULL, axes)
}

# Stops at the first field that the plan has not and at the first value that a field does not take.
# Whether values go together is found when the design's turn comes.
check_designs <- function(designs, gear) {
  for (name in names(designs)) {
    values <- designs[[name]]
    given <- which(!is.na(values))
    for (path in paths_of(name)) {
      for (k in given[telling_values(values[given])]) {
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

# Places of values of which all take the checks of a field if these do: the smallest and the largest
# of each unit, and everything that is no quantity.
telling_values <- function(values) {
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
    # of whole and of broken numbers
    unlist(lapply(split(rows, whole), function(some) {
      some[c(which.min(number[some]), which.max(number[some]))]
    }))
  }))
  sort(places[unique(c(odd, ends))])
}

# ---- one run -------------------------------------------------------------------------------------

# Settles design k. Returns its row as text. mark: of the study on disk, where it is on one.
run_design <- function(study, base, k, mark = NULL) {
  # messages are the same on every machine
  kept <- options(cli.unicode = FALSE, cli.num_colors = 1L, OutDec = ".", scipen = 0, digits = 7)
  on.exit(options(kept))
  fields <- design_fields(study$designs, k)
  found <- tryCatch(
    {
      gear <- do.call(update, c(list(study$gear), fields))
      from <- if (!is.null(base) && is.null(odd_parts(gear_si(gear), base))) base
      settle_one(gear, study$nodes, study$netting, from)
    },
    error = function(e) list(problem = plain_message(e))
  )
  row_text(k, found, mark)
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
    error = function(e) list(problem = plain_message(e), warning = warned)
  )
}

# ---- rows ----------------------------------------------------------------------------------------

# A row as a line of JSON, with numbers to the last bit.
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
  row <- sprintf("{\"design\":%d,%s\"problem\":%s,\"warning\":%s,\"measures\":{%s}}",
    as.integer(design), if (is.null(mark)) "" else sprintf("\"study\":\"%s\",", mark),
    text(found$problem), text(found$warning), paste(parts, collapse = ","))
  if (is.null(mark)) row else sealed_json(row)
}

# Rows by their text: list(design, problem, warning, measures = matrix with a column each, error =
# the same of their errors, unit).
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
      # stores of before have no errors
      if (length(part) > 2L && !is.null(part[[3L]])) errors[k, name] <- as.double(part[[3L]])
    }
  }
  list(
    design = sort(design), problem = said("problem"), warning = said("warning"), measures = values,
    error = errors, unit = unit
  )
}

# The columns with the errors of measures.
error_columns <- function(measures) if (length(measures)) paste0("error.", measures)

# What vary() returns of the rows that there are.
study_table <- function(study, rows) {
  designs <- study$designs
  fields <- field_columns(designs, study$gear)
  errors <- rows$error
  colnames(errors) <- error_columns(colnames(errors))
  table <- data.frame(
    fields$values[rows$design, , drop = FALSE], settled = is.na(rows$problem),
    problem = rows$problem, errors, warning = rows$warning, rows$measures,
    row.names = NULL, check.names = FALSE
  )
  structure(table, class = c("codend_variations", "data.frame"), gear_name = study$gear$plan$name,
    unit = c(fields$unit, rows$unit), study = list(
      how = attr(designs, "how"), number = attr(designs, "number"), design = rows$design,
      designs = nrow(designs), factors = attr(designs, "factors")
    ))
}

# A function(done) that shows a bar once a study has run for two seconds, or tells progressr.
study_progress <- function(total, done = 0L, frame = parent.frame()) {
  if (isNamespaceLoaded("progressr")) {
    tell <- progressr::progressor(steps = total, envir = frame)
    if (done > 0L) tell(amount = done)
    return(function(now) {
      if (now > done) tell(amount = now - done)
      done <<- now
    })
  }
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
