test_that("settle() warns about an unstable equilibrium by the part that moves", {
  said <- function(name) {
    state <- suppressWarnings(settle(read_gear(name), nodes = 60))
    expect_no_warning(warn_of_instability(state))
    state$report$unstable <- TRUE
    tryCatch(warn_of_instability(state), warning = identity)
  }
  boards <- said(test_path("plans", "towed_board.yaml"))
  expect_s3_class(boards, c("codend_warning_board_unstable", "codend_warning"))
  expect_match(conditionMessage(boards), "free boards and kites is unstable")
  pole <- said("beam_trawl")
  expect_s3_class(pole, "codend_warning_pole_unstable")
  expect_match(conditionMessage(pole), "ropes that support them")
  catch <- said("t90_codend")
  expect_s3_class(catch, "codend_warning_catch_unstable")
  expect_match(conditionMessage(catch), "around the catch, catch.panels, is unstable",
    fixed = TRUE)
})
