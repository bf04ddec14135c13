# Files of MoorDyn: its own cases against its own expected values, and gears written and read back.

deck <- function(name) testthat::test_path("reference", "moordyn", name)

end_tensions <- function(state) {
  tension <- in_unit(state$bar_tension[bars_of_part(state, 1L)], "kN")
  tension[c(length(tension), 1L)]
}

test_that("read_moordyn() gives the expected tensions of MoorDyn's chains", {
  # kN at the fairlead and the anchor (reference/moordyn/README.md). codend reports tensions at the
  # middle of bars, and its seabed stiffness follows another formula: 1 %.
  expected <- list(WD0050 = c(991.6, 826.2), WD0200 = c(2065.4, 1402.2), WD0600 = c(5232.6, 3244.2))
  for (name in names(expected)) {
    state <- settle(read_moordyn(deck(paste0(name, "_Chain.txt"))))
    expect_equal(end_tensions(state), expected[[name]], tolerance = 0.01, label = name)
  }
})

test_that("read_moordyn() gives the expected forces of a flexible jumper", {
  state <- settle(read_moordyn(deck("lowe_langley_line.txt")))
  held <- which(engine_array(state, "held"))
  held <- held[order(state$position[3, held])]
  # kN, within the 0.2 kN of MoorDyn's test: bottom, then top
  reaction <- in_unit(state$force[c(1, 3), held], "kN")
  expect_lt(max(abs(abs(reaction) - cbind(c(11.40, 24.04), c(11.40, 45.71)))), 0.2)
})

test_that("ropes written for MoorDyn settle as in their gear", {
  for (name in c("towed_cable", "crossing_cables", "midwater_trawl")) {
    state <- shipped_state(name)
    file <- file.path(test_folder(), "ropes.txt")
    if (name == "crossing_cables") {
      # no flow in a vacuum; crossings with a load are written as fixed points
      write_result(state, file)
      expect_false(file.exists(file.path(dirname(file), "current_profile.txt")))
      expect_length(grep(" Free ", readLines(file)), 0)
    }
    write_result(state, file)
    again <- settle(read_moordyn(file), nodes = 50)
    ropes <- moordyn_ropes(state)
    before <- unlist(lapply(ropes, function(rope) {
      bars <- bars_of_part(state, rope_part(state$mesh, rope$name))
      at <- match(rope$node, state$mesh$ropes[[rope$name]]$node)
      state$bar_tension[bars[at[-1L] - 1L]]
    }))
    after <- again$bar_tension[again$mesh$bar_part <= length(ropes)]
    expect_length(after, length(before))
    # Only taut ropes. The trawl's ropes use a drag model by angle that MoorDyn lacks; the other
    # numbers are written with 10 digits.
    taut <- before > 1e-3 * max(before)
    law <- if (name == "midwater_trawl") 0.01 else 1e-3
    expect_equal(after[taut], before[taut], tolerance = law, label = name)
  }
})

test_that("MoorDyn export evaluates drag coefficients at the towing speed", {
  gear <- update(read_gear("towed_cable"), ropes.cable.coefficients = "choo_casarella")
  file <- write_result(settle(gear), file.path(test_folder(), "ropes.txt"))
  cable <- read_moordyn(file)$plan$ropes[[1L]]
  rope <- gear_si(gear)$ropes$cable
  reynolds <- 4 * 1852 / 3600 * rope$diameter / gear_si(gear)$water$viscosity
  # Choo and Casarella (1971) for 30 < Re < 1e5
  normal <- 1.1 + 4 * reynolds^-0.5
  expect_equal(cable$coefficients$normal * cable$diameter, normal * rope$diameter, tolerance = 1e-3)
})

test_that("read_moordyn() rejects other files and unsupported features", {
  lines <- readLines(deck("WD0050_Chain.txt"))
  refused <- function(text, says) {
    file <- file.path(test_folder(), "deck.txt")
    writeLines(text, file)
    expect_error(read_moordyn(file), says, class = "codend_error_file")
  }
  refused("a net", "must be a MoorDyn file")
  refused(append(lines, c("--- RODS ---", "", ""), 6), "has rods")
  refused(sub("^1 +chain", "1 rope", lines), "does not define this type")
  refused(sub("Vessel", "Body2", lines), "attached to Body2")
  refused(sub("1025.0 ", "salt ", lines), "has salt as WtrDnsty")
  refused(sub("0.252", "thick", lines), "has thick as the diameter")
  refused(c(lines[1:21], "2 Currents", lines[22:30]), "time-dependent current")
  refused(c(lines[1:21], "1.62 g", lines[22:30]), "gravity of 1.62")
  expect_error(read_moordyn("none.txt"), class = "codend_error_file")
  file <- file.path(test_folder(), "x.txt")
  expect_wrong(write_result(settled("hung_panel"), file), "no free rope")
})

test_that("MoorDyn export does not overwrite another file's currents", {
  folder <- test_folder()
  profile <- file.path(folder, "current_profile.txt")
  writeLines("of another deck", profile)
  refused <- function(name) {
    expect_error(write_result(settled("towed_cable"), file.path(folder, name)),
      class = "codend_error_file")
  }
  expect_match(conditionMessage(refused("lines.txt")), "another file .*currents")
  refused("current_profile.txt")
  expect_identical(readLines(profile), "of another deck")
  expect_identical(list.files(folder), "current_profile.txt")
  unlink(profile)
  for (name in c("lines.txt", "again.txt")) {
    write_result(settled("towed_cable"), file.path(folder, name))
  }
  expect_length(list.files(folder), 3L)
})
