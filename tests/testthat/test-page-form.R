test_that("form places every field of every kind once", {
  known <- unique(unlist(lapply(plan_kinds, function(kind) names(kind_node(kind)$properties))))
  placed <- c(unlist(form_sections, use.names = FALSE), form_leaves)
  expect_setequal(placed, known)
  expect_identical(anyDuplicated(placed), 0L)
})

form_controls <- function(form) {
  unlist(lapply(form, function(group) {
    unlist(lapply(group$parts, `[[`, "fields"), recursive = FALSE)
  }), recursive = FALSE)
}

test_that("plan_form() contains every value and its values change nothing", {
  for (name in gears()$name) {
    gear <- read_gear(name)
    controls <- form_controls(plan_form(gear$plan))
    paths <- vapply(controls, function(control) control$paths[1], "")
    expect_identical(anyDuplicated(paths), 0L)
    # values in lists belong to a field that the form shows on one line
    inside <- vapply(given_paths(gear$plan), function(path) {
      any(path == paths | startsWith(path, paste0(paths, ".")))
    }, NA)
    expect_true(all(inside))
    values <- lapply(controls, function(control) list(value = control$value, unit = control$unit))
    same <- edited_gear(gear, stats::setNames(values, paths))
    expect_equal(gear_si(same), gear_si(gear), tolerance = 1e-14)
  }
})

test_that("edited_plan() copies, renames and moves parts with their references", {
  gear <- read_gear("poly_noreastern_trawl")
  plan <- edited_plan(gear$plan, list(
    sections.intermediate_2 = list(like = "sections.intermediate", after = "intermediate"),
    sections.intermediate = list(rename = "funnel")
  ))$plan
  expect_named(plan$sections, c("body", "funnel", "intermediate_2", "codend"))
  expect_identical(plan$belly_lines$until, "funnel")
  plan <- edited_plan(plan, list(sections.intermediate_2 = list(move = -1)))$plan
  expect_named(plan$sections, c("body", "intermediate_2", "funnel", "codend"))
  for (wrong in list("codend", "a.b", "", list(1))) {
    expect_error(edited_plan(plan, list(sections.body = list(rename = wrong))),
      class = "codend_error_plan")
  }
})

test_that("edited_plan() reads numbers as typed and questions unlikely ones", {
  plan <- read_gear("midwater_trawl")$plan
  read <- function(text, unit, path = "warps.length") {
    edited_plan(plan, stats::setNames(list(list(value = text, unit = unit)), path))
  }
  si <- function(text, unit) quantity_si(read(text, unit)$plan$warps$length, "length")
  expect_identical(si("320,5", "m"), 320.5)
  expect_identical(si("320.5 m", "fathom"), 320.5)
  expect_equal(si("11 fm", "m"), 11 * 1.8288)
  expect_equal(si("110", "fathom"), 110 * 1.8288)
  # thousands or decimals
  expect_identical(read("1,000", "m")$plan$warps$length, "1,000")
  expect_length(draft_gear(read("1,000", "m")$plan)$problems, 1L)
  mesh <- read("31", "m", "sections.codend.mesh_size")$understood[[1]]
  expect_identical(mesh$text, "31 m")
  expect_match(mesh$doubt$message, "Is 31 m correct?", fixed = TRUE)
  expect_identical(mesh$doubt$instead, "31 mm")
  expect_null(read("600", "m")$understood[[1]]$doubt)
})

test_that("plan_form() describes valid values and offers missing fields", {
  plan <- read_gear("midwater_trawl")$plan
  warp <- Filter(function(control) control$paths[1] == "warps.length",
    form_controls(plan_form(plan)))[[1]]
  expect_match(warp$must, "a length greater than 0 m", fixed = TRUE)
  offers <- form_offers(plan, "warps", "Rig")
  paths <- vapply(offers, function(one) one$paths[1], "")
  expect_true("warps.strumming" %in% paths)
  expect_false("warps.length" %in% paths)
  of_group <- form_offers(plan, "", "Netting")
  expect_true(all(vapply(of_group, function(one) one$paths[1], "") %in% form_sections$Netting))
  expect_error(form_offers(plan, "warps.lenght", "Rig"), class = "codend_error_argument")
  for (name in gears()$name) {
    plan <- read_gear(name)$plan
    for (group in plan_form(plan)) {
      for (part in group$parts) {
        offered <- form_offers(plan, part$path, group$title)
        if (nzchar(part$path)) expect_identical(length(offered) > 0L, part$open)
      }
    }
  }
})

test_that("edited_gear() adds and removes parts and fields", {
  gear <- read_gear("midwater_trawl")
  longer <- edited_gear(gear, list(
    warps.strumming = list(value = 0.3),
    canvas = list(gone = TRUE), floats.number = list(value = 40, unit = "")
  ))
  expect_identical(longer$plan$warps$strumming, 0.3)
  expect_null(longer$plan$canvas)
  expect_identical(longer$plan$floats$number, 40)
  cable <- read_gear("towed_cable")
  two <- edited_gear(cable, list(pieces.second = list(like = "pieces.sphere")))
  expect_identical(two$plan$pieces$second, cable$plan$pieces$sphere)
  listed <- edited_gear(gear, list(vessel.pull = list(
    value = "[{speed: 0 knot, pull: 600 kN}, {speed: 15 knot, pull: 0 kN}]"
  )))
  expect_identical(listed$plan$vessel$pull[[1]], list(speed = "0 knot", pull = "600 kN"))
  for (wrong in c("[1, ", "!expr stop('ran')", "*a", "")) {
    expect_error(edited_gear(gear, list(vessel.pull = list(value = wrong))),
      class = "codend_error_plan")
  }
})

test_that("catalogue picks fit their parts and give a gear", {
  plan <- new_plan("bottom_trawl")$plan
  parts <- do.call(c, lapply(plan_form(plan), `[[`, "parts"))
  picks <- do.call(c, lapply(parts, `[[`, "picks"))
  fits <- stats::setNames(lapply(picks, function(pick) unclass(pick$classes)),
    vapply(picks, `[[`, "", "path"))
  expect_identical(fits$otter_boards, "board")
  expect_identical(fits$floats, "float")
  expect_identical(fits$sections.body.twine, "twine")
  expect_setequal(fits$warps, c("rope", "wire", "chain"))
  offered <- offered_catalogue()
  expect_length(offered, nrow(catalogue()))
  classes <- vapply(offered, `[[`, "", "class")
  for (path in c("otter_boards", "floats", "sections.body.twine", "warps")) {
    for (class in fits[[path]]) {
      row <- offered[[match(class, classes)]]
      edits <- stats::setNames(lapply(row$values, function(value) list(value = value, unit = "")),
        paste0(path, ".", names(row$values)))
      expect_length(draft_gear(edited_plan(plan, edits)$plan)$problems, 0L)
    }
  }
  expect_true("otter_boards.polar" %in% unlist(lapply(parts, `[[`, "absent")))
})

test_that("own_rows() checks user-defined rows and stores them with designs", {
  given <- list(
    list(class = "float", title = " My\nfloat", values = list(diameter = "8 in", buoyancy = "2,9")),
    list(class = "rope", title = "Rope", values = list(strength = "50", material = "nylon")),
    list(class = "rope", title = "Rope", values = list(strength = "60", diameter = " ", no = "x"))
  )
  rows <- own_rows(given)
  expect_length(rows, 2L)
  expect_identical(rows[[1]][c("title", "source")], list(title = "My float", source = "own"))
  expect_identical(rows[[1]]$values, list(diameter = "8 in", buoyancy = "2.9 kgf"))
  expect_identical(rows[[2]]$values, list(strength = "60 kN"))
  expect_identical(own_rows(rows), rows)
  wrong <- function(message, ...) {
    row <- utils::modifyList(list(class = "float", title = "F", values = list(diameter = "8 in")),
      list(...))
    expect_error(own_rows(list(row)), message, class = "codend_error_argument")
  }
  wrong("one of", class = "boat")
  wrong("name", title = "")
  wrong("no numbers", values = list(diameter = NULL))
  wrong("diameter is", values = list(diameter = "8 kg"))
  wrong("diameter is", values = list(diameter = "-8 in"))
  wrong("diameter is", values = list(diameter = 8))
  many <- lapply(1:101, function(k) utils::modifyList(given[[1]], list(title = paste(k))))
  expect_error(own_rows(many), "at most")

  in_flume("towed_cable", function(session, sent, tank) {
    session$hear(own = list(number = 1, rows = given))
    expect_identical(sent("flume_own")[[1]]$rows, rows)
    session$hear(own = list(number = 2, rows = list(list(class = "boat"))))
    expect_identical(sent("flume_refused")[[1]]$where, "own")
  })
})

test_that("typed_quantity() adds the unit of the example to a number", {
  expect_identical(typed_quantity("15,6", "25 m"), "15.6 m")
  expect_identical(typed_quantity("11 fm", "25 m"), "11 fm")
  expect_identical(typed_quantity("1,000", "25 m"), "1,000")
  expect_identical(typed_quantity("80", "80"), "80")
  expect_equal(format_number("5", "speed", "speed"), 5 * 1852 / 3600)
})
