test_that("plan_controls() offers the main fields in the plan's units", {
  controls <- plan_controls(read_gear("midwater_trawl")$plan)
  labels <- vapply(controls, `[[`, "", "label", USE.NAMES = FALSE)
  expect_identical(labels[1:5],
    c("Towing speed", "Warp out", "Otter board area", "Hammer mass", "Canvas area"))
  speed <- controls[[1]]
  expect_identical(speed[c("value", "unit")], list(value = 4, unit = "knot"))
  expect_equal(1 / speed$factor, 3600 / 1852)
  # 0.5 to 1.5 times 4, in steps of a round number
  expect_equal(c(speed$low, speed$high, speed$step), c(2, 6, 0.05))
})

test_that("plan_controls() joins identical parts of one role in an assembly", {
  plan <- assembly(read_gear("midwater_trawl"))$plan
  warps <- c("ropes.warp_port.length", "ropes.warp_starboard.length")
  paths <- lapply(plan_controls(plan), `[[`, "paths")
  expect_true(list(I(warps)) %in% unname(paths))
  plan$ropes$warp_port$length <- "710 m"
  paths <- lapply(plan_controls(plan), `[[`, "paths")
  expect_true(all(lapply(warps, I) %in% unname(paths)))
})

test_that("every markable field gives a control that keeps its value", {
  for (name in gears()$name) {
    gear <- read_gear(name)
    paths <- markable_fields(gear$plan)
    expect_gt(length(paths), 3)
    controls <- plan_controls(gear$plan, as.list(paths))
    expect_true(all(paths %in% unlist(lapply(controls, `[[`, "paths"))))
    values <- list()
    for (control in controls) {
      for (path in control$paths) values[[path]] <- list(value = control$value, unit = control$unit)
    }
    same <- edited_gear(gear, values)
    expect_equal(gear_si(same), gear_si(gear), tolerance = 1e-14)
  }
})

test_that("plan_controls() includes choices and logical values", {
  plan <- read_gear("midwater_trawl")$plan
  controls <- plan_controls(plan, list("netting", "sections.section_1.knotted"))
  found <- controls[vapply(controls, function(c) c$kind != "number", NA)]
  expect_identical(found[[1]]$choices, I(c("cells", "bars")))
  expect_identical(found[[2]]$value, FALSE)
  gear <- read_gear("midwater_trawl")
  expect_error(edited_gear(gear, list(netting = list(value = "ropes"))), "one of cells, bars",
    class = "codend_error_plan")
  expect_error(edited_gear(gear, list(sections.section_1.knotted = list(value = 1))), "yes or no",
    class = "codend_error_plan")
})

test_that("control_range() stays within the bounds of its field", {
  range <- function(value, node, factor = 1) unlist(control_range(value, node, factor))
  most <- range(0.9, list(shape = "number", maximum = 1))
  expect_equal(most, c(low = 0.44, high = 1, step = 0.02))
  # 2.5 to 7.5 in integers
  expect_equal(range(5, list(shape = "integer", minimum = 3)), c(low = 3, high = 8, step = 1))
  # bounds are in SI, the slider in its unit
  expect_equal(range(1, list(shape = "quantity", minimum = 700), 1000)[["low"]], 0.7)
  expect_gt(range(1e-3, list(shape = "quantity", exclusiveMinimum = 0))[["low"]], 0)
})
