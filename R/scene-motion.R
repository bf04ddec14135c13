# A trajectory as an animated scene in the vessel's axes.

# Maximum number of saved times in a scene, and of their bytes. A page with its scripts then stays
# below 2 MB. Longer trajectories are thinned evenly.
scene_times <- 400L
scene_bytes <- 1.1e6

motion_scene <- function(trajectory, colour = "tension", bytes = scene_bytes) {
  kept <- length(trajectory$time)
  shown <- evenly(kept, scene_times)
  shapes <- lapply(trajectory$time[shown], function(t) {
    scene_shape(state_at(trajectory, t))
  })
  moved <- scene_moved(shapes)
  while ((size <- scene_size(moved)) > bytes && length(shown) > 2L) {
    some <- evenly(length(shown), max(2L, floor(0.95 * length(shown) * bytes / size)))
    shown <- shown[some]
    shapes <- shapes[some]
    moved <- scene_moved(shapes)
  }
  state <- shapes[[1L]]$fixed$state
  about <- scene_about(state, shapes)
  about$conditions <- motion_text(trajectory)
  # The flow changes, so it is in the label next to the slider.
  about$flow <- I(c(0, 0))
  ends <- vapply(range(trajectory$time), time_text, "", last = max(trajectory$time))
  c(
    list(
      times = I(trajectory$time[shown]), labels = I(motion_labels(trajectory)[shown]),
      colour = colour, ends = I(ends), graph_times = I(trajectory$time),
      graph = motion_graph(trajectory)
    ),
    about, scene_fixed(shapes[[1L]]), moved
  )
}

scene_size <- function(scene) sum(nchar(unlist(scene), "bytes"))

motion_graph <- function(trajectory) {
  table <- as.data.frame(trajectory, what = "measures")
  of_measures <- lapply(unique(table$measure), function(name) {
    of <- table[table$measure == name, ]
    list(words = paste0(label_of(name, of$unit[1L]), " (", of$unit[1L], ")"),
      values = I(signif(of$value, 5)))
  })
  energy <- trajectory$conditions$energy_imbalance
  put <- trajectory$conditions$energy_put_through
  if (is.null(energy) || !any(put > 0)) return(of_measures)
  c(of_measures, list(list(
    words = "energy imbalance (% of work)",
    values = I(signif(ifelse(put > 0, 100 * energy / pmax(put, 1e-300), 0), 5))
  )))
}

motion_text <- function(trajectory) {
  last <- max(trajectory$time)
  paste(if (is_towed(trajectory)) "towed for" else "after", time_text(last, last))
}

is_towed <- function(trajectory) any(trajectory$conditions$speed > 0)

motion_labels <- function(trajectory) {
  time <- vapply(trajectory$time, time_text, "", last = max(trajectory$time))
  if (!is_towed(trajectory)) return(paste("after", time))
  conditions <- trajectory$conditions
  sprintf("%s, %.1f knot, course %.0f\u00b0", time, in_unit(conditions$speed, "knot"),
    in_unit(conditions$course, "deg"))
}

# Formats a time (s) in the unit that suits the last time.
time_text <- function(time, last) {
  if (last <= 180) return(sprintf("%.1f s", time))
  sprintf("%.0f:%02.0f min", floor(round(time) / 60), round(time) %% 60)
}
