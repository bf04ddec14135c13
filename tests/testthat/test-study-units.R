# Results of studies in other units.

units <- c(force = "tonnef", speed = "m/s", length = "fathom")

converted <- function(x) do.call(in_units, c(list(x), units))

# a tonne weighs 9.80665 kN, a fathom is 1.8288 m
knot <- 1852 / 3600

study <- function() {
  vary("towed_cable", designs(towing.speed = c("3 knot", "5 knot"),
    ropes.cable.length = c("400 m", "700 m")), nodes = 50)
}

expect_printed_in_units <- function(x) {
  in_option <- withr::with_options(list(codend.units = units), capture.output(print(x)))
  expect_identical(in_option, capture.output(print(converted(x))))
  expect_false(identical(in_option, capture.output(print(x))))
}

test_that("in_units() of effects equals the effects of converted variations", {
  found <- study()
  for (what in c("fields", "pairs")) {
    effect <- effects(found, what = what)
    expect_equal(converted(effect), effects(converted(found), what = what))
    expect_printed_in_units(effect)
  }
})

test_that("in_units() converts the levels of fields next to text", {
  found <- vary("towed_cable", towing.speed = c("3 knot", "5 knot"), nodes = 50,
    ropes.cable.material = c("steel_wire", "PA"))
  effect <- converted(effects(found, "total_drag_kN"))
  speed <- effect[effect$field == "towing.speed_m_per_s", ]
  expect_equal(as.double(speed$level), c(3, 5) * knot)
  expect_setequal(effect$level[effect$field == "ropes.cable.material"], c("steel_wire", "PA"))
})

test_that("in_units() converts sensitivities by the units of measure and field", {
  found <- sensitivities(settled("towed_cable", nodes = 50), secants = FALSE,
    of = c("total_drag_kN", "body_depth_m"), fields = c("towing.speed", "ropes.cable.length"))
  other <- converted(found)
  expect_setequal(other$measure, c("total_drag_tonnef", "body_depth_fathom"))
  expect_identical(other$field, found$field)
  by <- ifelse(found$field == "towing.speed", knot, 1 / 1.8288)
  of <- ifelse(found$measure == "total_drag_kN", 1 / 9.80665, 1 / 1.8288)
  expect_equal(other$value, found$value * by)
  expect_equal(other$derivative, found$derivative * of / by)
  expect_identical(other$derivative_unit[found$measure == "total_drag_kN"],
    c("tonnef per m/s", "tonnef per fathom"))
  expect_identical(other$elasticity, found$elasticity)
})

test_that("in_units() converts uncertainties with their parts", {
  found <- uncertainty(settled("towed_cable", nodes = 50))
  other <- converted(found)
  drag <- which(found$measures$measure == "total_drag_kN")
  expect_identical(other$measures$measure[drag], "total_drag_tonnef")
  size <- c("value", "error", "lower", "upper", "coefficients", "plan")
  expect_equal(unlist(other$measures[drag, size]), unlist(found$measures[drag, size]) / 9.80665)
  expect_equal(other$sources$contribution[found$sources$measure == "body_depth_m"],
    found$sources$contribution[found$sources$measure == "body_depth_m"] / 1.8288)
  expect_identical(other$sources$percent, found$sources$percent)
  expect_printed_in_units(found)
})

test_that("prints of fields follow the option codend.units", {
  runs <- data.frame(towing.speed = 2:6 / 2, Drag = c(1.9, 3.2, 5, 7.4, 10.2))
  fit <- suppressMessages(calibrate("towed_cable", runs, nodes = 50, match = Drag ~ total_drag_kN,
    change = list(ropes.cable.length = c("800 m", "1200 m"))))
  expect_equal(converted(fit)$value * 1.8288, fit$fields$value)
  found <- suppressMessages(find_value("towed_cable", ropes.cable.length = c("500 m", "1200 m"),
    target = list(body_depth = "450 m"), nodes = 50))
  withr::local_options(codend.units = units)
  expect_match(capture.output(print(fit)), "ropes.cable.length .* fathom", all = FALSE)
  printed <- capture.output(print(found))
  expect_match(printed, "ropes.cable.length .* fathom", all = FALSE)
  # 450 m
  expect_match(printed, "body_depth_fathom .* target 246.1", all = FALSE)
})
