test_that("a plan that asks for too many nodes is refused before anything is allocated", {
  panel <- read_gear("flat_panel")
  many <- function(...) panel |> update(...)
  # 9000 x 9000 triangles have as many nodes
  huge <- many(panels.netting.columns = 9000, panels.netting.rows = 9000)
  before <- gc(reset = TRUE)
  error <- expect_error(settle(huge), "8.1e+07 nodes, which would take about 810 GB of memory",
    class = "codend_error_plan", fixed = TRUE)
  # Mb at most since the reset, beyond what was there: R's own and the check's, but no lattice
  expect_lt(sum(gc()[, 6]) - sum(before[, 2]), 50)
  expect_identical(error$path, "panels.netting")
  expect_refused(tow(huge, until = 1), "nodes")
  # a design of a study that cannot be is a row with its reason
  some <- suppressWarnings(
    vary(panel, panels.netting.columns = c(10, 9000), panels.netting.rows = 10, nodes = 50))
  expect_identical(some$settled, c(TRUE, TRUE))
  some <- suppressWarnings(vary(panel, panels.netting.columns = 9000, panels.netting.rows = 9000))
  expect_match(some$problem, "nodes")
  expect_wrong(settle(panel, nodes = 1e9), "at most")
})

test_that("what is allowed by the quick bound is allowed by the exact count", {
  for (name in gears()$name) {
    si <- gear_si(read_gear(name))
    # what the plan leaves open gets as few nodes as can be
    least <- sum(engine_node_counts(gear_numbers(si), 1)$nodes)
    open <- sum(vapply(si$ropes, function(rope) is.null(rope$segments), NA))
    # a rope that is left open has four bars at least
    expect_lte(least, divided_at_most(si) + 4 * open, label = name)
  }
})

test_that("counts in plans are bounded before a short form is expanded", {
  longline <- read_gear("longline")
  for (baskets in c(1e6, 1e12, 999)) {
    expect_refused(update(longline, baskets = baskets), "baskets")
  }
  expect_refused(update(read_gear("cage"), panels = 1e9), "at most 360")
  cable <- read_gear("towed_cable")
  expect_refused(update(cable, ropes.cable.segments = 1e9), "at most 10000")
  # every count of the schema has both bounds
  open <- character()
  walk <- function(node, path) {
    if (identical(node$shape, "integer") && is.null(node$const) && is.null(node$enum) &&
      is.null(node$maximum)) open <<- c(open, path)
    for (name in names(node$properties)) walk(node$properties[[name]], join(path, name))
    for (choice in node$choices) walk(choice, path)
    if (!is.null(node$items)) walk(node$items, path)
    if (!is.null(node$additionalProperties)) walk(node$additionalProperties, path)
  }
  for (kind in plan_kinds) walk(kind_node(kind), kind)
  expect_identical(open, character())
})
