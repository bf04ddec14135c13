# A trajectory as a scene that plays, in the vessel's axes.

# Kept times that a scene shows at most, and bytes that they may take, so that a page with its
# scripts stays below 2 MB; of more, every so many is shown.
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
  about$conditions <- motion_words(trajectory)
  # The flow changes: the label beside the slider tells it.
  about$flow <- I(c(0, 0))
  ends <- vapply(range(trajectory$time), time_words, "", last = max(trajectory$time))
  c(
    list(
      times = I(trajectory$time[shown]), labels = I(motion_labels(trajectory)[shown]),
      colour = colour, ends = I(ends), graph_times = I(trajectory$time),
      graph = motion_graph(trajectory)
    ),
    about, scene_fixed(shapes[[1L]]), moved
  )
}

# Some of 1..n, both ends among them.
evenly <- function(n, most) unique(round(seq(1, n, length.out = min(n, most))))

# Bytes of the text in a scene.
scene_size <- function(scene) sum(nchar(unlist(scene), "bytes"))

# Every measure at every kept time, and the energy that is made or lost.
motion_graph <- function(trajectory) {
  table <- as.data.frame(trajectory, what = "measures")
  of_measures <- lapply(unique(table$measure), function(name) {
    of <- table[table$measure == name, ]
    list(words = paste0(words_of(name, of$unit[1L]), " (", of$unit[1L], ")"),
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

motion_words <- function(trajectory) {
  last <- max(trajectory$time)
  paste(if (is_towed(trajectory)) "towed for" else "after", time_words(last, last))
}

is_towed <- function(trajectory) any(trajectory$conditions$speed > 0)

# What the page says beside its slider, at every time.
motion_labels <- function(trajectory) {
  time <- vapply(trajectory$time, time_words, "", last = max(trajectory$time))
  if (!is_towed(trajectory)) return(paste("after", time))
  conditions <- trajectory$conditions
  sprintf("%s, %.1f knot, course %.0f\u00b0", time, in_unit(conditions$speed, "knot"),
    in_unit(conditions$course, "deg"))
}

# A time (s) in the unit that suits the last of its times.
time_words <- function(time, last) {
  if (last <= 180) return(sprintf("%.1f s", time))
  sprintf("%.0f:%02.0f min", floor(round(time) / 60), round(time) %% 60)
}
