# The one way from a plan's path to its node of the schema.

# The node of a plan as a whole.
plan_node <- function(plan) {
  kind_node(first_of(plan$kind, plan_kinds[1L]))
}

# The steps of a path; a dot at its end is followed by an empty one, which no plan has.
path_steps <- function(path) strsplit(sub("[.]$", "..", path), ".", fixed = TRUE)[[1]]

# A path with its items' numbers as steps: `a[2].b` as `a.2.b`.
dotted_path <- function(path) gsub("\\[([0-9]+)\\]", ".\\1", path)

# The node one step below `node`, or NULL where it allows no such field. Items of a list go by their
# number.
#
# Where a node leaves a choice, the step tells which: a number is an item of a list, anything else a
# field of a map.
child_node <- function(node, step) {
  number <- grepl("^[0-9]+$", step)
  if (identical(node$shape, "any")) {
    shape <- if (number) "array" else "object"
    node <- first_of(Filter(function(choice) choice$shape == shape, node$choices)[1][[1]], list())
  }
  if (identical(node$shape, "array")) return(if (number) node$items)
  first_of(node$properties[[step]], node$additionalProperties)
}

# The node that a path leads to, or NULL.
path_node <- function(plan, path) {
  node <- plan_node(plan)
  for (step in path_steps(path)) {
    node <- child_node(node, step)
    if (is.null(node)) return(NULL)
  }
  node
}

# A field of a plan: list(node = of the schema, value = as given or by default, given), or NULL
# where the plan has none of that path.
plan_field <- function(plan, path) {
  given <- TRUE
  node <- plan_node(plan)
  value <- plan
  for (step in path_steps(path)) {
    node <- child_node(node, step)
    if (is.null(node)) return(NULL)
    if (is_map(value)) {
      given <- step %in% names(value)
      value <- if (given) value[[step]] else node[["default"]]
    } else {
      place <- suppressWarnings(as.integer(step))
      if (is.na(place) || place < 1L || place > length(value)) return(NULL)
      value <- value[[place]]
    }
    if (is.null(value)) return(NULL)
  }
  list(node = meant_node(value, node), value = value, given = given)
}

# A node that leaves a choice becomes the alternative that a value is meant as, or NULL.
meant_node <- function(value, node) {
  if (!identical(node$shape, "any")) return(node)
  tryCatch(choose_node(value, node, ""), codend_error_plan = function(e) NULL)
}

# The plan with one field changed (NULL: taken out).
set_plan_field <- function(plan, path, value) {
  set_at(plan, path_steps(path), value, plan_node(plan), "")
}

set_at <- function(tree, steps, value, node, path) {
  step <- steps[1]
  last <- length(steps) == 1
  inner <- child_node(node, step)
  tree <- as.list(tree)
  listed <- is.null(names(tree)) && length(tree) > 0
  key <- if (listed) suppressWarnings(as.integer(step)) else step
  if (listed && (is.na(key) || key < 1 || key > length(tree))) {
    abort_unknown(path, step, seq_along(tree))
  }
  if (is.null(inner)) abort_unknown(path, step, names(node$properties))
  if (!last && is.null(tree[[key]]) && is.null(node$properties[[step]])) {
    abort_unknown(path, step, names(tree))
  }
  tree[[key]] <- if (last) value else {
    set_at(tree[[key]], steps[-1], value, inner, join(path, step))
  }
  tree
}
