test_that("summary() of a state returns the printed values", {
  for (name in shipped_states) {
    state <- shipped_state(name)
    found <- summary(state)
    expect_s3_class(found, "codend_summary")
    expect_named(found, c("name", "conditions", "measures", "findings", "drag", "drag_totals",
      "tangential", "tensions", "slack", "boards", "reactions", "balance", "report"))
    expect_identical(found$drag, as.data.frame(state, what = "drag"))
    expect_equal(found$report$nodes, ncol(state$position))
  }
})

test_that("summary() prints plain aligned text without colours", {
  state <- shipped_state("midwater_trawl")
  lines <- capture.output(shown <- withVisible(print(summary(state), n = Inf)))
  expect_false(shown$visible)
  expect_false(any(cli::ansi_has_any(lines)))
  for (title in c("Measures", "Drag by component", "Highest rope tensions",
    "Highest twine tensions", "Slack netting", "Force balance", "Solution")) {
    expect_true(title %in% lines, info = title)
  }
  # lines fit a terminal
  expect_lte(max(nchar(lines)), 110)
})

test_that("summary() groups parts of one role", {
  tensions <- data.frame(
    part = c("port", "starboard", "sweep"), kind = "rope", role = c("warp", "warp", NA),
    max_kN = c(10, 12, 3), mean_kN = 1, strength_percent = c(20, 24, NA)
  )
  expect_equal(
    rope_tension_lines(tensions),
    c("  warp, 2 ropes  12.00 kN  24.0 % of breaking load", "  sweep           3.00 kN")
  )
})

test_that("summary() lists slack netting in percent", {
  slack <- data.frame(
    part = c("a", "b", "c"), role = c("wings", "wings", NA), twine_m = c(10, 30, 60),
    slack_percent = c(80, 40, 0)
  )
  expect_equal(
    slack_lines(slack),
    c(
      "  20.0 % of all twine carries no tension; slack netting may move.",
      "  wings, 2 panels  50.0 %"
    )
  )
  slack$slack_percent <- 0
  expect_equal(slack_lines(slack), "  All twine carries tension.")
  expect_null(slack_lines(slack[0, ]))
})

test_that("summary() prints whole sections that fit and counts the others", {
  found <- summary(shipped_state("midwater_trawl"))
  short <- capture.output(print(found))
  whole <- capture.output(print(found, n = Inf))
  expect_lte(length(short), 30)
  expect_true("Drag by component" %in% short)
  titles <- function(lines) sum(!startsWith(lines[-(1:2)], " ") & nzchar(lines[-(1:2)]))
  expect_match(short[length(short)], paste("and", titles(whole) - titles(short), "more sections"))
})
