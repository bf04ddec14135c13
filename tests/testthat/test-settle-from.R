# settle() from a state. tests/ratchets/cost.R counts its cost.

test_that("settle() from a gear's own state needs no iteration", {
  for (name in gears()$name) {
    gear <- read_gear(name)
    suppressWarnings(state <- settled(name, nodes = 300), classes = "codend_warning")
    suppressWarnings(again <- settle(gear, nodes = 300, from = state), classes = "codend_warning")
    expect_identical(again$report$iterations, 0L, label = name)
    expect_identical(again$report$factorisations, 0L, label = name)
    expect_identical(again$position, state$position, label = name)
  }
})

test_that("settle() from a state finds the same equilibrium as from scratch", {
  # With blended drag and a speed 10 % higher, the corners have two equilibria 0.03 % apart.
  thin <- update(read_gear(test_path("plans", "trawl_1536.yaml")), netting_drag = "morison")
  trawl <- read_gear("midwater_trawl")
  # Changes of length are omitted: they would change the mesh of a cold start.
  changed <- list(
    update(thin, towing.speed = "4.95 knot"), update(thin, otter_boards.area = "13.2 m2"),
    update(thin, otter_boards.mass = "4.4 tonne"), update(trawl, towing.speed = "4.4 knot")
  )
  from <- list(settle(thin, nodes = 1500), settle(trawl, nodes = 1500))[c(1, 1, 1, 2)]
  for (k in seq_along(changed)) {
    # The solver stops at net forces of 1e-8 of the largest tension.
    expect_equal(measures(settle(changed[[k]], nodes = 1500, from = from[[k]])),
      measures(settle(changed[[k]], nodes = 1500)), tolerance = 1e-6, label = paste("change", k))
  }
})
