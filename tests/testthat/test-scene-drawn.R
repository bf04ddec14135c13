# Returns the positions along a joint (0..1) of the ends of a panel's drawn twines. Drawn twines
# have multiples of a power of two as drawn coordinates, at most `most` per family.
drawn_ends <- function(si, drawn, panel, edge, from, to, most) {
  number <- match(panel, names(si$panels))
  ends <- edge_twines(si$panels[[panel]], edge, c(from, to)) / drawn$scale[number] +
    drawn$offset[, number]
  sort(unlist(lapply(1:2, function(family) {
    x <- ends[family, ]
    run <- x[2] - x[1]
    if (abs(run) < 1e-6) return(NULL)
    step <- 2^ceiling(log2(abs(run) / most))
    at <- step * seq(ceiling(min(x) / step - 1e-9), floor(max(x) / step + 1e-9))
    (at - x[1]) / run
  })))
}

# Returns the distance (fraction of the joint) of the coarser panel's twine ends from the other
# panel's ends.
apart <- function(si, drawn, joint) {
  first <- drawn_ends(si, drawn, joint$panel, joint$edge, joint$from, joint$to, 16)
  second <- drawn_ends(si, drawn, joint$other, joint$other_edge, joint$other_from,
    joint$other_to, 16)
  few <- if (length(first) < length(second)) first else second
  many <- if (length(first) < length(second)) second else first
  # rounding may omit a twine at the end of the joint on one side
  few <- few[few > 1e-6 & few < 1 - 1e-6]
  max(0, vapply(few, function(at) min(abs(many - at)), 0))
}

joints_with_ends <- function(si) {
  joints <- seam_joints(si)
  drawn <- drawn_twines(si)
  joints$apart <- vapply(seq_len(nrow(joints)), function(k) apart(si, drawn, joints[k, ]), 0)
  joints
}

test_that("drawn twines meet on the cross seams of every shipped net", {
  seams <- 0
  for (gear in gears()$name) {
    joints <- joints_with_ends(gear_si(read_gear(gear)))
    across <- joints$edge %in% c("upper", "lower") & joints$other_edge %in% c("upper", "lower")
    expect_lt(max(0, joints$apart[across]), 1e-6, label = gear)
    seams <- seams + sum(across)
  }
  expect_gt(seams, 100)
})

test_that("drawn twines meet on side seams between mirror images", {
  for (gear in c("midwater_trawl", "small_midwater_trawl", "cage", "model_cage", "t90_codend")) {
    joints <- joints_with_ends(gear_si(read_gear(gear)))
    expect_gt(nrow(joints), 0)
    expect_lt(max(joints$apart), 1e-6, label = gear)
  }
})

test_that("first panel draws its own twines, others at most every second", {
  drawn <- drawn_twines(gear_si(read_gear("midwater_trawl")))
  expect_gt(mean(drawn$scale == 1), 0.3)
  expect_true(all(drawn$scale > 1 - 1e-6 & drawn$scale < 2))
  # 80 meshes are joined to 133: three drawn twines represent five
  names <- names(gear_si(read_gear("midwater_trawl"))$panels)
  expect_equal(drawn$scale[names == "back_section_6"], 133 / 80, tolerance = 1e-9)
})
