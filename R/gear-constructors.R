# Constructors of plan parts. Each returns the same tree as the corresponding map in a plan file.

component <- function(group, fields) {
  structure(Filter(Negate(is.null), fields), class = "codend_component", group = group)
}

part_fields <- function(part) {
  file <- system.file("schema", "plan.schema.json", package = "codend", mustWork = TRUE)
  definitions <- jsonlite::fromJSON(file, simplifyVector = FALSE)[["$defs"]]
  names(definitions[[part]]$properties)
}

# Returns the constructor of a part: a function with one argument per field (default NULL).
constructor <- function(part, group) {
  fields <- part_fields(part)
  made <- function() component(group, as.list(environment()))
  formals(made) <- stats::setNames(rep(list(NULL), length(fields)), fields)
  made
}

# Parts with a constructor, and the plan field that lists each by name.
constructed_parts <- c(
  point = "points", rope = "ropes", panel = "panels", seam = "seams", piece = "pieces",
  otter_board = "otter_boards", kite = "kites"
)

# Returns roxygen `@param` lines of the constructors, from the descriptions in the schema.
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

# Returns the description of a schema field and its allowed values or list fields.
field_help <- function(node) {
  choices <- if (is.null(node$choices)) list(node) else node$choices
  taken <- unlist(lapply(choices, function(choice) {
    if (length(choice$enum)) return(paste0("`\"", unlist(choice$enum), "\"`"))
    if (length(choice$properties)) {
      paste0("`list(", paste(names(choice$properties), collapse = ", "), ")`")
    }
  }))
  paste(c(schema_description(node$description), if (length(taken)) {
    all_words <- all(lengths(lapply(choices, `[[`, "enum")) > 0L)
    lead <- if (all_words) "One of " else if (length(choices) == 1L) "As " else "It may be "
    paste0(lead, paste(taken, collapse = ", "), ".")
  }), collapse = " ")
}

#' Make a gear in R
#'
#' Builds the same tree as a plan file ([read_gear()]) with function calls. Quantities are strings
#' with a unit (`"4.5 knot"`, `"32 mm"`) or bare numbers in SI. Fields have the names and meanings
#' of plan fields.
#'
#' Some fields are described on other pages:
#'
#' - `coefficients`, `netting_drag`, `orientation`, `straight_bar`, `opening_stiffness`: [netting];
#' - `shielding`: [settle()];
#' - `polar`: [board_polar()].
#'
#' @param name Character: name of the gear.
#' @param ... Named components made by `gear_point()`, `rope()`, `netting_panel()`, `piece()`,
#'   `otter_board()`, `kite()`, `seam()` and [measure()], and further plan fields as lists or
#'   strings (`water`, `towing`, `netting`, `catch`, `materials`, `notes` and others).
#' @param kind Character: kind of plan. Default `"assembly"`, or a short form.
#' @param gears For a rig: a named list of whole gears ([read_gear()], `gear()`), such as the two
#'   trawls of a twin trawl. They keep their fields and uncertainties. Their names and the names of
#'   their parts and measures get the name of the gear as a prefix, such as `port_headline_height`.
#'   An item may also be a list of fields, such as `list(like = "port")` for a gear that is like
#'   another. Water, seabed, towing and drag models that are not given are those of the first gear.
#' @param joined For a rig: a list by gear of its joined points, as a named list or vector of
#'   locations by point, such as `list(port = c(board_port = "door"))`. A joined point is no longer
#'   held by itself.
#' @eval constructor_params()
#' @return `gear()` returns a checked gear of class `codend_gear`. The other functions return a
#'   component of class `codend_component` for `gear()`. An invalid plan is an error of class
#'   `codend_error_plan`.
#' @seealso [read_gear()] and [new_plan()] for plan files, [measure()] for measures, [settle()] for
#'   the shape of a gear, [assembly()] for the parts of a rig; `vignette("bottom-trawl", "codend")`.
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
#' trawl <- read_gear("beam_trawl")
#' gear("Two beam trawls", gears = list(port = trawl,
#'   starboard = list(like = "port", moved = c(0, 20, 0))))
gear <- function(name, ..., kind = "assembly", gears = NULL, joined = NULL) {
  check_given("name")
  given <- list(...)
  if (!is.null(gears)) given <- c(joined_gears(gears, joined, names(given)), given)
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

# Returns the field `gears` of a rig, and those fields of its first gear that are not `given`.
joined_gears <- function(gears, joined, given) {
  if (!is.list(gears) || is.null(names(gears)) || inherits(gears, "codend_gear")) {
    abort_argument("{.arg gears} must be a named list of gears, not {.cls {class(gears)}}.")
  }
  if (!is.null(joined) && !is.list(joined)) {
    abort_argument("{.arg joined} must be a list by gear, not {.cls {class(joined)}}.")
  }
  whole <- list()
  for (part in names(gears)) {
    if (!inherits(gears[[part]], "codend_gear")) next
    plan <- join_uncertain(gears[[part]]$plan)
    if (!length(whole)) whole <- plan[intersect(names(plan), whole_plan_fields)]
    gears[[part]] <- plan[setdiff(names(plan), whole_plan_fields)]
  }
  unknown <- setdiff(names(joined), names(gears))
  if (length(unknown)) {
    abort_argument("{.arg joined} has {.val {unknown[1]}}; it must be one of the gears
      {.val {names(gears)}}.")
  }
  for (part in names(joined)) gears[[part]]$joined <- as.list(joined[[part]])
  whole[c("codend", "name", "kind", "notes", "sources", "uncertain", "tow", "shooting", "laid",
    given)] <- NULL
  c(whole, list(gears = gears))
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
#' Requests one measure of a gear that [gear()] makes. The field `measures` of a plan has the same
#' fields.
#'
#' @return A component of class `codend_component` for [gear()], which checks it.
#' @eval measure_questions()
#' @seealso [measures()] for the definition and value of each kind; [gear()] for the points, ropes
#'   and panels that a measure refers to.
#' @export
#' @examples
#' measure(depth = "bottom")
#' measure(angle = list(warp_port.start = "declination"))
measure <- constructor("measure", "measures")

# Returns roxygen `@param` lines for the kinds of measures, from the schema.
measure_questions <- function() {
  kinds <- kind_node("assembly")$properties$measures$additionalProperties$properties
  descriptions <- vapply(kinds, function(kind) schema_description(kind$description), "")
  paste("@param", names(kinds), descriptions)
}
