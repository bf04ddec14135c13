# Short forms: kinds of plan with their own fields, which expand into an assembly.

# Returns the function that expands a kind of plan. Its arguments are the checked fields in SI and
# the plan as given; it returns the tree of an assembly.
expander_of <- function(kind) get(paste0("expand_", kind), mode = "function")

# Converts the groups of a tree to their plain form. Groups or parts identical to the `last` tree
# are copied from `plain`, the plain form of `last`.
plain_groups <- function(tree, last = NULL, plain = NULL, parts = TRUE) {
  for (name in names(tree)) {
    now <- tree[[name]]
    before <- last[[name]]
    tree[name] <- list(
      if (name %in% names(last) && identical(now, before)) {
        plain[[name]]
      } else if (parts && is.list(now) && is_map(now) && is.list(before)) {
        plain_groups(now, before, plain[[name]], parts = FALSE)
      } else {
        plain_tree(now)
      }
    )
  }
  tree
}

#' Expand a short form into an assembly
#'
#' Converts a short form, such as a midwater trawl given by its main dimensions, into points, ropes,
#' panels, seams and pieces. Use the assembly to inspect or change single parts, or write it as a
#' plan.
#'
#' @param gear A gear of class `codend_gear` ([read_gear()], [gear()]).
#' @return A gear of class `codend_gear` and kind `assembly`. A gear that is already an assembly is
#'   returned unchanged.
#' @seealso [write_gear()] to write the assembly as a plan, [gear()] for the components.
#' @export
#' @examples
#' assembly(read_gear("towed_cable"))
assembly <- function(gear) {
  check_given("gear")
  check_is_gear(gear)
  checked <- gear_checked(gear)
  if (is.null(checked$tree)) return(gear)
  as_gear(checked$tree)
}
