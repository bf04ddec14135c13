# Short forms: kinds of plan with their own fields, which expand into an assembly.
# Each takes the checked fields in SI and the plan as given, and returns the tree of an assembly.
gear_expanders <- list(
  beam_trawl = function(fields, plan) expand_beam_trawl(fields, plan),
  bottom_trawl = function(fields, plan) expand_bottom_trawl(fields, plan),
  cage = function(fields, plan) expand_cage(fields, plan),
  demersal_seine = function(fields, plan) expand_demersal_seine(fields, plan),
  dip_net = function(fields, plan) expand_dip_net(fields, plan),
  gillnet = function(fields, plan) expand_gillnet(fields, plan),
  longline = function(fields, plan) expand_longline(fields, plan),
  midwater_trawl = function(fields, plan) expand_midwater_trawl(fields, plan),
  pair_trawl = function(fields, plan) expand_pair_trawl(fields, plan),
  purse_seine = function(fields, plan) expand_purse_seine(fields, plan),
  stow_net = function(fields, plan) expand_stow_net(fields, plan)
)

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
