# Height above the bed (m), and fraction of the headline's height, above which a footrope no longer
# catches species on the bed.
greatest_footrope_height <- 0.5
greatest_footrope_share <- 0.25

define_finding("net off the bed", function(gear, state) {
  lapply(nets_on_bed(state$si), net_off_bed, state)
})

define_finding("net leaves the bed", function(gear, trajectory) {
  lapply(nets_on_bed(trajectory$si), net_leaves_bed, trajectory)
})

# Returns the numbers of each net that lies on the sea bed.
nets_on_bed <- function(si) {
  if (is.null(si$ground)) return(list())
  Filter(function(net) !(length(net$nets) && net$nets[[1L]]$kind == "midwater_trawl"),
    si_by_net(si))
}

# Warps lift a net off the sea bed below this ratio of their length to the depth, the least usual
# ratio in bands.csv.
lifting_scope <- 1.5

# Returns the finding of a net (`si`) that leaves the sea bed in a tow, or NULL.
net_leaves_bed <- function(si, trajectory) {
  time <- trajectory$time
  mesh <- trajectory$mesh
  ground <- trajectory$si$ground
  found <- lapply(seq_along(time), function(k) {
    footrope_height(si, mesh, ground, as.matrix(trajectory$position[, , k]))
  })
  if (!length(found[[1L]])) return(NULL)
  height <- vapply(found, `[[`, 0, "height")
  above <- height > vapply(found, `[[`, 0, "allowed")
  off <- above & cumsum(!above) > 0 & !hauls_up(si, trajectory)
  if (!any(off)) return(NULL)
  worst <- which.max(ifelse(off, height, -Inf))
  if (height[worst] <= found[[worst]]$allowed + height_error(state_at(trajectory, time[worst]))) {
    return(NULL)
  }
  label <- paste(figures(height[worst]), "m")
  finding("net leaves the bed", paste("rope", found[[worst]]$rope), height[worst], label,
    begin = figures(time[off][1L]), time = figures(time[worst]), height = label)
}

# Returns TRUE for each time of a tow at which a warp is too short for a net on the sea bed.
hauls_up <- function(si, trajectory) {
  conditions <- trajectory$conditions
  warps <- ropes_of_role(si, "warp")
  depth <- height_above_ground(trajectory$si$ground, rbind(conditions$x, conditions$y, 0))
  out <- vapply(warps, function(name) {
    first_of(conditions[[name]], rep(si$ropes[[name]]$length, nrow(conditions)))
  }, conditions$time)
  rowSums(matrix(out < lifting_scope * depth, nrow(conditions))) > 0
}

# Returns the finding of one net (`si`) off the sea bed, or NULL.
net_off_bed <- function(si, state) {
  found <- footrope_height(si, state$mesh, si$ground, state$position)
  if (is.null(found) || found$height <= found$allowed + height_error(state)) return(NULL)
  label <- paste(figures(found$height), "m")
  finding("net off the bed", paste("rope", found$rope), found$height, label, height = label,
    line = figures(found$line), case = if (is.finite(found$line)) "headline" else "")
}

# Returns list(rope, height, line, allowed) [m] of the lowest footrope of one net (`si`), or NULL.
# Half of the footrope's underside is above `height`. `line`: height of the headline, -Inf without
# one; `allowed`: height above which the footrope is off the sea bed.
footrope_height <- function(si, mesh, ground, position) {
  height_of <- function(roles) {
    vapply(ropes_of_role(si, roles), function(name) {
      height <- height_above_ground(ground, position[, mesh$ropes[[name]]$node])
      stats::median(height) - si$ropes[[name]]$diameter / 2
    }, 0)
  }
  low <- height_of(c("ground_gear", "footrope"))
  if (!length(low)) return(NULL)
  line <- max(height_of("headline"), -Inf)
  allowed <- greatest_footrope_height
  if (line > 0) allowed <- min(allowed, greatest_footrope_share * line)
  list(rope = names(low)[which.min(low)], height = min(low), line = line, allowed = allowed)
}

# Returns the largest reported error (m) of the heights of a gear, 0 without heights.
height_error <- function(state) {
  all <- measures(state)
  heights <- attr(all, "kind") %in% c("height", "clearance")
  max(0, attr(all, "error")[heights], na.rm = TRUE)
}

define_finding("opening", function(gear, state) {
  if (!is.null(state$time)) return(list())
  opening <- Filter(function(one) one$kind %in% c("height", "area", "volume"), state$si$measures)
  opening <- opening[grepl("height|opening|area|volume", names(opening))]
  Map(function(name, value) {
    if (!is.finite(value) || value > 0) return(NULL)
    unit <- c(height = "m", area = "m2", volume = "m3")[[opening[[name]]$kind]]
    label <- paste(figures(value), unit)
    finding("opening", gsub("_", " ", name), value, label)
  }, names(opening), measure_values(state, opening))
})

# A rope between points is idle below this fraction of the largest rope tension and of the gear's
# drag.
idle_share <- 0.001

define_finding("idle rope", function(gear, state) {
  if (!has_towing(state)) return(list())
  table <- tension_table(state)
  drag <- part_force_table(state)
  counts <- abs(drag$drag_kN) + abs(drag$lift_kN) + abs(drag$weight_in_water_kN)
  table$counts <- counts[match(table$part, drag$part)]
  free <- names(Filter(function(rope) is.null(rope$along) && !rope$strut, state$si$ropes))
  idle <- table$kind == "rope" & table$part %in% free &
    table$max_kN < idle_share * max(table$max_kN) &
    table$counts < idle_share * in_unit(abs(measure_value(state, "total_drag")), "kN")
  lapply(which(idle), function(k) {
    label <- paste(figures(1000 * table$max_kN[k]), "N")
    finding("idle rope", paste("rope", table$part[k]), 1000 * table$max_kN[k], label, force = label)
  })
})

# Minimum tension of a bridle as a fraction of an equal part.
least_bridle_part <- 0.2

define_finding("bridles", function(gear, state) {
  si <- state$si
  names <- unlist(lapply(unname(si_by_net(si)), function(net) {
    if (length(net$nets) && net$nets[[1L]]$kind == "beam_trawl") return(NULL)
    ropes_of_role(net, c("bridle", "hand_rope"))
  }))
  names <- as.character(unique(names))
  start <- vapply(names, function(name) bridle_start(si, si$ropes[[name]]$from), "")
  lapply(split(names, start), function(together) {
    pull <- vapply(together, function(name) {
      mean(state$bar_tension[rope_bars(state$mesh, name)])
    }, 0)
    share <- pull / sum(pull)
    odd <- which.min(share)
    if (sum(pull) <= 0 || share[odd] >= least_bridle_part / length(share)) return(NULL)
    label <- paste(figures(100 * share[[odd]]), "%")
    finding("bridles", paste("rope", together[odd]), 100 * share[[odd]], label, share = label)
  })
})

define_finding("weight on netting", function(gear, state) {
  si <- state$si
  ropes <- which(state$mesh$parts$kind == "rope")
  bars <- which(state$mesh$bar_part %in% ropes)
  cells <- state$mesh$model$cells$node
  hung <- Filter(function(name) {
    at <- si$pieces[[name]]$at
    if (!identical(si$pieces[[name]]$role, "weight") || is.null(at)) return(FALSE)
    node <- state$mesh$places[[at]]
    # At nodes of more cells, many rows of knots are gathered and carry the weight together.
    sum(cells == node) %in% 1:2 && !node %in% bar_ends(state, bars)
  }, names(si$pieces))
  if (!length(hung)) return(list())
  mass <- si$pieces[[hung[1]]]$mass
  label <- format_si(mass, "mass")
  list(finding("weight on netting", paste("piece", hung[1]), mass, label, n = length(hung),
    mass = label))
})

# Returns the start of a bridle; for the backstrops of a free board it is the board.
bridle_start <- function(si, from) {
  on <- vapply(si$otter_boards, function(board) from %in% board$points, NA)
  if (any(on)) names(si$otter_boards)[which(on)[1]] else from
}

ropes_of_role <- function(si, roles) {
  names(Filter(function(rope) rope$role %in% roles, si$ropes))
}

# Maximum fraction of a towed gear's netting that is loose in both directions. A single twine family
# may be loose in well set netting, for example along a rope that carries the load.
greatest_loose_share <- 0.3

define_finding("slack netting", function(gear, state) {
  if (!has_towing(state) || !length(state$si$panels)) return(list())
  loose <- loose_netting(state)
  if (!is.finite(loose) || loose <= greatest_loose_share) return(list())
  label <- paste(figures(100 * loose), "%")
  slack <- slack_table(state)
  most <- slack$part[which.max(slack$slack_percent * slack$twine_m)]
  list(finding("slack netting", "netting", 100 * loose, label, share = label, panel = most))
})

loose_netting <- function(state) {
  model <- state$mesh$model
  cells <- model$frame$cells
  twine <- 2 * cells$bars * cells$rest
  loose <- state$u_tension == 0 & state$v_tension == 0
  bars <- state$mesh$parts$kind[state$mesh$bar_part] == "netting"
  long <- (model$bars$multiplicity * model$bars$rest)[bars]
  (sum(twine[loose]) + sum(long[state$bar_tension[bars] == 0])) / (sum(twine) + sum(long))
}

define_finding("boards", function(gear, state) board_findings(board_table(state), state))

# Returns the findings of boards (rows of board_table()); NULL for a board without one.
board_findings <- function(boards, state) {
  lapply(seq_len(nrow(boards)), function(k) {
    board <- boards[k, ]
    polar <- state$si$otter_boards[[board$board]]$polar
    tested <- range(polar$attack[polar$published])
    label <- paste(figures(board$attack_deg), "deg")
    beyond <- board$attack_deg < tested[1] - 2 || board$attack_deg > tested[2] + 2
    flying <- board$condition == "flying"
    if (flying && !beyond) return(NULL)
    finding("boards", gsub("_", " ", board$board), board$attack_deg, label, attack = label,
      condition = board$condition, heel = figures(board$heel_deg), least = figures(tested[1]),
      most = figures(tested[2]), case = if (flying) "" else "not flying")
  })
}

define_finding("flutter", function(gear, state) {
  modes <- board_mode_table(state)
  modes <- modes[modes$condition %in% "flutters" & modes$growth_per_s > slowest_reported, ]
  modes <- modes[!duplicated(modes$board), ]
  lapply(seq_len(nrow(modes)), function(k) {
    mode <- modes[k, ]
    finding("flutter", gsub("_", " ", mode$board), mode$growth_per_s,
      paste(figures(mode$growth_per_s), "/s"), period = figures(mode$period_s),
      time = figures(1 / mode$growth_per_s))
  })
})

# Warns of boards that do not fly and, if `swings` is TRUE, of boards that flutter.
warn_of_boards <- function(state, swings) {
  if (!length(state$si$otter_boards)) return(invisible())
  if (swings) warn_of_check(finding_checks$flutter, state, "board_flutter")
  boards <- board_table(state)
  for (condition in setdiff(boards$condition, "flying")) {
    check <- finding_checks$boards
    own <- boards[boards$condition == condition, ]
    check$test <- function(gear, state) board_findings(own, state)
    warn_of_check(check, state, paste0("board_", gsub("[^a-z]", "_", condition)))
  }
}
