# Files are read back by the format's specification (glTF 2.0, sections 3.6 and 4.4).

gltf_node <- function(found, name) {
  Filter(function(node) identical(node$name, name), found$tree$nodes)[[1]]
}

gltf_primitives <- function(found, name) {
  found$tree$meshes[[gltf_node(found, name)$mesh + 1]]$primitives
}

# Converts linear light to screen colours (sRGB).
on_screen <- function(light) {
  share <- ifelse(light <= 0.0031308, 12.92 * light, 1.055 * light^(1 / 2.4) - 0.055)
  grDevices::rgb(share[1, ], share[2, ], share[3, ])
}

test_that("glTF export writes ropes and twines as named, coloured lines", {
  folder <- test_folder()
  for (netting in c("bars", "cells")) {
    state <- settled("panel_in_current", nodes = 200, netting = netting)
    for (extension in c(".glb", ".gltf")) {
      file <- file.path(folder, paste0("net", extension))
      expect_identical(write_result(state, file), file)
      found <- read_gltf_file(file)
      expect_identical(found$tree$asset$version, "2.0")
      for (part in c("headline", "net")) {
        of_bars <- elements_of(state, "bar", part)
        if (!length(of_bars)) next
        lines <- gltf_primitives(found, part)[[1]]
        expect_identical(lines$mode, 1L)
        ends <- state_points(state)[, matrix(engine_array(state, "bars", "node"), 2L)[, of_bars]]
        # single precision has 24 bits for metres
        expect_equal(found$get(lines$attributes$POSITION), ends, tolerance = 2^-23)
        colour <- on_screen(found$get(lines$attributes$COLOR_0))
        scale <- tension_scale(
          state$bar_tension[parts_of(state)$kind[part_of(state, "bar")] ==
            if (part == "net") "netting" else "rope"],
          if (part == "net") "netting" else "rope"
        )
        expect_identical(colour,
          rep(toupper(tension_colours(scale, state$bar_tension[of_bars])), each = 2L))
      }
      if (netting == "cells") {
        sheet <- gltf_primitives(found, "net")[[2]]
        expect_identical(sheet$mode, 4L)
        # two triangles per cell, all with four corners
        corner <- matrix(engine_array(state, "cells", "node"), 4L)
        expect_equal(found$get(sheet$attributes$POSITION),
          state_points(state)[, c(corner[1:3, ], corner[c(1, 3, 4), ])], tolerance = 2^-23)
      }
    }
  }
})

test_that("glTF accessors fit their buffer and have correct limits", {
  file <- file.path(test_folder(), "trawl.glb")
  write_result(settled("midwater_trawl", nodes = 500), file, colours = "part")
  found <- read_gltf_file(file)
  expect_equal(found$tree$scenes[[1]]$extras$measures$door_spread_m,
    measures(settled("midwater_trawl", nodes = 500))[["door_spread_m"]],
    tolerance = 1e-14) # text with 15 digits
  at <- 0
  for (view in found$tree$bufferViews) {
    expect_identical(as.numeric(view$byteOffset), at)
    at <- at + view$byteLength
  }
  for (number in seq_along(found$tree$accessors) - 1) {
    accessor <- found$tree$accessors[[number + 1]]
    values <- found$get(number)
    expect_false(anyNA(values))
    if (accessor$componentType != 5126L) next
    expect_equal(apply(values, 1, min), unlist(accessor$min), tolerance = 1e-14)
    expect_equal(apply(values, 1, max), unlist(accessor$max), tolerance = 1e-14)
  }
})

test_that("glTF export has y up and spheres for pieces", {
  state <- unsettled(sheets_plan)
  file <- file.path(test_folder(), "sheets.gltf")
  write_result(state, file)
  found <- read_gltf_file(file)
  top <- found$tree$nodes[[found$tree$scenes[[1]]$nodes[[1]] + 1]]
  expect_identical(top$name, "Sheets <& 'quotes'>")
  q <- unlist(top$rotation)
  turn <- function(v) {
    # v + 2 w (u x v) + 2 u x (u x v) of a quaternion (u, w)
    cross <- function(a, b) c(a[2] * b[3] - a[3] * b[2], a[3] * b[1] - a[1] * b[3],
      a[1] * b[2] - a[2] * b[1])
    v + 2 * q[4] * cross(q[1:3], v) + 2 * cross(q[1:3], cross(q[1:3], v))
  }
  expect_equal(turn(c(0, 0, 1)), c(0, 1, 0))
  expect_equal(turn(c(1, 0, 0)), c(1, 0, 0))
  floats <- gltf_node(found, "floats")
  ball <- found$tree$nodes[[floats$children[[1]] + 1]]
  expect_equal(unlist(ball$scale), rep(0.06, 3))
  places <- found$get(found$tree$meshes[[ball$mesh + 1]]$primitives[[1]]$attributes$POSITION)
  expect_equal(colSums(places^2), rep(1, ncol(places)), tolerance = 1e-6)
  # its faces point outwards
  corner <- array(places, c(3, 3, ncol(places) / 3))
  outward <- apply(corner, 3, function(face) det(face))
  expect_true(all(outward > 0))
  expect_identical(gltf_node(found, "board")$extras$role, "otter_board")
})

test_that("glTF export shows a free otter board as a plate", {
  state <- unsettled(test_path("plans", "towed_board.yaml"))
  file <- file.path(test_folder(), "board.glb")
  write_result(state, file)
  found <- read_gltf_file(file)
  plate <- found$get(gltf_primitives(found, "otter_board")[[1]]$attributes$POSITION)
  expect_equal(unique(t(plate)), t(board_corners(state)), tolerance = 1e-6, ignore_attr = TRUE)
})

test_that("glTF export of a tow animates every saved time", {
  skip_if_not_installed("RNetCDF")
  folder <- test_folder()
  trajectory <- tow("towed_cable", until = 6, every = 2, nodes = 40,
    schedule = tow_schedule(speed = data.frame(time = c(0, 3), value = c("4 knot", "5 knot"))))
  file <- file.path(folder, "tow.glb")
  write_result(trajectory, file)
  found <- read_gltf_file(file)
  lines <- gltf_primitives(found, "cable")[[1]]
  expect_length(lines$targets, 3)
  first <- found$get(lines$attributes$POSITION)
  state <- state_at(trajectory, 6)
  ends <- state_points(state)[, engine_array(state, "bars", "node")]
  # single precision of positions up to 1000 m
  expect_equal(first + found$get(lines$targets[[3]]$POSITION), ends, tolerance = 2^-22)
  play <- found$tree$animations[[1]]
  at <- vapply(found$tree$nodes, function(node) identical(node$name, "cable"), NA)
  channel <- Filter(function(one) one$target$node == which(at) - 1, play$channels)[[1]]
  expect_identical(channel$target$path, "weights")
  sampler <- play$samplers[[channel$sampler + 1]]
  expect_equal(drop(found$get(sampler$input)), c(0, 2, 4, 6))
  # the initial shape, then each target
  expect_equal(matrix(found$get(sampler$output), 3), cbind(0, diag(3)))
  # from a shell, by the file of the tow
  kept <- file.path(folder, "tow.nc")
  write_result(trajectory, kept)
  again <- file.path(folder, "again.glb")
  run_export(c(kept, again), list())
  expect_identical(readBin(again, "raw", 1e7), readBin(file, "raw", 1e7))
})

test_that("glTF validator accepts a state and a tow", {
  folder <- test_path("..", "gltf")
  skip_if_not(dir.exists(file.path(folder, "node_modules", "gltf-validator")) &&
    nzchar(Sys.which("node")), "the validator of glTF is not here")
  made <- test_folder()
  kept <- list(
    trawl.glb = settled("midwater_trawl", nodes = 500),
    panel.gltf = settled("panel_in_current", nodes = 200, netting = "cells"),
    board.glb = unsettled(test_path("plans", "towed_board.yaml")),
    tow.glb = tow("towed_cable", until = 4, every = 2, nodes = 40)
  )
  for (name in names(kept)) {
    file <- write_result(kept[[name]], file.path(made, name))
    said <- system2("node", shQuote(c(file.path(folder, "validate.js"), file)), stdout = TRUE)
    found <- jsonlite::fromJSON(said)
    expect_identical(c(found$numErrors, found$numWarnings), c(0L, 0L), label = said)
  }
})
