skip_if_not_installed("shiny")
skip_if_not_installed("bslib")

test_that("the page opens with the settled gear, its picture and its controls", {
  in_flume("towed_cable", function(session, sent, tank) {
    picture <- sent("flume_picture")[[1]]
    points <- matrix(unpacked(picture$now$points$floats, "double", 4), 3L)
    ends <- unpacked(picture$now$ropes$ends, "integer", 4) + 1L
    # the cable's bars, one after the other, in single precision of lengths up to 1000 m
    expect_equal(points[, ends], unname(state_points(tank$state)[, rope_lines(
      tank$state, state_points(tank$state), 1e4)$ends]), tolerance = 1e-6)
    expect_identical(picture$pinned$points, picture$now$points)
    expect_match(session$output$controls$html, "Towing speed", fixed = TRUE)
    expect_match(session$output$measures$html, "ship tension (kN)", fixed = TRUE)
    expect_match(session$output$code, "gear <- read_gear(\"towed_cable\")", fixed = TRUE)
  })
})

test_that("a control moves the gear to what settle() finds from the start", {
  in_flume("towed_cable", function(session, sent, tank) {
    opened <- tank$measures
    sent("flume_picture")
    ask(session, control_1 = list(value = 5, unit = "knot"), number = 7)
    picture <- sent("flume_picture")
    expect_length(picture, 1L)
    expect_identical(picture[[1]]$answers, 7)
    # what joins the points is not sent again
    expect_null(picture[[1]]$now$ropes)
    expect_type(picture[[1]]$now$points$floats, "character")
    anew <- settle(update(read_gear("towed_cable"), towing.speed = "5 knot"), nodes = 300)
    # both to 1e-8 of the largest tension; the cable's sag turns that into a few times more
    expect_equal(tank$measures, measures(anew), tolerance = 1e-6)
    session$setInputs(pin = 1)
    expect_identical(tank$pinned$measures, tank$measures)
    ask(session, control_1 = list(value = 2, unit = "m/s"))
    session$setInputs(reset = 1)
    expect_identical(tank$measures, tank$pinned$measures)
    expect_false(isTRUE(all.equal(tank$measures, opened)))
  })
})

test_that("a wrong value is told at its control and changes nothing", {
  in_flume("towed_cable", function(session, sent, tank) {
    before <- tank$state
    wrong <- list(
      list(value = -1, unit = "knot"), list(value = 4, unit = "furlong"), list(value = "4; q()"),
      list(value = NULL), list(value = 1:3, unit = "knot"), list()
    )
    for (value in wrong) {
      sent("flume_refused")
      ask(session, control_1 = value)
      refused <- sent("flume_refused")
      expect_length(refused, 1L)
      expect_identical(refused[[1]]$control, "control_1")
      expect_match(refused[[1]]$message, "`towing.speed`", fixed = TRUE)
    }
    # values for controls that there are not, and no values at all
    ask(session, control_99 = list(value = 1, unit = "m"))
    session$setInputs(design = "nonsense")
    expect_identical(tank$state$position, before$position)
    expect_identical(tank$gear$plan, before$gear$plan)
  })
})

test_that("a design that does not settle keeps the last shape and says where", {
  in_flume("towed_cable", function(session, sent, tank) {
    before <- tank$state
    sent("flume_refused")
    # a cable as soft as this stretches without end
    session$setInputs(plan_text = sub("12.717 MN", "0.001 N", format(tank$gear), fixed = TRUE))
    refused <- sent("flume_refused")[[1]]
    expect_match(refused$message, "did not settle")
    expect_match(refused$message, "rope `cable`", fixed = TRUE)
    expect_identical(refused$where, "plan_text")
    expect_identical(tank$gear$plan, before$gear$plan)
    expect_identical(tank$state$position, before$position)
  })
})

test_that("files that are no plans are refused by their own name", {
  in_flume("towed_cable", function(session, sent, tank) {
    upload <- function(text, name = "mine.yaml") {
      sent("flume_refused")
      session$setInputs(plan_file = list(name = name, text = text))
      sent("flume_refused")
    }
    garbage <- upload("\001{")[[1]]
    expect_match(garbage$message, "Plan file \"mine.yaml\" is not valid YAML", fixed = TRUE)
    expect_identical(garbage$where, "plan_file")
    large <- upload(strrep("a", 3 * 1024^2))[[1]]
    expect_match(large$message, "at most 2 MB")
    ran <- tempfile()
    code <- upload(sprintf("codend: 1\nname: !expr file.create('%s')\n", ran))[[1]]
    expect_match(code$message, "holds no code")
    expect_false(file.exists(ran))
    wrong <- upload(spoil("length: 100 m", "lenght: 100 m"))[[1]]
    expect_identical(wrong$path, "ropes.warp.lenght")
    expect_identical(tank$gear$plan, read_gear("towed_cable")$plan)

    # a gear that is shot settles while the page waits
    seine <- update(read_gear("purse_seine"), rings.number = 12, shooting.speed = "30 m/s")
    expect_length(upload(format(seine)), 0L)
    expect_identical(tank$gear$plan$kind, "purse_seine")

    expect_length(upload(format(settled_gear("panel_in_current"))), 0L)
    expect_identical(tank$gear$plan$name, "Panel in a current")
    expect_identical(tank$pinned$gear, tank$gear)
    expect_match(session$output$controls$html, "Current")
  })
})

test_that("no message makes the server read a file, or compute for longer than a page may ask", {
  in_flume("towed_cable", function(session, sent, tank) {
    before <- tank$state
    refused <- function(...) {
      sent("flume_refused")
      session$setInputs(...)
      sent("flume_refused")[[1]]$message
    }
    there <- system.file("gears", "flat_panel.yaml", package = "codend")
    forged <- list(
      data.frame(name = "a", size = 1, type = "", datapath = there),
      list(name = there, datapath = there), list(list(there)), there
    )
    for (message in forged) expect_identical(refused(plan_file = message), "A plan is text.")
    expect_match(refused(plan_file = list(name = "a", text = there)), "must hold a map")
    expect_match(refused(plan_text = strrep("a", 3 * 1024^2)), "at most 2 MB")

    divided <- read_gear("flat_panel")
    divided$plan$panels$netting[c("columns", "rows")] <- list(1000, 1000)
    expect_match(refused(plan_text = format(divided)),
      "asks for 1e+06 nodes, which would take about 10 GB of memory; at most 20000", fixed = TRUE)
    expect_identical(tank$state$position, before$position)
  })
})

test_that("a typed plan and a marked field take effect", {
  in_flume("towed_cable", function(session, sent, tank) {
    session$setInputs(plan_text = sub("length: 1000 m", "length: 700 m", format(tank$gear)))
    expect_identical(tank$gear$plan$ropes$cable$length, "700 m")
    session$setInputs(mark = "ropes.cable.length")
    expect_identical(tank$controls[[2]]$paths, "ropes.cable.length")
    expect_identical(tank$controls[[2]]$value, 700)
    sent("flume_refused")
    session$setInputs(mark = "ropes.cable.lenght")
    unknown <- sent("flume_refused")[[1]]
    expect_match(unknown$message, "did you mean \"ropes.cable.length\"", fixed = TRUE)
    session$setInputs(mark = list("a", "b"))
    two <- sent("flume_refused")[[1]]
    expect_match(two$message, "by its path")
  })
})

test_that("what is on screen is saved as it is", {
  in_flume("towed_cable", function(session, sent, tank) {
    ask(session, control_1 = list(value = 5, unit = "knot"))
    expect_identical(read_gear(session$output$save_plan)$plan, tank$gear$plan)
    table <- utils::read.csv(session$output$save_measures)
    expect_equal(table$now, unname(tank$measures), tolerance = 1e-12)
    expect_equal(table$change, table$now - table$pinned, tolerance = 1e-9)
    expect_equal(utils::read.csv(session$output$save_drag)$drag_kN,
      as.data.frame(tank$state, what = "drag")$drag_kN, tolerance = 1e-12)
  })
})

test_that("sessions do not share a gear", {
  gear <- read_gear("towed_cable")
  start <- list(gear = gear, state = settle(gear, nodes = 300))
  server <- flume_server(start, list(), 300, direct_worker)
  # the mock warns that it has no page to send to
  suppressWarnings({
    shiny::testServer(server, {
      ask(session, control_1 = list(value = 6, unit = "knot"))
      expect_identical(tank$gear$plan$towing$speed, "6 knot")
    })
    shiny::testServer(server, expect_identical(tank$gear$plan, gear$plan))
  })
})

test_that("flume() takes a gear and fields that it has", {
  expect_s3_class(flume("towed_cable", fields = "ropes.cable.length"), "shiny.appobj")
  expect_error(flume("towed_cable", fields = "ropes.cable.lengt"), "did you mean",
    class = "codend_error_argument")
  expect_error(flume("towed_cable", fields = "notes"), "no single number",
    class = "codend_error_argument")
  expect_error(flume("towed_cable", fields = 3), class = "codend_error_argument")
  expect_error(flume("towed_cabel"), class = "codend_error_plan")
  expect_error(flume("towed_cable", nodes = 0), class = "codend_error_argument")
})

test_that("the page asks for nothing from elsewhere", {
  expect_false(grepl("https?://", as.character(flume_page())))
  files <- list.files(system.file("app", package = "codend"), full.names = TRUE)
  expect_false(any(grepl("https?://|@import", unlist(lapply(files, readLines)))))
})
