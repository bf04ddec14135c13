# Short forms: kinds of plan with their own fields, which expand into an assembly.

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

#' Expand a short form
#'
#' Converts a short form, such as a midwater trawl given by its main dimensions, into points, ropes,
#' panels, seams and pieces. Use the assembly to inspect or change single parts, or write it as a
#' plan.
#'
#' @param gear A gear of class `codend_gear` ([read_gear()], [gear()]).
#' @param only `NULL`, or `"net"`: converts only the fields `wings`, `square` and `sections` of a
#'   trawl, into its field `net`, in which each piece of netting can be changed.
#' @return A gear of class `codend_gear`: an assembly, or with `only = "net"` a gear of the same
#'   kind with the field `net`. A gear that has this form is returned unchanged. With `only =
#'   "net"`, a gear without a trawl net is an error of class `codend_error_argument`.
#' @seealso [write_gear()] to write the result as a plan, [gear()] for the components, [read_net()]
#'   for nets as tables.
#' @export
#' @examples
#' assembly(read_gear("towed_cable"))
#' trawl <- assembly(read_gear("pair_trawl"), only = "net")
#' names(trawl$plan$net$upper)
#' update(trawl, net.lower.body.twine.diameter = "5 mm")
assembly <- function(gear, only = NULL) {
  check_given("gear")
  check_is_gear(gear)
  if (!is.null(only)) {
    chosen(only, "net")
    return(net_form(gear))
  }
  checked <- gear_checked(gear)
  if (is.null(checked$tree)) return(gear)
  as_gear(checked$tree)
}
