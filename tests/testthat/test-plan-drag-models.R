test_that("force_coefficients() covers every drag model of the table", {
  found <- force_coefficients()
  found <- found[is.na(found$source), ]
  across <- function(force, law, angle, coefficient) {
    found$value[found$force == force & found$law == law & found$by == "angle" &
      found$angle_deg == angle & found$coefficient == coefficient]
  }
  for (law in drag_model_names("twine")) expect_gt(across("twine", law, 90, "drag"), 0.5)
  for (law in drag_model_names("netting")) expect_gt(across("netting", law, 0, "drag"), 0.1)
  for (law in drag_model_names("wake")) expect_lt(across("wake", law, 0, "speed"), 0.95)
  known <- function(field) {
    engine <- specimen(matrix(0, 3L, 4L))
    engine$fields$screens <- list(node = 1:4, twine = numeric(8), twine_area = 1, overlap = 0,
      diameter = 1, multiplicity = 1, height = 1, law = "no law")
    said <- tryCatch(evaluate_specimen(engine, 1, 4L), error = conditionMessage)
    sub(".*must be ", "", gsub("\\s+", " ", said))
  }
  names <- drag_model_names("netting", "screen")
  n <- length(names)
  expect_match(known(), paste(toString(names[-n]), "or", names[n]), fixed = TRUE)
})

test_that("engine limits each screen model to the range in findings", {
  screens <- laws[laws$of == "netting" & laws$form == "screen", ]
  drag <- function(law, solidity, reynolds = 1000) {
    netting_specimens(law, 0, reynolds, solidity)$drag
  }
  for (k in seq_len(nrow(screens))) {
    law <- screens$name[k]
    end <- screens$most_solidity[k]
    # at the same Reynolds number of the flow between the twines
    expect_equal(drag(law, end + 0.2), drag(law, end), tolerance = 1e-9, label = law)
    expect_gt(drag(law, end), 1.02 * drag(law, end - 0.02))
    expect_identical(drag_model_column("most_solidity", "netting", "screen")[[law]], end)
    if (screens$least_solidity[k] > 0) {
      least <- screens$least_solidity[k]
      expect_equal(drag(law, least / 2), drag(law, least) / 2, tolerance = 1e-9, label = law)
    }
    if (!is.na(screens$most_reynolds[k])) {
      beyond <- screens$most_reynolds[k]
      expect_equal(drag(law, 0.2, 10 * beyond), drag(law, 0.2, beyond), tolerance = 1e-9)
      # and at 32 between the twines or less
      expect_equal(drag(law, 0.2, 2), drag(law, 0.2, 32 * (1 - 0.2) - 1e-9), tolerance = 1e-9)
    }
  }
})
