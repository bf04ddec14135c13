# Generates these files:
# - inst/schema/plan.schema.json from the parts in tools/schema and the units of R/plan-units.R.
#   tools/schema/README.md describes the format of the parts.
# - The engine's enumerations of drag models and of measures from inst/schema/drag_models.csv and
#   inst/schema/measures.csv.
#
#   Rscript tools/schema.R           writes the files
#   Rscript tools/schema.R --check   fails if the files are outdated
#
# Run it in the root of the checkout. Needs the packages jsonlite and yaml.

parts_folder <- "tools/schema"
schema_file <- "inst/schema/plan.schema.json"
laws_file <- "inst/schema/drag_models.csv"
laws_header <- "src/engine/base/drag_models.hpp"
measures_file <- "inst/schema/measures.csv"
measures_header <- "src/engine/measure/measure_kinds.hpp"

read_part <- function(name) {
  yaml::read_yaml(file.path(parts_folder, paste0(name, ".yaml")), handlers = list(
    # A list of one entry stays a list.
    seq = as.list
  ))
}

stop_part <- function(...) stop("tools/schema: ", ..., call. = FALSE)

# ---- quantities -------------------------------------------------------------------------------

units <- new.env()
sys.source("R/plan-units.R", units)

# Returns a pattern for a unit in a plan, as plain_unit() reads it. Squares and cubes are digits,
# with or without a caret, or superscripts. Blanks may surround a slash.
unit_pattern <- function(unit) {
  if (unit == "kg/100 m") return("kg */ *100 ?m")
  pattern <- gsub(" ", " +", unit, fixed = TRUE)
  pattern <- gsub("/", " */ *", pattern, fixed = TRUE)
  pattern <- gsub("2", "(\\^?2|\u00b2)", pattern, fixed = TRUE)
  gsub("3", "(\\^?3|\u00b3)", pattern, fixed = TRUE)
}

quantity <- function(dimension, example) {
  names <- names(units$plan_units[[dimension]])
  words <- gsub("_", " ", dimension, fixed = TRUE)
  article <- if (grepl("^[aeiou]", words)) "An" else "A"
  list(
    title = words,
    description = if (dimension == "number") {
      paste0("A number or a percentage, such as 0.45 or ", example, ".")
    } else {
      paste0(article, " ", words, ": text with a unit, such as \"", example,
        "\", or a bare number in ", names[1], ".")
    },
    type = list("number", "string", "object"), pattern = quantity_pattern(names),
    `x-dimension` = dimension, `if` = of_map, then = list(`$ref` = known_place(dimension))
  )
}

quantity_pattern <- function(units, sign = "[-+]?") {
  paste0(
    "^\\s*", sign, "([0-9]+[.]?[0-9]*|[.][0-9]+)([eE][-+]?[0-9]+)?(\\s*(",
    paste(vapply(units, unit_pattern, ""), collapse = "|"), "))?\\s*$"
  )
}

# ---- uncertainty of numbers ---------------------------------------------------------------------

# A plan may replace any number by a map with its uncertainty. codend removes such maps before it
# checks the schema (R/plan-uncertain.R). `if`, `then` and the type `object` of a number are for
# other validators.

of_map <- list(type = "object")
known_place <- function(dimension) paste0("#/$defs/known_", dimension)

known_quantity <- function(dimension) {
  names <- names(units$plan_units[[dimension]])
  plain <- list(type = list("number", "string"), pattern = quantity_pattern(names))
  shares <- names(units$plan_units$number)
  list(
    title = paste(gsub("_", " ", dimension, fixed = TRUE), "with its uncertainty"),
    type = "object",
    oneOf = list(list(required = list("value", "uncertainty")), list(required = list("range"))),
    properties = list(
      value = c(list(description = "The number."), plain),
      uncertainty = list(
        description = "Its standard uncertainty: a percentage such as 10 %, or an amount.",
        type = plain$type, minimum = 0,
        pattern = quantity_pattern(unique(c(names, shares)), "[+]?")
      ),
      range = list(
        description = "The two ends of an interval. All values in it are equally probable.",
        type = "array",
        minItems = 2, maxItems = 2, items = plain
      )
    ),
    additionalProperties = FALSE
  )
}

# Returns a node in which a map may replace each number, with the same bounds.
with_known <- function(node) {
  if (!is.list(node)) return(node)
  for (key in c("items", "additionalProperties")) node[[key]] <- with_known(node[[key]])
  for (key in c("properties", "anyOf")) {
    if (length(node[[key]])) node[[key]] <- lapply(node[[key]], with_known)
  }
  bounds <- node[intersect(names(node), c("pattern", "minimum", "exclusiveMinimum", "maximum"))]
  if (isTRUE(node$type %in% c("number", "integer")) && is.null(c(node$const, node$enum))) {
    bounds <- c(node["type"], bounds)
    node$type <- list(node$type, "object")
    known <- list(`$ref` = known_place("number"))
  } else if (length(bounds) && isTRUE(node$`$ref` %in% paste0("#/$defs/", names(examples)))) {
    known <- list()
  } else {
    return(node)
  }
  of_value <- list(properties = list(value = bounds, range = list(items = bounds)))
  c(node, list(`if` = of_map, then = c(known, of_value)))
}

# Returns a bound or default in SI. A part may write it with a unit.
si_number <- function(value, dimension) {
  number <- units$quantity_si(value, dimension)
  if (is.na(number)) stop_part("\"", value, "\" is not of dimension ", dimension)
  number
}

# ---- drag models --------------------------------------------------------------------------------

laws <- utils::read.csv(laws_file)

drag_model_names <- function(of, forms = NULL) {
  laws$name[laws$of == of & (is.null(forms) | laws$form %in% forms)]
}

# Returns the C++ code of an enumeration and its names. before: names that the table lacks.
cpp_names <- function(name, of, forms = NULL, before = NULL) {
  cpp_enumeration(name, c(before, drag_model_names(of, forms)))
}

cpp_enumeration <- function(name, all) {
  c(
    sprintf("enum class %s { %s };", name, toString(all)),
    sprintf("constexpr std::array<const char*, %d> names_of(%s) {", length(all), name),
    sprintf("  return {%s};", toString(dQuote(all, FALSE))), "}"
  )
}

# Returns the C++ code of the tested ranges of such an enumeration. A missing bound is 0 or
# infinity.
cpp_ranges <- function(name, of, forms, before = NULL) {
  names <- c(before, drag_model_names(of, forms))
  rows <- laws[match(names, ifelse(laws$of == of, laws$name, NA)), ]
  bound <- function(field, none) {
    ifelse(is.na(rows[[field]]), none, format(rows[[field]], trim = TRUE, drop0trailing = TRUE))
  }
  values <- sprintf("      {%s, %s, %s, %s},  // %s", bound("least_solidity", "0.0"),
    bound("most_solidity", "unbounded"), bound("least_reynolds", "0.0"),
    bound("most_reynolds", "unbounded"), c(before, drag_model_names(of, forms)))
  c(
    sprintf("inline LawRange range_of(%s law) {", name),
    "  constexpr LawRange ranges[] = {", values, "  };",
    "  return ranges[static_cast<std::size_t>(law)];", "}"
  )
}

laws_text <- function() {
  lines <- c(
    "// Names and tested ranges of drag and wake models. Generated by `make schema` from",
    sprintf("// %s; do not edit.", laws_file),
    "#pragma once", "", "// clang-format off",
    "#include <array>", "#include <cstddef>", "#include <limits>", "",
    "namespace codend {", "",
    "// Tested range. Solidities and Reynolds numbers are clamped to it.",
    "struct LawRange {", "  double least_solidity, most_solidity, least_reynolds, most_reynolds;",
    "};", "constexpr double unbounded = std::numeric_limits<double>::infinity();", "",
    "// Drag models of single twines. `constant`: constant coefficients.",
    cpp_names("CylinderLawKind", "twine", "formula", "constant"), "",
    "// Screen drag models of netting.",
    cpp_names("NettingScreenLaw", "netting", "screen"),
    cpp_ranges("NettingScreenLaw", "netting", "screen"), "",
    "// All drag models of netting.", cpp_names("NettingDrag", "netting"), "",
    "// Models of the water speed behind netting.",
    cpp_names("WakeLaw", "wake", "formula", "none"),
    cpp_ranges("WakeLaw", "wake", "formula", "none"), "", "}  // namespace codend"
  )
  paste0(c(lines, ""), collapse = "\n")
}

# ---- measures -----------------------------------------------------------------------------------

measures <- utils::read.csv(measures_file, na.strings = "")

measures_text <- function() {
  lines <- c(
    "// Kinds of measures, their classes and their quantities. Generated by `make schema` from",
    sprintf("// %s; do not edit.", measures_file),
    "#pragma once", "", "// clang-format off",
    "#include <array>", "#include <cstddef>", "",
    "namespace codend {", "",
    cpp_enumeration("MeasureKind", measures$kind), "",
    "// Measures of one class have similar relative errors. Quantity: the physical dimension.",
    sprintf("enum class MeasureClass { %s };", toString(unique(measures$class))),
    sprintf("enum class MeasureQuantity { %s };", toString(unique(measures$quantity))),
    "struct MeasureNature {", "  MeasureClass of;", "  MeasureQuantity in;", "};", "",
    "inline MeasureNature nature_of(MeasureKind kind) {",
    "  constexpr MeasureNature natures[] = {",
    sprintf("      {MeasureClass::%s, MeasureQuantity::%s},  // %s", measures$class,
      measures$quantity, measures$kind),
    "  };", "  return natures[static_cast<std::size_t>(kind)];", "}", "", "}  // namespace codend"
  )
  paste0(c(lines, ""), collapse = "\n")
}

# ---- definitions ------------------------------------------------------------------------------

# Letters of all scripts, as the ranges that XML allows in names. Some validators do not support
# \\p{L}.
letter <- paste0(
  "A-Za-z\u00c0-\u00d6\u00d8-\u00f6\u00f8-\u02ff\u0370-\u037d\u037f-\u1fff\u200c\u200d",
  "\u2070-\u218f\u2c00-\u2fef\u3001-\ud7ff\uf900-\ufdcf\ufdf0-\ufffd\U10000-\Ueffff"
)
name_pattern <- sprintf("[%s][%s0-9\u00b7\u0300-\u036f_-]*", letter, letter)

# Truth values in YAML 1.1, where yes is a truth value, and in YAML 1.2, where it is a string.
truth <- list(
  type = list("boolean", "string"),
  enum = list(TRUE, FALSE, "yes", "Yes", "YES", "no", "No", "NO")
)

# Returns the pattern for the start of a string if a quantity must be positive or not negative.
# Other bounds need the unit, so they do not apply to strings.
sign_pattern <- function(node) {
  if (identical(node$exclusiveMinimum, 0)) return("^\\s*[+]?[0.]*[1-9]")
  if (identical(node$minimum, 0)) "^\\s*[^-\\s]"
}

# Returns a node with expanded abbreviations.
whole_node <- function(node) {
  if (!is.list(node)) return(node)
  if (is.null(names(node))) return(lapply(node, whole_node))
  bounds <- intersect(names(node), c("minimum", "exclusiveMinimum", "maximum", "default"))
  if (isTRUE(node$`$ref` %in% names(examples))) {
    node[bounds] <- lapply(node[bounds], si_number, dimension = node$`$ref`)
    node$pattern <- sign_pattern(node)
  }
  if (identical(node$type, "boolean")) {
    node <- c(node["description"], truth, node[setdiff(names(node), c("description", "type"))])
  }
  if (is.list(node$enum) && "$laws" %in% names(node$enum)) {
    node$enum <- c(node$enum$and, as.list(drag_model_names(node$enum$`$laws`)))
  }
  if (is.character(node$`$ref`)) node$`$ref` <- paste0("#/$defs/", node$`$ref`)
  if (is.character(node$pattern)) {
    node$pattern <- gsub("<name>", name_pattern, node$pattern, fixed = TRUE)
  }
  if ("properties" %in% names(node)) node <- whole_map(node)
  for (key in c("items", "additionalProperties", "propertyNames", "anyOf")) {
    if (is.list(node[[key]])) node[[key]] <- whole_node(node[[key]])
  }
  node
}

# Returns a map with all its fields in order, including fields of `fields.yaml` and of mix-ins.
whole_map <- function(node) {
  properties <- list()
  for (name in names(node$properties)) {
    given <- node$properties[[name]]
    if (startsWith(name, "$")) {
      mixed <- mix_in(substring(name, 2), given)
      properties[names(mixed$properties)] <- mixed$properties
      if (!isTRUE(given$optional)) {
        node$required <- c(mixed$required, setdiff(node$required, mixed$required))
        node$allOf <- c(node$allOf, mixed$allOf)
        node$dependentRequired <- c(node$dependentRequired, mixed$dependentRequired)
      }
    } else if (is.null(given)) {
      if (is.null(fields[[name]])) stop_part("no field `", name, "` in fields.yaml")
      properties[[name]] <- whole_node(fields[[name]])
    } else {
      properties[[name]] <- whole_node(given)
    }
  }
  node$properties <- NULL
  c(
    node["title"[!is.null(node$title)]], node["description"[!is.null(node$description)]],
    list(type = if (is.null(node$type)) "object" else node$type),
    node[setdiff(names(node), c("title", "description", "open", "type"))],
    list(properties = properties, additionalProperties = isTRUE(node$open))
  )
}

# Returns the map of a mix-in or of another definition, without the fields that an option omits.
mix_in <- function(name, options) {
  part <- c(mixins, parts)[[name]]
  if (is.null(part)) stop_part("no mix-in or definition `", name, "`")
  unknown <- setdiff(names(options), c("optional", "defaults", "without"))
  if (length(unknown)) stop_part("`$", name, "` has an unknown option `", unknown[1], "`")
  missing <- setdiff(unlist(options$without), names(part$properties))
  if (length(missing)) stop_part("`$", name, "` has no field `", missing[1], "`")
  part$properties <- part$properties[setdiff(names(part$properties), unlist(options$without))]
  map <- whole_node(part)
  if (isFALSE(options$defaults)) {
    map$properties <- lapply(map$properties, function(node) node[names(node) != "default"])
  }
  map
}

# Adds the field `kind`. It is required except in an assembly.
as_kind <- function(node, name) {
  kind <- list(
    description = paste(
      "The form of the plan: an assembly, or a short form that expands into an assembly."
    ),
    type = "string", const = name
  )
  if (name == default_kind) {
    kind$default <- name
  } else {
    node$required <- append(node$required, "kind", after = 2)
  }
  node$properties <- append(node$properties, list(kind = kind), after = 4)
  node
}

# Returns the definition and unit of every kind of measure that a plan may request, named by kind.
measure_meanings <- function() {
  asked <- measures[!is.na(measures$requires), ]
  unit <- ifelse(asked$unit == "%", "percent", asked$unit)
  stats::setNames(paste0(asked$definition, " In ", unit, "."), asked$kind)
}

# Returns the definition `measure`. The description of each field starts with the measure's
# definition.
with_meanings <- function(node) {
  meanings <- measure_meanings()
  kinds <- names(node$properties)
  odd <- c(setdiff(kinds, names(meanings)), setdiff(names(meanings), kinds))
  if (length(odd)) {
    stop_part("measure `", odd[1], "` must be both in assembly.yaml and in ", measures_file)
  }
  for (kind in kinds) {
    node$properties[[kind]]$description <-
      paste(meanings[[kind]], node$properties[[kind]]$description)
  }
  node
}

default_kind <- "assembly"
fields <- read_part("fields")
mixins <- read_part("mixins")
examples <- read_part("quantities")
names <- sub("[.]yaml$", "", sort(list.files(parts_folder, "[.]yaml$"), method = "radix"))
parts <- lapply(setdiff(names, c("fields", "mixins", "quantities")), read_part)
parts <- do.call(c, parts)
twice <- names(parts)[duplicated(names(parts))]
if (length(twice)) stop_part("two definitions of `", twice[1], "`")
parts$measure <- with_meanings(parts$measure)
definitions <- lapply(parts, whole_node)
kinds <- names(Filter(function(part) "$plan" %in% names(part$properties), parts))
kinds <- c(default_kind, setdiff(sort(kinds, method = "radix"), default_kind))
definitions[kinds] <- Map(as_kind, definitions[kinds], kinds)
definitions <- lapply(definitions, with_known)
known <- lapply(names(examples), known_quantity)
names(known) <- paste0("known_", names(examples))
definitions <- c(definitions, Map(quantity, names(examples), examples), known)

# ---- JSON ---------------------------------------------------------------------------------------

# Writes numbers with up to 17 digits if needed for exact values; the JSON writer stops at 15.
exact_numbers <- function(node) {
  if (is.list(node)) return(lapply(node, exact_numbers))
  if (!is.numeric(node) || as.double(format(node, digits = 15)) == node) return(node)
  shown <- vapply(16:17, function(digits) format(node, digits = digits), "")
  structure(shown[as.double(shown) == node][1], class = "json")
}

json <- function(node) {
  enc2utf8(jsonlite::toJSON(
    exact_numbers(node), auto_unbox = TRUE, digits = 15, json_verbatim = TRUE
  ))
}

# ---- repeated nodes ---------------------------------------------------------------------------

# Calls change(name, node) for every node inside `node` that a reference can replace: the fields of
# a map, and the bounds of a map with an uncertainty.
change_inside <- function(node, change) {
  if (!is.list(node)) return(node)
  for (key in names(node)) {
    if (key == "properties") {
      node$properties[] <- Map(change, names(node$properties), node$properties)
    } else if (key == "then") {
      node$then <- change("bounds", node$then)
    } else if (key %in% c("items", "additionalProperties")) {
      node[[key]] <- change_inside(node[[key]], change)
    } else if (key %in% c("anyOf", "allOf")) {
      node[[key]] <- lapply(node[[key]], change_inside, change)
    }
  }
  node
}

# Returns the definitions with each repeated node as a separate definition.
share_repeated <- function(definitions) {
  key <- function(node) paste(deparse(node, width.cutoff = 500L), collapse = "")
  keys <- character()
  collect <- function(name, node) {
    known <- key(node) %in% keys
    keys <<- c(keys, key(node))
    # Nodes inside a repeated node are not counted again.
    if (known) node else change_inside(node, collect)
  }
  lapply(definitions, change_inside, collect)
  repeated <- unique(keys[duplicated(keys)])
  names <- character(length(repeated))
  shared <- list()
  share <- function(name, node) {
    place <- match(key(node), repeated)
    # A reference to a short node saves nothing.
    if (is.na(place) || nchar(json(node)) < 60L) return(change_inside(node, share))
    if (!nzchar(names[place])) {
      taken <- c(names(definitions), names[nzchar(names)])
      names[place] <<- utils::tail(make.unique(c(taken, name), "_"), 1L)
      shared[[names[place]]] <<- change_inside(node, share)
    }
    list(`$ref` = paste0("#/$defs/", names[place]))
  }
  c(lapply(definitions, change_inside, share), shared)
}

# ---- files ------------------------------------------------------------------------------------

one_kind <- function(kind) {
  asked <- list(properties = list(kind = list(const = kind)))
  if (kind != default_kind) asked$required <- list("kind")
  list(`if` = asked, then = list(`$ref` = paste0("#/$defs/", kind)))
}

schema <- list(
  `$schema` = "https://json-schema.org/draft/2020-12/schema",
  title = "Plan of a fishing gear",
  description = paste(
    "All fields of a plan file. Generated by `make schema` from tools/schema.",
    "x-dimension is the dimension of a quantity. Its minimum, exclusiveMinimum, maximum and",
    "default are in SI."
  ),
  type = "object",
  properties = list(kind = list(enum = as.list(kinds), default = default_kind)),
  allOf = lapply(kinds, one_kind),
  `$defs` = share_repeated(definitions)
)

# Writes one line per definition. Indents would double the size. A single line would hide the
# changed definition in a commit.
json_lines <- function(nodes) {
  lines <- sprintf("%s:%s", vapply(names(nodes), json, ""), vapply(nodes, json, ""))
  paste0("{\n", paste(lines, collapse = ",\n"), "\n}")
}

schema$`$defs` <- structure(json_lines(schema$`$defs`), class = "json")
text <- paste0(json_lines(schema), "\n")

read_bytes <- function(file) if (file.exists(file)) readBin(file, "raw", file.size(file))

made <- stats::setNames(
  list(text, laws_text(), measures_text()), c(schema_file, laws_header, measures_header)
)
for (file in names(made)) {
  # An unchanged header keeps its time, so the engine is not compiled again.
  if (identical(read_bytes(file), charToRaw(made[[file]]))) next
  if (identical(commandArgs(TRUE), "--check")) {
    stop(file, " is outdated: run `make schema`.", call. = FALSE)
  }
  beside <- tempfile(tmpdir = dirname(file))
  writeBin(charToRaw(made[[file]]), beside)
  invisible(file.rename(beside, file))
}
