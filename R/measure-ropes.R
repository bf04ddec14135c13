#' Tensions along ropes
#'
#' @param state A state, from [settle()] or [state_at()].
#' @param ropes Which ropes: names of ropes or roles (`"warp"` for all warps), or `NULL` for all.
#' @return A data frame of class `codend_rope_tensions` with a row per bar of a rope, in order from
#'   its start: `rope`, `role`, `line`, `along_m` (distance of the bar's middle from the line's
#'   start along it), `length_m` of the bar, its `tension_kN` and its middle `x_m`, `y_m`, `z_m`. A
#'   line is a rope, or ropes of one role that follow each other, such as the stretches of a main
#'   line between its branch lines. An unknown rope is an error of class `codend_error_argument`.
#' @seealso [codend_charts]
#' @export
#' @examples
#' head(tensions_along(settle("crossing_cables")))
tensions_along <- function(state, ropes = NULL) {
  check_given("state")
  check_is_state(state)
  parts <- state$lattice$parts
  every <- which(parts$kind == "rope")
  known <- unique(stats::na.omit(c(parts$name[every], parts$role[every])))
  if (!length(known)) abort_argument("The gear has no ropes.")
  ropes <- chosen_some(ropes, known)
  kept <- every[parts$name[every] %in% ropes | parts$role[every] %in% ropes]
  line <- rope_lines_end_to_end(state$lattice, kept)
  kept <- kept[order(match(line, line))]
  line <- line[order(match(line, line))]
  bars <- unlist(lapply(kept, function(part) bars_of_part(state, part)))
  part <- state$lattice$bar_part[bars]
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

# Which line each of some ropes (rows of the table of parts) belongs to, as numbers. A rope goes on
# another of its role where it alone starts and that alone ends.
rope_lines_end_to_end <- function(lattice, ropes) {
  name <- lattice$parts$name[ropes]
  role <- lattice$parts$role[ropes]
  node <- function(at) {
    vapply(name, function(rope) at(lattice$ropes[[rope]]$node), 0L, USE.NAMES = FALSE)
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
      # a ring begins where the plan begins it
      min(path)
    }
  }
  line
}

# Names of lines: of their rope, or of their first and last.
line_names <- function(rope, line) {
  ends <- split(rope, line)
  words <- vapply(ends, function(ropes) {
    paste(unique(ropes[c(1L, length(ropes))]), collapse = " to ")
  }, "")
  unname(words[match(line, names(ends))])
}
