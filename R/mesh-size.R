# Limits the size of a mesh. The size is estimated before any memory is allocated.

most_nodes <- 2e6
# Memory for cells; bars need half.
bytes_per_node <- 1e4

# Throws an error if a gear's mesh would exceed `most` nodes. `nodes`: target number of nodes, if
# the plan does not define the mesh.
check_mesh_size <- function(si, nodes, netting = NULL, most = most_nodes) {
  if (nodes > most) {
    abort_argument("{.arg nodes} is {.val {nodes}}; it must be at most {.val {most}}.")
  }
  if (divided_at_most(si) <= most) return(invisible())
  count <- engine_node_counts(gear_numbers(si, netting), nodes)$nodes
  total <- sum(count)
  if (total <= most) return(invisible())
  fields <- c(prefixed("panels.", names(si$panels)), prefixed("ropes.", names(si$ropes)))
  worst <- fields[which.max(count)]
  abort_plan(
    sprintf(
      paste(
        "This plan needs %s nodes (about %s of memory), but at most %s are allowed.",
        "Most nodes are in `%s`; reduce its size or segments."
      ),
      format(total, digits = 2),
      format(structure(total * bytes_per_node, class = "object_size"), "auto", "SI", digits = 2L),
      format(most), worst
    ),
    worst, total
  )
}

# Returns an upper bound of the number of nodes that the plan defines, including divisions
# transferred through seams. It is fast, unlike an exact count.
divided_at_most <- function(si) {
  ropes <- sum(unlist(lapply(si$ropes, `[[`, "segments")))
  across <- max(0, unlist(lapply(si$panels, function(panel) c(panel$columns, panel$rows))))
  panels <- vapply(si$panels, function(panel) {
    sides <- c(panel$upper, panel$lower, panel$deep)
    max(1, across)^2 * max(sides) / min(sides[sides > 0]) * 4 * first_of(panel$bar_segments, 1)
  }, 0)
  ropes + sum(panels)
}
