# Uses VTK's own reader in Python if it is installed (Debian: python3-vtk9). Otherwise the files are
# read by the format's specification.
read_with_vtk <- function(file) {
  read_with_python(file,
    "import json, math, sys, vtk",
    "reader = vtk.vtkXMLUnstructuredGridReader()",
    "reader.SetFileName(sys.argv[1])",
    "reader.Update()",
    "grid = reader.GetOutput()",
    "def values(a):",
    "    found = [a.GetValue(i) for i in range(a.GetNumberOfValues())]",
    "    return [None if math.isnan(x) else x for x in found]",
    "def arrays(d):",
    "    every = [d.GetAbstractArray(i) for i in range(d.GetNumberOfArrays())]",
    "    return {a.GetName(): values(a) for a in every}",
    "def corners(c):",
    "    return [c.GetPointId(k) for k in range(c.GetNumberOfPoints())]",
    "count = range(grid.GetNumberOfCells())",
    "print(json.dumps({'points': values(grid.GetPoints().GetData()),",
    "    'types': [grid.GetCellType(i) for i in count],",
    "    'corners': [p for i in count for p in corners(grid.GetCell(i))],",
    "    'point': arrays(grid.GetPointData()), 'cell': arrays(grid.GetCellData()),",
    "    'field': arrays(grid.GetFieldData())}))"
  )
}

test_that("VTK's own reader returns every exported number", {
  skip_if_not(has_python("vtk"), "VTK for Python is not installed")
  folder <- test_folder()
  for (netting in c("bars", "cells")) {
    state <- settled("panel_in_current", nodes = 200, netting = netting)
    file <- file.path(folder, "panel.vtu")
    expect_identical(write_result(state, file), file)
    found <- read_with_vtk(file)
    expect_identical(found$points, as.vector(state_points(state)))
    bars <- length(engine_array(state, "bars", "rest"))
    cells <- length(engine_array(state, "cells", "rest"))
    expect_identical(found$types[seq_len(bars + cells)], rep(c(3L, 9L), c(bars, cells)))
    expect_true(all(found$types[-seq_len(bars + cells)] == 1L))
    corners <- c(engine_array(state, "bars", "node"), engine_array(state, "cells", "node"))
    expect_identical(found$corners[seq_along(corners)] + 1L, corners)
    expect_identical(
      part_names_of(found$field)[found$cell$part[seq_len(bars + cells)]],
      parts_of(state)$name[c(part_of(state, "bar"), part_of(state, "cell"))]
    )
    expect_identical(found$cell$tension_N[seq_len(bars)], state$bar_tension)
    if (cells) {
      expect_identical(found$cell$v_tension_N[bars + seq_len(cells)], state$v_tension)
    }
    expect_identical(
      matrix(found$point$force_N, 3L)[, seq_len(engine_array(state, "nodes"))], state$force
    )
    for (name in names(measures(state))) {
      expect_identical(found$field[[name]], measures(state)[[name]])
    }
    plan <- file.path(folder, "plan.yaml")
    writeBin(as.raw(found$field$plan), plan)
    expect_identical(read_gear(plan)$plan, state$gear$plan)
  }
})

test_that("meshio opens exported grids", {
  skip_if_not(has_python("meshio"), "meshio is not installed")
  file <- file.path(test_folder(), "panel.vtu")
  state <- settled("panel_in_current", nodes = 200, netting = "cells")
  write_result(state, file)
  found <- read_with_python(file,
    "import meshio, json, sys, io, contextlib",
    "mesh = meshio.read(sys.argv[1])",
    "cells = {b.type: len(b.data) for b in mesh.cells}",
    "print(json.dumps({'points': mesh.points.ravel().tolist(), 'cells': cells,",
    "  'drag': float(mesh.field_data['total_drag_kN'][0]),",
    "  'names': bytes(mesh.field_data['part_names']).decode('utf-8').split('\\n')}))"
  )
  expect_identical(found$points, as.vector(state_points(state)))
  expect_identical(found$cells$quad, length(engine_array(state, "cells", "rest")))
  expect_identical(found$drag, measures(state)[["total_drag_kN"]])
  expect_identical(found$names, parts_of(state)$name)
})

test_that("VTK export writes forces that sum to the gear's drag", {
  file <- file.path(test_folder(), "net.vtu")
  for (netting in c("bars", "cells")) {
    state <- settled("panel_in_current", nodes = 200, netting = netting)
    write_result(state, file)
    found <- read_raw_vtu(file)
    drag <- as.data.frame(state, what = "drag")
    # forces of the sea bed and of loads are at nodes
    drag <- drag[drag$kind %in% parts_of(state)$kind, ]
    # sums of the same numbers in another order
    part_name <- part_names_of(found$FieldData)[found$CellData$part]
    for (name in unique(part_name)) {
      mine <- part_name == name
      force <- rowSums(found$CellData$drag_N[, mine, drop = FALSE])
      if (name == "net") force <- force + rowSums(found$PointData$knot_drag_N)
      along <- sum(force * flow_axes(state$si)[, "flow"])
      expect_equal(along, 1000 * drag$drag_kN[drag$part == name], tolerance = 1e-10)
    }
    expect_setequal(unique(part_name), drag$part)
    expect_equal(found$PointData$depth_m, 0 - found$Points$points[3, ])
    expect_equal(sum(found$PointData$held), 2)
    expect_identical(part_names_of(found$FieldData), parts_of(state)$name)
  }
})

test_that("VTK export writes slack and tension of both twine families", {
  file <- file.path(test_folder(), "net.vtu")
  state <- settled("hung_panel")
  write_result(state, file)
  found <- read_raw_vtu(file)
  cells <- found$CellData
  net <- part_names_of(found$FieldData)[cells$part] == "net"
  expect_identical(cells$tension_N[net], pmax(state$u_tension, state$v_tension))
  # crosswise twines are slack, lengthwise twines are taut
  expect_true(all(cells$slack[net] == 0.5))
})

test_that("VTK export writes hexagonal meshes and a catch", {
  net <- list(
    mesh_size = 0.144, meshes = list(upper = 5, lower = 5, deep = 20), orientation = "hexagonal",
    straight_bar = 0.012, twine = list(diameter = 0.003, material = "PA")
  )
  plan <- bag_plan(net, circle_of_corners(4, 0.4), list(blocked_meshes = 8))
  state <- unsettled(plan)
  file <- file.path(test_folder(), "bag.vtu")
  write_result(state, file)
  found <- read_raw_vtu(file)
  expect_identical(found$CellData$straight_tension_N[found$CellData$kind == 2],
    state$straight_tension)
  expect_equal(rowSums(found$CellData$catch_force_N), rowSums(state$forces$pressure_force))
  expect_gt(sum(abs(state$forces$pressure_force)), 0)
  # families without tension out of three
  expect_true(all(round(3 * found$CellData$slack[found$CellData$kind == 2]) ==
    (state$u_tension == 0) + (state$v_tension == 0) + (state$straight_tension == 0)))
})

test_that("VTK export shows a free otter board as a plate", {
  state <- unsettled(test_path("plans", "towed_board.yaml"))
  board <- state$si$otter_boards[[1]]
  at <- nodes_at(state, board$points)
  turn <- qr.Q(qr(matrix(c(2, 1, 0, -1, 3, 1, 1, 1, 4), 3L)))
  if (det(turn) < 0) turn <- -turn
  state$position[, at] <- turn %*% board$attachment + c(5, 6, -7)
  corner <- rbind(c(0, 0, board$chord, board$chord), 0, c(-0.5, 0.5, 0.5, -0.5) * board$span)
  expect_equal(board_corners(state), turn %*% corner + c(5, 6, -7))
  file <- file.path(test_folder(), "board.vtu")
  write_result(state, file)
  found <- read_raw_vtu(file)
  quad <- which(found$Cells$types == 9)
  expect_identical(part_names_of(found$FieldData)[found$CellData$part[quad]], "otter_board")
  expect_equal(found$n_points, ncol(state_points(state)) + 4L)
  expect_equal(found$CellData$drag_N[, quad], drop(state$forces$plate_force))
})

test_that("VTK export of a tow is a series over the ground", {
  folder <- test_folder()
  file <- file.path(folder, "turn.pvd")
  turn <- tow("towed_cable", until = 30, every = 15,
    schedule = tow_schedule(course = data.frame(time = c(0, 10, 30), value = c(0, 0, 1))))
  expect_identical(write_result(turn, file), file)
  expect_setequal(list.files(folder, all.files = TRUE, no.. = TRUE), c("turn", "turn.pvd"))
  lines <- grep("<DataSet", readLines(file), value = TRUE)
  expect_equal(as.numeric(sub(".*timestep=\"([^\"]*)\".*", "\\1", lines)), turn$time)
  files <- sub(".*file=\"([^\"]*)\".*", "\\1", lines)
  for (k in seq_along(files)) {
    found <- read_raw_vtu(file.path(folder, files[k]))
    nodes <- seq_len(ncol(turn$position))
    expect_identical(found$Points$points[, nodes], turn$position[, , k])
    expect_identical(found$PointData$velocity_m_per_s[, nodes], turn$velocity[, , k])
    expect_identical(found$FieldData$TimeValue, turn$time[k])
    # the drag of the cable, in axes over the ground, opposes its motion through the water
    drag <- rowSums(found$CellData$drag_N)
    expect_lt(sum(drag * rowMeans(turn$velocity[, , k])), 0)
  }
  # a second export replaces only its own files
  write_result(turn, file)
  writeLines("mine", file.path(folder, "turn", "notes.txt"))
  expect_error(write_result(turn, file), "has other files", class = "codend_error_file")
  expect_true(file.exists(file.path(folder, "turn", "notes.txt")))
})

test_that("VTK series accepts any valid file name", {
  skip_if_not_installed("xml2")
  name <- "a \"tow\" of <Tom's> & Co"
  file <- file.path(test_folder(), paste0(name, ".pvd"))
  tow <- tow("towed_cable", until = 1)
  write_result(tow, file)
  text <- paste(readLines(file), collapse = "\n")
  listed <- xml2::xml_attr(xml2::xml_find_all(xml2::read_xml(charToRaw(text)), "//DataSet"), "file")
  expect_identical(listed, sprintf("%s/%04d.vtu", name, seq_along(tow$time)))
})

test_that("low_word_first() splits numbers beyond 32 bits", {
  expect_identical(low_word_first(5), c(5L, 0L))
  expect_identical(low_word_first(2^32 + 7), c(7L, 1L))
  expect_identical(low_word_first(2^32 - 1), c(-1L, 0L))
})
