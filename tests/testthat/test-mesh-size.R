test_that("settle() rejects too many nodes before allocating memory", {
  panel <- read_gear("flat_panel")
  many <- function(...) panel |> update(...)
  # 9000 x 9000 triangles have as many nodes
  huge <- many(panels.netting.columns = 9000, panels.netting.rows = 9000)
  before <- gc(reset = TRUE)
  error <- expect_error(settle(huge), "8.1e+07 nodes (about 810 GB of memory)",
    class = "codend_error_plan", fixed = TRUE)
  # maximum Mb since the reset, above the initial value: R's own and the check's memory, but no mesh
  expect_lt(sum(gc()[, 6]) - sum(before[, 2]), 50)
  expect_identical(error$path, "panels.netting")
  expect_refused(tow(huge, until = 1), "nodes")
  # an impossible design of a study is a row with its reason
  some <- suppressWarnings(
    vary(panel, panels.netting.columns = c(10, 9000), panels.netting.rows = 10, nodes = 50))
  expect_identical(some$settled, c(TRUE, TRUE))
  some <- suppressWarnings(vary(panel, panels.netting.columns = 9000, panels.netting.rows = 9000))
  expect_match(some$problem, "nodes")
  expect_wrong(settle(panel, nodes = 1e9), "at most")
})

test_that("quick node bound accepts every plan that the exact count accepts", {
  for (name in gears()$name) {
    si <- gear_si(read_gear(name))
    # ropes without segments get the minimum number of nodes
    least <- sum(engine_node_counts(gear_numbers(si), 1)$nodes)
    open <- sum(vapply(si$ropes, function(rope) is.null(rope$segments), NA))
    # such a rope has at least four bars
    expect_lte(least, divided_at_most(si) + 4 * open, label = name)
  }
})

test_that("every count of the schema has an upper bound", {
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
