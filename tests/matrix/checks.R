# The checks of a plan, a state and a tow: functions of the object and a folder, by name. Each check
# stops if a result is wrong.

few_nodes <- 60

skip <- function() structure(list(), class = "skipped")

check_printed <- function(x) {
  lines <- utils::capture.output(print(x))
  if (length(lines) > 30L) stop_check("%d lines are printed", length(lines))
  text <- paste(sub(": print\\(x, n = Inf\\)$", "", lines), collapse = "\n")
  if (!nzchar(text)) stop_check("nothing is printed")
  check_words(text, "the text")
}

# tolerance: relative to the largest expected number, or to 1 if all are smaller.
check_near <- function(result, expected, tolerance, what) {
  scale <- if (is.numeric(expected)) max(abs(expected), 1, na.rm = TRUE)
  same <- all.equal(as.vector(result), as.vector(expected), tolerance = tolerance, scale = scale)
  if (!isTRUE(same)) stop_check("%s: %s", what, same[1L])
}

check_plot <- function(x, folder, extensions) {
  for (extension in extensions) {
    written(file.path(folder, paste0("plot.", extension)), function(file) plot(x, file = file))
  }
}

# Exports x in every format. checks: functions of a file and x, by the end of the file's name.
check_exports <- function(x, what, checks, folder) {
  for (format in codend:::formats_of(what)) {
    file <- file.path(folder, paste0(what, format$extension))
    format$write(x, file)
    check <- checks[[tools::file_ext(file)]]
    if (is.null(check)) stop_check("tests/matrix/checks.R has no check of %s", format$name)
    check(file, x)
  }
}

# Errors of measures are relative, or missing.
check_measures <- function(result) {
  error <- attr(result, "error")
  check_finite(as.numeric(result), "measures")
  if (!all(is.na(error) | (is.finite(error) & error >= 0))) stop_check("an error is negative")
  if (!all(nzchar(names(result))) || anyDuplicated(names(result))) stop_check("measures lack names")
}

# ---- plans ---------------------------------------------------------------------------------------

gear_checks <- list(
  "print" = function(gear, folder) check_printed(gear),
  "summary" = function(gear, folder) {
    result <- summary(gear)
    check_printed(result)
    for (table in c("parts", "totals", "netting")) {
      check_table(result[[table]], nrow(result[[table]]), table, "length_m")
    }
    check_near(sum(result$parts$mass_kg), sum(result$totals$mass_kg) / 2, 1e-9, "total mass")
  },
  "findings" = function(gear, folder) {
    result <- findings(gear)
    if (nrow(result)) stop_check("a shipped plan has the finding: %s", result$message[1L])
  },
  "write_gear" = function(gear, folder) {
    readers <- list(plan.yaml = yaml::read_yaml, plan.json = jsonlite::read_json)
    for (name in names(readers)) {
      file <- file.path(folder, name)
      write_gear(gear, file)
      if (!identical(readers[[name]](file)$name, gear$plan$name)) stop_check("%s has no name", name)
      if (!identical(read_gear(file)$plan, gear$plan)) stop_check("%s is another plan", name)
    }
  },
  "plan drawing" = function(gear, folder) check_plot(gear, folder, c("svg", "pdf", "png", "dxf"))
)

# ---- states --------------------------------------------------------------------------------------

engine_of <- function(state) state$mesh$model

netting_of <- function(state) if (length(engine_of(state)$cells$rest)) "cells" else "bars"

state_checks <- list(
  "equilibrium" = function(state, folder) {
    if (!state$report$converged) stop_check("the state has not converged")
    engine <- engine_of(state)
    held <- as.logical(engine$held)
    tension <- state$report$largest_tension
    free <- state$force[, !held, drop = FALSE]
    residual <- sqrt(max(colSums(free^2)))
    if (!(residual <= 1e-8 * tension)) {
      stop_check("the residual is %g of the largest tension", residual / tension)
    }
    external <- rowSums(matrix(engine$load, 3L)) +
      rowSums(vapply(state$forces, rowSums, numeric(3)))
    missed <- max(abs(rowSums(state$force[, held, drop = FALSE]) - external + rowSums(free)))
    # the rounding error of the sums is far below 1e-12 of the tension per node
    if (!(missed <= 1e-12 * tension * engine$nodes)) {
      stop_check("reactions differ from external forces by %g N", missed)
    }
  },
  "settle(from = state)" = function(state, folder) {
    again <- settle(state$gear, nodes = few_nodes, netting = netting_of(state), from = state)
    if (again$report$iterations != 0L) stop_check("the state takes further steps")
    if (again$report$factorisations != 0L) stop_check("the state is factorised again")
    if (!identical(again$position, state$position)) stop_check("the state moves")
  },
  "measures" = function(state, folder) {
    result <- measures(state)
    check_measures(result)
    check_printed(result)
    check_table(measure_definitions(state), length(result), "definitions", "sensor")
  },
  "summary" = function(state, folder) {
    result <- summary(state)
    check_printed(result)
    total <- result$drag_totals$drag_kN[result$drag_totals$group == "total"]
    check_near(total, measures(state)[["total_drag_kN"]], 1e-6, "total drag")
    check_printed(state)
  },
  "findings" = function(state, folder) {
    result <- findings(state)
    check_table(result, nrow(result), "findings", c("value", "field"))
    check_words(paste(result$message, result$advice, result$label), "a finding")
  },
  "tables" = function(state, folder) {
    engine <- engine_of(state)
    si <- state$si
    drag <- as.data.frame(state, what = "drag")
    outer <- !drag$kind %in% c("rope", "netting", "piece", "catch")
    rows <- c(
      tensions = length(engine$bars$rest) + 2 * length(engine$cells$rest) +
        sum(engine$cells$straight > 0),
      nodes = ncol(state$position), measures = length(measures(state)),
      drag = sum(outer) + length(si$ropes) + length(si$panels) + length(si$pieces) +
        length(si$otter_boards) +
        !is.null(si$catch),
      boards = sum(engine$plates$area > 0)
    )
    for (what in names(rows)) {
      check_table(as.data.frame(state, what = what), rows[[what]], what, c("role", "error"))
    }
    pieces <- as.data.frame(state, what = "pieces")
    check_table(pieces, nrow(pieces), "pieces", "role")
    at_a_point <- names(Filter(function(piece) length(piece$at) > 0L, si$pieces))
    check_near(unique(pieces$part), at_a_point, 0, "names of pieces")
    reactions <- as.data.frame(state, what = "reactions")
    held <- state$force[, as.logical(engine$held), drop = FALSE]
    check_near(colSums(reactions[-1L]), -rowSums(held) / 1000, 1e-9, "sum of reactions")
  },
  "table of rope tensions" = function(state, folder) {
    if (!length(state$si$ropes)) return(skip())
    result <- as.data.frame(state, what = "rope_tensions")
    check_table(result, nrow(result), "tensions along ropes", "role")
    missing <- setdiff(names(state$si$ropes), unlist(strsplit(result$rope, ", ")))
    if (length(missing)) stop_check("rope %s is missing", missing[1L])
    check_plot(result, folder, "png")
  },
  "table of mesh openings" = function(state, folder) {
    if (!length(state$si$panels)) return(skip())
    result <- as.data.frame(state, what = "mesh_openings")
    check_table(result, nrow(result), "mesh openings", "mesh_angle_deg")
    check_plot(result, folder, "png")
  },
  "sensitivities" = function(state, folder) {
    result <- sensitivities(state, secants = FALSE)
    fields <- length(unique(result$field))
    check_table(result, length(measures(state)) * fields, "sensitivities",
      c("elasticity", "secant_below", "secant_above", "smooth"))
    if (all(result$derivative == 0)) stop_check("no field changes a measure")
    check_printed(result)
    check_plot(result, folder, "png")
  },
  "plot" = function(state, folder) check_plot(state, folder, c("svg", "png")),
  "view_3d" = function(state, folder) {
    written(file.path(folder, "view.html"), function(file) view_3d(state, file))
  },
  "report" = function(state, folder) {
    body <- written(file.path(folder, "report.html"), function(file) report(state, file))
    rows <- xml2::xml_find_all(body, "//section[h2 = 'Measures']//table/tbody/tr")
    if (length(rows) != length(measures(state))) stop_check("the report lacks measures")
  },
  "exports" = function(state, folder) {
    check_exports(state, "state", state_files, folder)
  },
  "ropes for MoorDyn" = function(state, folder) {
    file <- file.path(folder, "ropes.txt")
    refusal <- tryCatch({
      write_result(state, file)
      NULL
    }, codend_error_argument = conditionMessage)
    # MoorDyn has no netting, rings or slopes
    if (length(refusal)) {
      known <- "has no free rope|slides through rings|slopes"
      if (!grepl(known, refusal)) stop_check("refused: %s", refusal)
      return(skip())
    }
    check_words(file_text(file), "the file of MoorDyn")
    if (!any(grepl("^-+ LINES", readLines(file)))) stop_check("the file of MoorDyn has no lines")
  }
)

state_files <- list(
  vtu = function(file, state) {
    grid <- read_vtu(file)
    check_near(grid$Points[[1L]][, seq_len(ncol(state$position))], state$position, 1e-12, "points")
    elements <- length(engine_of(state)$bars$rest) + length(engine_of(state)$cells$rest)
    if (grid$n_cells < elements) stop_check("the grid lacks elements")
  },
  glb = function(file, state) read_gltf(file),
  gltf = function(file, state) read_gltf(file),
  nc = function(file, state) {
    nc <- RNetCDF::open.nc(file)
    on.exit(RNetCDF::close.nc(nc))
    check_near(RNetCDF::var.get.nc(nc, "x_m"), state$position[1L, ], 0, "x")
    if (length(state$bar_tension)) {
      check_near(RNetCDF::var.get.nc(nc, "bar_tension_N"), state$bar_tension, 0, "tension of bars")
    }
    check_near(measures(read_result(file)), measures(state), 0, "measures of the file")
  },
  json = function(file, state) {
    variables <- jsonlite::fromJSON(file_text(file))$variables
    check_near(variables$x_m$values, state$position[1L, ], 0, "x")
    check_finite(variables, "the file of JSON")
  },
  csv = function(file, state) {
    table <- utils::read.csv(file, check.names = FALSE)
    expected <- as.data.frame(state, what = "tensions")
    check_table(table, nrow(expected), "the table", "role")
    check_near(table$tension_kN, expected$tension_kN, 1e-12, "tensions")
  }
)

# ---- tows ----------------------------------------------------------------------------------------

short_tow <- function(gear, netting) {
  tow(gear, until = 0.2, every = 0.1, nodes = few_nodes, netting = netting)
}

tow_checks <- list(
  "motion" = function(tow, folder) {
    check_near(tow$time, c(0, 0.1, 0.2), 1e-6, "times")
    check_finite(tow[c("position", "velocity", "bar_tension")], "the motion")
    check_printed(tow)
    check_printed(summary(tow))
  },
  "tables" = function(tow, folder) {
    times <- length(tow$time)
    measured <- lapply(tow$time, function(time) measures(state_at(tow, time)))
    for (one in measured) check_measures(one)
    rows <- c(measures = sum(lengths(measured)), conditions = times, swept = times,
      tensions = times * (length(tow$si$ropes) + length(tow$si$panels)),
      nodes = times * dim(tow$position)[2L])
    for (what in names(rows)) {
      check_table(as.data.frame(tow, what = what), rows[[what]], what,
        c("role", "error", "time_error", "mesh_error", "swept_volume_m3", "swept_area_m2"))
    }
  },
  "exports" = function(tow, folder) {
    check_exports(tow, "trajectory", tow_files, folder)
    file <- file.path(folder, "tow.nc")
    write_result(tow, file)
    nc <- RNetCDF::open.nc(file)
    on.exit(RNetCDF::close.nc(nc))
    check_near(RNetCDF::var.get.nc(nc, "x_m"), tow$position[1L, , ], 0, "x")
    check_near(read_result(file)$position, tow$position, 0, "positions of the file")
  },
  "plot" = function(tow, folder) check_plot(tow, folder, "svg"),
  "view_3d" = function(tow, folder) {
    written(file.path(folder, "tow.html"), function(file) view_3d(tow, file))
  },
  "report" = function(tow, folder) {
    written(file.path(folder, "report.html"), function(file) report(tow, file))
  }
)

tow_files <- list(
  pvd = function(file, tow) {
    sets <- xml2::xml_find_all(xml2::read_xml(file), "//DataSet")
    check_near(as.double(xml2::xml_attr(sets, "timestep")), tow$time, 1e-9, "times of the grids")
    for (grid in xml2::xml_attr(sets, "file")) read_vtu(file.path(dirname(file), grid))
  },
  glb = function(file, tow) read_gltf(file),
  gltf = function(file, tow) {
    if (!length(read_gltf(file)$tree$animations)) stop_check("the scene does not move")
  }
)
