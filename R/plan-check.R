# The schema file is the one table of fields. It is made ready once, when the package is installed,
# and a plan is walked along it. Only the keywords that the file uses are known; others are for
# editors.

# The schema with references put in place: a compiled node per kind of plan, the default first.
compile_schema <- function() {
  file <- system.file("schema", "plan.schema.json", package = "codend", mustWork = TRUE)
  schema <- jsonlite::fromJSON(file, simplifyVector = FALSE)
  kinds <- union(schema$properties$kind$default, unlist(schema$properties$kind$enum))
  lapply(
    stats::setNames(schema$`$defs`[kinds], kinds), compile_node, definitions = schema$`$defs`
  )
}

# The compiled node of a kind of plan. Each is an object of its own (R/plan-zzz.R): all of them
# together take longer to load than a plan takes to check.
kind_node <- function(kind) get(paste0("plan_kind_", kind), topenv())

compile_node <- function(node, definitions) {
  while (!is.null(node[["$ref"]])) {
    target <- definitions[[sub("#/$defs/", "", node[["$ref"]], fixed = TRUE)]]
    node[["$ref"]] <- NULL
    # what the definition itself says, where the field describes its own use of it
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
    # a number may be a map of how well it is known, which is taken apart before
    setdiff(unlist(node$type), if (length(node$type) > 1L) "object")
  } else {
    "any"
  }
  if (node$shape == "any") node$choices <- lapply(node$anyOf, compile_node, definitions)
  # Other validators use `if` and `then`; groups and choices replace the other keywords.
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

# Alternatives that only list required fields, as a group of which one (or at least one) is due.
requirement <- function(alternatives, one) {
  choices <- lapply(alternatives, function(choice) unlist(choice$required))
  if (length(choices) == 0 || any(lengths(choices) == 0)) return(NULL)
  list(list(one = one, choices = choices))
}

# Checks a plan tree against the schema of its kind.
# Returns the tree in SI numbers with every default of the schema filled in.
#
# last, fields: another tree and what this function returned for it, or NULL; a field of the same
# value is not checked again.
check_plan <- function(tree, last = NULL, fields = NULL) {
  if (!is_map(tree) || length(tree) == 0) {
    abort_plan("A plan must be a map of fields such as `codend: 1` and `name`.", NULL, tree)
  }
  kind <- tree[["kind"]]
  if (is.null(kind)) kind <- plan_kinds[1L]
  if (!is_text(kind) || !kind %in% plan_kinds) {
    abort_field("kind", kind, paste("one of", word_list(plan_kinds)))
  }
  if (!identical(fields$kind, kind)) last <- NULL
  check_map(tree, kind_node(kind), "", last, fields)
}

check_field <- function(value, node, path) {
  switch(node$shape,
    quantity = check_quantity(value, node, path),
    object = check_map(value, node, path),
    array = check_list(value, node, path),
    string = check_text(value, node, path),
    number = , integer = check_number(value, node, path),
    boolean = check_boolean(value, node, path),
    any = check_field(value, choose_node(value, node, path), path)
  )
}

check_quantity <- function(value, node, path) {
  if (length(value) == 1 && (is_text(value) || (is.numeric(value) && !is.na(value)))) {
    si <- quantity_si(value, node[["x-dimension"]])
    if (is.finite(si) && in_bounds(si, node)) {
      check_size(value, si, node[["x-dimension"]], path)
      return(si)
    }
  }
  abort_field(path, value, describe(node, value))
}

check_number <- function(value, node, path) {
  # YAML 1.1 reads 1e3, without a decimal point, as text
  if (is_text(value) && grepl("^[-+]?[0-9]+[eE][-+]?[0-9]+$", value)) value <- as.double(value)
  good <- is.numeric(value) && length(value) == 1 && is.finite(value) && in_bounds(value, node) &&
    (node$shape == "number" || value == round(value)) &&
    (is.null(node$const) || value == node$const)
  if (!good) abort_field(path, value, describe(node))
  check_size(value, as.double(value), "number", path)
  as.double(value)
}

# No number so large that forces could overflow.
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

# A pattern's end is the end of the text; to PCRE it is also before a line's end there.
fits <- function(texts, pattern) grepl(pattern, texts, perl = TRUE) & !grepl("\n$", texts)

truth_words <- c(yes = TRUE, Yes = TRUE, YES = TRUE, no = FALSE, No = FALSE, NO = FALSE)

# A text yes or no is how YAML 1.2 reads it.
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
    # such as the chains of a seam, each one edge
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

# Whether texts are all that a node of texts asks for.
all_text <- function(texts, node) {
  node$shape == "string" && is.null(node$enum) && is.null(node$minLength) && is.null(node$const) &&
    !anyNA(texts) && (is.null(node$pattern) || all(fits(texts, node$pattern)))
}

# last, fields: another map of this node and what it was checked to, or NULL.
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
      # the sides of a trawl follow each other and are alike
      if (i > 1 && identical(value[[i]], value[[i - 1]])) {
        checked[i] <- checked[i - 1]
        next
      }
    }
    # in single brackets: a place assigned NULL would go, and later fields move to wrong names
    same <- name %in% names(last) && identical(value[[i]], last[[name]])
    checked[i] <- if (same) {
      fields[name]
    } else if (property$shape == "object") {
      list(check_map(value[[i]], property, join(path, name), last[[name]], fields[[name]]))
    } else {
      list(check_field(value[[i]], property, join(path, name)))
    }
  }
  for (name in node$required) {
    if (!name %in% given) {
      abort_field(join(path, name), NULL, describe(node$properties[[name]]), "is missing")
    }
  }
  check_presence(given, value, node, path)
  c(checked, node$defaults[!names(node$defaults) %in% given])
}

# Which names a schema's rule for names allows.
may_name <- function(names, rule) {
  good <- !is.na(names) & nzchar(names)
  if (is.null(rule)) good else good & fits(names, rule$pattern)
}

# The node of a name that is not among the properties of a map.
open_property <- function(name, value, node, path) {
  if (is.null(node$additionalProperties)) {
    abort_unknown(path, name, names(node$properties), value[[name]])
  }
  if (!may_name(name, node$propertyNames)) {
    rule <- node$propertyNames
    abort_plan(
      sprintf(
        "Plan field `%s` has a name that is not allowed: \"%s\". %s",
        path, name, if (is.null(rule)) "It must not be empty." else rule$description
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
      choices <- vapply(group$choices, function(choice) {
        paste0("`", choice, "`", collapse = " with ")
      }, "")
      abort_plan(
        sprintf(
          "Plan field `%s` has %s; it must have %s of: %s.", path,
          if (sum(met) == 0) "none of what it needs" else "too much",
          if (group$one) "exactly one" else "at least one", paste(choices, collapse = "; ")
        ),
        path, value
      )
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

# The alternative of `node` that a value is meant as, by its shape alone.
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
    # A name is looked for first where the text may also be a quantity.
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
