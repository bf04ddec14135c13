# Net makers' terms in the short forms of trawls: discs, covers, half meshes. Also errors for
# terms that plans do not support.

words_trawl <- function(...) {
  update(new_plan("bottom_trawl", headline = "25 m", depth = "80 m"), ...)
}

# A part's weight in water, kN.
weight_of <- function(state, pattern) {
  table <- as.data.frame(state, what = "drag")
  sum(table$weight_in_water_kN[grepl(pattern, table$part)])
}

test_that("discs have the weight of rubber cylinders and their given drag", {
  bare <- settle(words_trawl(ground_gear = list(
    length = "30.5 m", diameter = "16 mm", material = "steel_wire"
  )), nodes = 250)
  discs <- list(
    list(diameter = "350 mm", width = "80 mm", spacing = "0.5 m", extent = c(0.4, 0.6)),
    list(number = 100, diameter = "120 mm", width = "60 mm", mass = "1 kg", extent = c(0, 0.4)),
    list(number = 100, diameter = "120 mm", width = "60 mm", mass = "1 kg", extent = c(0.6, 1))
  )
  with <- settle(words_trawl(ground_gear = list(
    length = "30.5 m", diameter = "16 mm", material = "steel_wire", discs = discs
  )), nodes = 250)
  # 0.2 of 30.5 m has space for 13, half a metre apart
  pieces <- assembly(with$gear)$plan$pieces
  expect_identical(as.integer(pieces$discs_1$number), 13L)
  full <- function(d, w) pi / 4 * d^2 * w
  due <- 13 * full(0.35, 0.08) * (1250 - 1025) + 200 * (1 - 1025 * full(0.12, 0.06))
  expect_equal(weight_of(with, "^discs"), due * 9.81 / 1000, tolerance = 2e-3)
  areas <- vapply(with$si$pieces[paste0("discs_", 1:3)], `[[`, 0, "drag_area")
  expect_equal(unname(areas), 0.63 * c(0.35 * 0.08, 0.12 * 0.06, 0.12 * 0.06), tolerance = 1e-12)
  expect_gt(measures(with)[["ground_load_kN"]], measures(bare)[["ground_load_kN"]])
})

test_that("cover weighs as the same netting and shares the codend's load", {
  plain <- words_trawl()
  codend <- plain$plan$sections$codend
  layer <- codend[c("mesh_size", "meshes", "twine")]
  doubled <- settle(update(plain, sections.codend.covers = list(second_layer = layer)), nodes = 300)
  once <- settle(plain, nodes = 300)
  expect_equal(
    weight_of(doubled, "codend_second_layer$"), weight_of(doubled, "^(back|belly)_codend$"),
    tolerance = 1e-9
  )
  # Identical layers, laced edge to edge, carry equal loads. Their sum is the load of one layer,
  # except for the drag of the second.
  pull <- function(state, pattern) {
    lines <- as.data.frame(state, what = "tensions")
    lines <- lines[grepl(pattern, lines$part), ]
    sum(lines$tension_kN * lines$lines * lines$length_m)
  }
  both <- c(pull(doubled, "_codend$"), pull(doubled, "second_layer$"))
  expect_equal(both[1], both[2], tolerance = 0.05)
  expect_gt(measures(doubled)[["total_drag_kN"]], measures(once)[["total_drag_kN"]])
})

test_that("chafer covers only the belly and accepts half meshes", {
  gear <- words_trawl(sections.codend.covers = list(chafer = list(
    over = list("belly"), mesh_size = "120 mm",
    meshes = list(upper = 30.5, lower = 30.5, deep = 45),
    twine = list(diameter = "4 mm", material = "PE")
  )))
  panels <- assembly(gear)$plan$panels
  expect_true("belly_codend_chafer" %in% names(panels))
  expect_false("back_codend_chafer" %in% names(panels))
  expect_identical(panels$belly_codend_chafer$meshes$upper, 30.5)
  expect_refused(
    words_trawl(sections.body.covers = list(chafer = list(
      mesh_size = "120 mm", meshes = list(upper = 30, lower = 30, deep = 45),
      twine = list(diameter = "4 mm", material = "PE")
    ))), "first section"
  )
})

test_that("empty list of floats gives a trawl without floats", {
  trawl <- read_gear("midwater_trawl")
  none <- gear_si(update(trawl, floats = list()))
  expect_identical(none$pieces, gear_si(update(trawl, floats = NULL))$pieces)
})
