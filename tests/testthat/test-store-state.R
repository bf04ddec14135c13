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
  expect_identical(get("z"), state$position[3, ])
  expect_identical(get("x_force"), state$force[1, ])
  expect_identical(get("bar_tension"), state$bar_tension)
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
  expect_identical(get("part_drag"), part_force_table(state)$drag_kN)
  expect_identical(get("part_name"), parts_of(state)$name)
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

test_that("Python's standard library reads a state's JSON", {
  skip_if_not(has_python("json"), "Python is not installed")
  file <- file.path(test_folder(), "state.json")
  for (name in c("towed_cable", "model_cage")) {
    state <- settled(name, nodes = 100)
    write_result(state, file)
    found <- read_with_python(file,
      "import json, sys",
      "state = json.load(open(sys.argv[1], encoding='utf-8'))",
      "measure = state['measures']['total_drag_kN']",
      "cut = {n: state['variables'][n] for n in ['x', 'bar_node', 'part_name']}",
      "print(json.dumps({'drag': [measure['value'], measure['error']], 'unit': measure['unit'],",
      "  'x': cut['x']['values'], 'node': cut['bar_node']['values'],",
      "  'across': cut['bar_node']['across'], 'parts': cut['part_name']['values']}))"
    )
    error <- attr(measures(state), "error")[["total_drag_kN"]]
    expect_identical(found$drag, c(measures(state)[["total_drag_kN"]], error))
    expect_identical(found$unit, "kN")
    expect_identical(found$x, state$position[1, ])
    expect_identical(found$node, t(matrix(engine_array(state, "bars", "node"), 2L)))
    expect_identical(found$across, c("bar", "bar_end"))
    expect_identical(found$parts, parts_of(state)$name)
  }
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
  expect_length(problems("state['variables']['x']['across'] = ['knot']"), 1)
  expect_length(problems("del state['plan']"), 1)
})
