# Lattices of gears that differ from one whose shape is known.

changed_gear <- function(gear, path, value) {
  gear_si(do.call(update, c(list(gear), stats::setNames(list(value), path))))
}

test_that("other conditions change the water and the ground of a lattice, and nothing else", {
  changes <- list(
    list("midwater_trawl", "towing.speed", "4.7 knot", "water"),
    list("poly_noreastern_trawl", "seabed.depth", "101 m", "ground"),
    list("model_cage", "water.current.speed", "0.3 m/s", "water")
  )
  for (change in changes) {
    gear <- read_gear(change[[1]])
    first <- build_lattice(gear_si(gear), 300)
    shape <- list(lattice = first, position = lattice_points(first, first$start))
    again <- build_lattice(changed_gear(gear, change[[2]], change[[3]]), 300, NULL, shape)
    label <- paste(change[[1]], change[[2]])
    fields <- engine_mesh_fields(first$mesh)
    same <- setdiff(names(fields), change[[4]])
    expect_identical(engine_mesh_fields(again$mesh)[same], fields[same], label = label)
    expect_false(identical(again$mesh[[change[[4]]]], fields[[change[[4]]]]), label = label)
    expect_identical(again$start, first$start, label = label)
    parts <- setdiff(names(first), c("mesh", "place"))
    expect_identical(unclass(again)[parts], unclass(first)[parts], label = label)
    expect_identical(again$places, first$places, label = label)
  }
})

test_that("a lattice of other lengths is divided as the one that its shape is of", {
  for (name in c("midwater_trawl", "poly_noreastern_trawl", "model_cage", "longline")) {
    gear <- read_gear(name)
    si <- gear_si(gear)
    first <- build_lattice(si, 200)
    shape <- list(lattice = first, position = lattice_points(first, first$start))
    longer <- si
    longer$ropes <- lapply(si$ropes, function(rope) {
      rope$length <- 1.05 * rope$length
      rope
    })
    again <- build_lattice(longer, 200, NULL, shape)
    expect_identical(again$counts, first$counts)
    expect_identical(again$ropes, first$ropes)
    expect_identical(engine_array(again, "bars", "node"), engine_array(first, "bars", "node"))
    of_ropes <- first$bar_part <= length(si$ropes)
    expect_equal(engine_array(again, "bars", "rest")[of_ropes],
      1.05 * engine_array(first, "bars", "rest")[of_ropes], tolerance = 1e-13)
    # what is divided anew is not
    expect_false(identical(build_lattice(si, 230, NULL, shape)$counts, first$counts))
  }
})

test_that("a shape of other parts is refused by the engine", {
  first <- build_lattice(gear_si(read_gear("midwater_trawl")), 200)
  other <- gear_si(read_gear("model_cage"))
  map <- part_map(gear_si(read_gear("midwater_trawl")), first)
  expect_error(
    engine_lattice(
      gear_numbers(other), lattice_numbers(other, NULL)$model, 0, 200, NULL, map,
      as.double(first$start), FALSE
    ),
    "not those of the gear's parts", class = "codend_error_engine"
  )
})
