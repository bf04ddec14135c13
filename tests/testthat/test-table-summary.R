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
  for (title in c("Measures", "Drag by component", "Ropes", "Netting",
    "Force balance", "Solution")) {
    expect_true(title %in% lines, info = title)
  }
  # lines fit a terminal
  expect_lte(max(nchar(lines)), 110)
})

test_that("summary() groups parts of one role", {
  tensions <- data.frame(
    part = c("port", "starboard", "sweep"), kind = "rope", role = c("warp", "warp", NA),
    max_kN = c(10, 12, 3), mean_kN = 1, strength_kN = c(50, 50, NA),
    strength_percent = c(20, 24, NA)
  )
  expect_match(column_lines(rope_columns(tensions)[c(1:3, 7)]), all = FALSE,
    "^  warp, 2 ropes +starboard +12.00 +24.0$")
  slack <- data.frame(part = c("a", "b", "c"), twine_m = c(10, 30, 60),
    slack_percent = c(80, 40, 0))
  netting <- data.frame(part = c("a", "b", "c"), kind = "netting", role = c("wings", "wings", NA),
    mean_kN = c(1, 3, 1) / 1000, most_loaded_kN = c(3, 5, 2) / 1000)
  columns <- netting_columns(netting, slack)
  expect_identical(unname(columns[c(1L, 4L)]), list(c("wings, 2 panels", "c"), c("50.0", "0.0")))
  expect_null(column_lines(netting_columns(netting[0L, ], slack)))
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
