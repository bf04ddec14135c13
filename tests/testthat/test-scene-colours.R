test_that("an even scale starts at zero and ends at or above the largest tension", {
  scale <- tension_scale(c(0, 3000, 12000, 7000), "rope")
  expect_false(scale$log)
  expect_equal(scale$unit, "kN")
  expect_equal(scale$limits[1], 0)
  expect_gte(scale$limits[2], 12000)
  expect_equal(range(scale$ticks) * 1000, scale$limits)
  expect_equal(scale_share(scale, scale$limits), c(0, 1))
  expect_equal(scale_share(scale, mean(scale$limits)), 0.5)
})

test_that("slack lines and pushing lines have their words", {
  expect_null(slack_words(c(1, 2)))
  expect_identical(slack_words(c(0, 2)), "slack")
  expect_identical(slack_words(c(0, -1)), "slack or pushing")
})

test_that("small tensions are in newtons", {
  expect_equal(tension_scale(c(200, 999), "netting")$unit, "N")
  expect_equal(tension_scale(c(200, 1000), "netting")$unit, "kN")
})

test_that("tensions over several decades are shown on a logarithmic scale of at most three", {
  tension <- 10^seq(-6, 4, length.out = 101)
  scale <- tension_scale(tension, "netting")
  expect_true(scale$log)
  expect_equal(scale$limits, c(10, 1e4))
  # A decade is a third of the bar; what lies below it has the first colour.
  expect_equal(scale_share(scale, c(1e-3, 10, 100, 1e4)), c(0, 0, 1 / 3, 1))
  expect_true(all(scale$ticks * scale$per_unit >= 9.99 & scale$ticks * scale$per_unit <= 10010))
})

test_that("slack lines have a colour that nothing else has", {
  tension <- c(0, 1, 50, 100)
  scale <- tension_scale(tension, "netting")
  colours <- tension_colours(scale, tension)
  expect_equal(colours == slack_colour, tension == 0)
  expect_null(tension_scale(c(0, 0), "rope"))
  expect_equal(tension_colours(NULL, c(0, 0)), rep(slack_colour, 2))
})

test_that("both palettes darken steadily, so that they survive grey printing", {
  for (kind in c("rope", "netting")) {
    # Luminance by the weights of ITU-R BT.709.
    grey <- c(0.2126, 0.7152, 0.0722) %*% (grDevices::col2rgb(tension_palette(kind)) / 255)^2.2
    expect_lt(max(diff(as.vector(grey))), 0.005)
    # Slack differs in hue from them all, also for the colour-blind, who see dashes too.
    lab <- function(colour) {
      grDevices::convertColor(t(grDevices::col2rgb(colour) / 255), "sRGB", "Lab")
    }
    apart <- sqrt(colSums((t(lab(tension_palette(kind))) - drop(lab(slack_colour)))^2))
    expect_gt(min(apart), 30)
  }
})

test_that("colours of series differ in grey and for the colour-blind", {
  # Vienot, Brettel and Mollon (1999), Color Research and Application 24:243: what dichromats see,
  # in linear light. Independent of the simulation that the colours were found with.
  seen <- list(
    normal = diag(3),
    protanopia = rbind(c(0.11238, 0.88762, 0), c(0.11238, 0.88762, 0), c(0.00401, -0.00401, 1)),
    deuteranopia = rbind(c(0.29275, 0.70725, 0), c(0.29275, 0.70725, 0), c(-0.02234, 0.02234, 1))
  )
  share <- grDevices::col2rgb(series_palette) / 255
  for (sight in seen) {
    light <- pmin(pmax(sight %*% linear_light(share), 0), 1)
    shown <- ifelse(light <= 0.0031308, 12.92 * light, 1.055 * light^(1 / 2.4) - 0.055)
    lab <- grDevices::convertColor(t(shown), "sRGB", "Lab")
    # 2 is just noticed; the simulations differ by a few
    expect_gt(min(stats::dist(lab)), 20)
  }
  lab <- grDevices::convertColor(t(share), "sRGB", "Lab")
  expect_gt(min(diff(lab[, 1])), 10)
  for (n in 1:7) expect_length(series_colours(n), n)
  expect_false(anyDuplicated(series_colours(4)) > 0)
})

test_that("netting counts by its area with meshes open at 90 degrees, ropes by their length", {
  state <- settled("panel_in_current", nodes = 200)
  size <- setNames(part_sizes(state$si, state$lattice), state$lattice$parts$name)
  # 20 meshes of 0.1 m each way
  expect_equal(size[["net"]], 2 * sin(pi / 4) * 2 * cos(pi / 4))
  expect_equal(size[["head_line"]], 2.2)
})
