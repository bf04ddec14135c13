test_that("reading rejects hostile or broken files without evaluation", {
  trap <- tempfile()
  code <- sprintf("codend: 1\nname: !expr file.create('%s')\n", trap)
  expect_match(text_error(code)$message, "cannot contain code", fixed = TRUE)
  expect_false(file.exists(trap))

  cases <- list(
    list("", "must be a map of fields"), list("# nothing", "must be a map of fields"),
    list("- 1\n- 2", "must be a map of fields"), list("hello", "must be a map of fields"),
    list(spoil("[net.upper]", "[net.upper[0:6]]"), "needs quotes"),
    list("a: [1", "not valid YAML"), list("\ta: 1", "not valid YAML"),
    list("a: 1\na: 2", "`a` is given twice"), list("a: *nowhere", "not valid YAML"),
    list(as.raw(c(0x61, 0x3a, 0x00, 0x31)), "NUL bytes"),
    list(as.raw(c(0x61, 0x3a, 0x20, 0xff, 0xfe)), "not UTF-8"),
    list(strrep("x", 2.2e6), "at most 2 MB"), list(strrep("[", 1e5), "nested too deeply"),
    list(strrep("{a: ", 1e4), "nested too deeply"), list(strrep("- ", 1e5), "nested too deeply"),
    list(paste0("a", seq_len(3e4), ": 1", collapse = "\n"), "too many fields"),
    # the parser would need 12 s for these
    list(paste0("a", seq_len(19000), ": 1", collapse = "\n"), "too many fields"),
    list(paste0(strrep(" ", 0:40), "a:", collapse = "\n"), "at most 20 levels"),
    # aliases that multiply
    list(paste0("a0: &a0 [x]\n", paste0(sprintf("a%d: &a%d [%s]", 1:9, 1:9,
      strrep(paste0("*a", 0:8, ", "), 9)), collapse = "\n")), "and 50000 values")
  )
  for (case in cases) {
    said <- text_error(case[[1]])$message
    expect_length(gregexpr(case[[2]], said, fixed = TRUE)[[1]], 1L)
    expect_match(said, case[[2]], fixed = TRUE)
  }
})

test_that("reading rejects merge keys but accepts their sign in text", {
  merged <- c(
    "ropes:\n  warp:\n    <<: {length: 1 m}\n    length: 1000 m", "a: {x: 1, << : {y: 2}}",
    "b: {<<: {y: 2}}", "? <<\n: {x: 1}", "- <<: {x: 1}", "<<:\n  x: 1", "a: {!!merge q: {x: 1}}"
  )
  for (text in merged) expect_match(text_error(text)$message, "merge key", fixed = TRUE)
  expect_match(text_error(merged[1])$message, "in line 3, a merge key", fixed = TRUE)
  kept <- c("name: \"a << : b\"", "name: a # <<: b", "name: 'x <<'", "name: a<<b")
  for (text in kept) expect_no_match(text_error(text)$message, "merge key", fixed = TRUE)
})

test_that("reading accepts other line ends, byte order marks and alphabets", {
  plan <- read_text(small_plan)$plan
  expect_identical(read_text(gsub("\n", "\r\n", small_plan))$plan, plan)
  expect_identical(read_text(paste0("\ufeff", small_plan))$plan, plan)
  named <- read_text(gsub("warp", "tr\u00e5l_\u00f8", small_plan))
  expect_identical(names(named$plan$ropes), "tr\u00e5l_\u00f8")
})

test_that("reading accepts four logical words and decimal numbers only", {
  plan <- read_text(spoil("knot: {}", "knot: {}\n  n: {at: y}\n  y: {at: ship}"))
  expect_identical(names(plan$plan$points), c("ship", "knot", "n", "y"))
  expect_true(read_text(spoil("material: PE",
    "material: PE, double: yes"))$plan$panels$net$twine$double)
  expect_identical(gear_si(read_text(spoil("100 m\n", "010\n")))$ropes$warp$length, 10)
  expect_identical(gear_si(read_text(spoil("deep: 10", "deep: 1e2")))$panels$net$deep, 100)
})

test_that("reading rejects a folder and suggests a missing file ending", {
  expect_refused(read_gear(tempdir()))
  # a file name without its ending
  file <- tempfile("trawl", fileext = ".yaml")
  on.exit(unlink(file))
  writeLines("codend: 1", file)
  expect_refused(read_gear(sub("[.]yaml$", "", file)), paste0("did you mean `", file, "`"),
    fixed = TRUE)
})

test_that("reading rejects several YAML documents in one file", {
  text <- paste(readLines(shipped_plans()[["towed_cable"]]), collapse = "\n")
  expect_refused(read_text(paste0(text, "\n---\nname: Another\n")), "several YAML documents")
  expect_refused(read_text(paste0("---\nname: Another\n---\n", text)), "several YAML documents")
  expect_identical(read_text(paste0("%YAML 1.1\n# one\n---\n", text, "\n...\n"))$plan,
    read_gear("towed_cable")$plan)
})

test_that("reading reports a decimal comma in values and keys", {
  expect_no_warning({
    value <- plan_error("length: 100 m", "length: 1,5")
    key <- text_error(paste0(small_plan, "\n1,5: 3\n"))
  })
  expect_match(value$message, "is \"1,5\"; it must be a length", fixed = TRUE)
  expect_match(key$message, "`1,5` is not known", fixed = TRUE)
})

test_that("names must not end in a newline, and text keeps it", {
  found <- text_error(paste0(small_plan, "\nmaterials: {\"a\\n\": {density: 900 kg/m3}}\n"))
  expect_match(found$message, "name that is not allowed", fixed = TRUE)
  gear <- update(read_gear("towed_cable"), name = "a\n")
  file <- tempfile(fileext = ".yaml")
  write_gear(gear, file)
  expect_identical(read_gear(file)$plan, gear$plan)
})

test_that("reading opens only regular files", {
  skip_on_os("windows")
  pipe <- tempfile()
  system2("mkfifo", pipe)
  setTimeLimit(elapsed = 10, transient = TRUE)
  expect_refused(read_gear(pipe), "is not a plan file")
  skip_if_not_installed("RNetCDF")
  expect_error(read_result(pipe), "not a regular file", class = "codend_error_file")
  setTimeLimit()
})
