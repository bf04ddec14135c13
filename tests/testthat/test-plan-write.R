test_that("write_gear() of every test plan reads back identically", {
  for (name in Sys.glob(test_path("plans", "*.yaml"))) {
    gear <- read_gear(name)
    file <- tempfile(fileext = ".yaml")
    write_gear(gear, file)
    expect_identical(read_gear(file)$plan, gear$plan, label = name)
  }
})

test_that("numbers and strings of every kind read back identically", {
  texts <- c(
    "yes", "no", "null", "~", "NA", "n", "on", "1e3", "1_000", "012", "0x1F", "2020-01-01", "1:30",
    "5", "-5 m", "4.5 knot", "45 %", " a", "a ", "a: b", "a #b", "#a", "- a", "[a]", "{a}", "'",
      "\"",
    "a\nb", "a\tb", "\\", "/", "!expr 1", "&a", "*a", "%a", "@a", "`a`", "|", ">", "?", "a,b", "<<",
    "\u00e5\u4e2d", "belly.upper[0:6]", "-belly.right", ".inf", ".5", "5.", "a  b", "\u0001", "=",
    "true", "a:", ":", "-", "+1 m", "1 000 m", "\u0085", "\u00a0", "\u2028", "\u007f"
  )
  numbers <- c(0, 1, -1, 0.1, 1 / 3, 1e-300, 1e17, 1e5, 1e15, 123456789, 2^53, pi, 1e-6, 100000)
  plan <- list(
    codend = 1, name = "x", notes = texts, sources = stats::setNames(as.list(texts), texts),
    points = list(
      a = list(position = numbers[1:3], held = "fixed"),
      b = list(at = "a", load = numbers[4:6]), c = list(at = "a", load = numbers[7:9]),
      d = list(at = "a", load = numbers[10:12]), e = list(at = "a", load = list(1, "2 kN", 3))
    )
  )
  gear <- as_gear(plan)
  file <- tempfile()
  write_gear(gear, file)
  expect_identical(read_gear(file)$plan, gear$plan)
})

test_that("write_gear() keeps remarks and layout of unchanged lines", {
  gear <- read_gear("poly_noreastern_trawl")
  source <- readLines(gear$file, encoding = "UTF-8")
  expect_identical(strsplit(format(gear, remarks = TRUE), "\n", fixed = TRUE)[[1]], source)
  changed <- update(gear,
    towing.speed = "3.5 knot", sections.codend.mesh_size = "40 mm", belly_lines.hanging_ratio = 0.9,
    bridles.middle = NULL, otter_boards.drag_coefficient = 0.6,
    footrope_extensions = list(length = "5 m", diameter = 0.1, material = "steel_wire"),
    warps = list(length = "300 m", diameter = 0.02, material = "steel_wire"),
    belly_lines.until = NULL, towing = list(speed = 2), sections.body.back = list(knotted = FALSE)
  )
  file <- tempfile(fileext = ".yaml")
  write_gear(changed, file)
  expect_identical(read_gear(file)$plan, changed$plan)
  lines <- readLines(file, encoding = "UTF-8")
  marks <- function(lines) sub("^[^#]*", "", lines[grepl("#", lines, fixed = TRUE)])
  # only the remarks on deleted lines are gone
  gone <- grepl("volume_per_length|mass_per_length: [{]value: 7 kg", source)
  gone <- gone[grepl("#", source, fixed = TRUE)]
  expect_identical(marks(lines), marks(source)[!gone])
  expect_true("  hanging_ratio: 0.9                    # [published]" %in% lines)
})

test_that("write_gear() drops the remark of a section that a schedule replaces", {
  remark <- "shoot, tow, turn to starboard, haul"
  gear <- read_gear("midwater_trawl")
  written <- function(gear) format(gear, remarks = TRUE)
  expect_match(written(update(gear, tow.every = "20 s")), remark)
  turn <- tow_schedule(course = data.frame(time = c(60, 240), value = c("0 deg", "90 deg")))
  turned <- written(update(gear, tow = turn))
  expect_no_match(turned, remark)
  expect_match(turned, "\ntow:\n")
  # other remarks remain
  expect_match(turned, "as in the paper: Morison-type drag")
})

test_that("write_gear() of any changed shipped plan reads back identically", {
  # every field is removed once, and every number changed, also if the gear becomes impossible
  for (name in c("towed_cable", "gillnet", "t90_codend", "model_cage", "purse_seine")) {
    text <- paste(c(readLines(shipped_plans()[[name]], encoding = "UTF-8"), ""), collapse = "\n")
    plan <- plan_of_bytes(charToRaw(text), name)
    kept <- 0
    for (field in names(plan)) {
      without <- plan[names(plan) != field]
      changed <- without
      changed$new_field <- list(a = "1 m", b = list(c = c(1, 2), d = list(list(e = "x: y"))))
      for (wanted in list(without, changed)) {
        found <- edited_text(text, wanted)
        expect_identical(plan_of_bytes(charToRaw(found), name), wanted, label = paste(name, field))
        kept <- kept + grepl("#", found, fixed = TRUE)
      }
    }
    expect_gt(kept, 0)
  }
})
