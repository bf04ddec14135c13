test_that("gear() calls give the same tree as a file", {
  built <- gear(
    "A net on a warp",
    ship = gear_point(position = c(0, 0, 0), held = "fixed"), knot = gear_point(),
    warp = rope("ship", "knot", length = "100 m", diameter = "20 mm", material = "PA"),
    net = netting_panel(
      mesh_size = "100 mm", meshes = list(upper = 10L, lower = 5, deep = 10),
      twine = list(diameter = "2 mm", material = "PE")
    ),
    top = seam(list("net.upper"), gathered_at = "knot")
  )
  read <- read_text(small_plan)
  plan <- built$plan
  plan$kind <- NULL
  # a file's [net.upper] and R's list("net.upper") are one list
  expect_identical(plan[names(read$plan)], read$plan)
  expect_identical(gear_si(built), gear_si(read))
})

test_that("constructors accept every field of the schema", {
  fields <- kind_node("assembly")$properties
  groups <- list(
    points = gear_point, ropes = rope, panels = netting_panel, pieces = piece, seams = seam,
    measures = measure
  )
  for (group in names(groups)) {
    known <- names(fields[[group]]$additionalProperties$properties)
    expect_setequal(names(formals(groups[[group]])), known)
  }
})

test_that("update() gives the same gear as reading the changed plan", {
  changes <- list(
    list(towing.speed = "1.1 knot"), list(name = "Another name"), list(water.density = 1010),
    list(warps.length = "123 m"), list(headline.length = NULL), list(notes = list()),
    list(sections.intermediate.meshes.deep = 20), list(towing.speed = 1), list(canvas = NULL),
    list(coefficients = "wan"), list(sections.codend.rows = 3), list(measures = NULL),
    list(ropes.cable.length = "800 m"), list(ropes.cable.material = "polyester"),
    list(water.current = list(speed = 0.7, toward = "45 deg")), list(depth = "11 m"),
    list(towing = NULL)
  )
  # one gear of each kind
  table <- gears()
  taken <- 0
  for (name in table$name[!duplicated(table$kind)]) {
    gear <- chained <- read_gear(name)
    for (change in changes) {
      # some gears lack the field
      changed <- tryCatch(do.call(update, c(list(chained), change)),
        codend_error = function(e) NULL)
      if (is.null(changed)) next
      taken <- taken + 1
      chained <- changed
      expect_identical(chained$checked, as_gear(chained$plan)$checked,
        label = paste(name, names(change)))
    }
    for (like in list(chained, read_gear("gillnet"))) {
      expect_identical(as_gear(gear$plan, like = like)$checked, gear$checked, label = name)
    }
  }
  expect_gt(taken, 5 * sum(!duplicated(table$kind)))
})

test_that("update() changes, adds and removes fields by path and checks them", {
  gear <- read_gear("towed_cable")
  faster <- update(gear, towing.speed = "5 knot", ropes.cable.segments = NULL)
  expect_identical(faster$plan$towing$speed, "5 knot")
  expect_null(faster$plan$ropes$cable$segments)
  expect_identical(update(faster, towing.speed = "4 knot", ropes.cable.segments = 200)$plan$towing,
    gear$plan$towing)

  current <- list(list(depth = 0, speed = 1, toward = 0), list(depth = 50, speed = 0.5, toward = 0))
  streamed <- update(gear, water.current = current)
  expect_identical(gear_si(streamed)$water$current$x, c(1, 0.5))
  slower <- update(streamed, water.current.2.speed = "0.1 m/s")
  expect_identical(gear_si(slower)$water$current$x, c(1, 0.1))

  moved <- with_fields(gear, list(points.ship.position.3 = "-5 m"))
  expect_identical(gear_si(moved)$points$ship$position, c(0, 0, -5))

  expect_refused(update(gear, ropes.cabel.length = 1), "cable")
  expect_refused(update(gear, towing.speed.x = 1))
  expect_refused(update(gear, water.current.1.speed = 1))
})

test_that("assembly() returns an assembly unchanged", {
  gear <- read_gear("towed_cable")
  expect_identical(assembly(gear), gear)
  expect_wrong(assembly(list()))
})

test_that("plan changed by hand is checked again", {
  gear <- read_gear("towed_cable")
  gear$plan$towing$speed <- 1.5
  expect_identical(gear_si(gear)$towing$speed, 1.5)
  gear$plan$towing$speed <- -1
  expect_refused(gear_si(gear))
})

test_that("check reuses panel edges only while shapes are the same", {
  gear <- assembly(read_gear("midwater_trawl"))
  path <- "panels.belly_section_2.twine.diameter"
  thicker <- do.call(update, c(list(gear), setNames(list("4.1 mm"), path)))
  expect_identical(thicker$checked, as_gear(thicker$plan)$checked)
  expect_identical(gear_structure(gear_si(thicker)), gear_structure(gear_si(gear)))
  # edges are reused only for the same shape
  si <- gear_si(gear)
  marked <- gear$checked
  marked$si$seams[[1]]$edges[[1]][[1]]$mark <- TRUE
  of <- function(gear) check_whole(gear$plan, marked)$si$seams[[1]]$edges[[1]][[1]]$mark
  expect_true(of(thicker))
  panel <- si$seams[[1]]$edges[[1]][[1]]$panel
  finer <- do.call(update, c(list(gear), setNames(list(gear$plan$panels[[panel]]$meshes$deep + 1),
    paste0("panels.", panel, ".meshes.deep"))))
  expect_null(of(finer))
})

test_that("update() converts changed parts to their plain form", {
  gear <- assembly(read_gear("midwater_trawl"))
  changed <- update(gear,
    panels.belly_section_2.twine = list(diameter = 0.004, material = "PA", double = FALSE),
    points = c(gear$plan$points, list(spare = list(position = list(1L, 2L, 3L), held = "moved"))),
    points.spare.load = 1:3
  )
  expect_identical(changed$plan, as_gear(changed$plan)$plan)
  expect_identical(changed$plan$points$spare,
    list(position = c(1, 2, 3), held = "moved", load = c(1, 2, 3)))
  expect_identical(changed$plan$panels$belly_section_2$twine$material, "PA")
})
