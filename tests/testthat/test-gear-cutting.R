# Meshes across and down of a cutting rate, counted along its cuts: independent of the code that
# finds the rate. The factor of a cycle is its number of repeats.
walk_rate <- function(text) {
  total <- c(across = 0, down = 0)
  for (group in strsplit(text, "+", fixed = TRUE)[[1]]) {
    times <- if (grepl("(", group, fixed = TRUE)) as.integer(sub("[(].*", "", group)) else 1L
    cycle <- sub(".*[(](.*)[)]", "\\1", group)
    parts <- regmatches(cycle, gregexpr("[0-9]+[NTB]", cycle))[[1]]
    for (part in parts) {
      cuts <- as.integer(sub("[NTB]", "", part))
      step <- switch(sub("[0-9]+", "", part), N = c(0, 1), T = c(1, 0), B = c(0.5, 0.5))
      total <- total + times * cuts * step
    }
  }
  total
}

test_that("cutting_rate() returns the textbook rates", {
  # meshes lost over meshes deep; the usual table of net makers (J. Prado, Fisherman's Workbook, FAO
  # and Fishing News Books, 1990)
  known <- c(
    "1T1B" = 3 / 1, "1T2B" = 2 / 1, "1T4B" = 3 / 2, "1N6B" = 3 / 4, "1N4B" = 2 / 3, "1N3B" = 3 / 5,
    "1N2B" = 1 / 2, "1N1B" = 1 / 3, "3N2B" = 1 / 4, "2N1B" = 1 / 5, "3N1B" = 1 / 7, "4N1B" = 1 / 9
  )
  for (rate in names(known)) expect_identical(cutting_rate(known[[rate]] * 630, 630), rate)
  expect_identical(cutting_rate(0, 40), "AN")
  expect_identical(cutting_rate(40, 40), "AB")
  # 180 meshes to 140 in 30, half of the loss at each side: 4 bars to 1 point (Fishing Gear
  # Technology, Marine Institute course MSC 132, after A. L. Fridman 1986)
  expect_identical(cutting_rate((180 - 140) / 2, 30), "1N4B")
  expect_identical(cutting_rate(-20, 30), "1N4B")
})

test_that("cutting_rate() repeats to the whole edge", {
  for (deep in c(17, 84, 120, 150, 201)) {
    for (lost in c(0.5, 1, 7, 16, 52.5, 91.5, 149, 260)) {
      text <- cutting_rate(lost, deep)
      expect_match(text, "^(AB|[0-9]+[NT][0-9]+B|[0-9]+[(][0-9]+[NT][0-9]+B[)][+].*)$")
      if (text == "AB") next
      walked <- walk_rate(text)
      expect_equal(walked[["across"]] / walked[["down"]], lost / deep)
      # two cycles end with the edge, or with two edges that lose half a mesh
      turns <- 2 * deep / walked[["down"]]
      if (grepl("+", text, fixed = TRUE)) expect_equal(turns, round(turns))
    }
  }
  expect_identical(cutting_rate(91.5, 120), "11(1N6B)+8(1N7B)")
})

test_that("cutting_rate() approximates an edge of fractional meshes", {
  # 32.72 of 65.93: bars over points 1.97; 1N2B has 2 and is the nearest of up to 7 cuts
  expect_identical(cutting_rate(32.72, 65.93), "~1N2B")
})

test_that("cutting_rate() has rules for turned, square and hexagonal netting", {
  expect_identical(cutting_rate(0, 40, "turned"), "AT")
  expect_identical(cutting_rate(20, 40, "turned"), "1T2B")
  expect_identical(cutting_rate(0, 40, "square"), "AB")
  expect_identical(cutting_rate(10, 40, "square"), "")
  expect_identical(cutting_rate(10, 40, "hexagonal"), "")
})

test_that("panel taper is divided between its edges", {
  panel <- list(upper = 60, lower = 20, deep = 40, orientation = "diamond", lost_left = 20,
    lost_right = 20)
  expect_identical(panel_rates(panel), c(left = "1N2B", right = "1N2B"))
  panel[c("lost_left", "lost_right")] <- list(0, 40)
  expect_identical(panel_rates(panel), c(left = "AN", right = "AB"))
})
