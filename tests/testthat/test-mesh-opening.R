# Stiff meshes: they settle, slack or taut, and turned netting stays wider open than diamond.

t90_codend <- function(orientation = "turned", couple = 0.1) {
  plan <- read_gear("t90_codend")$plan
  plan$panels <- lapply(plan$panels, function(panel) {
    panel$orientation <- orientation
    panel$opening_stiffness <- if (couple > 0) list(couple = couple, angle = "23 deg")
    panel
  })
  settle(as_gear(plan), nodes = 300)
}

widest <- function(state) max(abs(state$position[2, ]))

test_that("a T90 codend is wider and shorter than one of diamond netting", {
  turned <- t90_codend("turned")
  diamond <- t90_codend("diamond")
  expect_gt(widest(turned), 1.05 * widest(diamond))
  expect_lt(measures(turned)[["length_m"]], measures(diamond)[["length_m"]])
  expect_gt(measures(turned)[["catch_volume_m3"]], measures(diamond)[["catch_volume_m3"]])
})

test_that("without stiffness turned netting is diamond netting", {
  # Found to 1e-8 of the largest tension.
  expect_equal(widest(t90_codend("turned", 0)), widest(t90_codend("diamond", 0)), tolerance = 1e-6)
})

test_that("the stiffer the meshes the further the two are apart", {
  apart <- vapply(c(0.01, 0.03, 0.1), function(couple) {
    widest(t90_codend("turned", couple)) - widest(t90_codend("diamond", couple))
  }, 0)
  expect_true(all(diff(apart) > 0))
  # Small couples change the shape in proportion: 3 times the couple, to some 10 %.
  expect_equal(apart[2] / apart[1], 3, tolerance = 0.1)
})

test_that("stiff meshes settle where their twine is slack", {
  # Thin netting with much slack in a current, with knots as stiff as those of thick codends.
  plan <- panel_in_current_plan
  for (couple in c(0.01, 0.1)) {
    plan$panels$net$opening_stiffness <- list(couple = couple, angle = 1)
    state <- settle(as_gear(plan), nodes = 300)
    expect_true(state$report$converged)
    expect_lt(state$report$iterations, 600)
  }
})

test_that("the key of a plot of meshes has every line as it is drawn", {
  skip_if_not(capabilities("cairo"))
  meshes <- mesh_openings(suppressWarnings(settle("pair_trawl", nodes = 300)))
  file <- tempfile(fileext = ".svg")
  plot(meshes, file = file)
  # cairo writes style="fill:none;stroke:rgb(...)" or, from 1.18 on, fill="none" stroke="rgb(...)"
  lines <- gsub('="', ":", readLines(file), fixed = TRUE)
  drawn <- grep("fill:none.*stroke:rgb", lines, value = TRUE)
  colour <- sub(".*stroke:rgb\\(([^)]*)\\).*", "\\1", drawn)
  dash <- ifelse(grepl("dasharray", drawn), sub('.*dasharray:([^;"]*).*', "\\1", drawn), "")
  # lines of one colour, the key's among them, are all dashed or none is
  dashes <- lapply(split(dash, colour), unique)
  expect_gt(sum(nzchar(unlist(dashes))), 0)
  expect_true(all(lengths(dashes) == 1L))
})
