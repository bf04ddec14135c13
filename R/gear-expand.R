# Short forms: kinds of plan with their own fields, which expand into an assembly.

# The function that expands a kind of plan: it takes the checked fields in SI and the plan as given,
# and returns the tree of an assembly.
expander_of <- function(kind) get(paste0("expand_", kind), mode = "function")

# The groups of a tree in their plain form, taken from the `plain` form of a `last` tree where they,
# or parts of them, are the same.
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

#' Expand a short form
#'
#' A gear of another kind than `assembly`, such as a midwater trawl by its main dimensions, is
#' for an assembly of points, ropes, panels, seams and pieces. This is that assembly, to look at, to
#' change or to write as a plan of its own.
#'
#' @param gear A gear ([read_gear()], [gear()]).
#' @return A gear of kind `assembly`; the same gear when it already is one.
#' @export
#' @examples
#' assembly(read_gear("towed_cable"))
assembly <- function(gear) {
  check_given("gear")
  check_is_gear(gear)
  checked <- gear_checked(gear)
  if (checked$fields$kind == "assembly") return(gear)
  as_gear(checked$tree)
}
