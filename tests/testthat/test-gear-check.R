# Plans with one wrong line. Each throws an error with the message stored in _snaps, which names the
# field, its value and its position in the file.

two_panels <- paste0(sub("seams:.*", "", small_plan), "  mat:
    mesh_size: 100 mm
    meshes: {upper: 10, lower: 10, deep: 50}
    twine: {diameter: 2 mm, material: PE}
seams:
  top: {edges: [net.upper], gathered_at: knot}
  join: {edges: [net.left, mat.upper]}
")

framed <- paste0(sub("seams:.*", "", small_plan), "seams:
  top: {edges: [net.upper], held_between: [ship, post]}
")

right_plans <- list(
  small = small_plan, two_panels = two_panels,
  parts = spoil("{edges: [net.left, mat.upper]}", "{edges: [\"net.left[0:4]\", \"mat.upper[0:4]\"]}
  rest: {edges: [\"net.left[4:10]\", \"mat.upper[4:10]\"]}", two_panels),
  clamped = spoil("knot: {}",
    "knot: {}\n  clamp: {at: net.upper_left, position: [1, 0, 0], held: fixed}"),
  framed = spoil("knot: {}", "knot: {}\n  post: {position: [0, 0.6, 0], held: fixed}", framed)
)

# Adds the fields of a piece or a measure to the small plan.
with_piece <- function(fields) c("seams:", paste0("pieces:\n  p: {", fields, "}\nseams:"))
with_measure <- function(fields) c("seams:", paste0("measures:\n  m: {", fields, "}\nseams:"))

# The replaced string and its wrong replacement, by plan.
wrong_edits <- list(
  small = list(
    # missing, wrong and surplus fields
    c("    length: 100 m\n", ""), c("    from: ship\n", ""), c("    diameter: 20 mm\n", ""),
    c("    material: PA\n", ""), c("material: PA", "material: polyamid"),
    c("100 m\n", "100 m\n    hanging_ratio: 1\n"), c("codend: 1", "codend: 2"),
    c("codend: 1\n", ""), c("name: A net on a warp", "name: 5"),
    c("name: A", "kind: trawl\nname: A"), c("twine: {", "twine: {double: maybe, "),
    c("upper: 10", "upper: -1"), c("length: 100 m", "length: -5 m"),
    c("length: 100 m", "lenght: 5 m"), c("length: 100 m", "length: 1e308 m"),
    c("PA", "'{cli::ansi_nchar}'"),
    # uncertainties
    c("length: 100 m", "length: {value: 100 m, uncertainty: 10 kg}"),
    c("length: 100 m", "length: {value: 100 m, uncertainty: about 3 m}"),
    c("length: 100 m", "length: {uncertainty: 3 m}"),
    c("length: 100 m", "length: {range: [90 m, 110 m, 120 m]}"),
    c("length: 100 m", "length: {value: 100 m, range: [103 m, 97 m]}"),
    c("length: 100 m", "length: {value: 100 m, range: [101 m, 105 m]}"),
    c("length: 100 m", "length: {value: 100 kg, uncertainty: 10 %}"),
    c("seams:", "uncertain: {ropes.wrap.length: 10 %}\nseams:"),
    # panels
    c("upper: 10, lower: 5", "upper: 0, lower: 0"), c("mesh_size: 100 mm", "mesh_size: 3 mm"),
    c("mesh_size", "rows: 2.5\n    mesh_size"), c("held: fixed", "held: fixd"),
    c("knot: {}", "knot: {position: [0, 0, 1]}"), c("knot: {}", "knot: {load: [1, 2]}"),
    c("knot: {}", "knot: {load: [1, 2, 3 m]}"), c("knot: {}", "k.not: {}"),
    c("[net.upper]", "[net.uper]"), with_measure("depth: knot, length: [knot, ship]"),
    c("points:", "coefficients: hoern\npoints:"),
    c("twine: {", "straight_bar: 10 mm\n    twine: {"),
    c("twine: {", "orientation: hexagonal\n    straight_bar: 50 mm\n    twine: {"),
    # references to missing parts
    c("from: ship", "from: shop"), c("from: ship", "from: nett.upper_left"),
    c("from: ship", "from: wrap.end"), c("gathered_at: knot", "gathered_at: knit"),
    c("[net.upper]", "[mat.upper]"), with_piece("along: rope, mass: 5"),
    with_measure("tension: war.max"), with_measure("area: [warp, x]"),
    c("knot: {}", "knot: {at: other}"),
    # ranges outside their edge
    c("[net.upper]", "[\"net.upper[0:11]\"]"), c("[net.upper]", "[\"net.upper[5:5]\"]"),
    c("[net.upper]", "[\"net.upper[6:2]\"]"),
    # points without support, or supported twice
    c("position: [0, 0, 0], held: fixed", ""),
    c("knot: {}", "knot: {}\n  twin: {at: ship, position: [0, 0, 0], held: fixed}"),
    c("knot: {}", "knot: {at: again}\n  again: {at: knot}"),
    c("points:", "towing: {speed: 3 knot}\npoints:"), c("knot: {}", "knot: {}\n  lonely: {}"),
    c("knot: {}\n", "knot: {position: [9, 0, 0], held: moved}\ntowing: {speed: 3 knot}\n"),
    c(", gathered_at: knot", ""),
    c("seams:\n  top: {edges: [net.upper], gathered_at: knot}\n", ""),
    # ropes between two names of one position
    c("to: knot", "to: ship\n    segments: 2"), c("knot: {}", "knot: {at: ship}"),
    c("to: knot", "to: knot\n    along: net.left"),
    # pieces with contradicting fields
    with_piece("at: knot, role: weight"), with_piece("at: knot, buoyancy: 5, mass: 3"),
    with_piece("at: knot, mass: 5, density: 7850, volume: 1"),
    with_piece("at: knot, density: 7850"),
    with_piece("at: knot, buoyancy: 1000 N, diameter: 10 cm"),
    with_piece("at: knot, mass: 5, drag_coefficient: 1"),
    with_piece("at: knot, area: 5, lift_coefficient: 1"),
    with_piece("at: knot, mass: 5, extent: [0, 1]"), with_piece("at: knot, mass: 5, along: warp"),
    with_piece("along: warp, extent: [0.5, 0.2], mass: 1"),
    with_piece("along: warp, mass: 5, end_to_end: yes"),
    with_piece("at: knot, mass: 5, number: 2, end_to_end: yes"),
    with_piece("along: warp, mass: 5, number: 2, end_to_end: 2")
  ),
  # seams of unequal lengths, and meshes joined twice
  two_panels = list(
    c("[net.left, mat.upper]", "[net.left, mat.right]"),
    c("upper: 10, lower: 10", "upper: 0, lower: 10"),
    c("  join:", "  again: {edges: [net.left, mat.lower]}\n  join:"),
    c("[net.left, mat.upper]", "[net.upper, mat.upper]")
  ),
  parts = list(c("net.left[4:10]", "net.left[3:10]")),
  # the whole upper edge is gathered, so its corners are one position
  clamped = list(c("clamp:",
    "other: {at: net.upper_right, position: [1, 0, 0], held: fixed}\n  clamp:")),
  # points that the upper edge cannot reach: 10 meshes of 100 mm
  framed = list(
    c("[ship, post]", "[ship, pots]"), c("[ship, post]", "[ship]"),
    c("[ship, post]", "[ship, knot]"), c("[ship, post]", "[net.upper_left, post]"),
    c("[ship, post]", "[ship, ship]"), c("0.6", "1.6"),
    c("held_between: ", "gathered_at: knot, held_between: "),
    c("knot: {}", "knot: {}\n  nail: {at: net.upper_left, position: [1, 0, 0], held: fixed}")
  )
)

test_that("check accepts joined, clamped and framed panels", {
  for (plan in right_plans) expect_s3_class(read_text(plan), "codend_gear")
})

test_that("wrong plans throw an error that names the field, its value and its position", {
  texts <- unlist(lapply(names(wrong_edits), function(plan) {
    vapply(wrong_edits[[plan]], function(edit) {
      message <- plan_error(edit[1], edit[2], right_plans[[plan]])$message
      paste0(encodeString(edit[1]), " -> ", encodeString(edit[2]), "\n  ", without_lists(message))
    }, "")
  }))
  expect_identical(grep("no error", texts, value = TRUE), character())
  expect_snapshot(cat(texts, sep = "\n"), cran = TRUE)
})
