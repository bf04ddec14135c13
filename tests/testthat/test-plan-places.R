# The text between a field's positions must parse to the field: yaml's own parser is independent.
read_part <- function(text, places, k) {
  lines <- strsplit(substr(text, 1, places$to[k]), "\n", fixed = TRUE)[[1]]
  from <- places$from[k]
  before <- nchar(sub(".*\n", "", substr(text, 1, from - 1)))
  yaml::yaml.load(paste0(strrep(" ", before), substr(text, from, places$to[k])), eval.expr = FALSE)
}

expect_places <- function(text, label) {
  places <- plan_places(text)
  expect_true(attr(places, "whole"), label = label)
  tree <- yaml::yaml.load(text, eval.expr = FALSE)
  # names that contain dots, such as `angle: {warp.start: declination}`, cannot be split
  for (k in which(!is.na(places$from) & !grepl("angle.", places$path, fixed = TRUE))) {
    value <- tree
    for (step in strsplit(places$path[k], ".", fixed = TRUE)[[1]]) {
      value <- as.list(value)[[if (grepl("^[0-9]+$", step)) as.integer(step) else step]]
    }
    found <- read_part(text, places, k)
    # the line end after a folded text is outside its position
    if (is.character(value)) value <- sub("\n$", "", value)
    expect_equal(found, value, label = paste(label, places$path[k]))
  }
}

test_that("plan_places() of shipped plans agree with the YAML parser", {
  for (name in setdiff(names(shipped_plans()), "t90_codend")) {
    text <- paste(c(readLines(shipped_plans()[[name]], encoding = "UTF-8"), ""), collapse = "\n")
    expect_places(text, name)
  }
})

test_that("plan_places() covers all YAML forms of a field", {
  expect_places(paste(sep = "\n",
    "# remark", "---", "a: 1 # one", "b: {c: [1, 2 m, 'it''s'], d: \"x # \\\" y\", e: {}}",
    "\"f g\":", "  - 1", "  - h: i", "    j: k", "  -  - 2", "     - 3", "l:", "- m", "- n",
    "o: plain text", "  goes on # but not here", "p: >", "  folded", "", "  text",
    "q: |", "  as # is",
    "r: a:b", "s: [", "  1, # first", "  2", "]", ""
  ), "forms")
})

test_that("plan_places() handles empty fields, aliases and Windows line ends", {
  places <- plan_places("a:\r\nb: &x {c: 1}\r\nd: *x\r\ne: [1, {f: 2}]\r\n")
  expect_identical(places$path, c("a", "b", "b.c", "d", "e", "e.1", "e.2", "e.2.f"))
  expect_identical(places$line, c(1L, 2L, 2L, 3L, 4L, 4L, 4L, 4L))
  expect_identical(places$column, c(1L, 1L, 8L, 1L, 1L, 5L, 8L, 9L))
})

test_that("errors of a plan file report line and column", {
  expect_place <- function(old, new, line, column, plan = small_plan) {
    error <- tryCatch(read_text(spoil(old, new, plan)), codend_error_plan = identity)
    expect_identical(c(error$line, error$column), c(line, column))
    expect_match(gsub("\\s+", " ", conditionMessage(error)),
      sprintf("line %d, column %d", line, column), fixed = TRUE)
  }
  expect_place("100 m\n", "-1 m\n", 10L, 5L)
  expect_place("deep: 10", "deep: none", 16L, 35L)
  expect_place("material: PE", "material: PX", 17L, 29L)
  # a missing field is reported at the map that lacks it
  expect_place("    from: ship\n", "", 7L, 3L)
  expect_place("[net.upper]", "[net.upper, net.lowr]", 19L, 28L)
  expect_place("knot: {}", "knot: {}\n  knot: {}", 6L, 3L)
  expect_place("    from", "\t from", 8L, 1L)
  expect_place("name: A", "name: 'A", 2L, 7L)
})
