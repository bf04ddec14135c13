# The engine as a separate program (tests/engine/programs/settle_file.cpp), compared with settle().

engine_program <- test_path("..", "engine", "build", "optimised", "settle_file")

# A model of the engine as the program's text of arrays: see src/engine/base/text_source.hpp.
model_text <- function(x, name) {
  if (is.list(x) && (is.null(names(x)) || !length(x))) {
    items <- Map(model_text, x, paste0(name, ".", seq_along(x)))
    return(c(paste(name, "list", length(x)), unlist(items)))
  }
  if (is.list(x)) return(unlist(Map(model_text, x, paste0(name, ".", names(x)))))
  if (is.null(x)) return(NULL)
  type <- switch(typeof(x), double = "number", integer = "whole", logical = "mark", "name")
  values <- switch(typeof(x), double = sprintf("%.17g", x), logical = as.integer(x), x)
  paste(c(name, type, length(x), values), collapse = " ")
}

run_program <- function(text, program = engine_program, ...) {
  file <- tempfile(fileext = ".txt")
  on.exit(unlink(file))
  writeLines(text, file)
  said <- suppressWarnings(system2(program, c(shQuote(file), ...), stdout = TRUE, stderr = TRUE))
  list(said = said, status = c(attr(said, "status"), 0L)[1])
}

array_of <- function(said, name) {
  words <- strsplit(paste(said, collapse = " "), " ")[[1]]
  at <- which(words == name)
  as.numeric(words[at + 2L + seq_len(as.integer(words[at + 2L]))])
}

test_that("engine program settles a gear from a file as settle() does", {
  skip_if_not(file.exists(engine_program), "engine programs: make -C tests/engine programs")
  # triangles and catch of a trawl, ground and struts of a beam trawl, one body on a cable
  for (name in c("towed_cable", "beam_trawl", "midwater_trawl")) {
    state <- if (name == "midwater_trawl") settled(name, nodes = 400) else settled(name)
    mesh <- state$mesh
    from <- as.double(mesh$start)
    run <- run_program(c(model_text(engine_model_fields(mesh$model), "model"), model_text(from,
      "start")))
    expect_identical(run$status, 0L, info = name)
    expect_identical(array_of(run$said, "converged"), 1)
    found <- matrix(array_of(run$said, "position"), 3L)
    size <- max(apply(state$position, 1L, function(x) diff(range(x))))
    # From another start. The tolerance limits forces; slack netting moves by a few times as much.
    expect_lt(max(abs(found - state$position)) / size, 10 * settle_tolerance)
  }
})

test_that("engine program names the wrong field of a file", {
  skip_if_not(file.exists(engine_program), "engine programs: make -C tests/engine programs")
  mesh <- build_mesh(gear_si(read_gear("towed_cable")))
  fields <- engine_model_fields(mesh$model)
  fields$bars$rest[2] <- NaN
  run <- run_program(c(
    model_text(fields, "model"), model_text(as.double(mesh$start), "start")
  ))
  expect_identical(run$status, 1L)
  expect_match(run$said, "model.bars.rest[2] must be a finite number", fixed = TRUE)
})

# All numbers of a gear, as in src/engine/measure/measured_gear.hpp.
gear_text <- function(state, asked) {
  numbers <- c(mesh_numbers(state$si, NULL), list(
    questions = questions_of(state$si, state$mesh, asked),
    blocked = planned_front(state$si), volume = max(0, state$si$catch$volume, na.rm = TRUE)
  ))
  unlist(Map(model_text, numbers, names(numbers)))
}

test_that("program without R gives the same measures and errors", {
  program <- sub("settle_file", "settle_gear", engine_program)
  skip_if_not(file.exists(program), "the engine's programs are not built")
  for (name in gears()$name) {
    state <- suppressWarnings(settle(name, nodes = 1500))
    # a shot gear starts from the shape in which it sinks, which R integrates in time
    if (!is.null(state$si$shooting)) next
    asked <- measure_request(state$si)
    found <- run_program(gear_text(state, asked), program, "1500")
    expect_identical(found$status, 0L, label = paste(name, found$said[1]))
    told <- state_values(state)
    has <- match(names(told$values), names(measured_kinds(state$si)))
    expect_identical(array_of(found$said, "measures")[has], unname(told$values), label = name)
    expect_identical(
      array_of(found$said, "errors")[has], unname(state_errors(state, told)), label = name
    )
  }
})

test_that("example in the header of codend.hpp runs", {
  program <- sub("settle_file", "header_example", engine_program)
  skip_if_not(file.exists(program), "the engine's programs are not built")
  state <- settle("flat_panel", nodes = 1500)
  run <- run_program(gear_text(state, state$si$measures), program)
  expect_identical(run$status, 0L)
  own <- seq_along(state$si$measures)
  expect_match(run$said[own], "^[-0-9.e]+ \\+- [-0-9.e]+$")
  found <- as.double(sub(" .*", "", run$said[own]))
  expect_equal(found, unname(state_values(state)$values)[own], tolerance = 1e-5)
  # a gear at rest stays within the allowed error of a step
  expect_lt(as.double(run$said[length(own) + 1L]), 0.01)
})
