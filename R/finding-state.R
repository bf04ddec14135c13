# Height above the bed (m), and fraction of the headline's height, above which a footrope no longer
# catches species on the bed.
greatest_footrope_height <- 0.5
greatest_footrope_share <- 0.25

define_finding("net off the bed", "state",
  "Half of the footrope or ground gear hangs more than 0.5 m, or a quarter of the headline height,
  plus the reported error of heights above the sea bed. This check omits midwater trawls.",
  function(gear, state) lapply(nets_on_bed(state$si), net_off_bed, state),
  rank = 1L
)

define_finding("net leaves the bed", "tow",
  "A footrope or ground gear leaves the sea bed during a tow, by the heights of the check 'net off
  the bed'. This check omits the time before it first lies on the bed, and hauling: warps shorter
  than 1.5 times the depth.",
  function(gear, trajectory) lapply(nets_on_bed(trajectory$si), net_leaves_bed, trajectory),
  rank = 1L
)

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
  finding(paste("rope", found[[worst]]$rope), height[worst], label,
    template("it leaves the sea bed at {begin} s; at {time} s one half is {height} or more above
      it.", begin = figures(time[off][1L]), time = figures(time[worst]), height = label),
    bed_advice(),
    field = "warps.length")
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
  finding(paste("rope", found$rope), found$height, label,
    if (is.finite(found$line)) {
      template("one half is {height} or more above the sea bed; the headline is at {line} m.",
        height = label, line = figures(found$line))
    } else {
      template("one half is {height} or more above the sea bed.", height = label)
    },
    bed_advice(),
    field = "warps.length")
}

bed_advice <- function() {
  template("Pay out more warp, tow more slowly, or add weight to the footrope or the boards.")
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

define_finding("opening", "state",
  "A height, an opening, an area or a volume is zero or negative: the net is closed or upside down.
  This check omits moments of a tow.",
  function(gear, state) {
    if (!is.null(state$time)) return(list())
    opening <- Filter(function(one) one$kind %in% c("height", "area", "volume"), state$si$measures)
    opening <- opening[grepl("height|opening|area|volume", names(opening))]
    Map(function(name, value) {
      if (!is.finite(value) || value > 0) return(NULL)
      unit <- c(height = "m", area = "m2", volume = "m3")[[opening[[name]]$kind]]
      label <- paste(figures(value), unit)
      finding(gsub("_", " ", name), value, label,
        template("it is {value} but must be positive.", value = label),
        "Add floats above or weight below, or change the lengths of the bridles.",
        field = "floats")
    }, names(opening), measure_values(state, opening))
  },
  rank = 1L
)

# A rope between points is idle below this fraction of the largest rope tension and of the gear's
# drag.
idle_share <- 0.001

define_finding("idle rope", "state",
  "The tension, weight and drag of a free rope of a towed gear are less than 0.1 % of the gear's.
  Its fields have no effect on the results.",
  function(gear, state) {
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
      finding(paste("rope", table$part[k]), 1000 * table$max_kN[k], label,
        template("it carries at most {force}; its fields have no effect.", force = label),
        "Shorten this rope, or remove it from the plan.", field = "length")
    })
  }
)

# Minimum tension of a bridle as a fraction of an equal part.
least_bridle_part <- 0.2

define_finding("bridles", "state",
  "One of several bridles or hand ropes from the same point carries less than 20 % of an equal part
  of their tension (10 % of the total for two bridles). This check omits beam trawls: their middle
  bridle only keeps the beam straight.",
  function(gear, state) {
    si <- state$si
    names <- unlist(lapply(unname(si_by_net(si)), function(net) {
      if (length(net$nets) && net$nets[[1L]]$kind == "beam_trawl") return(NULL)
      ropes_of_role(net, c("bridle", "hand_rope"))
    }))
    names <- as.character(unique(names))
    start <- vapply(names, function(name) bridle_start(si, si$ropes[[name]]$from), "")
    unlist(lapply(split(names, start), function(together) {
      if (length(together) < 2L) return(list())
      pull <- vapply(together, function(name) {
        mean(state$bar_tension[rope_bars(state$mesh, name)])
      }, 0)
      if (sum(pull) <= 0) return(list())
      share <- pull / sum(pull)
      odd <- which.min(share)
      if (share[odd] >= least_bridle_part / length(share)) return(list())
      percent <- 100 * share[[odd]]
      label <- paste(figures(percent), "%")
      list(finding(paste("rope", together[odd]), percent, label,
        template("it carries {share} of the total tension of all bridles at this point.",
          share = label),
        "Shorten this bridle, or lengthen the others.", field = "length"))
    }), recursive = FALSE, use.names = FALSE)
  }
)

define_finding("weight on netting", "state",
  "A weight hangs on an edge of netting without a rope. In the model the adjacent meshes carry the
  weight, so that the netting gathers around it. On a real net, a rope or a row of knots carries the
  weight.",
  function(gear, state) {
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
    list(finding(paste("piece", hung[1]), mass, label,
      template("{n} such weights of {mass} each hang on netting without a rope.", n = length(hung),
        mass = label),
      "Add a rope at these positions (in a cage: side_ropes, bottom_rope)."))
  }
)

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

define_finding("slack netting", "state",
  "More than 30 % of the netting of a towed gear is slack: neither of its two families of twines
  carries tension (with `netting: bars`: more than 30 % of the twine).",
  function(gear, state) {
    if (!has_towing(state) || !length(state$si$panels)) return(list())
    loose <- loose_netting(state)
    if (!is.finite(loose) || loose <= greatest_loose_share) return(list())
    label <- paste(figures(100 * loose), "%")
    slack <- slack_table(state)
    most <- slack$part[which.max(slack$slack_percent * slack$twine_m)]
    list(finding("netting", 100 * loose, label,
      template("{share} of the netting is slack, mostly in panel {panel}.", share = label,
        panel = most),
      "Check the speed, the spread, and the ropes along the netting; they may be too short."))
  }
)

loose_netting <- function(state) {
  model <- state$mesh$model
  cells <- model$frame$cells
  twine <- 2 * cells$bars * cells$rest
  loose <- state$u_tension == 0 & state$v_tension == 0
  bars <- state$mesh$parts$kind[state$mesh$bar_part] == "netting"
  long <- (model$bars$multiplicity * model$bars$rest)[bars]
  (sum(twine[loose]) + sum(long[state$bar_tension[bars] == 0])) / (sum(twine) + sum(long))
}

define_finding("boards", "state",
  "A free otter board or kite is stalled, back-winded or fallen over, or its angle of attack is more
  than 2 deg outside the tested range of its polar.",
  function(gear, state) board_findings(board_table(state), state)
)

# Returns the findings of boards (rows of board_table()); NULL for a board without one.
board_findings <- function(boards, state) {
  lapply(seq_len(nrow(boards)), function(k) {
    board <- boards[k, ]
    polar <- state$si$otter_boards[[board$board]]$polar
    tested <- range(polar$attack[polar$published])
    label <- paste(figures(board$attack_deg), "deg")
    beyond <- board$attack_deg < tested[1] - 2 || board$attack_deg > tested[2] + 2
    if (board$condition == "flying" && !beyond) return(NULL)
    message <- if (board$condition != "flying") {
      template("it is {condition}, at an angle of attack of {attack} and a heel of {heel} deg.",
        condition = board$condition, attack = label, heel = figures(board$heel_deg))
    } else {
      template("its angle of attack is {attack}; its polar was tested from {least} to {most} deg.",
        attack = label, least = figures(tested[1]), most = figures(tested[2]))
    }
    finding(gsub("_", " ", board$board), board$attack_deg, label, message,
      template("Move the attachment points of warp and backstrops, or use a polar for this angle."))
  })
}

define_finding("flutter", "state",
  "A free otter board or kite is dynamically unstable: after a small disturbance, its oscillations
  grow.",
  function(gear, state) {
    modes <- fluttering_modes(state)
    modes <- modes[!duplicated(modes$board), ]
    lapply(seq_len(nrow(modes)), function(k) {
      mode <- modes[k, ]
      finding(gsub("_", " ", mode$board), mode$growth_per_s,
        paste(figures(mode$growth_per_s), "/s"),
        template("it oscillates with a period of {period} s; the amplitude grows by a factor of e in
          {time} s.", period = figures(mode$period_s), time = figures(1 / mode$growth_per_s)),
        "Move the attachment points of warp and backstrops, or reduce the weight of the board.")
    })
  }
)

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
