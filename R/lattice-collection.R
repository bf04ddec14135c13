# Gathers nodes, ties and elements from the parts of a gear, and joins them once at the end.
#
# Tied points are numbered -1, -2, ... until all nodes are known.
new_collection <- function(nodes) {
  engine <- c("ties", "bars", "cells", "spheres", "lifts", "wake_sheets")
  types <- c(
    lapply(setNames(engine, engine), function(kind) {
      c(engine_fields_of(kind), list(part = integer()))
    }),
    list(sheets = list(node = integer(), twine = double(), height = double(), part = integer()),
      masses = list(node = integer(), mass = double(), volume = double(), height = double(),
      surface = double(), area = double()))
  )
  types$ties$part <- NULL
  chunks <- lapply(types, function(fields) list())
  ties <- 0L
  add <- function(kind, ...) {
    chunks[[kind]][[length(chunks[[kind]]) + 1L]] <<- list(...)
    invisible()
  }
  join <- function(kind) {
    fields <- types[[kind]]
    lapply(setNames(names(fields), names(fields)), function(f) {
      all <- unlist(lapply(chunks[[kind]], `[[`, f), use.names = FALSE)
      if (is.null(all)) fields[[f]] else as.vector(all, typeof(fields[[f]]))
    })
  }
  list(
    add = add,
    new_nodes = function(n) {
      ids <- nodes + seq_len(n)
      nodes <<- nodes + as.integer(n)
      ids
    },
    # Points on the straight lines between nodes `first` and `second`.
    tie = function(first, second, share) {
      add("ties", first = first, second = second, share = share)
      ids <- -(ties + seq_along(first))
      ties <<- ties + length(first)
      ids
    },
    # All so far, to be taken by another collection that has neither nodes nor ties of its own yet.
    hand_over = function() {
      list(found = lapply(setNames(names(types), names(types)), join), nodes = nodes, ties = ties)
    },
    take = function(given) {
      stopifnot(ties == 0L)
      for (kind in names(types)) do.call(add, c(list(kind), given$found[[kind]]))
      nodes <<- given$nodes
      ties <<- given$ties
    },
    collect = function() {
      points <- nodes + ties
      found <- lapply(setNames(names(types), names(types)), function(kind) {
        out <- join(kind)
        if (!is.null(out$node)) out$node <- point_number(out$node, nodes)
        out
      })
      c(found, list(
        nodes = nodes, mass = sum_by(found$masses$mass, found$masses$node, points),
        volume = sum_by(found$masses$volume, found$masses$node, points)
      ))
    }
  )
}

# The engine's fields of a kind of element, from its own table: a named list of empty vectors of
# their types.
engine_fields_of <- function(kind) {
  if (is.null(known_fields[[kind]])) {
    table <- engine_fields()
    of <- table$kind == kind
    empty <- list(number = double(), whole = integer(), mark = logical(), name = character())
    assign(kind, setNames(empty[table$type[of]], table$name[of]), known_fields)
  }
  known_fields[[kind]]
}

# Those that were asked for: they do not change while R runs.
known_fields <- new.env(parent = emptyenv())

# Elements of a kind, without what is not the engine's to know.
engine_elements <- function(elements) elements[setdiff(names(elements), "part")]

# Of masses with volume, area on the ground and height: per point the area and the largest half
# height.
contact_points <- function(masses) {
  some <- masses$area > 0
  node <- masses$node[some]
  last <- max(0L, node)
  area <- group_sums(masses$area[some], node, last)
  largest <- group_maxima(masses$height[some], node, last)
  touching <- which(area > 0)
  list(node = touching, area = area[touching], clearance = largest[touching] / 2)
}

# Volumes that leave the water over one height at one point together: list(node, buoyancy (N),
# height).
immersed_volumes <- function(masses, density) {
  found <- group_volumes(masses$volume, masses$surface, masses$node, max(0L, masses$node))
  list(
    node = masses$node[found$first], height = masses$surface[found$first],
    buoyancy = gear_gravity * density * found$volume
  )
}

# Numbers among all points, nodes first: tied ones are drawn as -1, -2, ...
point_number <- function(node, nodes) {
  tied <- node < 0L
  node[tied] <- nodes - node[tied]
  node
}

# Sums of x over groups 1..n, numbered by `group`.
sum_by <- function(x, group, n) group_sums(as.double(x), as.integer(group), as.integer(n))
