test_that("a hostile or broken file is one clear error, and nothing is evaluated", {
  trap <- tempfile()
  code <- sprintf("codend: 1\nname: !expr file.create('%s')\n", trap)
  expect_match(text_error(code)$message, "holds no code", fixed = TRUE)
  expect_false(file.exists(trap))

  cases <- list(
    list("", "must hold a map of fields"), list("# nothing", "must hold a map of fields"),
    list("- 1\n- 2", "must hold a map of fields"), list("hello", "must hold a map of fields"),
    list("a: [1", "not valid YAML"), list("\ta: 1", "not valid YAML"),
    list("a: 1\na: 2", "Duplicate map key"), list("a: *nowhere", "not valid YAML"),
    list(as.raw(c(0x61, 0x3a, 0x00, 0x31)), "NUL bytes"),
    list(as.raw(c(0x61, 0x3a, 0x20, 0xff, 0xfe)), "not UTF-8"),
    list(strrep("x", 2.2e6), "at most 2 MB"), list(strrep("[", 1e5), "nested too deeply"),
    list(strrep("{a: ", 1e4), "nested too deeply"), list(strrep("- ", 1e5), "nested too deeply"),
    list(paste0("a", seq_len(3e4), ": 1", collapse = "\n"), "too many fields"),
    list(paste0(strrep(" ", 0:40), "a:", collapse = "\n"), "nested at most 20 deep")
  )
  for (case in cases) expect_match(text_error(case[[1]])$message, case[[2]], fixed = TRUE)
})

test_that("aliases that multiply are refused", {
  lines <- vapply(1:9, function(i) {
    sprintf("a%d: &a%d [%s]", i, i, paste(rep(paste0("*a", i - 1), 9), collapse = ", "))
  }, "")
  bomb <- paste(c("a0: &a0 [x, x, x, x, x, x, x, x, x]", lines), collapse = "\n")
  expect_match(text_error(bomb)$message, "at most 50000 values")
})

test_that("line ends, a byte order mark and other alphabets do no harm", {
  plan <- read_text(small_plan)$plan
  expect_identical(read_text(gsub("\n", "\r\n", small_plan))$plan, plan)
  expect_identical(read_text(paste0("\ufeff", small_plan))$plan, plan)
  named <- read_text(gsub("warp", "tr\u00e5l_\u00f8", small_plan))
  expect_identical(names(named$plan$ropes), "tr\u00e5l_\u00f8")
})

test_that("only yes, no, true and false are truth values, and numbers are decimal", {
  plan <- read_text(spoil("knot: {}", "knot: {}\n  n: {at: y}\n  y: {at: ship}"))
  expect_identical(names(plan$plan$points), c("ship", "knot", "n", "y"))
  expect_true(read_text(spoil("material: PE",
    "material: PE, double: yes"))$plan$panels$net$twine$double)
  expect_identical(gear_si(read_text(spoil("100 m\n", "010\n")))$ropes$warp$length, 10)
  expect_identical(gear_si(read_text(spoil("deep: 10", "deep: 1e2")))$panels$net$deep, 100)
})

test_that("an edge's mesh range inside brackets asks for quotes", {
  expect_match(plan_error("[net.upper]", "[net.upper[0:6]]")$message, "needs quotes", fixed = TRUE)
})

test_that("no file and no shipped plan of a name", {
  expect_error(read_gear("towed_cabel"), "towed_cable", class = "codend_error_plan")
  expect_error(read_gear(tempdir()), class = "codend_error_plan")
  expect_error(read_gear(1), class = "codend_error_argument")
})
