# Returns the two-seam trawl with some of the fields of its second upper wing replaced.
wing_2 <- function(...) {
  given <- list(...)
  names(given) <- sprintf("net.upper.wing_2.%s", names(given))
  do.call(two_seam, given)
}

test_that("a wing's third count follows from its two counts and both edges", {
  # 50 rows: AB gains 50 meshes, 1N2B loses 25.
  panel <- gear_si(wing_2())$panels$back_wing_2_left
  expect_equal(panel$lower, 51 + 50 - 25)
  expect_equal(c(panel$lost_left, panel$lost_right), c(25, -50))
  mirrored <- gear_si(wing_2())$panels$back_wing_2_right
  expect_equal(c(mirrored$lost_left, mirrored$lost_right), c(-50, 25))
  expect_equal(gear_si(wing_2(meshes.deep = NULL, meshes.rear = 76))$panels$back_wing_2_left$deep,
    50)
  expect_equal(gear_si(wing_2(meshes.front = NULL, meshes.rear = 76))$panels$back_wing_2_left$upper,
    51)
})

test_that("edges without a rate take the rest of the meshes", {
  panel <- gear_si(wing_2(meshes.rear = 70, cutting = list(outer = "1N2B")))$panels$back_wing_2_left
  expect_equal(c(panel$lost_left, panel$lost_right), c(25, -44))
  panel <- gear_si(wing_2(meshes.rear = 76, cutting = NULL))$panels$back_wing_2_left
  expect_equal(c(panel$lost_left, panel$lost_right), c(0, -25))
})

test_that("pieces take omitted fields from the piece of the same name in the upper panel", {
  panels <- gear_si(wing_2())$panels
  expect_equal(panels$belly_body_1$twine_diameter, 0.004)
  expect_identical(panels$belly_body_1$material, panels$back_body_1$material)
  expect_equal(panels$belly_body_1[c("upper", "lower", "deep")],
    panels$back_body_1[c("upper", "lower", "deep")])
})
