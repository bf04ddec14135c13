# How large a lattice may be. What a plan asks for is estimated before anything is allocated.

most_nodes <- 2e6
# Of cells; bars take half.
bytes_per_node <- 1e4

# Stops where a gear's lattice would have more nodes than `most`; nodes: about how many it should
# have where its plan leaves that open.
check_lattice_size <- function(si, nodes, netting = NULL, most = most_nodes) {
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
        "This plan needs %s nodes, which would take about %s of memory; at most %s are allowed.",
        "Most of them are in `%s`."
      ),
      format(total, digits = 2), memory_text(total * bytes_per_node), format(most), worst
    ),
    worst, total
  )
}

# At least as many nodes as the plan's own divisions may give, whatever seams hand on from panel to
# panel. Quick; exact counts are not.
divided_at_most <- function(si) {
  ropes <- sum(unlist(lapply(si$ropes, `[[`, "segments")))
  across <- max(0, unlist(lapply(si$panels, function(panel) c(panel$columns, panel$rows))))
  panels <- vapply(si$panels, function(panel) {
    sides <- c(panel$upper, panel$lower, panel$deep)
    max(1, across)^2 * max(sides) / min(sides[sides > 0]) * 4 * first_of(panel$bar_segments, 1)
  }, 0)
  ropes + sum(panels)
}

memory_text <- function(bytes) {
  power <- min(floor(log(bytes, 1000)), 5)
  paste(format(bytes / 1000^power, digits = 2), c("kB", "MB", "GB", "TB", "PB")[power])
}
