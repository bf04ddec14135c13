# Meshes of gears that differ from a gear with a known shape.

changed_gear <- function(gear, path, value) {
  gear_si(do.call(update, c(list(gear), stats::setNames(list(value), path))))
}

test_that("changed conditions change only the water and ground of a mesh", {
  changes <- list(
    list("midwater_trawl", "towing.speed", "4.7 knot", "water"),
    list("poly_noreastern_trawl", "seabed.depth", "101 m", "ground"),
    list("model_cage", "water.current.speed", "0.3 m/s", "water")
  )
  for (change in changes) {
    gear <- read_gear(change[[1]])
    first <- build_mesh(gear_si(gear), 300)
    shape <- list(mesh = first, position = mesh_points(first, first$start))
    again <- build_mesh(changed_gear(gear, change[[2]], change[[3]]), 300, NULL, shape)
    label <- paste(change[[1]], change[[2]])
    fields <- engine_model_fields(first$model)
    same <- setdiff(names(fields), change[[4]])
    expect_identical(engine_model_fields(again$model)[same], fields[same], label = label)
    expect_false(identical(again$model[[change[[4]]]], fields[[change[[4]]]]), label = label)
    expect_identical(again$start, first$start, label = label)
    parts <- setdiff(names(first), "model")
    expect_identical(unclass(again)[parts], unclass(first)[parts], label = label)
    expect_identical(again$places, first$places, label = label)
  }
})

test_that("mesh from a shape keeps its counts for other lengths", {
  for (name in c("midwater_trawl", "poly_noreastern_trawl", "model_cage", "longline")) {
    gear <- read_gear(name)
    si <- gear_si(gear)
    first <- build_mesh(si, 200)
    shape <- list(mesh = first, position = mesh_points(first, first$start))
    longer <- si
    longer$ropes <- lapply(si$ropes, function(rope) {
      rope$length <- 1.05 * rope$length
      rope
    })
    again <- build_mesh(longer, 200, NULL, shape)
    expect_identical(again$counts, first$counts)
    expect_identical(again$ropes, first$ropes)
    expect_identical(engine_array(again, "bars", "node"), engine_array(first, "bars", "node"))
    of_ropes <- first$bar_part <= length(si$ropes)
    expect_equal(engine_array(again, "bars", "rest")[of_ropes],
      1.05 * engine_array(first, "bars", "rest")[of_ropes], tolerance = 1e-13)
    # with another node count the counts change
    expect_false(identical(build_mesh(si, 230, NULL, shape)$counts, first$counts))
  }
})

test_that("engine rejects a shape of other parts", {
  first <- build_mesh(gear_si(read_gear("midwater_trawl")), 200)
  other <- gear_si(read_gear("model_cage"))
  map <- part_map(gear_si(read_gear("midwater_trawl")), first)
  expect_error(
    engine_mesh(
      gear_numbers(other), mesh_numbers(other, NULL)$model, 0, 200, NULL, map,
      as.double(first$start), FALSE
    ),
    "do not match the parts of the gear", class = "codend_error_engine"
  )
})
