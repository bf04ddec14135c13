# Returns the plan of a bag of panels like `net` next to each other, with a gathered end. Its
# entrance is fixed at `corners` (m, a row each) and towed. catch: the plan's fields of the catch;
# `...`: its other fields.
bag_plan <- function(net, corners, catch, ..., speed = 1.5) {
  sides <- nrow(corners)
  names <- paste0("net_", seq_len(sides))
  ring <- lapply(seq_len(sides), function(k) {
    list(position = corners[k, ], held = "moved", at = paste0(names[k], ".upper_left"))
  })
  joined <- lapply(seq_len(sides), function(k) {
    list(edges = list(paste0(names[k], ".right"), paste0(names[k %% sides + 1], ".left")))
  })
  end <- list(codline = list(edges = as.list(paste0(names, ".lower")), gathered_at = "codline"))
  list(
    codend = 1, name = "Bag", towing = list(speed = speed), ...,
    points = c(stats::setNames(ring, paste0("ring_", seq_len(sides))), list(codline = list())),
    panels = stats::setNames(rep(list(net), sides), names),
    seams = c(stats::setNames(joined, paste0("side_", seq_len(sides))), end),
    catch = c(list(panels = names), catch)
  )
}

# Corners of a circle across x with its centre at z (m), the first to starboard.
circle_of_corners <- function(sides, radius, z = 0) {
  angle <- 2 * pi * (seq_len(sides) - 1) / sides
  cbind(0, radius * cos(angle), radius * sin(angle) + z)
}
