# Validates plans against the schema file, which defines all fields. The schema is compiled when the
# package is installed. Only the keywords in this file are supported.

# Returns the schema with numbers instead of descriptions, which are in attribute `descriptions`.
# Many nodes share a description, and R stores each copy of a text.
read_schema <- function() {
  file <- system.file("schema", "plan.schema.json", package = "codend", mustWork = TRUE)
  known <- character()
  numbered <- function(node) {
    if (!is.list(node)) return(node)
    if (is.character(node$description)) {
      known <<- union(known, node$description)
      node$description <- match(node$description, known)
    }
    lapply(node, numbered)
  }
  schema <- numbered(jsonlite::fromJSON(file, simplifyVector = FALSE))
  structure(schema, descriptions = known)
}

# Returns the description with a number, or NULL.
schema_description <- function(number) if (!is.null(number)) schema_descriptions[number]

# Returns the compiled schema: one node per kind of plan, the default first.
compile_schema <- function(schema) {
  kinds <- union(schema$properties$kind$default, unlist(schema$properties$kind$enum))
  lapply(
    stats::setNames(schema$`$defs`[kinds], kinds), compile_node, definitions = schema$`$defs`
  )
}

# Returns the compiled node of a kind of plan. Each node is a separate object (R/plan-zzz.R):
# loading all nodes would take longer than checking a plan.
kind_node <- function(kind) get(paste0("plan_kind_", kind), topenv())

compile_node <- function(node, definitions) {
  while (!is.null(node[["$ref"]])) {
    target <- definitions[[sub("#/$defs/", "", node[["$ref"]], fixed = TRUE)]]
    node[["$ref"]] <- NULL
    # Keep the general description if the field has its own.
    if (!is.null(node$description)) node$meaning <- target$description
    node <- c(node, target[setdiff(names(target), names(node))])
  }
  node$groups <- c(
    requirement(node$oneOf, one = TRUE), requirement(node$anyOf, one = FALSE),
    unlist(lapply(node$allOf, function(part) {
      c(requirement(part$oneOf, one = TRUE), requirement(part$anyOf, one = FALSE))
    }), recursive = FALSE)
  )
  node$shape <- if (!is.null(node[["x-dimension"]])) {
    "quantity"
  } else if ("boolean" %in% node$type) {
    node$enum <- NULL
    "boolean"
  } else if (!is.null(node$type)) {
    # Other types than the first are replaced before: a map with the uncertainty of a number by
    # split_uncertain(), the name of a table by with_net_file().
    node$type[[1L]]
  } else {
    "any"
  }
  if (node$shape == "any") node$choices <- lapply(node$anyOf, compile_node, definitions)
  # Other validators use `if` and `then`; here `groups` and `choices` replace these keywords.
  node[c("if", "then", "anyOf", "oneOf", "allOf")] <- NULL
  if (!is.null(node$items)) node$items <- compile_node(node$items, definitions)
  if (!is.null(node$propertyNames)) {
    node$propertyNames <- compile_node(node$propertyNames, definitions)
  }
  if (is.list(node$additionalProperties)) {
    node$additionalProperties <- compile_node(node$additionalProperties, definitions)
  } else {
    node$additionalProperties <- NULL
  }
  if (!is.null(node$properties)) {
    node$properties <- lapply(node$properties, compile_node, definitions)
    given <- Filter(function(property) !is.null(property[["default"]]), node$properties)
    node$defaults <- lapply(given,
      function(property) check_field(property[["default"]], property, ""))
  }
  node$enum <- unlist(node$enum)
  node$required <- unlist(node$required)
  node
}

# Returns alternatives of required fields as a group: exactly (or at least) one must be met.
requirement <- function(alternatives, one) {
  choices <- lapply(alternatives, function(choice) unlist(choice$required))
  if (length(choices) == 0 || any(lengths(choices) == 0)) return(NULL)
  list(list(one = one, choices = choices))
}

# Checks a plan tree against the schema of its kind. Returns the tree in SI numbers with all schema
# defaults.
#
# `last`, `fields`: another tree and the result of this function for it, or NULL; fields with
# identical values are not checked again.
check_plan <- function(tree, last = NULL, fields = NULL) {
  if (!is_map(tree) || length(tree) == 0) {
    abort_plan("A plan must be a map of fields such as `codend: 1` and `name`.", NULL, tree)
  }
  kind <- tree[["kind"]]
  if (is.null(kind)) kind <- plan_kinds[1L]
  if (!is_text(kind) || !kind %in% plan_kinds) {
    abort_field("kind", kind, paste("one of", word_list(plan_kinds)))
  }
  for (name in names(tree$gears)) gear_like(tree$gears, name)
  if (!identical(fields$kind, kind)) last <- NULL
  check_map(tree, plan_node(tree), "", last, fields)
}

check_field <- function(value, node, path) {
  switch(node$shape,
    quantity = check_quantity(value, node, path),
    object = check_map(value, node, path),
    array = check_list(value, node, path),
    string = check_text(value, node, path),
    number = , integer = check_number(value, node, path),
    boolean = check_boolean(value, node, path),
    any = check_field(value, with_partial(choose_node(value, node, path), node$partial), path)
  )
}

# Returns a node that requires no fields in its maps if `partial` is TRUE.
with_partial <- function(node, partial) {
  if (isTRUE(partial)) node$partial <- TRUE
  node
}

check_quantity <- function(value, node, path) {
  if (length(value) == 1 && (is_text(value) || (is.numeric(value) && !is.na(value)))) {
    si <- quantity_si(value, node[["x-dimension"]])
    if (is.finite(si) && in_bounds(si, node)) {
      check_size(value, si, node[["x-dimension"]], path)
      if (in_bare_degrees(value, si, node[["x-dimension"]])) {
        abort_field(path, value, bare_degrees_text(value))
      }
      return(si)
    }
  }
  abort_field(path, value, describe(node, value))
}

check_number <- function(value, node, path) {
  # YAML 1.1 reads 1e3, without a decimal point, as a string.
  if (is_text(value) && grepl("^[-+]?[0-9]+[eE][-+]?[0-9]+$", value)) value <- as.double(value)
  good <- is.numeric(value) && length(value) == 1 && is.finite(value) && in_bounds(value, node) &&
    (node$shape == "number" || value == round(value)) &&
    (is.null(node$const) || value == node$const)
  if (!good) abort_field(path, value, describe(node))
  check_size(value, as.double(value), "number", path)
  as.double(value)
}

# Rejects numbers that could make forces overflow.
check_size <- function(value, si, dimension, path) {
  most <- plan_largest[[dimension]]
  if (abs(si) > most) abort_field(path, value, paste("at most", format_like(most, dimension,
    value)))
}

check_text <- function(value, node, path) {
  good <- is_text(value) && (is.null(node$enum) || value %in% node$enum) &&
    (is.null(node$minLength) || nchar(value) >= node$minLength) &&
    (is.null(node$const) || value == node$const) &&
    (is.null(node$pattern) || fits(value, node$pattern))
  if (!good) {
    abort_field(path, value, describe(node), hint = if (is_text(value)) nearest(value, node$enum))
  }
  value
}

# In PCRE, `$` also matches before a final newline. Plans must not end in one.
fits <- function(texts, pattern) grepl(pattern, texts, perl = TRUE) & !grepl("\n$", texts)

truth_words <- c(yes = TRUE, Yes = TRUE, YES = TRUE, no = FALSE, No = FALSE, NO = FALSE)

# YAML 1.2 reads yes and no as strings.
check_boolean <- function(value, node, path) {
  if (is_text(value) && value %in% names(truth_words)) return(truth_words[[value]])
  if (!is.logical(value) || length(value) != 1 || is.na(value)) {
    abort_field(path, value, describe(node))
  }
  value
}

check_list <- function(value, node, path) {
  n <- length(value)
  good <- is.null(names(value)) && (is.list(value) || is.atomic(value)) && !is.null(value) &&
    (is.null(node$minItems) || n >= node$minItems) && (is.null(node$maxItems) || n <= node$maxItems)
  if (!good) abort_field(path, value, describe(node))
  if (is.character(value) && n > 0) {
    # For example the chains of a seam, each of one edge.
    any <- node$items$shape == "any"
    items <- if (any) choose_node(value[[1]], node$items, path) else node$items
    if (all_text(value, items)) return(if (any) as.list(value) else value)
  }
  checked <- vector("list", n)
  for (i in seq_len(n)) {
    checked[i] <- list(check_field(value[[i]], node$items, paste0(path, "[", i, "]")))
  }
  switch(node$items$shape,
    quantity = , number = , integer = vapply(checked, identity, 0),
    string = vapply(checked, identity, ""),
    checked
  )
}

all_text <- function(texts, node) {
  node$shape == "string" && is.null(node$enum) && is.null(node$minLength) && is.null(node$const) &&
    !anyNA(texts) && (is.null(node$pattern) || all(fits(texts, node$pattern)))
}

# last, fields: another map of this node and its checked form, or NULL.
check_map <- function(value, node, path, last = NULL, fields = NULL) {
  if (!is_map(value)) abort_field(path, value, describe(node))
  given <- names(value)
  if (anyDuplicated(given)) {
    abort_field(join(path, given[anyDuplicated(given)]), NULL, "given once", "is given twice")
  }
  checked <- stats::setNames(vector("list", length(given)), given)
  named_well <- may_name(given, node$propertyNames)
  for (i in seq_along(given)) {
    name <- given[i]
    property <- node$properties[[name]]
    if (is.null(property)) {
      property <- if (named_well[i]) node$additionalProperties
      if (is.null(property)) property <- open_property(name, value, node, path)
      # The two sides of a trawl are often adjacent and identical.
      if (i > 1 && identical(value[[i]], value[[i - 1]])) {
        checked[i] <- checked[i - 1]
        next
      }
    }
    property <- with_partial(property, node$partial)
    # Single brackets: `[[<-` with NULL would delete the element and shift the others.
    same <- name %in% names(last) && identical(value[[i]], last[[name]])
    checked[i] <- if (same) {
      fields[name]
    } else if (property$shape == "object") {
      list(check_map(value[[i]], property, join(path, name), last[[name]], fields[[name]]))
    } else {
      list(check_field(value[[i]], property, join(path, name)))
    }
  }
  if (isTRUE(node$partial)) return(checked)
  for (name in node$required) {
    if (!name %in% given) {
      abort_field(join(path, name), NULL, describe(node$properties[[name]]), "is missing")
    }
  }
  check_presence(given, value, node, path)
  c(checked, node$defaults[!names(node$defaults) %in% given])
}

# Returns TRUE for each name that the schema's rule for names allows.
may_name <- function(names, rule) {
  good <- !is.na(names) & nzchar(names)
  if (is.null(rule)) good else good & fits(names, rule$pattern)
}

# Returns the node of a name outside the properties of a map.
open_property <- function(name, value, node, path) {
  if (is.null(node$additionalProperties)) {
    abort_unknown(path, name, names(node$properties), value[[name]])
  }
  if (!may_name(name, node$propertyNames)) {
    rule <- node$propertyNames
    abort_plan(
      sprintf(
        "Plan field `%s` has a name that is not allowed: \"%s\". %s",
        path, name, first_of(schema_description(rule$description), "It must not be empty.")
      ),
      path, name
    )
  }
  node$additionalProperties
}

check_presence <- function(given, value, node, path) {
  for (name in names(node$dependentRequired)) {
    if (!name %in% given) next
    for (due in unlist(node$dependentRequired[[name]])) {
      if (!due %in% given) {
        abort_field(join(path, due), NULL, sprintf("given with `%s`", name), "is missing")
      }
    }
  }
  for (group in node$groups) {
    met <- vapply(group$choices, function(choice) all(choice %in% given), logical(1))
    if (sum(met) == 0 || (group$one && sum(met) > 1)) {
      abort_plan(sprintf("Plan field `%s` %s.", path, choices_text(group$choices, met, given)),
        path, value)
    }
  }
  size <- length(given)
  if ((!is.null(node$minProperties) && size < node$minProperties) ||
    (!is.null(node$maxProperties) && size > node$maxProperties)) {
    known <- if (length(node$properties)) {
      paste(" of", paste0("`", names(node$properties), "`", collapse = ", "))
    } else {
      ""
    }
    abort_field(path, value, NULL,
      sprintf("has %d fields; it must have exactly one%s", size, known))
  }
}

# Describes why alternative sets of required fields do not fit: the fields that each set lacks, the
# nearest set first, or the sets that exclude each other.
choices_text <- function(choices, met, given) {
  quoted <- function(names) paste0("`", names, "`", collapse = ", ")
  if (any(met)) {
    sets <- vapply(choices[met], quoted, "")
    return(paste("has", paste(sets, collapse = " and "), "together; it must have only one"))
  }
  lacks <- lapply(choices, setdiff, given)
  nearest <- order(lengths(lacks) == lengths(choices), lengths(lacks))
  paste("lacks", paste(vapply(lacks[nearest], quoted, ""), collapse = "; or "))
}

# Returns the alternative of `node` that matches the shape of a value.
choose_node <- function(value, node, path) {
  found <- NULL
  for (choice in node$choices) {
    fits <- switch(choice$shape,
      object = is_map(value) && (length(value) > 0 || is.list(value)),
      array = is.null(names(value)) && (is.list(value) || length(value) > 1),
      string = is.character(value) && length(value) == 1,
      quantity = is_text(value) || (is.numeric(value) && length(value) == 1),
      number = , integer = is.numeric(value) && length(value) == 1,
      boolean = length(value) == 1 && (is.logical(value) || value %in% names(truth_words))
    )
    if (!fits) next
    # Prefer an enumerated name if the string may also be a quantity.
    if (is.null(choice$enum) || value %in% choice$enum) return(choice)
    if (is.null(found)) found <- choice
  }
  if (!is.null(found)) return(found)
  abort_field(path, value, describe(node))
}

in_bounds <- function(value, node) {
  (is.null(node$minimum) || value >= node$minimum) &&
    (is.null(node$exclusiveMinimum) || value > node$exclusiveMinimum) &&
    (is.null(node$maximum) || value <= node$maximum)
}

join <- function(path, name) if (nzchar(path)) paste0(path, ".", name) else name
