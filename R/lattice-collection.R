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
    collect = function() {
      points <- nodes + ties
      join <- function(kind) {
        fields <- types[[kind]]
        out <- lapply(setNames(names(fields), names(fields)), function(f) {
          all <- unlist(lapply(chunks[[kind]], `[[`, f), use.names = FALSE)
          if (is.null(all)) fields[[f]] else as.vector(all, typeof(fields[[f]]))
        })
        if (!is.null(out$node)) out$node <- point_number(out$node, nodes)
        out
      }
      found <- lapply(setNames(names(types), names(types)), join)
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
  table <- engine_fields()
  of <- table$kind == kind
  empty <- list(number = double(), whole = integer(), mark = logical(), name = character())
  setNames(empty[table$type[of]], table$name[of])
}

# Elements of a kind, without what is not the engine's to know.
engine_elements <- function(elements) elements[setdiff(names(elements), "part")]

# Of masses with volume, area on the ground and height: per point the area and the largest half
# height.
contact_points <- function(masses) {
  some <- masses$area > 0
  node <- masses$node[some]
  order <- order(node, -masses$height[some])
  first <- order[!duplicated(node[order])]
  list(
    node = node[first], area = as.vector(rowsum(masses$area[some], node)),
    clearance = masses$height[some][first] / 2
  )
}

# Volumes that leave the water over one height at one point together: list(node, buoyancy (N),
# height).
immersed_volumes <- function(masses, density) {
  some <- which(masses$volume > 0 & masses$surface > 0)
  # heights that only rounding keeps apart are one
  distinct <- unique(masses$surface[some])
  height <- signif(distinct, 12)[match(masses$surface[some], distinct)]
  key <- masses$node[some] + (max(0, masses$node) + 1) * match(height, unique(height))
  first <- some[!duplicated(key)]
  list(
    node = masses$node[first], height = masses$surface[first],
    buoyancy = gear_gravity * density *
      as.vector(rowsum(masses$volume[some], key, reorder = FALSE))
  )
}

# Numbers among all points, nodes first: tied ones are drawn as -1, -2, ...
point_number <- function(node, nodes) {
  tied <- node < 0L
  node[tied] <- nodes - node[tied]
  node
}

# Sums of x over groups 1..n, numbered by `group`.
sum_by <- function(x, group, n) {
  total <- numeric(n)
  if (length(x)) total[unique(group)] <- rowsum(x, group, reorder = FALSE)
  total
}
