# Stiffness of ropes against bending, between every two of their bars.

# list(node = 3 per bend, couple = bending stiffness over the length that bends there, N m,
# length = that length, m), as Bends.
bend_elements <- function(si, lattice) {
  stiff <- Filter(function(name) si$ropes[[name]]$bending_stiffness > 0, names(si$ropes))
  bends <- lapply(stiff, function(name) {
    rope <- si$ropes[[name]]
    run <- lattice$ropes[[name]]
    node <- run$node
    rest <- diff(run$at) * rope$length
    closed <- node[1L] == node[length(node)]
    if (closed) {
      node <- c(node, node[2L])
      rest <- c(rest, rest[1L])
    }
    at <- seq_len(max(0L, length(rest) - 1L))
    list(
      node = as.vector(rbind(node[at], node[at + 1L], node[at + 2L])),
      couple = 2 * rope$bending_stiffness / (rest[at] + rest[at + 1L]),
      length = (rest[at] + rest[at + 1L]) / 2
    )
  })
  list(
    node = as.integer(unlist(lapply(bends, `[[`, "node"))),
    couple = as.double(unlist(lapply(bends, `[[`, "couple"))),
    length = as.double(unlist(lapply(bends, `[[`, "length")))
  )
}
