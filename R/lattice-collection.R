# Gathers nodes, ties and elements from the parts of a gear, and joins them once at the end.
#
# Tied points are numbered -1, -2, ... until all nodes are known.
new_collection <- function(nodes) {
  kinds <- c("bars", "triangles", "spheres", "lifts", "masses", "ties", "screens")
  chunks <- setNames(rep(list(list()), length(kinds)), kinds)
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
      join <- function(kind, fields, whole = character()) {
        out <- lapply(setNames(fields, fields), function(f) {
          all <- unlist(lapply(chunks[[kind]], `[[`, f), use.names = FALSE)
          if (f %in% whole) as.integer(all) else as.double(all)
        })
        if (!is.null(out$node)) out$node <- point_number(out$node, nodes)
        out
      }
      masses <- join("masses", c("node", "mass", "volume", "height", "surface", "area"),
        "node")
      list(
        nodes = nodes,
        ties = join("ties", c("first", "second", "share"), c("first", "second")),
        bars = join("bars", c("node", "rest", "multiplicity", "height", "material", "part"),
          c("node", "material", "part")),
        triangles = join("triangles",
          c("node", "twine", "rest", "straight", "inner", "multiplicity", "height", "material",
            "part"),
          c("node", "inner", "material", "part")),
        spheres = join("spheres", c("node", "drag_area", "diameter", "smooth", "added_mass", "height", "part"),
          c("node", "smooth", "part")),
        lifts = join("lifts", c("node", "lift_area", "direction", "height", "part"),
          c("node", "direction", "part")),
        screens = join("screens", c("node", "twine_area", "part"), c("node", "part")),
        mass = sum_by(masses$mass, masses$node, points),
        volume = sum_by(masses$volume, masses$node, points), masses = masses
      )
    }
  )
}

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
  height <- signif(masses$surface[some], 12)
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
