# The gear: a plan as given, with the result of its check (`checked`, from `check_whole()`).

# Returns a gear from a tree of lists, in plain form and checked completely.
# `like`: a checked gear; identical parts are not checked again.
# `source`: text of the plan file, whose remarks are kept when writing.
# `changed`: paths (as steps) that may not be in plain form; NULL: all.
as_gear <- function(tree, file = NULL, like = NULL, source = like$source, changed = NULL) {
  tree <- with_included_plans(tree, file)
  plan <- if (is.null(changed)) plain_tree(tree) else plain_again(tree, changed)
  if (!is.null(like)) plan <- without_gone(plan, like$plan)
  maps <- is.null(changed) ||
    any(vapply(changed, function(steps) is.list(at_path(tree, steps)), NA))
  if (maps) plan <- split_uncertain(plan)
  checked <- check_whole(plan, like$checked)
  if (maps) uncertain_numbers(plan)
  structure(
    list(plan = plan, file = file, source = source, checked = checked), class = "codend_gear"
  )
}

# Returns the result of the check. If a user changed the plan by hand, the plan is checked again.
gear_checked <- function(gear) {
  if (identical(gear$checked$plan, gear$plan)) return(gear$checked)
  check_whole(gear$plan, gear$checked)
}

# Returns the checked fields, in SI, of the gear's assembly.
gear_fields <- function(gear) gear_checked(gear)$assembly

gear_si <- function(gear) gear_checked(gear)$si

#' Read the plan of a gear
#'
#' Reads a plan file (YAML) and checks it completely before anything is computed. The check covers
#' every field, unit and bound, and the connections of the parts. The file cannot contain code. Its
#' field `net` may be the name of a table in the same folder, such as `net: my_net.csv`
#' ([read_net()]).
#'
#' @param plan Character: path of a YAML file, or name of a plan that ships with the package
#'   ([gears()]).
#' @return A gear of class `codend_gear`: a list of `plan` (the plan as given, a tree of named
#'   lists), `file` (its path) and the result of the check. An invalid plan is an error of class
#'   `codend_error_plan`; its `path` and `value` refer to the first wrong field.
#' @seealso [gear()] to make a gear without a file, [new_plan()] to start a plan, [write_gear()] to
#'   write one.
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
        "There is no plan file \"", plan, "\" and no shipped plan with that name",
        if (is.na(near)) "." else paste0("; did you mean `", near, "`?"),
        " Shipped: ", word_list(names(shipped)), "."
      ),
      NULL, plan
    )
  }
  gear_of_bytes(plan_bytes(file), file, file, tables = TRUE)
}

# Returns the gear of a plan's bytes (raw YAML). `name`: name in messages; `file`: path or NULL;
# `tables`: TRUE if the plan may name a table in the folder of the file.
gear_of_bytes <- function(bytes, name, file = NULL, tables = FALSE) {
  text <- plan_text_of(bytes, name)
  with_places({
    tree <- plan_of_bytes(bytes, name)
    if (tables) tree <- with_net_file(tree, file)
    as_gear(tree, file = file, source = text)
  }, text)
}

#' List the plans that ship with the package
#'
#' Returns the shipped plans. Pass a `name` to [read_gear()].
#'
#' @return A data frame with one row per plan: `name` (for [read_gear()]), `title` and `kind`
#'   (character).
#' @seealso [read_gear()] to read a plan, [new_plan()] to start your own.
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
  speed <- quantity_text(fields$towing$speed, "speed", x$plan$towing$speed)
  cat("  towing speed ", speed, "\n", sep = "")
  derived <- gear_checked(x)$derived
  if (length(derived)) {
    cat("  computed from cutting rates and take-up: ",
      paste(names(derived), vapply(derived, displayed_count, ""), collapse = ", "), "\n", sep = "")
  }
  invisible(x)
}

#' Change fields of a gear
#'
#' Returns a copy of the gear with new values of one or several fields. The changed plan is checked
#' completely.
#'
#' @param object A gear of class `codend_gear`.
#' @param ... Fields by their path in the plan, such as `towing.speed = "5 knot"` or
#'   `ropes.warp.length = 300`. `NULL` removes a field. Use numbers in SI, strings with a unit, or
#'   objects of the package units. An angle without a unit is at most 2 pi (rad). Address a list
#'   item by its number (`water.current.1.speed`). `tow` may be a schedule ([tow_schedule()]).
#' @return A gear of class `codend_gear`. If the plan gives a field in another unit than SI, a
#'   message of class `codend_message_units` reports once how a number is read. An unknown path is
#'   an error of class `codend_error_plan`. A value of an unsupported class, such as a date, is an
#'   error of class `codend_error_argument`.
#' @seealso [vary()] to solve a gear for a range of values, [settle()] for the new shape.
#' @importFrom stats update
#' @export
#' @examples
#' update(read_gear("towed_cable"), towing.speed = "5 knot", ropes.cable.length = "800 m")
update.codend_gear <- function(object, ...) {
  fields <- list(...)
  if (length(fields) && (is.null(names(fields)) || any(!nzchar(names(fields))))) {
    abort_argument(
      "Every change needs its path as a name, such as {.code towing.speed = \"5 knot\"}."
    )
  }
  twice <- names(fields)[duplicated(names(fields))]
  if (length(twice)) abort_argument("{.arg {twice[1]}} is given twice.")
  for (path in names(fields)) {
    fields[path] <- list(planned_value(fields[[path]], object$plan[[path]]))
  }
  gear <- with_fields(object, fields)
  note_bare_numbers(object$plan, fields)
  gear
}

# Returns a value for a plan in place of the `present` value.
planned_value <- function(value, present) UseMethod("planned_value")

#' @export
planned_value.default <- function(value, present) value

#' @export
update.codend_state <- function(object, ...) {
  abort_argument(c(
    "A state cannot be changed: it is the equilibrium of its gear.",
    i = "Change the gear and settle it: {.code settle(update(state$gear, ...), from = state)}."
  ))
}

#' @export
update.codend_trajectory <- function(object, ...) {
  abort_argument(c(
    "A trajectory cannot be changed.",
    i = "Change the gear and tow it: {.code tow(update(trajectory$gear, ...))}."
  ))
}

# Returns the gear with the values of `fields`, a list by path.
with_fields <- function(gear, fields) {
  plan <- gear$plan
  for (path in names(fields)) plan <- set_plan_field(plan, path, fields[[path]])
  as_gear(plan, file = gear$file, like = gear, changed = changed_steps(gear, names(fields)))
}

# Returns the steps of paths in a gear's plan; NULL if a user changed the plan by hand.
changed_steps <- function(gear, paths) {
  if (identical(gear$checked$plan, gear$plan)) lapply(paths, path_steps)
}
