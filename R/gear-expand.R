# Short forms: kinds of plan with their own fields, which expand into an assembly.
# Each takes the checked fields in SI and the plan as given, and returns the tree of an assembly.
gear_expanders <- list(
  beam_trawl = function(fields, plan) expand_beam_trawl(fields, plan),
  bottom_trawl = function(fields, plan) expand_bottom_trawl(fields, plan),
  cage = function(fields, plan) expand_cage(fields, plan),
  dip_net = function(fields, plan) expand_dip_net(fields, plan),
  gillnet = function(fields, plan) expand_gillnet(fields, plan),
  longline = function(fields, plan) expand_longline(fields, plan),
  midwater_trawl = function(fields, plan) expand_midwater_trawl(fields, plan),
  pair_trawl = function(fields, plan) expand_pair_trawl(fields, plan),
  purse_seine = function(fields, plan) expand_purse_seine(fields, plan),
  stow_net = function(fields, plan) expand_stow_net(fields, plan)
)

# The tree of the assembly that a checked plan stands for: the plan itself when it is one.
expand_plan <- function(fields, plan) {
  if (fields$kind == "assembly") return(plan)
  tree <- gear_expanders[[fields$kind]](fields, plan)
  for (name in names(tree)) {
    tree[[name]] <- remembered(paste0("plain ", name), list(tree[[name]]), function() {
      plain_tree(tree[[name]])
    })
  }
  tree
}

# The checked fields, in SI, of the assembly that a plan stands for.
assembly_fields <- function(plan) {
  fields <- check_plan(plan)
  if (fields$kind == "assembly") return(fields)
  check_plan(expand_plan(fields, plan))
}

#' Expand a short form
#'
#' A gear of another kind than `assembly`, such as a midwater trawl by its main dimensions, stands
#' for an assembly of points, ropes, panels, seams and pieces. This is that assembly, to look at, to
#' change or to write as a plan of its own.
#'
#' @param gear A gear ([read_gear()], [gear()]).
#' @return A gear of kind `assembly`; the same gear when it already is one.
#' @export
#' @examples
#' assembly(read_gear("towed_cable"))
assembly <- function(gear) {
  check_is_gear(gear)
  fields <- check_plan(gear$plan)
  if (fields$kind == "assembly") return(gear)
  as_gear(expand_plan(fields, gear$plan))
}
