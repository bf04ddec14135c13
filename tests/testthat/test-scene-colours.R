test_that("linear tension scale starts at zero and includes the largest tension", {
  scale <- tension_scale(c(0, 3000, 12000, 7000), "rope")
  expect_false(scale$log)
  expect_equal(scale$unit, "kN")
  expect_equal(scale$limits[1], 0)
  expect_gte(scale$limits[2], 12000)
  expect_equal(range(scale$ticks) * 1000, scale$limits)
  expect_equal(scale_share(scale, scale$limits), c(0, 1))
  expect_equal(scale_share(scale, mean(scale$limits)), 0.5)
})

test_that("slack_text() names slack lines and lines in compression", {
  expect_null(slack_text(c(1, 2)))
  expect_identical(slack_text(c(0, 2)), "slack")
  expect_identical(slack_text(c(0, -1)), "slack or in compression")
})

test_that("small tensions use newtons", {
  expect_equal(tension_scale(c(200, 999), "netting")$unit, "N")
  expect_equal(tension_scale(c(200, 1000), "netting")$unit, "kN")
})

test_that("tensions over several decades use a three-decade logarithmic scale", {
  tension <- 10^seq(-6, 4, length.out = 101)
  scale <- tension_scale(tension, "netting")
  expect_true(scale$log)
  expect_equal(scale$limits, c(10, 1e4))
  # A decade is a third of the colour bar; lower values have the first colour.
  expect_equal(scale_share(scale, c(1e-3, 10, 100, 1e4)), c(0, 0, 1 / 3, 1))
  expect_true(all(scale$ticks * scale$per_unit >= 9.99 & scale$ticks * scale$per_unit <= 10010))
})

test_that("slack lines have a unique colour", {
  tension <- c(0, 1, 50, 100)
  scale <- tension_scale(tension, "netting")
  colours <- tension_colours(scale, tension)
  expect_equal(colours == slack_colour, tension == 0)
  expect_null(tension_scale(c(0, 0), "rope"))
  expect_equal(tension_colours(NULL, c(0, 0)), rep(slack_colour, 2))
})

test_that("both palettes darken steadily for greyscale printing", {
  for (kind in c("rope", "netting")) {
    # Luminance by the weights of ITU-R BT.709.
    grey <- c(0.2126, 0.7152, 0.0722) %*% (grDevices::col2rgb(tension_palette(kind)) / 255)^2.2
    expect_lt(max(diff(as.vector(grey))), 0.005)
    # The slack colour differs in hue, also for the colour-blind, and slack lines are dashed.
    lab <- function(colour) {
      grDevices::convertColor(t(grDevices::col2rgb(colour) / 255), "sRGB", "Lab")
    }
    apart <- sqrt(colSums((t(lab(tension_palette(kind))) - drop(lab(slack_colour)))^2))
    expect_gt(min(apart), 30)
  }
})

test_that("series colours differ in greyscale and for the colour-blind", {
  # Vienot, Brettel and Mollon (1999), Color Research and Application 24:243: vision of dichromats,
  # in linear light. Independent of the simulation that was used to choose the colours.
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
    # 2 is just noticeable; the simulations differ by a few units
    expect_gt(min(stats::dist(lab)), 20)
  }
  lab <- grDevices::convertColor(t(share), "sRGB", "Lab")
  expect_gt(min(diff(lab[, 1])), 10)
  for (n in 1:7) expect_length(series_colours(n), n)
  expect_false(anyDuplicated(series_colours(4)) > 0)
})

test_that("part_sizes() uses open area for netting and length for ropes", {
  state <- settled("panel_in_current", nodes = 200)
  size <- setNames(part_sizes(state$si, state$mesh), state$mesh$parts$name)
  # 20 meshes of 0.1 m in both directions
  expect_equal(size[["net"]], 2 * sin(pi / 4) * 2 * cos(pi / 4))
  expect_equal(size[["headline"]], 2.2)
})
