# Lattices filled again equal those built anew.

changed_gear <- function(gear, path, value) {
  gear_si(do.call(update, c(list(gear), stats::setNames(list(value), path))))
}

test_that("a lattice filled with other conditions equals the one that is built", {
  changes <- list(
    list("midwater_trawl", "towing.speed", "4.7 knot"),
    list("poly_noreastern_trawl", "towing.speed", "3.3 knot"),
    list("poly_noreastern_trawl", "seabed.depth", "101 m"),
    list("model_cage", "water.current.speed", "0.3 m/s"),
    list("t90_codend", "towing.speed", "1.3 m/s")
  )
  for (change in changes) {
    gear <- read_gear(change[[1]])
    shape <- state_shape(settle(gear, nodes = 300))
    si <- changed_gear(gear, change[[2]], change[[3]])
    filled <- fill_lattice(si, 300, NULL, shape)
    label <- paste(change[[1]], change[[2]])
    expect_false(is.null(filled), label = label)
    shape$settled <- NULL
    built <- build_lattice(si, 300, NULL, shape)
    if (!is.null(si$catch)) built <- set_catch_front(built, shape$lattice$catch$blocked)
    expect_identical(filled$engine, built$engine, label = label)
    expect_identical(filled$start, built$start, label = label)
    expect_identical(names(filled), names(built), label = label)
  }
})

test_that("a lattice is built anew where more than the conditions has changed", {
  gear <- read_gear("midwater_trawl")
  shape <- state_shape(settle(gear, nodes = 300))
  expect_null(fill_lattice(gear_si(gear), 301, NULL, shape))
  expect_null(fill_lattice(gear_si(gear), 300, "cells", shape))
  for (change in list(
    list("warps.length", "720 m"), list("otter_boards.mass", "4.1 tonne"),
    list("water.density", "1000 kg/m3"), list("water.free_surface", FALSE)
  )) {
    si <- changed_gear(gear, change[[1]], change[[2]])
    expect_null(fill_lattice(si, 300, NULL, shape), label = change[[1]])
  }
})

test_that("a lattice that takes its division from another equals the one that is built", {
  taken <- 0
  for (name in c("midwater_trawl", "poly_noreastern_trawl", "model_cage", "longline")) {
    gear <- read_gear(name)
    si <- gear_si(gear)
    first <- build_lattice(si, 200)
    shape <- list(lattice = first, position = lattice_points(first, first$start), settled = si)
    fields <- slope_fields(gear, "all")
    # a field of every name
    fields <- fields[!duplicated(sub(".*[.]", "", vapply(fields, `[[`, "", "name")))]
    for (field in fields) {
      changed <- scaled_gear(gear, field, 0.01)
      if (is.null(changed)) next
      changed <- gear_si(changed)
      taken <- taken + !is.null(division_again(changed, shape))
      made <- lapply(list(si, NULL), function(settled) {
        shape$settled <- settled
        shape$lattice$engine$wake <- numeric()
        lattice <- build_lattice(changed, 200, NULL, shape)
        c(unclass(lattice)[names(lattice) != "place"], places = lattice_places(lattice))
      })
      expect_identical(made[[1]], made[[2]], label = paste(name, field$name))
    }
  }
  expect_gt(taken, 40)
})

test_that("a division is taken over only where it would be the same", {
  gear <- read_gear("poly_noreastern_trawl")
  first <- build_lattice(gear_si(gear), 200)
  shape <- list(lattice = first, settled = gear_si(gear))
  again <- function(path, value) !is.null(division_again(changed_gear(gear, path, value), shape))
  expect_true(again("warps.length", "310 m"))
  expect_false(again("sections.body.mesh_size", "110 mm"))
  expect_false(again("head_line.length", "27.4 m"))
  shape$lattice$division$runs <- NULL
  expect_false(again("warps.length", "310 m"))
})

test_that("netting that is taken again equals the netting that is made", {
  gear <- read_gear("midwater_trawl")
  si <- gear_si(gear)
  first <- build_lattice(si, 200)
  shape <- list(lattice = first, position = lattice_points(first, first$start), settled = si)
  longer <- changed_gear(gear, "warps.length", "720 m")
  build <- function() {
    lattice <- build_lattice(longer, 200, NULL, shape)
    unclass(lattice)[names(lattice) != "place"]
  }
  again <- build()
  build_lattice(gear_si(read_gear("model_cage")), 200)
  expect_identical(again, build())
  # another twine on the same knots, beside knots made for another net in between
  longer <- changed_gear(gear, "sections.section_3.twine.diameter", "5 mm")
  again <- build()
  build_lattice(gear_si(read_gear("model_cage")), 200, "bars")
  expect_identical(again, build())
})
