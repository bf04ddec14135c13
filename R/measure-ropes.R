#' Tensions along ropes
#'
#' @param state A state, from [settle()] or [state_at()].
#' @param ropes Which ropes: names of ropes or roles (`"warp"` for all warps), or `NULL` for all.
#' @return A data frame of class `codend_rope_tensions` with a row per bar of a rope, in order from
#'   its start: `rope`, `role`, the distance of the bar's middle from the rope's start along it
#'   `along_m`, the length of the bar `length_m`, its `tension_kN` and its middle `x_m`, `y_m`, `z_m`.
#'   An unknown rope is an error of class `codend_error_argument`.
#' @seealso [plot.codend_rope_tensions()]
#' @export
#' @examples
#' plot(tensions_along(settle("crossing_cables")))
tensions_along <- function(state, ropes = NULL) {
  check_is_state(state)
  parts <- state$lattice$parts
  every <- which(parts$kind == "rope")
  known <- unique(stats::na.omit(c(parts$name[every], parts$role[every])))
  if (!length(known)) abort_ropes("The gear has no ropes.")
  if (!is.null(ropes) && !(is.character(ropes) && length(ropes) && all(ropes %in% known))) {
    abort_ropes("{.arg ropes} is {.val {ropes}}; it must be any of {.val {known}}.",
      list(ropes = ropes, known = known))
  }
  kept <- if (is.null(ropes)) every else {
    every[parts$name[every] %in% ropes | parts$role[every] %in% ropes]
  }
  bars <- unlist(lapply(kept, function(part) bars_of_part(state, part)))
  part <- state$lattice$bar_part[bars]
  name <- parts$name[part]
  ends <- bar_ends(state, bars)
  middle <- (state$position[, ends[1L, ], drop = FALSE] +
    state$position[, ends[2L, ], drop = FALSE]) / 2
  length <- state$bar_length[bars]
  structure(
    data.frame(
      rope = name, role = parts$role[part],
      along_m = stats::ave(length, part, FUN = cumsum) - length / 2, length_m = length,
      tension_kN = state$bar_tension[bars] / 1000,
      x_m = middle[1L, ], y_m = middle[2L, ], z_m = middle[3L, ]
    ),
    class = c("codend_rope_tensions", "data.frame"), gear_name = state$gear$plan$name,
    conditions = state_conditions(state)
  )
}

abort_ropes <- function(message, values = list()) {
  cli::cli_abort(message, class = c("codend_error_argument", "codend_error"), call = NULL,
    .envir = list2env(values, parent = environment(abort_ropes)))
}
