# Fields that only the whole plan has. A gear in it takes them from there.
whole_plan_fields <- c(
  "codend", "name", "notes", "sources", "uncertain", "water", "seabed", "towing", "vessel", "tow",
  "shooting", "laid", "method", "netting", "coefficients", "netting_drag", "slack_twine",
  "shielding", "multipliers"
)

# Fields of a gear that its kind does not have.
part_fields_of_gears <- c("plan", "like", "joined", "moved", "number", "apart")

# Returns the node of a plan's kind. Each gear in the plan has the node of its own kind.
plan_node <- function(plan) {
  kind <- plan$kind
  node <- kind_node(if (is_text(kind) && kind %in% plan_kinds) kind else plan_kinds[1L])
  gears <- plan$gears
  if (!is_map(gears) || is.null(node$properties$gears)) return(node)
  of_part <- node$properties$gears$additionalProperties
  named <- names(gears)[may_name(names(gears), node$properties$gears$propertyNames)]
  node$properties$gears$properties <- lapply(stats::setNames(nm = named), function(name) {
    gear_part_node(gears, name, of_part)
  })
  node
}

# Returns the node of one gear in a plan. A gear that is like another requires no fields.
gear_part_node <- function(gears, name, node) {
  whole <- tryCatch(gear_like(gears, name), codend_error_plan = function(e) list())
  if (is_text(whole$kind) && !whole$kind %in% plan_kinds) whole["kind"] <- NULL
  of_kind <- plan_node(whole)
  own <- setdiff(names(of_kind$properties), c(whole_plan_fields, "kind"))
  node$properties <- c(node$properties, of_kind$properties[own])
  node$properties$kind$enum <- plan_kinds
  partial <- is_map(gears[[name]]) && "like" %in% names(gears[[name]])
  if (partial) return(with_partial(node, TRUE))
  node$required <- setdiff(of_kind$required, c(whole_plan_fields, "kind"))
  node[c("groups", "dependentRequired")] <- of_kind[c("groups", "dependentRequired")]
  node
}

# Returns the fields of a gear with the fields of the gears that it is like.
gear_like <- function(gears, name, seen = NULL) {
  own <- gears[[name]]
  if (!is_map(own)) return(list())
  like <- own$like
  if (is.null(like)) return(own)
  path <- paste0("gears.", name, ".like")
  others <- setdiff(names(gears), name)
  if (!is_text(like) || !like %in% others) {
    abort_field(path, like, paste("another gear of this plan:", word_list(others)),
      hint = if (is_text(like)) nearest(like, others))
  }
  if (like %in% seen) abort_field(path, like, "a gear that is not itself like this one")
  merged_fields(gear_like(gears, like, c(seen, name)), own[names(own) != "like"])
}

# Returns a map with the fields of another map in place of its own, also within inner maps. An empty
# field removes the map's own.
merged_fields <- function(map, other) {
  for (name in names(other)) {
    if (is.null(other[[name]])) {
      map[[name]] <- NULL
      next
    }
    inner <- is_map(map[[name]]) && is_map(other[[name]])
    map[name] <- list(
      if (inner) merged_fields(map[[name]], other[[name]]) else other[[name]]
    )
  }
  map
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
  child <- first_of(node$properties[[step]], node$additionalProperties)
  if (is.null(child)) NULL else with_partial(child, node$partial)
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
  # A gear that is like another may lack maps that the other gear has.
  known <- !is.null(tree[[key]]) || !is.null(node$properties[[step]]) || isTRUE(node$partial)
  if (!last && !known) {
    abort_unknown(path, step, names(tree))
  }
  tree[[key]] <- if (last) value else {
    set_at(tree[[key]], steps[-1], value, inner, join(path, step))
  }
  tree
}
