# Dip net (short form): a bag of netting in a ring or a square frame, which hangs by bridles from a
# line and is lifted. It is built like the net of a cage.

expand_dip_net <- function(fields, plan) {
  check_dip_net(fields)
  fields$collar <- c(fields$frame, list(held = FALSE))
  plan$collar <- plan$frame
  outline <- cage_outline(fields)
  slope <- sqrt(fields$bridles$length^2 - max(outline$radius)^2)
  outline$top <- -fields$lift_line$length - slope
  net <- cage_net(fields, plan, outline)
  rig <- cage_frame(fields, plan, outline)
  out <- shared_fields(plan, fields)
  out$points <- c(
    list(
      block = list(position = list(0, 0, 0), held = "moved"),
      crowfoot = list(near = list(0, 0, -fields$lift_line$length))
    ),
    net$points, rig$points
  )
  out$panels <- net$panels
  out$seams <- c(net$seams, rig$seams)
  out$ropes <- c(
    list(lift_line = rope_between("block", "crowfoot", plan$lift_line, "lift_line")), rig$ropes
  )
  bridle <- plan$bridles[setdiff(names(plan$bridles), "number")]
  number <- fields$bridles$number
  for (k in seq_len(number)) {
    corner <- (k - 1) * fields$panels / number + 1
    out$ropes[[paste0("bridle_", k)]] <-
      rope_between("crowfoot", paste0("collar_", corner), bridle, "bridle")
  }
  out$pieces <- rig$pieces
  panels <- names(net$panels)
  out$measures <- list(
    net_volume = list(volume = panels),
    volume_left = list(volume_fraction = list(panels = panels, of = outline$volume)),
    net_drag = list(drag = panels), net_lift = list(lift = panels),
    # Any corner of a tilted frame may be the lowest.
    frame_depth = list(depth = as.list(paste0("collar_", seq_len(fields$panels)))),
    bottom_depth = list(depth = if (is.null(fields[["bottom"]])) "foot_1" else "bottom_centre"),
    lift_tension = list(tension = "lift_line.start"),
    lift_angle = list(angle = list(lift_line.start = "declination"))
  )
  out
}

check_dip_net <- function(fields) {
  if (fields$shape == "square" && fields$panels %% 4 != 0) {
    abort_field("panels", fields$panels, "a multiple of 4 in a square frame")
  }
  if (fields$panels %% fields$bridles$number != 0) {
    abort_field("bridles.number", fields$bridles$number,
      paste("a divisor of", fields$panels, "(the corners of the panels)"))
  }
  if (fields$frame$bending_stiffness == 0) {
    abort_field("frame.bending_stiffness", 0, "greater than 0")
  }
  radius <- fields$diameter / if (fields$shape == "square") sqrt(2) else 2
  if (fields$bridles$length <= radius) {
    abort_field("bridles.length", format_si(fields$bridles$length, "length"),
      paste("more than the distance from the centre to a corner,", format_si(radius, "length")))
  }
}
