plan_node <- function(plan) {
  kind_node(first_of(plan$kind, plan_kinds[1L]))
}

# Returns the steps of a path. A final dot gives an empty last step, which no plan contains.
path_steps <- function(path) strsplit(sub("[.]$", "..", path), ".", fixed = TRUE)[[1]]

# Returns a path with list indices as steps: `a[2].b` becomes `a.2.b`.
dotted_path <- function(path) gsub("\\[([0-9]+)\\]", ".\\1", path)

# Returns the node one step below `node`, or NULL if it does not allow the field. A list item has
# its number as its step. If the node is a choice, a number selects the list and a name the map.
child_node <- function(node, step) {
  number <- grepl("^[0-9]+$", step)
  if (identical(node$shape, "any")) {
    shape <- if (number) "array" else "object"
    node <- first_of(Filter(function(choice) choice$shape == shape, node$choices)[1][[1]], list())
  }
  if (identical(node$shape, "array")) return(if (number) node$items)
  first_of(node$properties[[step]], node$additionalProperties)
}

path_node <- function(plan, path) {
  node <- plan_node(plan)
  for (step in path_steps(path)) {
    node <- child_node(node, step)
    if (is.null(node)) return(NULL)
  }
  node
}

# Returns a field of a plan: list(node, value (given or default), given), or NULL.
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

# Returns the alternative of a choice that matches a value, or NULL.
meant_node <- function(value, node) {
  if (!identical(node$shape, "any")) return(node)
  tryCatch(choose_node(value, node, ""), codend_error_plan = function(e) NULL)
}

# Returns the plan with one field changed (NULL removes it).
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
