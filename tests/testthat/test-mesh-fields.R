# The engine reads meshes by its own table of fields, and reports the wrong field.

engine_of <- function(name) engine_model_fields(build_mesh(gear_si(read_gear(name)),
  nodes = 200)$model)

# The field that the engine rejects, and its message.
complaint <- function(engine) {
  x <- numeric(3L * engine$nodes)
  error <- tryCatch(engine_evaluate(engine_model(engine), x, x), codend_error_engine = identity)
  expect_s3_class(error, "codend_error")
  c(error$field, conditionMessage(error))
}

test_that("mesh has exactly the fields of the engine", {
  table <- list2DF(engine_fields())
  for (name in c("midwater_trawl", "beam_trawl")) {
    engine <- engine_of(name)
    of_one <- c("", "ground", "plates", "plates.polar", "sliding")
    # only for gears that have them
    of_one <- c(of_one, "water.waves", "load_table", "line_friction", "multipliers")
    for (kind in setdiff(unique(table$kind), of_one)) {
      elements <- Reduce(`[[`, strsplit(kind, ".", fixed = TRUE)[[1]], engine)
      inner <- if (kind == "blended") "materials"
      expect_setequal(names(elements), c(table$name[table$kind == kind], inner))
    }
  }
})

test_that("engine names an array of the wrong length or type", {
  engine <- engine_of("midwater_trawl")
  bars <- length(engine$bars$rest)

  short <- engine
  short$bars$rest <- short$bars$rest[-1L]
  expect_identical(complaint(short)[1], "bars.rest")
  expect_match(complaint(short)[2], sprintf("has %d values, must have %d", bars - 1L, bars))

  text <- engine
  text$spheres$diameter <- rep("thick", length(text$spheres$node))
  expect_match(complaint(text)[2], "spheres.diameter must be numbers", fixed = TRUE)
})

test_that("engine rejects positions of another mesh", {
  engine <- engine_of("beam_trawl")
  expect_error(engine_evaluate(engine_model(engine), numeric(3), numeric(3)),
    "position has 3 values",
    class = "codend_error_engine")
})

test_that("errors of R pass through the engine unchanged", {
  engine <- engine_of("beam_trawl")
  start <- as.double(build_mesh(gear_si(read_gear("beam_trawl")), nodes = 200)$start)
  stop_it <- function(...) {
    classes <- c("watched", "error", "condition")
    stop(structure(list(message = "enough", call = NULL), class = classes))
  }
  expect_error(
    engine_settle(engine_model(engine), start, "crude", numeric(), integer(), 1e-8, 5L, stop_it),
    class = "watched"
  )
})

test_that("state has every force that the engine reports", {
  expect_setequal(names(settled("midwater_trawl", nodes = 400)$forces), reported_forces()$name)
})
