# Values with a class: objects of the package units are converted to SI, any other class is
# rejected.

# 4 knot is 4 * 1852 / 3600 m/s (NIST SP 811).
four_knots <- 4 * 1852 / 3600

in_units <- function(value, unit) units::set_units(value, unit, mode = "standard")

test_that("update() converts units objects to SI", {
  skip_if_not_installed("units")
  cable <- read_gear("towed_cable")
  si <- gear_si(update(cable, towing.speed = in_units(4, "knot"),
    ropes.cable.length = in_units(0.9, "km"),
    ropes.cable.coefficients = list(normal = in_units(1.1, "1")),
    pieces.sphere.mass = in_units(200, "lb")))
  expect_equal(si$towing$speed, four_knots, tolerance = 1e-15)
  expect_equal(si$ropes$cable$length, 900, tolerance = 1e-15)
  expect_equal(si$pieces$sphere$mass, 200 * 0.45359237, tolerance = 1e-15)
  expect_identical(si$ropes$cable$coefficients$normal, 1.1)
  current <- update(cable, water.current = list(
    list(depth = in_units(10, "fathom"), speed = in_units(36, "km/h"),
      toward = in_units(90, "degree")),
    list(depth = in_units(50, "m"), speed = 0, toward = 0)
  ))
  # udunits defines the fathom by the survey foot
  expect_equal(gear_si(current)$water$current$depth, c(10 * 6 * 1200 / 3937, 50))
  expect_equal(gear_si(current)$water$current$y, c(10, 0))
  held <- update(cable, points.ship.position = in_units(c(0, 50, -200), "cm"))
  expect_equal(unname(as.double(gear_si(held)$points$ship$position)), c(0, 0.5, -2))
})

test_that("update() rejects units objects of another dimension", {
  skip_if_not_installed("units")
  cable <- read_gear("towed_cable")
  expect_refused(update(cable, towing.speed = in_units(4, "m/s2")),
    "Plan field `towing.speed` is \"4 [m/s2]\"; it must be a speed", fixed = TRUE)
  expect_refused(update(cable, water.current = list(speed = 1, toward = in_units(4, "%"))),
    "must be an angle")
  expect_refused(update(cable, pieces.sphere.number = in_units(2, "m")), "must be a whole number")
  expect_refused(vary(cable, towing.speed = in_units(3:4, "kg")), "Design 1: .* is 3 kg")
  expect_wrong(tow(cable, until = in_units(1, "m")), "`until` is 1 m; it must be a time")
  expect_wrong(tow(cable, until = 2,
    schedule = tow_schedule(speed = data.frame(time = 0, value = in_units(1, "kg")))),
    "`speed\\$value` is 1 kg; it must be a speed")
  expect_wrong(value_range(in_units(1, "m"), in_units(2, "kg")), "must have the same dimension")
})

test_that("update() accepts a decorated string and full turns in both units", {
  cable <- read_gear("towed_cable")
  expect_identical(update(cable, towing.speed = noquote("4 knot")),
    update(cable, towing.speed = "4 knot"))
  expect_identical(
    gear_si(update(cable, water.current = list(speed = 1, toward = 2 * pi)))$water,
    gear_si(update(cable, water.current = list(speed = 1, toward = "360 deg")))$water
  )
})

test_that("columns take the unit at the end of their name", {
  measured <- data.frame(depth_fathom = c(10, 20), speed_knot = 1:2, toward_deg = c(270, 90))
  said <- data.frame(depth = c("18.288 m", "36.576 m"), speed = c("1 knot", "2 knot"),
    toward = c("270 deg", "90 deg"))
  expect_equal(current_profile(measured), current_profile(said))
  expect_wrong(current_profile(cbind(measured, toward = 0)), "only one of them")

  log <- data.frame(time_min = 0:10, longitude_deg = 4.58, latitude_deg = 60 + (0:10) / 1000)
  si <- data.frame(time = 60 * log$time_min, longitude = log$longitude_deg * pi / 180,
    latitude = log$latitude_deg * pi / 180)
  expect_equal(track_schedule(log, 0, "10 min"), track_schedule(si, 0, 600))

  cable <- read_gear("towed_cable")
  tow_to <- function(course) {
    tow(cable, until = 10, every = 5, nodes = 20, schedule = tow_schedule(course = course))$position
  }
  expect_identical(tow_to(data.frame(time_min = c(0, 0.1), value_deg = c(0, 450))),
    tow_to(data.frame(time = c(0, 6), value = c("0 deg", "450 deg"))))

  found <- vary(cable, towing.speed_knot = 3:4, ropes.cable.length = "600 m", nodes = 20)
  expect_identical(found,
    vary(cable, towing.speed = c("3 knot", "4 knot"), ropes.cable.length = "600 m", nodes = 20))
  expect_identical(vary(cable, found[1:2], nodes = 20)$total_drag_kN, found$total_drag_kN)

  hauls <- data.frame(towing.speed_knot = c(3, 4), Tension = c(12, 13.3))
  fit <- function(data) {
    calibrate(cable, data, list(ropes.cable.length = c("800 m", "1500 m")),
      Tension ~ ship_tension_kN, error = 0.2, nodes = 20, accuracy = NULL)
  }
  knots <- data.frame(towing.speed = c("3 knot", "4 knot"), Tension = hauls$Tension)
  expect_identical(coef(fit(hauls)), coef(fit(knots)))
  expect_identical(predict(fit(hauls), hauls)$fit, predict(fit(knots), knots)$fit)
})

test_that("tow() turns by more than a turn of the plan's section", {
  gear <- update(read_gear("towed_cable"), tow = list(until = "4 s", every = "2 s",
    course = list(list(time = 0, value = "0 deg"), list(time = "4 s", value = "400 deg"))))
  found <- tow(gear, nodes = 20)
  expect_equal(found$conditions$course[found$time == 4], 400 * pi / 180)
})

test_that("studies convert units objects to SI", {
  skip_if_not_installed("units")
  speed <- in_units(c(3, 4), "knot")
  length <- in_units(c(0.6, 0.9), "km")
  found <- designs(towing.speed = speed, ropes.cable.length = length)
  speeds <- vapply(found$towing.speed, quantity_si, 0, "speed", USE.NAMES = FALSE)
  lengths <- vapply(found$ropes.cable.length, quantity_si, 0, "length", USE.NAMES = FALSE)
  expect_equal(speeds, rep(c(3 / 4, 1) * four_knots, 2))
  expect_equal(lengths, rep(c(600, 900), each = 2))
  # a column may have missing values, which keep the plan's value
  table <- data.frame(towing.speed = speed)
  table$towing.speed[2] <- NA
  expect_identical(is.na(designs(table)$towing.speed), c(FALSE, TRUE))

  settled <- vary("towed_cable", ropes.cable.length = length, nodes = 20)
  expect_equal(settled$ropes.cable.length_m, c(600, 900))
  told <- vary("towed_cable", ropes.cable.length = c("0.6 km", "0.9 km"), nodes = 20)
  expect_equal(settled$total_drag_kN, told$total_drag_kN)

  expect_equal(value_range(in_units(3, "knot"), "9 km/h"), value_range(
    paste(0.75 * four_knots, "m/s"), "9 km/h"))
  expect_equal(normal_value(in_units(0.6, "km"), "20 m"), normal_value("600 m", "20 m"))
  expect_wrong(value_range(in_units(1, "m"), 2), "both with units or both without")
})

test_that("calibrate() accepts units objects in fields, ranges, data and errors", {
  skip_if_not_installed("units")
  speed <- c(3, 3, 4, 4, 5)
  tension <- c(11.9, 12.1, 13.4, 13.3, 15.0)
  fit_of <- function(speed, tension, range, match, error = NULL) {
    data <- data.frame(towing.speed = speed, Tension = tension)
    calibrate("towed_cable", data, list(ropes.cable.length = range), match, error = error,
      nodes = 20, accuracy = NULL)
  }
  told <- fit_of(paste(speed, "knot"), tension, c("800 m", "1500 m"), Tension ~ ship_tension_kN,
    0.2)
  matches <- list(
    Tension ~ ship_tension_kN, Tension ~ ship_tension, Tension / 1 ~ 1 * ship_tension
  )
  for (match in matches) {
    found <- fit_of(in_units(speed, "knot"), in_units(1000 * tension, "N"),
      in_units(c(0.8, 1.5), "km"), match, list(in_units(200, "N")))
    # a fit stops when its objective is stationary within about 1e-4 of the coefficient
    expect_equal(coef(found), coef(told), tolerance = 1e-4)
  }
  again <- predict(found,
    data.frame(towing.speed = in_units(4, "knot"), Tension = in_units(13.4, "kN")))
  expect_equal(again$measured, 13400)
  expect_wrong(
    fit_of(in_units(speed, "knot"), in_units(tension, "kN"), in_units(c(0.8, 1.5), "km"),
      Tension ~ 2 * ship_tension_kN),
    "Remove the unit from the name"
  )
  expect_wrong(
    fit_of(in_units(speed, "knot"), in_units(tension, "m"), in_units(c(0.8, 1.5), "km"),
      Tension ~ ship_tension_kN),
    "Tension` is 11.9 m, which does not convert to the unit of `ship_tension_kN`: kN"
  )
})

test_that("optimise_gear() accepts units objects as limits", {
  skip_if_not_installed("units")
  best <- function(limit, range) {
    optimise_gear("towed_cable", ~ total_drag, list(ropes.cable.length = range),
      keep = ~ ship_tension <= limit, nodes = 20, accuracy = NULL)$gear
  }
  expect_equal(
    gear_si(best(in_units(14, "kN"), in_units(c(0.8, 1.5), "km")))$ropes$cable$length,
    gear_si(best("14 kN", c("800 m", "1500 m")))$ropes$cable$length
  )
})

test_that("tow() accepts units objects in all its quantities", {
  skip_if_not_installed("units")
  told <- tow("towed_cable", until = 20, every = 10, nodes = 20, accuracy = 0.02,
    schedule = tow_schedule(speed = data.frame(time = c(0, 10), value = c("4 knot", "5 knot")),
    course = function(time) 0.01 * time, heave = function(time) 0.1 * sin(time / 2),
    current = list(speed = 0.2, toward = 0.1)))
  found <- tow("towed_cable", until = in_units(1 / 3, "min"), every = in_units(10, "s"), nodes = 20,
    accuracy = in_units(2, "cm"),
    schedule = tow_schedule(
      speed = data.frame(time = in_units(c(0, 1 / 6), "min"), value = in_units(c(4, 5), "knot")),
    course = function(time) in_units(in_units(0.01 * time, "rad"), "degree"),
    heave = function(time) in_units(10 * sin(time / 2), "cm"),
    current = list(speed = in_units(0.72, "km/h"), toward = in_units(0.1, "rad"))))
  expect_equal(found$time, told$time)
  expect_equal(found$position, told$position, tolerance = 1e-6)
  state <- state_at(found, in_units(1 / 6, "min"))
  expect_equal(state$time, 10)
  # a file stores plain numbers for the schedule
  skip_if_not_installed("RNetCDF")
  file <- tempfile(fileext = ".nc")
  on.exit(unlink(file))
  write_result(found, file)
  expect_identical(read_result(file)$given$current, found$given$current)
})

test_that("other functions accept units objects for their quantities", {
  skip_if_not_installed("units")
  table <- data.frame(depth = in_units(c(0, 20), "m"), speed = in_units(c(1.8, 0.9), "km/h"),
    toward = in_units(c(0, 90), "degree"))
  plain <- data.frame(depth = c(0, 20), speed = c(0.5, 0.25), toward = c(0, pi / 2))
  expect_identical(current_profile(table, in_units(270, "degree")),
    current_profile(plain, "270 deg"))
  expect_wrong(current_profile(data.frame(depth = in_units(1, "s"), speed = 1, toward = 0)),
    "`table\\$depth` is 1 s; it must be a length")
  log <- data.frame(time = 10 * 0:60, longitude = 4.58, latitude = 60 + (0:60) / 1000)
  shown <- data.frame(time = in_units(log$time / 60, "min"),
    longitude = in_units(log$longitude, "degree"), latitude = in_units(log$latitude, "degree"))
  log[2:3] <- log[2:3] * pi / 180
  expect_equal(track_schedule(shown, 0, 600), track_schedule(log, 0, 600))
  expect_identical(track_schedule(log, 0, in_units(10, "min")), track_schedule(log, 0, 600))
  expect_wrong(settle("towed_cable", nodes = in_units(50, "m")), "nodes")
  expect_equal(gear_si(new_plan("gillnet", depth = in_units(20, "m")))$seabed$depth,
    gear_si(new_plan("gillnet", depth = "20 m"))$seabed$depth)
})

# Returns all quantities with a unit in the shipped plans: a data frame of gear, path, text and
# dimension.
shipped_quantities <- function() {
  do.call(rbind, lapply(names(shipped_plans()), function(name) {
    leaves <- plan_leaves(read_gear(name)$plan)
    text <- vapply(leaves$value, function(value) if (is_text(value)) value else "", "")
    paths <- grepl("[0-9]", text) & !grepl("^(tow|notes|sources|name|uncertain)", leaves$path)
    paths[paths] <- !is.na(vapply(text[paths], quantity_dimension, ""))
    data.frame(gear = name, path = leaves$path[paths], text = text[paths],
      dimension = vapply(text[paths], quantity_dimension, ""), row.names = NULL)
  }))
}

test_that("text, units objects and numbers in SI give the same gear", {
  skip_if_not_installed("units")
  known <- shipped_quantities()
  expect_gt(nrow(known), 400)
  # %, and units that the package units does not know or defines differently
  units <- vapply(known$text, function(text) split_quantity(text)[2L], "")
  known <- known[!units %in% c("kgf", "tf", "%", "deg", "kg/100 m"), ]
  rows <- with_seed(3, sample(nrow(known), 60))
  gears <- lapply(setNames(nm = unique(known$gear[rows])), read_gear)
  for (row in rows) {
    one <- known[row, ]
    parts <- split_quantity(one$text)
    si <- quantity_si(one$text, one$dimension)
    forms <- list(one$text, paste(si, names(plan_units[[one$dimension]])[1L]), si,
      in_units(as.double(parts[1L]), parts[2L]))
    found <- lapply(forms, function(value) {
      changed <- suppressMessages(classes = "codend_message_units",
        do.call(update, c(list(gears[[one$gear]]), setNames(list(value), one$path))))
      gear_si(changed)
    })
    # paste() keeps 15 digits
    for (other in found[-1L]) expect_equal(other, found[[1L]], tolerance = 1e-12, info = one$path)
  }
})

test_that("a wrong dimension is an error with field, value and units", {
  skip_if_not_installed("units")
  known <- shipped_quantities()
  rows <- with_seed(4, sample(nrow(known), 40))
  for (row in rows) {
    one <- known[row, ]
    gear <- read_gear(one$gear)
    wrong <- if (one$dimension == "mass") "7 m" else "7 kg"
    parts <- split_quantity(wrong)
    for (value in list(wrong, in_units(7, parts[2L]))) {
      e <- expect_refused(do.call(update, c(list(gear), setNames(list(value), one$path))))
      said <- plain_message(e)
      expect_match(dotted_path(said), one$path, fixed = TRUE)
      expect_match(said, wrong, fixed = TRUE)
      if (one$dimension == "number") next
      expect_match(said, names(plan_units[[one$dimension]])[1L], fixed = TRUE)
    }
  }
})

test_that("a number for a field in knot gives one message per session", {
  said <- function(code) {
    messages <- character()
    withCallingHandlers(eval(code, globalenv()), codend_message_units = function(m) {
      messages <<- c(messages, strsplit(plain_message(m), " This message")[[1L]][1L])
      invokeRestart("muffleMessage")
    })
    messages
  }
  rlang::reset_message_verbosity("codend_towing.speed")
  cable <- read_gear("towed_cable")
  knots <- bquote(codend::settle(update(.(cable), towing.speed = 3), nodes = 20))
  expect_identical(said(knots),
    "towing.speed = 3 is read as 3 m/s (5.832 knot). Write \"3 knot\" for knot.")
  expect_identical(said(knots), character())
  rlang::reset_message_verbosity("codend_towing.speed")
  for (quiet in list("3 knot", "3 m/s")) {
    expect_identical(said(bquote(update(.(cable), towing.speed = .(quiet)))), character())
  }
  # the plan gives the length in m
  expect_identical(said(bquote(update(.(cable), ropes.cable.length = 900))), character())
  expect_length(said(bquote(codend::vary(.(cable), towing.speed = 2:3, nodes = 20))), 1L)
  rlang::reset_message_verbosity("codend_towing.speed")
  expect_no_message(capture.output(run_command(c("optimise", "towed_cable",
    "--minimise=total_drag", "--change=towing.speed=1..3", "--nodes=20"))))
})
