test_that("former names of fields and values are errors that give the present names", {
  former <- function(old, new, field, value, plan = "poly_noreastern_trawl") {
    text <- gsub(field, value, paste(format(read_gear(plan)), collapse = "\n"))
    expect_error(read_text(text), sprintf("%s` .*did you mean `%s`", old, new),
      class = "codend_error_plan", ignore.case = TRUE)
  }
  former("head_line", "headline", "\nheadline:", "\nhead_line:")
  former("floats.share", "extent", "extent:", "share:")
  former("pushes", "lift_direction", "lift_direction:", "pushes:",
    test_path("plans", "towed_board.yaml"))
  former("place", "position", "position: start", "place: start", "longline")
  former("netting_drag", "morison", "netting_drag: morison", "netting_drag: twines",
    "midwater_trawl")
})

test_that("check rejects every kind of wrong quantity", {
  wrong <- c(
    "0", "5 kg", ".nan", ".inf", "NA", "", "1_000", "2020-01-01", "yes", "0x1F", "'1,5 m'",
    "[1, 2]", "{a: 1}", "1e400 m", "''", "'100 {m}'", "~"
  )
  for (value in wrong) {
    error <- plan_error("length: 100 m", paste("length:", value))
    expect_identical(error$path, "ropes.warp.length", label = value)
    expect_match(error$message, "must be a length greater than 0 m", fixed = TRUE)
  }
})

test_that("schema uses only keywords that the checker knows", {
  known <- c(
    "$ref", "title", "description", "type", "enum", "const", "pattern", "minLength", "minimum",
    "exclusiveMinimum", "maximum", "items", "minItems", "maxItems", "properties", "required",
    "additionalProperties", "propertyNames", "dependentRequired", "minProperties", "maxProperties",
    "anyOf", "oneOf", "allOf", "default", "x-dimension",
    # of numbers with an uncertainty, which are split before the check
    "if", "then"
  )
  schema <- jsonlite::fromJSON(
    system.file("schema", "plan.schema.json", package = "codend"), simplifyVector = FALSE
  )
  found <- character()
  visit <- function(node) {
    found <<- union(found, names(node))
    lapply(node$properties, visit)
    for (key in c("items", "additionalProperties", "propertyNames")) {
      if (is.list(node[[key]])) visit(node[[key]])
    }
    for (key in c("anyOf", "oneOf", "allOf")) lapply(node[[key]], visit)
  }
  lapply(schema$`$defs`, visit)
  expect_identical(setdiff(found, known), character())
})

test_that("schema choices of a field differ in shape", {
  clashes <- character()
  check <- function(node, path) {
    shapes <- vapply(node$choices, `[[`, "", "shape")
    if (anyDuplicated(shapes)) clashes <<- c(clashes, path)
    for (name in names(node$properties)) check(node$properties[[name]], paste0(path, ".", name))
    for (key in c("items", "additionalProperties")) {
      if (is.list(node[[key]])) check(node[[key]], path)
    }
  }
  for (kind in plan_kinds) check(kind_node(kind), kind)
  expect_identical(clashes, character())
})

# Paths of the lists that may be empty in a plan, without the number of an item.
lists_that_may_be_empty <- function(node, path = character()) {
  found <- if (node$shape == "array" && is.null(node$minItems)) list(path)
  inner <- unlist(lapply(names(node$properties), function(name) {
    lists_that_may_be_empty(node$properties[[name]], c(path, name))
  }), recursive = FALSE)
  choices <- unlist(lapply(node$choices, lists_that_may_be_empty, path), recursive = FALSE)
  unique(c(found, inner, choices))
}

test_that("empty list in a plan equals a missing field", {
  for (name in names(shipped_plans())) {
    plan <- read_gear(name)$plan
    lists <- lists_that_may_be_empty(plan_node(plan))
    expect_true(list("notes") %in% lists)
    for (path in lists) {
      field <- path[1]
      # a plan without this field is invalid, so there is nothing to compare
      if (field %in% plan_node(plan)$required) next
      empty <- if (length(path) == 1) list() else stats::setNames(list(list()), path[2])
      others <- plan[names(plan) != field]
      expected <- check_plan(others)
      for (at in c(0, length(others) %/% 2, length(others))) {
        checked <- check_plan(append(others, stats::setNames(list(empty), field), after = at))
        expect_length(checked[[path]], 0)
        expect_identical(
          checked[setdiff(names(expected), field)], expected[names(expected) != field],
          label = sprintf("%s with %s empty at %d", name, paste(path, collapse = "."), at)
        )
      }
    }
  }
})

test_that("check agrees with standard validators of the schema", {
  cases <- yaml::read_yaml(test_path("right-and-wrong.yaml"))
  right <- function(change) {
    file <- plan_file(gsub(change[[1]], change[[2]], cases$plan, fixed = TRUE))
    tryCatch(
      {
        plan <- split_uncertain(read_plan(file))
        check_plan(plan)
        uncertain_numbers(plan)
        TRUE
      },
      codend_error_plan = function(e) FALSE
    )
  }
  for (verdict in c("right", "wrong")) {
    for (change in cases[[verdict]]) {
      expect_true(grepl(change[[1]], cases$plan, fixed = TRUE), label = change[[1]])
      expect_identical(right(change), verdict == "right", label = change[[2]])
    }
  }
})
