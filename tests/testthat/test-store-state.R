skip_if_not_installed("RNetCDF")

test_that("saved state is read back identically", {
  folder <- test_folder()
  file <- file.path(folder, "state.nc")
  states <- list(
    settled("panel_in_current", nodes = 200, netting = "cells"),
    settled("panel_in_current", nodes = 200, netting = "bars"),
    state_at(tow("towed_cable", until = 10, every = 5), 5)
  )
  for (state in states) {
    expect_identical(write_result(state, file), file)
    found <- read_result(file)
    expect_identical(plain_result(found), plain_result(state))
    expect_identical(measures(found), measures(state))
  }
  expect_identical(list.files(folder, all.files = TRUE, no.. = TRUE), "state.nc")
  expect_identical(settle(states[[1]]$gear, nodes = 200, from = {
    write_result(states[[1]], file)
    read_result(file)
  })$position, settle(states[[1]]$gear, nodes = 200, from = states[[1]])$position)
})

test_that("saved state is plain NetCDF with CF units", {
  file <- file.path(test_folder(), "state.nc")
  state <- settled("midwater_trawl", nodes = 500)
  write_result(state, file)
  nc <- RNetCDF::open.nc(file)
  on.exit(RNetCDF::close.nc(nc))
  get <- function(name) as.vector(RNetCDF::var.get.nc(nc, name))
  expect_identical(get("z_m"), state$position[3, ])
  expect_identical(get("x_force_N"), state$force[1, ])
  expect_identical(get("bar_tension_N"), state$bar_tension)
  for (name in names(measures(state))) expect_identical(get(name), measures(state)[[name]])
  unit <- function(name) RNetCDF::att.get.nc(nc, name, "units")
  expect_identical(unit("door_spread_m"), "m")
  expect_identical(unit("swept_area_km2_per_h"), "km2 h-1")
  expect_identical(unit("slack_netting_percent"), "percent")
  # the UDUNITS library knows every unit, as the conventions require
  info <- RNetCDF::file.inq.nc(nc)
  for (id in seq_len(info$nvars) - 1L) {
    known <- RNetCDF::var.inq.nc(nc, id)
    has_unit <- "units" %in% vapply(seq_len(known$natts) - 1L, function(k) {
      RNetCDF::att.inq.nc(nc, id, k)$name
    }, "")
    if (has_unit && unit(known$name) != "1") {
      expect_match(unit(known$name), paste0(
        "^(m|m2|m3|N|kN|kW|degree|percent|km2 h-1|m3 h-1|l h-1|l km-2|1e-9)$"
      ))
    }
  }
  expect_identical(get("drag_kN"), part_force_table(state)$drag_kN)
  expect_identical(get("part"), parts_of(state)$name)
})

test_that("read_result() rejects other files with the reason", {
  folder <- test_folder()
  file <- file.path(folder, "other.nc")
  expect_error(read_result(file), "does not exist", class = "codend_error_file")
  write_netcdf(file, function(nc) RNetCDF::dim.def.nc(nc, "node", 3))
  expect_error(read_result(file), "no state", class = "codend_error_file")
  writeLines("text", file)
  expect_error(read_result(file), "not a NetCDF file", class = "codend_error_file")
})

# Returns the lines that a shipped program in Python prints for a file, split at spaces.
example_output <- function(program, file) {
  program <- system.file("examples", program, package = "codend")
  strsplit(system2(python, shQuote(c(program, file)), stdout = TRUE), " ")
}

test_that("examples in Python print the measures and tensions of R", {
  skip_if_not(has_python("xarray") && has_python("netCDF4"), "xarray is not installed")
  folder <- test_folder()
  for (name in c("poly_noreastern_trawl", "crossing_cables")) {
    state <- settled(name, nodes = 300)
    found <- measures(state)
    bar <- which.max(state$bar_tension)
    node <- engine_array(state, "bars", "node")[2L * bar - 1L]
    for (extension in c("json", "netcdf")) {
      file <- file.path(folder, paste0("state.", c(json = "json", netcdf = "nc")[[extension]]))
      write_result(state, file)
      printed <- example_output(sprintf("read_%s.py", extension), file)
      expect_match(paste(printed[[1]], collapse = " "), state$gear$plan$name, fixed = TRUE)
      rows <- do.call(rbind, lapply(printed[1 + seq_along(found)], `[`, 1:3))
      expect_identical(rows[, 1], names(found))
      # both languages print numbers that are read back exactly
      expect_identical(as.double(rows[, 2]), unname(plain_measures(found)))
      expect_identical(as.double(rows[, 3]), unname(attr(found, "error")))
      last <- printed[[length(printed)]]
      expect_identical(last[2], parts_of(state)$name[state$mesh$bar_part[bar]])
      expect_identical(as.double(last[-(1:2)]),
        c(state$bar_tension[bar], state$position[, node]))
    }
  }
})

test_that("names in NetCDF, JSON and tables of a state are the same", {
  folder <- test_folder()
  state <- settled("model_cage", nodes = 100)
  for (file in file.path(folder, c("state.nc", "state.json"))) write_result(state, file)
  json <- jsonlite::fromJSON(file.path(folder, "state.json"))
  nc <- RNetCDF::open.nc(file.path(folder, "state.nc"))
  on.exit(RNetCDF::close.nc(nc))
  info <- RNetCDF::file.inq.nc(nc)
  inside <- vapply(seq_len(info$nvars) - 1L, function(id) RNetCDF::var.inq.nc(nc, id)$name, "")
  expect_setequal(grep("^saved_", inside, value = TRUE, invert = TRUE),
    c(names(json$measures), names(json$variables)))
  expect_named(json$measures, names(measures(state)))
  tables <- list(nodes = c("x_m", "y_m", "z_m"), drag = c("part", "drag_kN", "side_kN", "lift_kN",
    "weight_in_water_kN"))
  for (what in names(tables)) {
    table <- as.data.frame(state, what = what)
    # further rows of the table of drag, such as the sea bed, are no parts
    if (what == "drag") table <- table[match(parts_of(state)$name, table$part), ]
    for (name in tables[[what]]) expect_identical(json$variables[[name]]$values, table[[name]])
  }
  held <- as.data.frame(state, what = "nodes")$held
  expect_identical(json$variables$held$values, as.integer(held))
})

test_that("JSON of a state satisfies its schema", {
  skip_if_not(has_python("jsonschema"), "jsonschema for Python is not installed")
  file <- file.path(test_folder(), "state.json")
  write_result(settled("model_cage", nodes = 100), file)
  schema <- system.file("schema", "state.schema.json", package = "codend")
  problems <- function(change = "") {
    read_with_python(file,
      "import json, jsonschema, sys",
      "state = json.load(open(sys.argv[1], encoding='utf-8'))", change,
      sprintf("schema = json.load(open('%s'))", schema),
      "check = jsonschema.Draft202012Validator(schema)",
      "print(json.dumps([e.message for e in check.iter_errors(state)]))")
  }
  expect_length(problems(), 0)
  expect_length(problems("state['variables']['x_m']['across'] = ['knot']"), 1)
  expect_length(problems("del state['plan']"), 1)
  ran <- run_command(c("settle", "towed_cable", "--nodes", "20", "--uncertainty", "--json", file))
  expect_identical(ran, 0L)
  expect_length(problems(), 0)
})
