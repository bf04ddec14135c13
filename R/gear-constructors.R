# A gear without a file: each constructor gives the same piece of tree as its map in a plan file.

# fields: by name; those not given are NULL.
component <- function(group, fields) {
  structure(Filter(Negate(is.null), fields), class = "codend_component", group = group)
}

# The names of a part's fields in the schema, in order.
part_fields <- function(part) {
  file <- system.file("schema", "plan.schema.json", package = "codend", mustWork = TRUE)
  definitions <- jsonlite::fromJSON(file, simplifyVector = FALSE)[["$defs"]]
  names(definitions[[part]]$properties)
}

# The constructor of a part: its arguments are the part's fields, each NULL where not given. Made
# when the package is installed.
constructor <- function(part, group) {
  fields <- part_fields(part)
  made <- function() component(group, as.list(environment()))
  formals(made) <- stats::setNames(rep(list(NULL), length(fields)), fields)
  made
}

# The parts that constructors make, and the field of a plan that has them by name.
constructed_parts <- c(
  point = "points", rope = "ropes", panel = "panels", seam = "seams", piece = "pieces",
  otter_board = "otter_boards", kite = "kites"
)

# The help of the constructors' arguments: what the schema says of each part's field of that name.
constructor_params <- function() {
  nodes <- lapply(constructed_parts, function(group) {
    path_node(list(), paste0(group, ".any"))$properties
  })
  vapply(unique(unlist(lapply(nodes, names))), function(field) {
    text <- lapply(Filter(function(of) field %in% names(of), nodes), function(of) {
      field_help(of[[field]])
    })
    parts <- split(gsub("_", " ", names(text)), factor(unlist(text), unique(unlist(text))))
    whose <- vapply(parts, paste, "", collapse = " or ")
    words <- paste0(capital(whose), ": ", names(parts))
    paste("@param", field, paste(words, collapse = " "))
  }, "", USE.NAMES = FALSE)
}

# A field in words: its description, and the words or the fields of a list that it takes.
field_help <- function(node) {
  choices <- if (is.null(node$choices)) list(node) else node$choices
  taken <- unlist(lapply(choices, function(choice) {
    if (length(choice$enum)) return(paste0("`\"", unlist(choice$enum), "\"`"))
    if (length(choice$properties)) {
      paste0("`list(", paste(names(choice$properties), collapse = ", "), ")`")
    }
  }))
  paste(c(node$description, if (length(taken)) {
    all_words <- all(lengths(lapply(choices, `[[`, "enum")) > 0L)
    lead <- if (all_words) "One of " else if (length(choices) == 1L) "As " else "It may be "
    paste0(lead, paste(taken, collapse = ", "), ".")
  }), collapse = " ")
}

#' Make a gear in R
#'
#' The same tree as a plan file ([read_gear()]), made by calls. Quantities are text with a unit
#' (`"4.5 knot"`, `"32 mm"`) or bare numbers in SI. Fields and their meaning are those of the plan;
#' `coefficients`, `netting_drag`, `orientation`, `straight_bar` and `opening_stiffness` are
#' explained in [netting], `shielding` in [settle()] and a `polar` in [board_polar()].
#'
#' @param name Name of the gear.
#' @param ... Components made by `gear_point()`, `rope()`, `netting_panel()`, `piece()`,
#'   `otter_board()`,
#'   `kite()`, `seam()` and `measure()`, each under its name; and further fields of the plan
#'   (`water`, `towing`, `netting`, `coefficients`, `netting_drag`, `slack_twine`, `catch`
#'   ([catch]), `shooting`, `laid`, `tow`, `materials`, `notes`, `sources`) as lists or text.
#' @param kind Kind of plan: `"assembly"`, or a short form.
#' @eval constructor_params()
#' @return `gear()` returns a checked gear of class `codend_gear`; the others a component for it. A
#'   wrong plan is an error of class `codend_error_plan`.
#' @export
#' @examples
#' gear(
#'   "A weight on a line",
#'   top = gear_point(position = c(0, 0, 0), held = "moved"), bottom = gear_point(),
#'   line = rope("top", "bottom", length = "20 m", diameter = "8 mm", material = "polyamide"),
#'   weight = piece(at = "bottom", mass = "5 kg", material = "steel_wire"),
#'   depth = measure(depth = "bottom"),
#'   towing = list(speed = "2 knot")
#' )
gear <- function(name, ..., kind = "assembly") {
  check_given("name")
  given <- list(...)
  if (length(given) && (is.null(names(given)) || any(!nzchar(names(given))))) {
    abort_argument("Every argument of {.fn gear} after the first must be named.")
  }
  tree <- list(codend = 1, name = name, kind = kind)
  for (i in seq_along(given)) {
    group <- attr(given[[i]], "group")
    key <- names(given)[i]
    if (is.null(group)) {
      tree[[key]] <- given[[i]]
      next
    }
    if (key %in% names(tree[[group]])) {
      abort_field(join(group, key), NULL, "given once", "is given twice")
    }
    tree[[group]] <- c(tree[[group]], given[i])
  }
  as_gear(tree)
}

#' @rdname gear
#' @export
gear_point <- constructor("point", "points")

#' @rdname gear
#' @export
rope <- constructor("rope", "ropes")

#' @rdname gear
#' @export
netting_panel <- constructor("panel", "panels")

#' @rdname gear
#' @export
seam <- constructor("seam", "seams")

#' @rdname gear
#' @export
piece <- constructor("piece", "pieces")

#' @rdname gear
#' @export
otter_board <- constructor("otter_board", "otter_boards")

#' @rdname gear
#' @export
kite <- constructor("kite", "kites")

#' Define a measure of a gear
#'
#' One of the measures that a gear made by [gear()] reports; a plan's `measures` have the same
#' fields. [measures()] defines each kind and gives their values.
#'
#' @return A component for [gear()], which checks it.
#' @eval measure_questions()
#' @seealso [gear()] for points, ropes and panels, whose places and names it needs.
#' @export
#' @examples
#' measure(depth = "bottom")
#' measure(angle = list(warp_port.start = "declination"))
measure <- constructor("measure", "measures")

# What each kind of measure asks for, as arguments of help, from the schema.
measure_questions <- function() {
  kinds <- kind_node("assembly")$properties$measures$additionalProperties$properties
  paste("@param", names(kinds), vapply(kinds, function(kind) kind$description, ""))
}
