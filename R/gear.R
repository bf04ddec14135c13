# The gear: a plan as given, with what its check made of it (`checked`, of check_whole()).

# A gear from a tree of lists: put into its plain form and checked in full.
# like: a gear, parts of which are checked already where this one is the same.
# source: the text that it was read from, whose remarks a file of it keeps.
# changed: paths, as their steps, of what in the tree is not known to be in plain form; NULL: all.
as_gear <- function(tree, file = NULL, like = NULL, source = like$source, changed = NULL) {
  plan <- if (is.null(changed)) plain_tree(tree) else plain_again(tree, changed)
  if (!is.null(like)) plan <- without_gone(plan, like$plan)
  maps <- is.null(changed) ||
    any(vapply(changed, function(steps) is.list(at_path(tree, steps)), NA))
  if (maps) plan <- split_uncertain(plan)
  checked <- check_whole(plan, like$checked)
  if (maps) uncertain_shares(plan)
  structure(
    list(plan = plan, file = file, source = source, checked = checked), class = "codend_gear"
  )
}

# What the check made of a gear's plan; checked again where somebody changed the plan by hand.
gear_checked <- function(gear) {
  if (identical(gear$checked$plan, gear$plan)) return(gear$checked)
  check_whole(gear$plan, gear$checked)
}

# The checked fields, in SI, of the assembly that a gear is or stands for.
gear_fields <- function(gear) gear_checked(gear)$assembly

# The gear as SI numbers, of si_of().
gear_si <- function(gear) gear_checked(gear)$si

#' Read the plan of a gear
#'
#' Reads a plan file (YAML) and checks it in full before anything is computed: every field, unit and
#' bound, and that the parts hang together. Nothing in the file is evaluated as code.
#'
#' @param plan Path of a YAML file, or the name of a plan that ships with the package ([gears()]).
#' @return A gear: an object of class `codend_gear` that holds the plan as given (`plan`, a tree of
#'   named lists), its path (`file`) and what the check made of it. A wrong plan is an error of
#'   class `codend_error_plan`, with the path and the value of the first wrong field as `path` and
#'   `value`.
#' @seealso [gear()] for the same without a file, [write_gear()].
#' @export
#' @examples
#' read_gear("towed_cable")
read_gear <- function(plan) {
  check_given("plan")
  if (!is_text(plan)) {
    abort_argument(
      "{.arg plan} must be one path or the name of a shipped plan, not {.cls {class(plan)}}."
    )
  }
  shipped <- shipped_plans()
  file <- if (plan %in% names(shipped)) shipped[[plan]] else plan
  if (!file.exists(file)) {
    written <- paste0(plan, c(".yaml", ".yml"))
    near <- c(written[file.exists(written)], nearest(plan, names(shipped)), NA)[1L]
    abort_plan(
      paste0(
        "There is no plan file \"", plan, "\" and no shipped plan of that name",
        if (is.na(near)) "." else paste0("; did you mean `", near, "`?"),
        " Shipped: ", word_list(names(shipped)), "."
      ),
      NULL, plan
    )
  }
  gear_of_bytes(plan_bytes(file), file, file)
}

# The gear of a plan's bytes (raw, of its YAML). name: what messages call them; file: their path or
# NULL.
gear_of_bytes <- function(bytes, name, file = NULL) {
  tree <- plan_of_bytes(bytes, name)
  text <- plan_text_of(bytes, name)
  with_places(as_gear(tree, file = file, source = text), text)
}

# Paths of the plans that ship with the package, named by file name.
shipped_plans <- function() {
  files <- list.files(
    system.file("gears", package = "codend"), pattern = "[.]yaml$", full.names = TRUE
  )
  stats::setNames(files, sub("[.]yaml$", "", basename(files)))
}

#' Plans that ship with the package
#'
#' @return A data frame with one row per plan: `name` (for [read_gear()]), `title` and `kind`.
#' @export
#' @examples
#' gears()
gears <- function() {
  files <- shipped_plans()
  plans <- lapply(files, read_plan)
  data.frame(
    name = as.character(names(files)),
    title = vapply(plans, `[[`, "", "name", USE.NAMES = FALSE),
    kind = vapply(plans, function(plan) first_of(plan$kind, "assembly"), "", USE.NAMES = FALSE)
  )
}

#' @export
print.codend_gear <- function(x, ...) {
  fields <- gear_fields(x)
  groups <- c("panels", "seams", "ropes", "pieces", "points", "measures")
  cat("Gear \"", x$plan$name, "\" (", gear_checked(x)$fields$kind, ")\n", sep = "")
  cat("  ", paste(groups, lengths(fields[groups]), collapse = ", "), "\n", sep = "")
  cat("  towing speed ", format_si(fields$towing$speed, "speed"), "\n", sep = "")
  derived <- gear_checked(x)$derived
  if (length(derived)) {
    cat("  found from cutting rates and take-up: ",
      paste(names(derived), vapply(derived, shown_count, ""), collapse = ", "), "\n", sep = "")
  }
  invisible(x)
}

#' Change fields of a gear
#'
#' @param object A gear.
#' @param ... Fields by their path in the plan, such as `towing.speed = "5 knot"` or
#'   `ropes.warp.length = 300`; `NULL` takes a field out. An item of a list goes by its number
#'   (`water.current.1.speed`). Quantities are numbers in SI, texts with a unit, or objects of the
#'   package units, which are converted to SI.
#' @return The gear with these fields, checked in full again. An unknown path is an error of class
#'   `codend_error_plan`; a value of another class, such as a date, is one of class
#'   `codend_error_argument`.
#' @importFrom stats update
#' @export
#' @examples
#' update(read_gear("towed_cable"), towing.speed = "5 knot", ropes.cable.length = "800 m")
update.codend_gear <- function(object, ...) {
  fields <- list(...)
  if (length(fields) && (is.null(names(fields)) || any(!nzchar(names(fields))))) {
    abort_argument(
      "Every change must be named by its path, such as {.code towing.speed = \"5 knot\"}."
    )
  }
  twice <- names(fields)[duplicated(names(fields))]
  if (length(twice)) abort_argument("{.arg {twice[1]}} is given twice.")
  plan <- object$plan
  for (path in names(fields)) plan <- set_plan_field(plan, path, fields[[path]])
  as_gear(plan, file = object$file, like = object, changed = changed_steps(object, names(fields)))
}

#' @export
update.codend_state <- function(object, ...) {
  abort_argument(c(
    "A state cannot be changed: it is the balance of its gear.",
    i = "Change the gear and settle that: {.code settle(update(state$gear, ...), from = state)}."
  ))
}

#' @export
update.codend_trajectory <- function(object, ...) {
  abort_argument(c(
    "A tow that is done cannot be changed.",
    i = "Change the gear and tow that: {.code tow(update(trajectory$gear, ...))}."
  ))
}

# The gear with one field changed (NULL: taken out), checked in full again.
set_field <- function(gear, path, value) {
  as_gear(set_plan_field(gear$plan, path, value), file = gear$file, like = gear,
    changed = changed_steps(gear, path))
}

# The steps of paths in a gear's plan; NULL where somebody changed the plan by hand.
changed_steps <- function(gear, paths) {
  if (identical(gear$checked$plan, gear$plan)) lapply(paths, path_steps)
}
