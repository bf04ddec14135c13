test_that("page opens with the settled gear, its picture and controls", {
  in_flume("towed_cable", function(session, sent, tank) {
    picture <- sent("flume_picture")[[1]]
    expect_identical(picture$edited, 0)
    points <- matrix(unpacked(picture$scene$points$floats, "double", 4), 3L)
    ends <- unpacked(picture$scene$ropes$ends, "integer", 4) + 1L
    # the cable's bars in sequence, in single precision of lengths up to 1000 m
    expect_equal(points[, ends], unname(state_points(tank$state)[,
      state_drawing(tank$state, 1e4)$ropes$ends]), tolerance = 1e-6)
    form <- tank$form()
    expect_identical(form$quick[[1]]$label, "Towing speed")
    opened <- list(base = "towed_cable")
    session$hear(code_wanted = list(opened = opened, kept = opened))
    code <- sent("flume_code")[[1]]$text
    expect_match(code, "gear <- read_gear(\"towed_cable\")", fixed = TRUE)
  })
})

test_that("control moves the gear to the result of settle()", {
  in_flume("towed_cable", function(session, sent, tank) {
    sent("flume_picture")
    ask(session, towing.speed = list(value = 5, unit = "knot"), number = 7)
    picture <- sent("flume_picture")
    expect_length(picture, 1L)
    expect_identical(picture[[1]]$answers, 7)
    # the connections are not sent again
    expect_null(picture[[1]]$scene$ropes)
    expect_identical(picture[[1]]$edited, 7)
    expect_type(picture[[1]]$scene$points$floats, "character")
    anew <- settle(update(read_gear("towed_cable"), towing.speed = "5 knot"), nodes = 300)
    # both to 1e-8 of the largest tension; the cable's sag increases that a few times
    expect_equal(tank$measures, measures(anew), tolerance = 1e-6)
  })
})

# Header and numbers of a shape during a slider movement.
passed_shape <- function(bytes) {
  size <- readBin(bytes, "integer", endian = "little")
  header <- jsonlite::fromJSON(rawToChar(bytes[4L + seq_len(size)]), simplifyVector = FALSE)
  numbers <- readBin(bytes[-seq_len(4L + size)], "double", length(bytes), 4L, endian = "little")
  counts <- unlist(header$counts)
  expect_length(numbers, sum(counts))
  list(header = header, numbers = split(numbers, rep(factor(names(counts), names(counts)), counts)))
}

test_that("page receives a moved shape before the rest of the picture", {
  in_flume("midwater_trawl", function(session, sent, tank) {
    ask(session, towing.speed = list(value = 4.1, unit = "knot"), number = 1)
    expect_length(sent("flume_moved"), 0L)
    ask(session, towing.speed = list(value = 4.2, unit = "knot"), number = 2)
    shape <- passed_shape(sent("flume_moved")[[1]]$bytes)
    expect_equal(shape$header$answers, 2)
    expect_match(shape$header$part$conditions, "4.2 knot", fixed = TRUE)
    expect_null(shape$header$part$ropes)
    # in single precision
    drawn <- scene_shape(tank$state, flume_lines)
    expect_equal(matrix(shape$numbers$points, 3L), unname(drawn$points), tolerance = 1e-6)
    expect_equal(unname(shape$numbers$u), drawn$u, tolerance = 1e-6)
    # the rest omits the shape, which the page has, but includes mesh openings
    ask(session, towing.speed = list(value = 4.3, unit = "knot"), number = 3)
    picture <- sent("flume_picture")
    expect_identical(picture[[1]]$answers, 3)
    expect_null(picture[[1]]$scene$points)
    expect_type(picture[[1]]$scene$opening$floats, "character")
    expect_identical(tank$measures, measures(tank$state))
    # changes of parts arrive with the shape
    ask(session, canvas.area = list(value = 14, unit = "m2"), number = 4)
    shape <- passed_shape(sent("flume_moved")[[1]]$bytes)
    expect_named(shape$header$part, c("conditions", "flow", "marks"))
    # the same for a whole design
    edits <- list(towing.speed = list(value = 4.3, unit = "knot"))
    whole <- list(base = "midwater_trawl", edits = list(edits))
    session$hear(design = list(number = 6, design = whole))
    expect_equal(passed_shape(sent("flume_moved")[[1]]$bytes)$header$answers, 6)
    expect_identical(tank$gear$plan, update(read_gear("midwater_trawl"),
      towing.speed = "4.3 knot")$plan)
  })
})

test_that("derivative of the shape is the difference of two settled shapes over the field", {
  in_flume("midwater_trawl", function(session, sent, tank) {
    knot <- 1852 / 3600
    drawn <- function(speed) {
      gear <- update(tank$gear, towing.speed = paste(speed, "knot"))
      scene_shape(settle(gear, nodes = 300, from = tank$state), flume_lines)$points
    }
    sent("flume_moved")
    session$hear(prediction_wanted = list(number = 1, paths = list("towing.speed")))
    message <- passed_shape(sent("flume_moved")[[1]]$bytes)
    expect_identical(message$header$predicts, list("towing.speed"))
    expect_equal(message$header$value, 4 * knot, tolerance = 1e-6)
    expected <- (drawn(4.01) - drawn(3.99)) / (0.02 * knot)
    expect_lt(max(abs(message$numbers$points - expected)), 0.01 * max(abs(expected)))
    # the next shape arrives without the rest
    ask(session, towing.speed = list(value = 4.1, unit = "knot"), number = 2)
    expect_equal(passed_shape(sent("flume_moved")[[1]]$bytes)$header$answers, 2)
    # fields that change the mesh, and fields without a number, have no derivative
    for (path in c("sections.section_1.meshes.deep", "name", "towing.none")) {
      session$hear(prediction_wanted = list(number = 3, paths = list(path)))
    }
    expect_length(sent("flume_moved"), 0L)
  })
})

test_that("page receives the whole shape when a wrong design interrupts it", {
  waiting <- list()
  # a worker that delays the rest of shapes until released
  keeping_worker <- function(...) {
    worker <- direct_worker()
    answer <- worker$ask
    worker$ask <- function(kind, make, then, pause = 0) {
      if (kind == "rest") {
        waiting <<- c(waiting, list(function() answer(kind, make, then)))
      } else {
        answer(kind, make, then)
      }
    }
    worker
  }
  in_flume("towed_cable", new_worker = keeping_worker, test = function(session, sent, tank) {
    ask(session, towing.speed = list(value = 4.9, unit = "knot"), number = 1)
    ask(session, towing.speed = list(value = 5, unit = "knot"), number = 2)
    expect_length(sent("flume_moved"), 1L)
    passed_over <- length(waiting)
    ask(session, towing.speed = list(value = -1, unit = "knot"), number = 3)
    expect_identical(sent("flume_idle")[[1]]$answers, 3)
    expect_length(waiting, passed_over + 1L)
    waiting[[length(waiting)]]()
    picture <- sent("flume_picture")
    expect_identical(picture[[1]]$answers, 2)
    expect_equal(tank$gear$plan$towing$speed, "5 knot")
    expect_identical(tank$measures, measures(tank$state))
  })
})

test_that("server answers a step whose rest the next step replaces", {
  rest <- NULL
  passing_worker <- function(...) {
    worker <- direct_worker()
    answer <- worker$ask
    worker$ask <- function(kind, make, then, pause = 0) {
      passed <- rest
      rest <<- NULL
      if (kind == "design" && !is.null(passed)) passed(NULL)
      if (kind == "rest") rest <<- then else answer(kind, make, then)
    }
    worker
  }
  in_flume("towed_cable", new_worker = passing_worker, test = function(session, sent, tank) {
    for (number in 1:3) {
      ask(session, towing.speed = list(value = 4 + number / 10, unit = "knot"), number = number)
    }
    slower <- list(base = "towed_cable")
    session$hear(design = list(number = 4, design = slower))
    sent("flume_moved")
    session$hear(design = list(number = 5, design = slower))
    expect_identical(sent("flume_idle")[[1]]$answers, 4)
  })
})

test_that("server answers queued requests once with the last draft", {
  jobs <- list()
  held_worker <- function(...) {
    worker <- direct_worker()
    answer <- worker$ask
    worker$ask <- function(kind, make, then, pause = 0) {
      jobs <<- c(jobs, list(list(kind = kind, answer = function() answer(kind, make, then))))
    }
    worker
  }
  in_flume("towed_cable", new_worker = held_worker, test = function(session, sent, tank) {
    ask(session, towing.speed = list(value = 4.1, unit = "knot"), number = 1)
    drafts <- length(sent("flume_draft"))
    expect_gt(drafts, 0L)
    for (number in 2:40) {
      ask(session, towing.speed = list(value = 4 + number / 100, unit = "knot"), number = number)
    }
    ask(session, ropes.cable.length = list(value = 410, unit = "m"), number = 41)
    # no other message is sent for replaced requests
    expect_length(sent("flume_draft"), 0L)
    expect_length(jobs, 1L)
    # each answer refers to the current draft
    jobs[[1]]$answer()
    expect_identical(vapply(jobs, `[[`, "", "kind"), c("design", "design"))
    told <- sent("flume_picture")[[1]]
    expect_identical(told$answers, 1)
    jobs[[2]]$answer()
    expect_identical(sent("flume_moved")[[1]]$type, "flume_moved")
    expect_identical(tank$draft$plan$towing$speed, "4.4 knot")
    expect_identical(tank$draft$plan$ropes$cable$length, "410 m")
    expect_identical(tank$edited, 41)
  })
})

test_that("click on a part returns its plan field", {
  in_flume("midwater_trawl", function(session, sent, tank) {
    found <- function(name) {
      session$hear(part_wanted = list(number = stats::runif(1), name = name))
      vapply(sent("flume_part"), `[[`, "", "path")
    }
    expect_identical(found("warp_port"), "warps")
    names <- c(names(tank$state$si$ropes), names(tank$state$si$panels))
    for (path in vapply(names, found, "")) expect_false(is.null(plan_field(tank$gear$plan, path)))
    for (odd in list("nothing", NULL, 1, c("a", "b"), strrep("x", 1e4), "../x", "plan name")) {
      expect_length(found(odd), 0L)
    }
    # a chosen field returns its parts
    session$hear(part_wanted = list(number = 1, path = "hand_ropes.upper.length"))
    told <- sent("flume_part")[[1]]
    expect_false(told$clicked)
    expect_setequal(told$names, c("hand_rope_upper_port", "hand_rope_upper_starboard"))
  })
})

test_that("each gear of a rig has its own parts in the form and in a selection", {
  rig <- read_gear("twin_trawl")
  paths <- unlist(lapply(plan_form(rig$plan), function(group) lapply(group$parts, `[[`, "path")))
  expect_true(all(c("gears.port", "gears.port.headline", "gears.starboard") %in% paths))
  expect_setequal(parts_of_field(rig, "gears.port.headline"),
    c("port_headline", "starboard_headline"))
  expect_true(all(startsWith(parts_of_field(rig, "gears.starboard"), "starboard_")))
})

test_that("clicked_field() finds every part and support of shipped gears", {
  for (gear in names(shipped_plans())) {
    gear <- read_gear(gear)
    si <- gear_si(gear)
    held <- names(Filter(function(point) is_given(point$held), si$points))
    parts <- c(names(si$ropes), names(si$panels), names(si$pieces), names(si$otter_boards), held)
    for (part in unique(parts)) {
      path <- clicked_field(gear, part)
      if (is.na(path) || is.null(plan_field(gear$plan, path))) fail(paste(gear$plan$name, part))
    }
  }
  place <- function(gear, part) clicked_field(read_gear(gear), part)
  expect_identical(place("beam_trawl", "brace_lower_port"), "beam")
  expect_identical(place("cage", "anchor_8"), "moorings")
  expect_identical(place("demersal_seine", "block_port"), "warps")
  expect_identical(place("dip_net", "collar"), "frame")
  expect_identical(place("pair_trawl", "back_square"), "square")
  expect_identical(place("poly_noreastern_trawl", "side_port_jib"), "wings.jib")
  expect_identical(place("purse_seine", "bridle_40"), "rings.bridles")
  expect_identical(place("purse_seine", "davit_last"), "purse_wire")
})

test_that("draft keeps a wrong value while the last shape stays", {
  in_flume("towed_cable", function(session, sent, tank) {
    before <- tank$state
    draft <- function() utils::tail(sent("flume_draft"), 1L)[[1]]
    for (value in list(
      list(value = -1, unit = "knot"), list(value = "4 furlong"), list(value = "4; q()"),
      list(value = strrep("9", 4000))
    )) {
      sent("flume_draft")
      ask(session, towing.speed = value)
      problem <- draft()$problems[[1]]
      expect_identical(problem$path, "towing.speed")
      expect_match(problem$message, "`towing.speed`", fixed = TRUE)
    }
    expect_identical(tank$state$position, before$position)
    expect_identical(tank$gear$plan, before$gear$plan)
    # values that no field accepts change nothing
    draft_before <- tank$draft
    wrong <- list(
      list(value = NULL), list(value = 1:3, unit = "knot"), list(), list(value = list(1)),
      list(value = strrep("9", 1e5)), list(value = NA), list(value = 4, unit = c("knot", "m/s"))
    )
    for (value in wrong) {
      sent("flume_refused")
      ask(session, towing.speed = value)
      refused <- sent("flume_refused")
      expect_length(refused, 1L)
      expect_identical(refused[[1]]$path, "towing.speed")
    }
    # unknown fields, and missing values
    ask(session, towing.sped = list(value = 1, unit = "m"))
    got <- sent("flume_refused")[[1]]$message
    expect_match(got, "did you mean `speed`", fixed = TRUE)
    ask(session, ropes.cable = list(like = "ropes.other"))
    got <- sent("flume_refused")[[1]]$message
    expect_match(got, "does not have this part")
    session$hear(design = "nonsense")
    session$hear(design = list(number = 3, edits = list(1, 2)))
    expect_identical(tank$draft, draft_before)
    ask(session, towing.speed = list(value = "5,5", unit = "knot"))
    expect_length(draft()$problems, 0L)
    expect_identical(tank$gear$plan$towing$speed, "5.5 knot")
  })
})

test_that("page reaches a consistent net by contradicting edits in any order", {
  plan <- system.file("extdata", "survey_trawl.yaml", package = "codend")
  edits <- list(
    wings.upper.meshes.deep = list(value = "60", unit = ""),
    wings.lower.meshes.deep = list(value = "87", unit = ""),
    headline.length = list(value = "32,5", unit = "m")
  )
  whole <- as_gear(edited_plan(read_gear(plan)$plan, edits)$plan)
  in_flume(plan, function(session, sent, tank) {
    opened <- sent("flume_opened")[[1]]$design
    for (order in list(c(1, 2, 3), c(2, 3, 1))) {
      unfinished <- 0L
      for (k in order) {
        do.call(ask, c(list(session), edits[k], number = k))
        unfinished <- unfinished + (length(tank$problems) > 0L)
      }
      expect_gt(unfinished, 0L)
      expect_length(tank$problems, 0L)
      expect_identical(tank$gear$plan, whole$plan)
      session$hear(design = list(number = 4, design = opened))
      expect_identical(tank$gear$plan, read_gear(plan)$plan)
    }
  }, nodes = 150)
})

test_that("page keeps the last shape if a design fails to settle", {
  in_flume("towed_cable", function(session, sent, tank) {
    before <- tank$state
    sent("flume_draft")
    # such a soft cable stretches without limit
    typed <- sub("12.717 MN", "0.001 N", format(tank$gear), fixed = TRUE)
    session$hear(design = list(number = 1, design = list(plan = typed)))
    draft <- utils::tail(sent("flume_draft"), 1L)[[1]]
    expect_match(draft$problems[[1]]$message, "did not settle")
    expect_match(draft$problems[[1]]$message, "rope `cable`", fixed = TRUE)
    expect_identical(tank$draft$plan$ropes$cable$axial_stiffness, "0.001 N")
    expect_identical(tank$gear$plan, before$gear$plan)
    expect_identical(tank$state$position, before$position)
  })
})

test_that("page rejects invalid plan files by their own name", {
  in_flume("towed_cable", function(session, sent, tank) {
    upload <- function(text, name = "mine.yaml") {
      sent("flume_refused")
      session$hear(plan_file = list(asked = list(name = name, text = text)))
      sent("flume_refused")
    }
    garbage <- upload("\001{")[[1]]
    expect_match(garbage$message, "Plan file \"mine.yaml\" is not valid YAML", fixed = TRUE)
    expect_identical(garbage$where, "plan_file")
    large <- upload(strrep("a", 3 * 1024^2))[[1]]
    expect_match(large$message, "at most 2 MB")
    ran <- tempfile()
    code <- upload(sprintf("codend: 1\nname: !expr file.create('%s')\n", ran))[[1]]
    expect_match(code$message, "cannot contain code")
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
    labels <- vapply(tank$form()$quick, `[[`, "", "label")
    expect_true("Current" %in% labels)
  })
})

test_that("messages cannot make the server read files or compute too long", {
  in_flume("towed_cable", function(session, sent, tank) {
    before <- tank$state
    refused <- function(...) {
      sent("flume_refused")
      session$hear(...)
      sent("flume_refused")[[1]]$message
    }
    there <- system.file("gears", "flat_panel.yaml", package = "codend")
    forged <- list(
      data.frame(name = "a", size = 1, type = "", datapath = there),
      list(name = there, datapath = there), list(list(there)), there
    )
    for (message in forged) {
      expect_identical(refused(plan_file = list(asked = message)), "The plan must be text.")
    }
    expect_match(refused(plan_file = list(asked = list(name = "a", text = there))), "must be a map")
    large <- list(plan = strrep("a", 3 * 1024^2))
    expect_match(refused(design = list(design = large)), "at most 2 MB")

    divided <- read_gear("flat_panel")
    divided$plan$panels$netting[c("columns", "rows")] <- list(1000, 1000)
    expect_match(refused(plan_file = list(asked = list(name = "a", text = format(divided)))),
      "needs 1e+06 nodes (about 10 GB of memory), but at most 20000", fixed = TRUE)
    expect_identical(tank$state$position, before$position)
  })
})

test_that("typed plan takes effect and keeps its text", {
  in_flume("towed_cable", function(session, sent, tank) {
    sent("flume_picture")
    typed <- sub("length: 1000 m", "length: 700 m  # shorter", format(tank$gear))
    session$hear(design = list(number = 2, design = list(plan = typed)))
    expect_identical(tank$gear$plan$ropes$cable$length, "700 m")
    got <- sent("flume_picture")[[1]]$answers
    expect_identical(got, 2)
    session$hear(plan_wanted = 1)
    got <- sent("flume_plan")[[1]]$text
    expect_match(got, "700 m  # shorter", fixed = TRUE)
  })
})

test_that("page starts at the gallery of shipped and new gears", {
  in_flume(NULL, function(session, sent, tank) {
    expect_null(tank$gear)
    expect_length(sent("flume_picture"), 0L)
    # requests before there is a gear
    ask(session, towing.speed = list(value = 5, unit = "knot"))
    session$hear(plan_wanted = 1, code_wanted = list(), table_wanted = list(name = "drag"))
    expect_null(tank$gear)
    session$hear(words = list(number = 4, asked = list(base = "../towed_cable")))
    got <- sent("flume_refused")[[1]]$message
    expect_match(got, "No shipped gear")
    session$hear(words = list(number = 5, asked = list(base = "towed_cable")))
    expect_identical(tank$gear$plan, read_gear("towed_cable")$plan)
    session$hear(new = list(asked = list(kind = "bottom_trawl",
      values = list(headline = "20 m", depth = "", file = tempfile()))))
    expect_identical(tank$gear$plan, new_plan("bottom_trawl", headline = "20 m")$plan)
    sent("flume_refused")
    session$hear(new = list(asked = list(kind = "bottom_trawl",
      values = list(headline = "wide"))))
    got <- sent("flume_refused")[[1]]$message
    expect_match(got, "headline", fixed = TRUE)
    session$hear(new = list(asked = list(kind = "boat")))
    got <- sent("flume_refused")[[1]]$message
    expect_match(got, "boat")
  })
})

test_that("server names the last change in each picture and the opened design", {
  in_flume("towed_cable", function(session, sent, tank) {
    expect_identical(sent("flume_opened")[[1]][c("answers", "design")],
      list(answers = 0, design = list(base = "towed_cable")))
    session$hear(new = list(number = 3, asked = list(kind = "bottom_trawl")))
    design <- sent("flume_opened")[[1]]$design
    expect_identical(gear_of_words(design)$plan, new_plan("bottom_trawl")$plan)
    ask(session, towing.speed = list(value = 3, unit = "knot"), number = 4)
    sent("flume_picture")
    ask(session, towing.speed = list(value = 3.1, unit = "knot"), number = 5)
    expect_identical(sent("flume_picture")[[1]]$edited, 5)
  })
})

test_that("page settles a design without opening it", {
  in_flume("towed_cable", function(session, sent, tank) {
    before <- tank$gear
    edits <- list(list(towing.speed = list(value = 5, unit = "knot")))
    session$hear(kept = list(number = 2, design = list(base = "towed_cable", edits = edits)))
    kept <- sent("flume_kept")[[1]]
    expect_identical(kept$number, 2)
    anew <- measures(settle(update(read_gear("towed_cable"), towing.speed = "5 knot"), nodes = 300))
    expect_identical(unclass(kept$design$numbers$now), unname(plain_measures(anew)))
    expect_identical(vapply(kept$design$about, `[[`, "", "name"), names(anew))
    expect_type(kept$design$scene$points$floats, "character")
    expect_identical(tank$gear, before)
    session$hear(kept = list(number = 3, design = list(base = "boat")))
    expect_null(sent("flume_kept")[[1]]$design)
  })
})

test_that("sent_design() applies the changes of a page in their order", {
  value <- function(x, unit) list(value = x, unit = unit)
  design <- sent_design(list(base = "towed_cable", edits = list(
    list(towing.speed = value(5, "knot"), ropes.cable.length = value("800", "m")),
    list(ropes.second = list(like = "ropes.cable", after = "cable")),
    list(ropes.cable.length = value(900, "m"))
  )))
  expect_identical(design$plan$ropes$second$length, "800 m")
  expect_identical(design$plan$ropes$cable$length, "900 m")
  # addresses of earlier versions have one map of values
  expect_identical(sent_design(list(base = "towed_cable", edits = list(towing.speed = "5 knot"))),
    sent_design(list(base = "towed_cable", edits = list(list(towing.speed = value(5, "knot"))))))
  # a field that is gone has no uncertainty
  gear <- read_gear("midwater_trawl")
  path <- names(gear$plan$uncertain)[1L]
  edits <- stats::setNames(list(list(gone = TRUE)), path)
  expect_false(path %in% names(sent_design(list(base = "midwater_trawl",
    edits = list(edits)))$plan$uncertain))
})

test_that("server opens the design of an address and validates it", {
  in_flume(NULL, function(session, sent, tank) {
    edits <- list(list(towing.speed = "5 knot", ropes.cable.length = "800 m"))
    session$hear(words = list(number = 9, asked = list(base = "towed_cable", edits = edits)))
    expect_identical(tank$gear$plan,
      update(read_gear("towed_cable"), towing.speed = "5 knot", ropes.cable.length = "800 m")$plan)
    before <- tank$gear$plan
    wrong <- list(
      list(base = "../x"), list(base = list("towed_cable")), list(), "text",
      list(plan = "codend: 1\nname: !expr stop('ran')\n"),
      list(base = "towed_cable", edits = list(1)), list(base = "towed_cable", edits = 1),
      list(base = "towed_cable", edits = list(towing.sped = 3)),
      list(base = "towed_cable", edits = list(towing.speed = "fast")),
      list(base = "towed_cable", edits = list(towing.speed = 1:3)),
      list(base = "towed_cable", edits = rep(list(list(towing.speed = 3)), 501))
    )
    for (now in wrong) {
      sent("flume_refused")
      session$hear(words = list(number = stats::runif(1), asked = now))
      expect_length(sent("flume_refused"), 1L)
    }
    session$hear(words = "nonsense")
    expect_identical(tank$gear$plan, before)
  })
})

test_that("page that continues after a lost connection starts without a gear", {
  start <- settled_start(read_gear("towed_cable"), 300)
  server <- flume_server(start, list(), 300, direct_worker)
  session <- open_flume(server, list(QUERY_STRING = "?continues=1"))
  expect_null(session$tank$gear)
  session$hear(words = list(number = 1, asked = list(base = "flat_panel")))
  expect_identical(session$sent("flume_opened")[[1]]$answers, 1)
  expect_identical(open_flume(server)$tank$gear$plan, start$gear$plan)
})

test_that("page saves the displayed plan and tables", {
  in_flume("towed_cable", function(session, sent, tank) {
    ask(session, towing.speed = list(value = 5, unit = "knot"))
    expect_identical(read_gear(saved_file(session, "plan"))$plan, tank$gear$plan)
    expect_equal(utils::read.csv(saved_file(session, "drag"))$drag_kN,
      as.data.frame(tank$state, what = "drag")$drag_kN, tolerance = 1e-12)
  })
})

test_that("drawing names only fields of the form", {
  in_flume("midwater_trawl", function(session, sent, tank) {
    sent("flume_drawing")
    session$hear(drawing_wanted = 1)
    svg <- sent("flume_drawing")[[1]]$svg
    named <- unlist(regmatches(svg, gregexpr("(?<=data-path=\")[^\"]+", svg, perl = TRUE)))
    expect_gt(length(unique(named)), 20L)
    # Chromium reports an error for a point that is not a number
    expect_no_match(svg, "points=\"[^\"]*NA")
    parts <- unlist(lapply(plan_form(tank$gear$plan), function(group) {
      lapply(group$parts, function(part) {
        c(part$path, unlist(lapply(part$fields, function(field) field$paths)))
      })
    }))
    # a field of the form, or a parent of one
    at <- sub("[.].*", "", unique(named))
    expect_true(all(at %in% sub("[.].*", "", parts)))
  }, nodes = 200)
})

test_that("sessions have separate gears", {
  gear <- read_gear("towed_cable")
  start <- settled_start(gear, 300)
  server <- flume_server(start, list(), 300, direct_worker)
  one <- open_flume(server)
  other <- open_flume(server)
  ask(one, towing.speed = list(value = 6, unit = "knot"))
  expect_identical(one$tank$gear$plan$towing$speed, "6 knot")
  expect_identical(other$tank$gear$plan, gear$plan)
})

test_that("flume() accepts a gear and its fields, and rejects others", {
  expect_s3_class(flume("towed_cable", fields = "ropes.cable.length"), "codend_flume")
  expect_error(flume("towed_cable", fields = "ropes.cable.lengt"), "did you mean",
    class = "codend_error_argument")
  expect_error(flume("towed_cable", fields = "notes"), "has no control for that field",
    class = "codend_error_argument")
  expect_error(flume("towed_cable", fields = 3), class = "codend_error_argument")
  expect_error(flume("towed_cabel"), class = "codend_error_plan")
  expect_s3_class(flume(), "codend_flume")
  expect_error(flume(fields = "ropes.cable.length"), "needs `gear`",
    class = "codend_error_argument")
  expect_error(flume("towed_cable", nodes = 0), class = "codend_error_argument")
})

test_that("page loads nothing from other servers", {
  files <- list.files(system.file("app", package = "codend"), "[.](js|css|html)$",
    full.names = TRUE)
  # names of XML vocabularies and addresses of licences are text
  texts <- vapply(files, function(file) {
    sub("(?s)^/[*]!.*?[*]/", "", paste(readLines(file), collapse = "\n"), perl = TRUE)
  }, "")
  expect_length(texts, 3L)
  expect_false(any(grepl("https?://(?!www[.]w3[.]org/)|@import", texts, perl = TRUE)))
})

test_that("server serves the page, its files and messages, and rejects other hosts", {
  skip_if_not_installed("httpuv")
  skip_if_not_installed("callr")
  port <- httpuv::randomPort()
  process <- callr::r_bg(function(port) codend:::serve_flume(codend::flume(), port, FALSE),
    list(port), stdout = NULL, stderr = NULL)
  withr::defer(process$kill())
  read <- function(path) readLines(url(sprintf("http://127.0.0.1:%d/%s", port, path)), warn = FALSE)
  for (k in 1:100) {
    page <- tryCatch(suppressWarnings(read("")), error = function(e) NULL)
    if (!is.null(page)) break
    Sys.sleep(0.2)
  }
  expect_match(page, "<script src=\"tank.js\" defer></script>", fixed = TRUE, all = FALSE)
  expect_gt(sum(nchar(read("view/viewer.js"))), 1e5)
  expect_error(suppressWarnings(read("../DESCRIPTION")))
  # a WebSocket's first message is the start of the page
  shake <- function(host) {
    socket <- socketConnection("127.0.0.1", port, open = "r+b")
    on.exit(close(socket))
    writeBin(charToRaw(paste0(paste(c("GET /?lang=fr HTTP/1.1", paste("Host:", host),
      "Upgrade: websocket", "Connection: Upgrade", "Sec-WebSocket-Version: 13",
      "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ=="), collapse = "\r\n"), "\r\n\r\n")), socket)
    bytes <- raw()
    for (k in 1:100) {
      bytes <- c(bytes, readBin(socket, "raw", 400L))
      if (length(bytes) > 300) break
      Sys.sleep(0.02)
    }
    rawToChar(bytes[bytes >= 0x20 & bytes < 0x7f])
  }
  expect_match(shake(paste0("localhost:", port)), "\"flume_begin\"", fixed = TRUE)
  expect_no_match(shake("evil.example"), "flume_begin", fixed = TRUE)
  process$interrupt()
  process$wait(5000)
  expect_false(process$is_alive())
})

test_that("page that exceeds its limits is disconnected", {
  heard <- list()
  closed <- FALSE
  act <- NULL
  socket <- list(request = list(), send = function(message) NULL,
    close = function(...) closed <<- TRUE, onMessage = function(f) act <<- f,
    onClose = function(f) NULL)
  connect_page(socket, function(request, send, send_bytes, close) {
    list(hear = function(type, given) heard[[type]] <<- given, leave = function() NULL)
  })
  texts <- c("{\"own\": {\"number\": 1}}", "{", "3", "{\"a\": 1, \"b\": 2}", "[1]")
  for (text in texts) act(FALSE, text)
  expect_identical(heard, list(own = list(number = 1L)))
  expect_false(closed)
  act(FALSE, strrep("x", most_message_bytes + 1))
  expect_true(closed)
  act(FALSE, "{\"cancel\": 1}")
  expect_named(heard, "own")
})

test_that("expect_declared() rejects messages that the page's protocol does not declare", {
  skip_if(is.null(declared_messages()), "the sources of pages are not here")
  expect_no_error(expect_declared("flume_idle", list(answers = 0)))
  expect_failure(expect_declared("flume_idle", list(answers = 0, other = 1)), "other")
  expect_failure(expect_declared("flume_idle", list()), "answers")
  expect_failure(expect_declared("flume_other", list()), "flume_other")
})

test_that("server reads exactly the messages of the page's protocol", {
  lines <- c(protocol_lines("Asked"), protocol_lines("Told"))
  skip_if(is.null(lines), "the sources of pages are not here")
  folder <- tempfile("shared-")
  dir.create(folder)
  page <- open_flume(flume_server(NULL, list(), 300, direct_worker, folder))$page
  expect_setequal(names(page$handlers), sub("^  (\\w+):.*", "\\1", grep("^  \\w+:", lines,
    value = TRUE)))
})
