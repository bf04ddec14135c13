test_that("a state is tidy: its measures, and one row of the whole", {
  state <- settled("towed_cable", nodes = 300)
  table <- tidy.codend_state(state)
  expect_identical(table$estimate, as.double(measures(state)))
  expect_identical(table$term, names(measures(state)))
  row <- glance.codend_state(state)
  expect_identical(nrow(row), 1L)
  expect_true(row$converged)
  expect_identical(row$nodes, nrow(as.data.frame(state, what = "nodes")))
})

test_that("a trajectory and slopes are tidy", {
  state <- settled("towed_cable", nodes = 300)
  trajectory <- tow(state, until = 4, every = 2, speed = data.frame(time = c(0, 2),
    value = c("4 knot", "4.5 knot")))
  table <- tidy.codend_trajectory(trajectory)
  now <- table[table$time == 4, ]
  expect_identical(now$estimate, as.double(measures(state_at(trajectory, 4))))
  row <- glance.codend_trajectory(trajectory)
  expect_identical(row[c("times", "until", "end")],
    data.frame(times = 3L, until = 4, end = "reached"))
  # tow() itself stops where more than 2 % is made or lost
  expect_lt(abs(row$energy_imbalance), 0.02)

  slopes <- sensitivities(state, to = "towing.speed", secants = FALSE)
  expect_identical(tidy.codend_sensitivities(slopes)$estimate, slopes$slope)
})

test_that("the package generics finds the methods", {
  skip_if_not_installed("generics")
  state <- settled("towed_cable", nodes = 300)
  expect_identical(generics::tidy(state), tidy.codend_state(state))
  expect_identical(generics::glance(state), glance.codend_state(state))
})
