bed_colours <- c(ground = "#EDE6D8", line = "#8A7653")

# Returns list(normal, height (m), middle), or NULL without a sea bed. `middle` is x and y (m) of
# the tenth of the gear nearest to the bed: a slope is drawn there.
drawn_bed <- function(state) {
  ground <- state$si$ground
  if (is.null(ground)) return(NULL)
  above <- height_above_ground(ground, state$position)
  near <- above <= stats::quantile(above, 0.1, names = FALSE)
  list(
    normal = ground$normal, height = ground$height,
    middle = rowMeans(state$position[1:2, near, drop = FALSE])
  )
}

bed_heights <- function(bed, places) {
  (bed$height - colSums(bed$normal[1:2] * places)) / bed$normal[3]
}
