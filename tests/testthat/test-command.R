# The commands without a shell: status, output and error streams, files. test-command-line.R tests
# the shell.

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

test_that("help of every command shows its usage", {
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

test_that("parse_command() takes the last value of a field as in plans", {
  words <- command_words()$settle
  taken <- parse_command("settle", words, c("a", "--set", "x=1", "--set=y=yes", "--uncertainty",
    "--set", "x=2.5e3", "--set=z=3 m", "--nodes", "5", "--nodes=6"))
  expect_identical(taken$plan, "a")
  expect_identical(taken$options$set, list(y = TRUE, x = 2500, z = "3 m"))
  expect_true(taken$options$uncertainty)
  expect_identical(taken$options$nodes, 6)
  for (wrong in list("--set", c("--set", "x"), "--uncertainty=yes", "--nodes=-6", "--nod", "-s",
      character())) {
    expect_error(parse_command("settle", words, wrong), class = "codend_error_usage")
  }
})

# Expected messages, by command line.
wrong_uses <- c(
  "sink" = "no command sink; the commands are check,", "check" = "one PLAN is needed, not 0",
  "settle --nets towed_cable" = "no option --nets",
  "settle towed_cable --nodes many" = "--nodes is many",
  "settle towed_cable --nodes 0" = "--nodes is 0; it must be .* See codend settle --help.",
  "settle towed_cable --nodes" = "--nodes needs a value",
  "settle towed_cable --set speed" = "--set is speed",
  "settle towed_cable --json none/state.json" = "--json is none/state.json",
  "new" = "a KIND is needed, one of bottom_trawl,", "new bottom_trawl '30 m'" = "NAME=VALUE",
  "flume --port 80" = "--port is 80; it must be",
  "flume towed_cable flat_panel" = "at most one PLAN", "optimise towed_cable" = "--minimise",
  "optimise --minimise total_drag --change a towed_cable" = "FIELD = FROM",
  "optimise --minimise a --change 'a = 1 .. 2' --starts none towed_cable" = "--starts is none",
  "find --change 'towing.speed = 1 .. 3' towed_cable" = "--target is empty",
  "find --target body_depth towed_cable --change 'a = 1 .. 2'" = "MEASURE = VALUE",
  "find --target 'body_depth = 3 m' towed_cable" = "--change is empty",
  "find --change 'a = 1 .. 2' --target 'a = 1' --json none/a.json gillnet" =
    "--json is none/a.json",
  "calibrate --data x.csv --match Depth towed_cable" = "COLUMN ~ MEASURE",
  "calibrate --data x.csv --match 'Depth ~ depth' towed_cable" = "--data is x.csv",
  "study new x.study towed_cable" = "either --designs",
  "study new x.study towed_cable --change towing.speed" = "FIELD = A, B",
  "study new x.study towed_cable --designs x.csv" = "x.csv; it must be a CSV file that exists",
  "study fly x.study" = "the actions are new, run", "study plot x.study" = "--out FILE.png",
  "report towed_cable --out ." = "--out is .*[.]html", "export towed_cable" = "FILE... is needed",
  "export towed_cable a.obj" = "end in one of .vtu",
  "export towed_cable a.pvd" = "a.pvd holds a tow",
  "export towed_cable none/a.vtu" = "a writable folder",
  "export kept.nc --nodes 9 a.vtu" = "cannot change the result file",
  "draw gillnet a.jpg" = "must end in one of .svg, .pdf, .png, .dxf",
  "draw gillnet a.svg --page B4" = "--page is B4"
)
wrong_plans <- c(
  "check no_such_plan" = "no_such_plan", "check wrong.yaml" = "`ropes.cable.length` is -5 m",
  "settle towed_cable --set 'towing.sped=5 knot'" = "towing.sped",
  "report towed_cabel --out a.html" = "towed_cable",
  "settle towed_cable --accuracy -1" = "`accuracy` is",
  "sensitivities --of depth --nodes 50 towed_cable" = "`of` is \"depth\"",
  # only formulas are evaluated
  "optimise --minimise 'quit()' --change 'towing.speed = 1 .. 3' towed_cable" = "`quit`"
)

test_that("wrong command leaves no file and exits with 1 or 2", {
  kept <- setwd(test_folder())
  on.exit(setwd(kept))
  shipped <- readLines(system.file("gears", "towed_cable.yaml", package = "codend"))
  writeLines(sub("length: 1000 m", "length: -5 m", shipped), "wrong.yaml")
  for (status in 1:2) {
    said <- list(wrong_plans, wrong_uses)[[status]]
    for (line in names(said)) {
      wrong <- ran(scan(text = line, what = "", quiet = TRUE))
      expect_identical(wrong$status, status, label = line)
      expect_match(paste(wrong$err, collapse = " "), said[[line]], label = line)
      expect_identical(wrong$out, character())
    }
  }
  expect_identical(list.files(all.files = TRUE, no.. = TRUE), "wrong.yaml")
})

test_that("settle --uncertainty prints intervals and writes them as JSON", {
  file <- file.path(test_folder(), "cable.json")
  found <- ran("settle", "towed_cable", "--nodes", "40", "--uncertainty", "--json", file)
  expect_identical(found$status, 0L)
  expect_match(found$out, "body depth .* m +90 %: +[0-9.]+ +to +[0-9.]+ +\\(.*plan", all = FALSE)
  expect_match(found$out, "largest sources", fixed = TRUE, all = FALSE)
  said <- jsonlite::read_json(file)$uncertainty$body_depth_m
  known <- uncertainty(settle("towed_cable", nodes = 40), "body_depth_m")$measures
  expect_equal(unlist(said[c("lower", "upper", "error")]),
    unlist(known[c("lower", "upper", "error")]), tolerance = 1e-12)
})

test_that("export command writes every format of a state", {
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
  # a CSV file stores 15 digits
  expect_equal(table$tension_kN, as.data.frame(state, what = "tensions")$tension_kN,
    tolerance = 1e-13)
})

test_that("export command gives the same file from a saved state", {
  skip_if_not_installed("RNetCDF")
  folder <- test_folder()
  at <- function(name) file.path(folder, name)
  made <- ran("export", "towed_cable", at("cable.vtu"), at("cable.nc"), "--set", "towing.speed=2")
  expect_identical(made$status, 0L)
  expect_identical(read_result(at("cable.nc"))$si$towing$speed, 2)
  expect_identical(ran("export", at("cable.nc"), at("again.vtu"))$status, 0L)
  expect_identical(unname(tools::md5sum(at("again.vtu"))), unname(tools::md5sum(at("cable.vtu"))))
})

test_that("draw command writes every format on the requested sheet", {
  files <- file.path(test_folder(), c("net.svg", "net.dxf"))
  drawn <- ran("draw", "gillnet", files, "--page", "A3", "--set", "wall.mesh_size=140 mm")
  expect_identical(drawn$status, 0L)
  expect_true(all(file.exists(files)))
  svg <- paste(readLines(files[1]), collapse = "")
  expect_match(svg, "width=\"420mm\"", fixed = TRUE)
  expect_match(svg, ">140<", fixed = TRUE)
})

test_that("export formats have unique names and extensions", {
  expect_false(anyDuplicated(vapply(export_formats, `[[`, "", "name")) > 0)
  expect_false(anyDuplicated(vapply(export_formats, `[[`, "", "extension")) > 0)
  expect_null(format_of_file("cable.obj"))
  expect_identical(format_of_file("A.VTU")$name, "vtu")
})

test_that("new command prints a plan or writes it to a file", {
  shown <- ran("new", "bottom_trawl", "headline=30 m")
  expect_identical(shown$status, 0L)
  file <- tempfile(fileext = ".yaml")
  expect_identical(ran("new", "bottom_trawl", "headline=30 m", "--file", file)$status, 0L)
  expect_identical(readLines(file), shown$out)
})
