# The commands without a shell: status, both outputs, files. What a shell adds is tested in
# test-command-line.R.

ran <- function(...) {
  said <- tempfile()
  connection <- file(said, "w")
  on.exit(unlink(said))
  sink(connection, type = "message")
  status <- NULL
  out <- tryCatch(utils::capture.output(status <- run_command(c(...))), finally = {
    sink(type = "message")
    close(connection)
  })
  list(status = status, out = out, err = readLines(said))
}

test_that("the help of every command says how it is used", {
  usage <- ran("--help")$out
  expect_setequal(names(command_words()), names(command_runs()))
  for (name in names(command_words())) {
    help <- ran(name, "--help")
    expect_identical(help$status, 0L)
    expect_match(help$out[1], paste("Usage: codend", name), fixed = TRUE)
    expect_true(any(startsWith(usage, paste0("  ", name, " ")) &
      endsWith(usage, command_words()[[name]]$does)))
  }
})

test_that("the last of two values for a field counts, and text is read as in a plan", {
  words <- command_words()$settle
  taken <- parse_command("settle", words, c("a", "--set", "x=1", "--set=y=yes", "--uncertainty",
    "--set", "x=2.5e3", "--set=z=3 m", "--nodes", "5", "--nodes=-6"))
  expect_identical(taken$plan, "a")
  expect_identical(taken$options$set, list(y = TRUE, x = 2500, z = "3 m"))
  expect_true(taken$options$uncertainty)
  expect_identical(taken$options$nodes, "-6")
  for (wrong in list("--set", c("--set", "x"), "--uncertainty=yes", "--nod", "-s", character())) {
    expect_error(parse_command("settle", words, wrong), class = "codend_error_usage")
  }
})

test_that("status and message tell a wrong use from a wrong plan", {
  wrong <- ran("settle", "towed_cable", "--nodes", "0")
  expect_identical(wrong$status, 2L)
  expect_match(wrong$err, "--nodes is 0; it must be .* See codend settle --help.")
  wrong <- ran("check", "no_such_plan")
  expect_identical(wrong$status, 1L)
  expect_match(paste(wrong$err, collapse = " "), "no_such_plan")
  expect_identical(wrong$out, character())
})

test_that("settle --uncertainty shows intervals next to the estimated errors, and in JSON", {
  file <- file.path(test_folder(), "cable.json")
  found <- ran("settle", "towed_cable", "--nodes", "40", "--uncertainty", "--json", file)
  expect_identical(found$status, 0L)
  expect_match(found$out, "body depth .* m +90 %: +[0-9.]+ +to +[0-9.]+ +\\(.*plan", all = FALSE)
  expect_match(found$out, "largest sources", fixed = TRUE, all = FALSE)
  said <- jsonlite::read_json(file)$uncertainty$body_depth_m
  known <- uncertainty(settle("towed_cable", nodes = 40), "body_depth_m")$measures
  expect_equal(unlist(said[c("low", "high", "uncertainty")]),
    unlist(known[c("low", "high", "uncertainty")]), tolerance = 1e-12)
})

test_that("export writes every format of a state, each as its writer does", {
  folder <- test_folder()
  formats <- Filter(function(format) {
    is.null(format$package) || requireNamespace(format$package, quietly = TRUE)
  }, formats_of("state"))
  files <- file.path(folder, paste0("cable", vapply(formats, `[[`, "", "extension")))
  found <- ran("export", "towed_cable", files, "--nodes", "20")
  expect_identical(found$status, 0L)
  expect_setequal(list.files(folder, all.files = TRUE, no.. = TRUE), basename(files))
  state <- settle("towed_cable", nodes = 20)
  again <- file.path(folder, "again")
  formats$glb$write(state, paste0(again, ".glb"))
  expect_identical(unname(tools::md5sum(paste0(again, ".glb"))),
    unname(tools::md5sum(files[names(formats) == "glb"])))
  table <- utils::read.csv(files[names(formats) == "tensions"])
  # a CSV file holds 15 digits
  expect_equal(table$tension_kN, as.data.frame(state, what = "tensions")$tension_kN,
    tolerance = 1e-13)
})

test_that("a kept state is exported as its plan is, and a wrong use settles nothing", {
  skip_if_not_installed("RNetCDF")
  folder <- test_folder()
  at <- function(name) file.path(folder, name)
  made <- ran("export", "towed_cable", at("cable.vtu"), at("cable.nc"), "--set", "towing.speed=2")
  expect_identical(made$status, 0L)
  expect_identical(read_state(at("cable.nc"))$si$towing$speed, 2)
  expect_identical(ran("export", at("cable.nc"), at("again.vtu"))$status, 0L)
  expect_identical(unname(tools::md5sum(at("again.vtu"))), unname(tools::md5sum(at("cable.vtu"))))
  wrong <- function(...) {
    found <- ran("export", ...)
    expect_identical(found$status, 2L)
    paste(found$err, collapse = " ")
  }
  wrong("towed_cable")
  expect_match(wrong("towed_cable", at("cable.obj")), "must end in one of .vtu")
  wrong("towed_cable", at("cable.pvd"))
  wrong("towed_cable", file.path(tempfile(), "cable.vtu"))
  wrong("kept.nc", "--nodes", "9", at("a.vtu"))
})

test_that("a plan is drawn in every format, on the sheet that is asked for", {
  files <- file.path(test_folder(), c("net.svg", "net.dxf", "net.jpg"))
  drawn <- ran("draw", "gillnet", files[1:2], "--page", "A3", "--set", "wall.mesh_size=140 mm")
  expect_identical(drawn$status, 0L)
  expect_true(all(file.exists(files[1:2])))
  svg <- paste(readLines(files[1]), collapse = "")
  expect_match(svg, "width=\"420mm\"", fixed = TRUE)
  expect_match(svg, ">140<", fixed = TRUE)
  wrong <- ran("draw", "gillnet", files[3])
  expect_identical(wrong$status, 2L)
  expect_match(paste(wrong$err, collapse = " "), "must end in one of .svg, .pdf, .png, .dxf",
    fixed = TRUE)
  expect_identical(ran("draw", "gillnet", files[1], "--page", "B4")$status, 2L)
})

test_that("no two formats share a name or an extension", {
  expect_false(anyDuplicated(vapply(export_formats, `[[`, "", "name")) > 0)
  expect_false(anyDuplicated(vapply(export_formats, `[[`, "", "extension")) > 0)
  expect_null(format_of_file("cable.obj"))
  expect_identical(format_of_file("A.VTU")$name, "vtu")
})

test_that("a new plan is printed, or written to a file", {
  shown <- ran("new", "bottom_trawl", "head_line=30 m")
  expect_identical(shown$status, 0L)
  file <- tempfile(fileext = ".yaml")
  expect_identical(ran("new", "bottom_trawl", "head_line=30 m", "--file", file)$status, 0L)
  expect_identical(readLines(file), shown$out)
  expect_identical(ran("new")$status, 2L)
  expect_identical(ran("new", "bottom_trawl", "30 m")$status, 2L)
})
