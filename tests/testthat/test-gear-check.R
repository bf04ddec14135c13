test_that("check rejects references to missing parts with a suggestion", {
  e <- expect_plan_error
  e("from: ship", "from: shop", "ropes.warp.from", "there is no point `shop`; did you mean `ship`?")
  e("from: ship", "from: nett.upper_left", "ropes.warp.from", "there is no panel `nett`")
  e("from: ship", "from: wrap.end", "ropes.warp.from",
    "there is no rope `wrap`; did you mean `warp`?")
  e("gathered_at: knot", "gathered_at: knit", "seams.top.gathered_at", "did you mean `knot`?")
  e("[net.upper]", "[mat.upper]", "seams.top.edges[1]", "there is no panel `mat`")
  e("seams:", "pieces:\n  p: {along: rope, mass: 5}\nseams:", "pieces.p.along",
    "there is no rope `rope`")
  e("seams:", "measures:\n  p: {tension: war.max}\nseams:", "measures.p.tension", "no rope `war`")
  e("seams:", "measures:\n  p: {area: [warp, x]}\nseams:", "measures.p.area", "no rope `x`")
  e("knot: {}", "knot: {at: other}", "points.knot.at", "there is no point `other`")
})

test_that("check rejects a mesh range outside its edge", {
  for (range in c("[0:11]", "[5:5]", "[6:2]")) {
    expect_plan_error(
      "[net.upper]", paste0("[\"net.upper", range, "\"]"), "seams.top.edges[1]",
        "within the 10 meshes"
    )
  }
})

test_that("check rejects points without support, or supported twice", {
  e <- expect_plan_error
  e("position: [0, 0, 0], held: fixed", "", "points", "no held point")
  e(
    "knot: {}", "knot: {}\n  twin: {at: ship, position: [0, 0, 0], held: fixed}", "points.twin",
    "same position as the held point"
  )
  e("knot: {}", "knot: {at: again}\n  again: {at: knot}", "points.knot.at", "refers to itself")
  towed <- spoil("points:", "towing: {speed: 3 knot}\npoints:")
  e("codend: 1", "codend: 1", "towing.speed", "no point is moved", plan = towed)
  e("knot: {}", "knot: {position: [9, 0, 0], held: moved}", "points", "drift apart", plan = towed)
})

test_that("check rejects a rope between two names of one position, and a ring of two segments", {
  e <- expect_plan_error
  e("to: knot", "to: ship\n    segments: 2", "ropes.warp.segments", "needs at least 3")
  e("knot: {}", "knot: {at: ship}", "ropes.warp.to", "the same position as the start")
  e("to: knot", "to: knot\n    along: net.left", "ropes.warp", "has `from` and `along` together")
})

test_that("check rejects parts that no support holds", {
  e <- expect_plan_error
  e("knot: {}", "knot: {}\n  lonely: {}", "points.lonely", "is not attached")
  e(", gathered_at: knot", "", "seams.top.edges", "has one chain")
  e("seams:\n  top: {edges: [net.upper], gathered_at: knot}\n", "", "panels.net", "is not attached")
})

two_panels <- paste0(sub("seams:.*", "", small_plan), "  mat:
    mesh_size: 100 mm
    meshes: {upper: 10, lower: 10, deep: 50}
    twine: {diameter: 2 mm, material: PE}
seams:
  top: {edges: [net.upper], gathered_at: knot}
  join: {edges: [net.left, mat.upper]}
")

test_that("check rejects seams of unequal lengths or meshes joined twice", {
  expect_s3_class(read_text(two_panels), "codend_gear")
  e <- function(...) expect_plan_error(..., plan = two_panels)
  e("[net.left, mat.upper]", "[net.left, mat.right]", "seams.join.edges", "a factor of at most 3")
  e("upper: 10, lower: 10", "upper: 0, lower: 10", "seams.join.edges", "needs `gathered_at`")
  e(
    "  join:", "  again: {edges: [net.left, mat.lower]}\n  join:", "seams.join",
    "but seam `again` already joins them"
  )
  e("[net.left, mat.upper]", "[net.upper, mat.upper]", "seams.join", "already joins")
  parts <- spoil(
    "{edges: [net.left, mat.upper]}",
    paste0(
      "{edges: [\"net.left[0:4]\", \"mat.upper[0:4]\"]}\n",
      "  rest: {edges: [\"net.left[4:10]\", \"mat.upper[4:10]\"]}"
    ),
    two_panels
  )
  expect_s3_class(read_text(parts), "codend_gear")
  overlap <- sub("net.left[4:10]", "net.left[3:10]", parts, fixed = TRUE)
  expect_match(text_error(overlap)$message, "already joins", fixed = TRUE)
})

test_that("check accepts two fixed corners but not the same corner twice", {
  plan <- spoil(
    "knot: {}", "knot: {}\n  clamp: {at: net.upper_left, position: [1, 0, 0], held: fixed}"
  )
  expect_s3_class(read_text(plan), "codend_gear")
  twice <- sub("clamp:",
    "other: {at: net.upper_right, position: [1, 0, 0], held: fixed}\n  clamp:", plan)
  # the whole upper edge is gathered, so its corners are one position
  expect_match(text_error(twice)$message, "same position as the held point", fixed = TRUE)
})

framed <- paste0(sub("seams:.*", "", small_plan), "seams:
  top: {edges: [net.upper], held_between: [ship, post]}
")
framed <- sub("knot: {}", "knot: {}\n  post: {position: [0, 0.6, 0], held: fixed}", framed,
  fixed = TRUE)

test_that("check rejects `held_between` points that the edge cannot reach", {
  expect_s3_class(read_text(framed), "codend_gear")
  e <- function(...) expect_plan_error(..., plan = framed)
  e("[ship, post]", "[ship, pots]", "seams.top.held_between", "did you mean `post`?")
  e("[ship, post]", "[ship]", "seams.top.held_between", "a list of 2 (each a location)")
  e("[ship, post]", "[ship, knot]", "seams.top.held_between[2]",
    "is \"knot\"; it must be a held point from this list: ship, post")
  e("[ship, post]", "[net.upper_left, post]", "seams.top.held_between[1]", "a held point")
  e("[ship, post]", "[ship, ship]", "seams.top.held_between", "two points at different positions")
  # the upper edge: 10 meshes of 100 mm
  e("0.6", "1.6", "seams.top.held_between", "stretched length 1 m between points 1.6 m apart")
  e("held_between: ", "gathered_at: knot, held_between: ", "seams.top",
    "has both `gathered_at` and `held_between`")
})

test_that("check rejects `held_between` if a point holds another corner", {
  expect_plan_error(
    "knot: {}", "knot: {}\n  nail: {at: net.upper_left, position: [1, 0, 0], held: fixed}",
    "points.nail", "same position as the held point", plan = framed
  )
})
