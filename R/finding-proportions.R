# Typical proportions by kind of gear (inst/extdata/bands.csv).

# Returns a measure of a net (`si`) in a state.
measure_of <- function(si, state, name) {
  measure <- si$measures[[name]]
  if (!is.null(measure)) unname(measure_values(state, list(measure)))
}

headline_of <- function(si) {
  line <- ropes_of_role(si, "headline")
  if (length(line) == 1L) si$ropes[[line]]$length
}

# Returns mouth height divided by headline length. A closed mouth has a different warning.
height_over_headline <- function(si, state) {
  whole <- headline_of(si)
  height <- measure_of(si, state, "net_mouth_height")
  if (!is.null(whole) && !is.null(height) && height > 0) height / whole
}

define_number("towing speed", function(si, state) in_unit(si$towing$speed, "knot"))

define_number("footrope over headline", function(si, state) {
  lower <- si$ropes[ropes_of_role(si, c("footrope", "footrope_extension"))]
  whole <- headline_of(si)
  if (length(lower) && !is.null(whole)) sum(vapply(lower, `[[`, 0, "length")) / whole
})

define_number("warp over depth", function(si, state) {
  warp <- ropes_of_role(si, "warp")
  depth <- if (!is.null(si$ground)) height_above_ground(si$ground, cbind(numeric(3)))
  # In shallow water a minimum warp length applies instead.
  if (length(warp) && isTRUE(depth > 15)) si$ropes[[warp[1L]]]$length / depth
})

define_number("ground gear weight", function(si, state) {
  name <- ropes_of_role(si, "ground_gear")
  if (!length(name)) return(NULL)
  gear <- loaded_parts(si)$ropes[[name[1L]]]
  (gear$mass - si$water$density * gear$volume) / si$ropes[[name[1L]]]$length
})

define_number("board weight over area", function(si, state) {
  boards <- Filter(function(piece) identical(piece$role, "otter_board"), si$pieces)
  if (length(boards)) boards[[1L]]$mass / boards[[1L]]$area
})

define_number("headline height over headline", height_over_headline)

define_number("mouth height over headline", height_over_headline)

define_number("spread over headline", function(si, state) {
  line <- ropes_of_role(si, "headline")
  if (!has_towing(state) || length(line) != 1L) return(NULL)
  node <- state$mesh$ropes[[line]]$node
  ends <- state$position[1:2, c(node[1L], node[length(node)])]
  sqrt(sum((ends[, 2L] - ends[, 1L])^2)) / si$ropes[[line]]$length
})

define_number("bridle angle", function(si, state) {
  angle <- in_unit(first_of(measure_of(si, state, "bridle_angle"), NA_real_), "deg")
  setNames(angle, if (is.null(state$gear$plan$sweeps)) "bridles" else "sweeps.length")
})

define_number("ground friction over drag", function(si, state) {
  if (!is.null(state$si$ground)) 100 * measure_value(state, "ground_friction")
})

define_number("boards' drag over drag", function(si, state) {
  totals <- drag_totals(drag_table(state))
  drag <- setNames(totals$drag_kN, totals$group)
  if ("otter boards" %in% names(drag)) 100 * drag[["otter boards"]] / drag[["total"]]
})

define_number("hammers' weight over drag", function(si, state) {
  of_hammers <- state$mesh$parts$role %in% "hammer"
  drag <- measure_value(state, "total_drag")
  if (any(of_hammers) && drag > 0) 100 * sum(part_weight(state)[of_hammers]) / drag
})

define_number("net height over hung height", function(si, state) {
  hung <- gillnet_hung_height(si, si$panels[["wall"]])
  height <- measure_of(si, state, "net_height")
  if (!is.null(height) && is.finite(hung) && hung > 0) height / hung
})

# Returns the height (m) of a wall hung on its float line, from its stretched height and hanging
# ratio.
gillnet_hung_height <- function(si, wall) {
  if (is.null(wall)) return(NA_real_)
  across <- wall$upper * wall$mesh_size
  ratio <- min(1, si$ropes$float_line$length / across)
  wall$deep * wall$mesh_size * sqrt(1 - ratio^2)
}

define_number("volume left", function(si, state) measure_of(si, state, "volume_left"))
