# Wakes of netting by published formulas, consistent with the shape of the netting.

# Square sheets of netting in a row, fixed stretched along their upper and lower edges.
sheets <- function(law, number = 2, ...) {
  points <- seams <- panels <- list()
  for (k in seq_len(number)) {
    for (level in c("upper", "lower")) {
      z <- if (level == "upper") -1 else -3.04
      for (side in c("port", "starboard")) {
        y <- if (side == "port") -1.01 else 1.01
        points[[paste(level, side, k, sep = "_")]] <-
          gear_point(position = c(4 * (k - 1), y, z), held = "fixed")
      }
      seams[[paste(level, k, sep = "_")]] <- seam(
        edges = list(paste0("sheet_", k, ".", level)),
        held_between = paste(level, c("port", "starboard"), k, sep = "_")
      )
    }
    panels[[paste0("sheet_", k)]] <- netting_panel(
      mesh_size = "40 mm", meshes = list(upper = 100, lower = 100, deep = 100), knotted = FALSE,
      orientation = "square",
      twine = list(diameter = "2 mm", axial_stiffness = "30 kN", mass_per_length = "3 g/m"), ...
    )
  }
  # Numbered after the lower seams of the panels.
  do.call(gear, c(list("sheets"), points, panels, seams, list(
    water = list(current = list(speed = "0.5 m/s", toward = "0 deg")),
    shielding = law, coefficients = list(normal = 1.2)
  )))
}

drag_of <- function(state) {
  drag <- as.data.frame(state, what = "drag")
  drag$drag_kN[drag$kind == "netting"]
}

test_that("shielding reduces speed by the published formulas", {
  laws <- list(
    loland = function(sn) 1 - 0.46 * (0.33 * sn + 6.54 * sn^2 - 4.88 * sn^3),
    cheng = function(sn) (1 + 0.05 - 0.38 * sn) / (1 + 0.05)
  )
  for (netting in c("cells", "bars")) {
    for (law in names(laws)) {
      state <- settle(sheets(law), nodes = 400, netting = netting)
      # Twine of 2 mm, bars of 20 mm: solidity 0.2 as the sum of twines. Stretch reduces it, and so
      # do crossings, which have no knots and count once.
      lines <- state_lines(state)
      twine <- 0.2 / mean(lines$length / lines$rest)^2
      sn <- twine - twine^2 / 4
      drag <- drag_of(state)
      # Drag is proportional to speed squared; sheets sag by a few degrees. Midpoints of bars on a
      # sheet's border are outside the wake: with 8 by 8 meshes this is 10 % of the twine with half
      # the speed reduction, 2 %.
      expect_equal(drag[2] / drag[1], laws[[law]](sn)^2,
        tolerance = c(cells = 0.005, bars = 0.025)[[netting]])
      expect_lt(state$report$wake_change, 1e-5)
      expect_gt(state$report$wake_renewals, 1)
    }
  }
})

test_that("each sheet upstream reduces the speed again", {
  drag <- drag_of(settle(sheets("loland", 3), nodes = 600))
  expect_equal(drag[3] / drag[2], drag[2] / drag[1], tolerance = 0.01)
})

test_that("shielding is a field per panel and off by default", {
  none <- drag_of(settle(sheets("none"), nodes = 400))
  expect_equal(none[1], none[2], tolerance = 1e-6)
  expect_equal(drag_of(settle(sheets("loland", shielding = "none"), nodes = 400)), none)
  expect_refused(sheets("some"))
})

test_that("shielded states have zero remainder and are reproducible", {
  plan <- sheets("cheng")
  state <- settle(plan, nodes = 400)
  balance <- summary(state)$balance
  remainder <- unlist(balance[balance$force == "remainder", -1])
  # 1e-8 of the largest tension on each node.
  expect_lt(max(abs(remainder)), 1e-6)
  expect_identical(settle(plan, nodes = 400)$position, state$position)
})

test_that("shielded state remains at rest in a tow", {
  for (netting in c("cells", "bars")) {
    state <- settle(sheets("cheng"), nodes = 200, netting = netting)
    expect_lt(min(engine_array(state, "wake")), 0.95)
    found <- tow(state, until = 10, every = 5)
    # settled to 1e-8 of the largest tension
    expect_lt(max(abs(found$position[, , 3] - state$position)), 1e-6)
    expect_identical(found$wake[, 3], found$wake[, 1])
    expect_equal(drag_of(state_at(found, 10)), drag_of(state), tolerance = 1e-6)
  }
})

test_that("wake follows a changing current to the settled state", {
  gear <- update(sheets("loland"), water.current.toward = "15 deg")
  turning <- list(speed = 0.5, toward = data.frame(time = c(0, 20), value = c("0 deg", "15 deg")))
  found <- tow(sheets("loland"), until = 200, every = 20, nodes = 200,
    schedule = tow_schedule(current = turning))
  expected <- settle(gear, nodes = 200)
  # the second sheet leaves half of the first sheet's wake, with 4 m and 15 deg
  expect_gt(mean(found$wake[, 11]), mean(found$wake[, 1]) + 0.005)
  # speed fractions to 1e-5 each; drag with their square
  expect_equal(drag_of(state_at(found, 200)), drag_of(expected), tolerance = 1e-4)

  file <- file.path(test_folder(), "tow.nc")
  skip_if_not_installed("RNetCDF")
  half <- tow(sheets("loland"), until = 100, every = 20, nodes = 200,
    schedule = tow_schedule(current = turning))
  write_result(half, file)
  on <- tow(read_result(file), until = 200)
  for (field in c("time", "position", "wake")) {
    expect_equal(on[[field]], found[[field]], tolerance = 1e-3)
  }
})
