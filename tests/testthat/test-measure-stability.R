test_that("a balance that does not last is warned of by what a push carries away", {
  said <- function(name) {
    state <- suppressWarnings(settle(read_gear(name), nodes = 60))
    expect_no_warning(warn_of_instability(state))
    state$report$unstable <- TRUE
    tryCatch(warn_of_instability(state), warning = identity)
  }
  boards <- said(test_path("plans", "towed_board.yaml"))
  expect_s3_class(boards, c("codend_warning_board_unstable", "codend_warning"))
  expect_match(conditionMessage(boards), "free boards and kites does not last")
  pole <- said("beam_trawl")
  expect_s3_class(pole, "codend_warning_pole_unstable")
  expect_match(conditionMessage(pole), "where ropes hold them")
  catch <- said("t90_codend")
  expect_s3_class(catch, "codend_warning_catch_unstable")
  expect_match(conditionMessage(catch), "around the catch, catch.panels, does not last",
    fixed = TRUE)
})
