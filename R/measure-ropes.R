# Returns the table "rope_tensions" of a state; `ropes`: names of ropes or roles, or NULL for all.
rope_tension_table <- function(state, ropes = NULL) {
  parts <- state$mesh$parts
  every <- which(parts$kind == "rope")
  known <- unique(stats::na.omit(c(parts$name[every], parts$role[every])))
  if (!length(known)) abort_argument("The gear has no ropes.")
  ropes <- chosen_some(ropes, known, "parts")
  kept <- every[parts$name[every] %in% ropes | parts$role[every] %in% ropes]
  line <- rope_lines_end_to_end(state$mesh, kept)
  kept <- kept[order(match(line, line))]
  line <- line[order(match(line, line))]
  bars <- unlist(lapply(kept, function(part) bars_of_part(state, part)))
  part <- state$mesh$bar_part[bars]
  line <- line[match(part, kept)]
  name <- parts$name[part]
  ends <- bar_ends(state, bars)
  middle <- (state$position[, ends[1L, ], drop = FALSE] +
    state$position[, ends[2L, ], drop = FALSE]) / 2
  length <- state$bar_length[bars]
  structure(
    data.frame(
      rope = name, role = parts$role[part], line = line_names(name, line),
      along_m = stats::ave(length, line, FUN = cumsum) - length / 2, length_m = length,
      tension_kN = in_unit(state$bar_tension[bars], "kN"),
      x_m = middle[1L, ], y_m = middle[2L, ], z_m = middle[3L, ]
    ),
    class = c("codend_rope_tensions", "data.frame"), gear_name = state$gear$plan$name,
    conditions = state_conditions(state)
  )
}

# Returns the line number of each rope (row of the parts table). A rope continues another rope of
# the same role unless a third rope with this role starts or ends at their common point.
rope_lines_end_to_end <- function(mesh, ropes) {
  name <- mesh$parts$name[ropes]
  role <- mesh$parts$role[ropes]
  node <- function(at) {
    vapply(name, function(rope) at(mesh$ropes[[rope]]$node), 0L, USE.NAMES = FALSE)
  }
  start <- paste(role, node(function(nodes) nodes[1L]))
  end <- paste(role, node(function(nodes) nodes[length(nodes)]))
  alone <- function(x) !x %in% x[duplicated(x)]
  before <- match(start, end)
  before[is.na(role) | !alone(start) | (!alone(end))[before] | before == seq_along(ropes)] <- NA
  line <- rep(NA_integer_, length(ropes))
  for (k in seq_along(ropes)) {
    path <- k
    while (is.na(line[path[1L]]) && !before[path[1L]] %in% c(NA, k)) {
      path <- c(before[path[1L]], path)
    }
    known <- line[path[1L]]
    line[path] <- if (!is.na(known)) {
      known
    } else if (is.na(before[path[1L]])) {
      path[1L]
    } else {
      # a closed ring starts at its first rope in the plan
      min(path)
    }
  }
  line
}

# Returns line names: the rope, or "first to last".
line_names <- function(rope, line) {
  ends <- split(rope, line)
  words <- vapply(ends, function(ropes) {
    paste(unique(ropes[c(1L, length(ropes))]), collapse = " to ")
  }, "")
  unname(words[match(line, names(ends))])
}
