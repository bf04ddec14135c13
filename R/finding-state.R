# Checks of a settled shape and its forces.

# Height (m) above the bed, and share of the head line's height, at which a footrope no longer
# fishes for what lies on it.
greatest_footrope_height <- 0.5
greatest_footrope_share <- 0.25

define_finding("net off the bed", "state",
  "Half of the footrope or ground gear of a gear that is towed over a sea bed hangs more than 0.5 m,
  or a quarter of the head line's height, above it. Not of midwater trawls.",
  function(gear, state) {
    si <- state$si
    if (is.null(si$ground) || identical(gear$plan$kind, "midwater_trawl")) return(list())
    # heights that half of the underside of each rope is above
    height_of <- function(roles) {
      vapply(ropes_of_role(si, roles), function(name) {
        node <- state$lattice$ropes[[name]]$node
        height <- height_above_ground(si$ground, state$position[, node])
        stats::median(height) - si$ropes[[name]]$diameter / 2
      }, 0)
    }
    low <- height_of(c("ground_gear", "footrope"))
    if (!length(low)) return(list())
    least <- min(low)
    above <- max(height_of("head_line"), -Inf)
    allowed <- greatest_footrope_height
    if (above > 0) allowed <- min(allowed, greatest_footrope_share * above)
    if (least <= allowed) return(list())
    shown <- paste(figures(least), "m")
    list(finding(paste("rope", names(low)[which.min(low)]), least, shown,
      if (above > 0) {
        told("half of it hangs {height} or more above the sea bed, under a head line at {line} m.",
          height = shown, line = figures(above))
      } else {
        told("half of it hangs {height} or more above the sea bed.", height = shown)
      },
      "Pay out more warp, tow more slowly, or weigh the footrope or the boards more.",
      field = "warps.length"))
  },
  rank = 1L
)

# Share of a rope's breaking load. Half of it is the most that towing lines of ships are loaded
# with; trawl warps are chosen for a third to a fifth.
greatest_load_percent <- 50

define_finding("rope load", "state",
  "A rope carries more than half of its breaking load: that of its material, or `strength`.",
  function(gear, state) {
    table <- tension_table(state)
    table <- table[which(table$strength_percent > greatest_load_percent), ]
    table <- table[order(-table$strength_percent), ]
    lapply(seq_len(nrow(table)), function(k) {
      shown <- paste(figures(table$strength_percent[k]), "%")
      finding(paste("rope", table$part[k]), table$strength_percent[k], shown,
        told("it carries {force} kN, {share} of its breaking load.",
          force = figures(table$max_kN[k]), share = shown),
        "Use a thicker or a stronger rope, or check what pulls so hard.", field = "diameter")
    })
  },
  rank = 1L
)

define_finding("opening", "state",
  "A measure of a height, an opening, an area or a volume is zero or negative: the net is closed or
  upside down there. Not during a tow.",
  function(gear, state) {
    if (!is.null(state$time)) return(list())
    opening <- Filter(function(one) one$kind %in% c("height", "area", "volume"), state$si$measures)
    opening <- opening[grepl("height|opening|area|volume", names(opening))]
    Map(function(name, value) {
      if (!is.finite(value) || value > 0) return(NULL)
      unit <- c(height = "m", area = "m2", volume = "m3")[[opening[[name]]$kind]]
      shown <- paste(figures(value), unit)
      finding(gsub("_", " ", name), value, shown,
        told("it is {value}: it must be positive.", value = shown),
        "Give more floats above, more weight below, or other lengths of bridles.",
        field = "floats")
    }, names(opening), measure_values(state, opening))
  },
  rank = 1L
)

# Share of the largest rope tension, and of the gear's drag, below which a rope that leads from
# point to point does nothing.
idle_share <- 0.001

define_finding("idle rope", "state",
  "A rope of a towed gear that leads from point to point, not along netting or over the sea bed,
  carries, weighs and drags less than a thousandth of the others: its fields change nothing.",
  function(gear, state) {
    if (!has_towing(state)) return(list())
    table <- tension_table(state)
    drag <- drag_table(state)
    counts <- abs(drag$drag_kN) + abs(drag$lift_kN) + abs(drag$weight_in_water_kN)
    table$counts <- counts[match(table$part, drag$part)]
    free <- names(Filter(function(rope) is.null(rope$along) && !rope$strut, state$si$ropes))
    idle <- table$kind == "rope" & table$part %in% free &
      table$max_kN < idle_share * max(table$max_kN) &
      table$counts < idle_share * in_unit(abs(measure_value(state, "total_drag")), "kN")
    lapply(which(idle), function(k) {
      shown <- paste(figures(1000 * table$max_kN[k]), "N")
      finding(paste("rope", table$part[k]), 1000 * table$max_kN[k], shown,
        told("it carries {force} at most, so that its fields change nothing.", force = shown),
        "Shorten it, or leave it out.", field = "length")
    })
  }
)

# Share of the tension of the bridles of one side. Two bridles of shipped gear share it 76 to 24.
greatest_bridle_share <- 0.85
# ... and what one must have of its equal part.
least_bridle_part <- 0.27

define_finding("bridles", "state",
  "Of the bridles or hand ropes that start at one place, one carries more than 85 % of their tension
  or less than 0.27 of its equal part (9 % of three). Not of beam trawls, whose middle one only
  keeps the beam straight.",
  function(gear, state) {
    if (identical(gear$plan$kind, "beam_trawl")) return(list())
    si <- state$si
    names <- ropes_of_role(si, c("bridle", "hand_rope"))
    start <- vapply(names, function(name) bridle_start(si, si$ropes[[name]]$from), "")
    unlist(lapply(split(names, start), function(together) {
      if (length(together) < 2L) return(list())
      pull <- vapply(together, function(name) {
        mean(state$bar_tension[rope_bars(state$lattice, name)])
      }, 0)
      if (sum(pull) <= 0) return(list())
      share <- pull / sum(pull)
      least <- least_bridle_part / length(share)
      odd <- if (max(share) > greatest_bridle_share) which.max(share) else which.min(share)
      if (share[odd] <= greatest_bridle_share && share[odd] >= least) return(list())
      percent <- 100 * share[[odd]]
      shown <- paste(figures(percent), "%")
      list(finding(paste("rope", together[odd]), percent, shown,
        told("it carries {share} of the tension of the bridles there.", share = shown),
        if (share[odd] < least) {
          "Shorten it, or lengthen the others."
        } else {
          "Lengthen it, or shorten the others."
        }, field = "length"))
    }), recursive = FALSE, use.names = FALSE)
  }
)

define_finding("weight on netting", "state",
  "A weight is on an edge of netting alone, without a rope there. The model passes it on to
  the meshes next to it, so that the netting comes together around it, where a line or one row of
  knots carries it.",
  function(gear, state) {
    si <- state$si
    ropes <- which(state$lattice$parts$kind == "rope")
    bars <- which(state$lattice$bar_part %in% ropes)
    cells <- state$lattice$mesh$cells$node
    hung <- Filter(function(name) {
      at <- si$pieces[[name]]$at
      if (!identical(si$pieces[[name]]$role, "weight") || is.null(at)) return(FALSE)
      node <- state$lattice$places[[at]]
      # where more cells meet many rows of knots are gathered, which carry it together
      sum(cells == node) %in% 1:2 && !node %in% bar_ends(state, bars)
    }, names(si$pieces))
    if (!length(hung)) return(list())
    mass <- si$pieces[[hung[1]]]$mass
    shown <- format_si(mass, "mass")
    list(finding(paste("piece", hung[1]), mass, shown,
      told("{n} such weights hang on netting alone, {mass} each.", n = length(hung), mass = shown),
      "Give the netting a rope where they hang (of a cage: side_ropes, bottom_rope)."))
  }
)

# Share of the volume of a cylinder as deep as it hangs, around which its rope would go, below which
# a net that nothing holds open hangs as a bundle.
least_open_share <- 0.01

define_finding("bundle", "state",
  "A net whose `enclosed_volume` is measured hangs as a bundle: it encloses less than 1 % of what it
  could, a cylinder as deep whose circumference is the rope's length. Not during a tow.",
  function(gear, state) {
    if (!is.null(state$time)) return(list())
    asked <- Filter(function(one) identical(one$kind, "enclosed_volume"), state$si$measures)
    lapply(asked, function(measure) {
      volume <- measure_values(state, list(measure))
      node <- state$lattice$ropes[[measure$rope]]$node
      could <- state$si$ropes[[measure$rope]]$length^2 / (4 * pi) * -min(state$position[3, node])
      if (!is.finite(volume) || volume >= least_open_share * could) return(NULL)
      shown <- paste(figures(volume), "m3")
      finding(paste("rope", measure$rope), volume, shown,
        told("it encloses {volume} of the {could} m3 that it could: the net hangs as a bundle.",
          volume = shown, could = figures(could)),
        "At rest its shape, volume and their errors mean nothing: look at its operation, by tow().")
    })
  }
)

# The place that a bridle starts at: of a free board's backstrops the board.
bridle_start <- function(si, from) {
  on <- vapply(si$otter_boards, function(board) from %in% board$points, NA)
  if (any(on)) names(si$otter_boards)[which(on)[1]] else from
}

ropes_of_role <- function(si, roles) {
  names(Filter(function(rope) rope$role %in% roles, si$ropes))
}

# Share of the meshes of a towed gear that are loose in both directions. One family alone may hang
# loose in netting that is well set, such as along a rope that takes the load.
greatest_loose_share <- 0.3

define_finding("slack netting", "state",
  "More than 30 % of a towed gear's netting hangs loose: neither of its two families of twines
  carries tension there (netting of bars: that share of its twine).",
  function(gear, state) {
    if (!has_towing(state) || !length(state$si$panels)) return(list())
    loose <- loose_netting(state)
    if (!is.finite(loose) || loose <= greatest_loose_share) return(list())
    shown <- paste(figures(100 * loose), "%")
    slack <- slack_table(state)
    most <- slack$part[which.max(slack$slack_percent * slack$twine_m)]
    list(finding("netting", 100 * loose, shown,
      told("{share} of it hangs loose, most of that in panel {panel}.", share = shown,
        panel = most),
      "Check the speed, the spread, and the ropes that hold it: are they shorter than meant?"))
  }
)

# Share of netting, by length of twine, whose twines all are slack.
loose_netting <- function(state) {
  mesh <- state$lattice$mesh
  cells <- mesh$cells
  all <- seq_along(cells$rest)
  twine <- 2 * cell_bars(cells, all) * cells$rest
  loose <- state$u_tension == 0 & state$v_tension == 0
  bars <- state$lattice$parts$kind[state$lattice$bar_part] == "netting"
  long <- (mesh$bars$multiplicity * mesh$bars$rest)[bars]
  (sum(twine[loose]) + sum(long[state$bar_tension[bars] == 0])) / (sum(twine) + sum(long))
}

# Height (m) above the surface that a wave may lift a float to.
greatest_freeboard <- 0.5

define_finding("out of the water", "state",
  "Nodes of the gear are more than 0.5 m above the surface, apart from ropes that end at a point
  above the water.",
  function(gear, state) {
    lattice <- state$lattice
    up <- vapply(state$si$points, function(point) {
      !is.null(point$position) && point$position[3] > 0
    }, NA)
    held <- vapply(names(which(up)), function(name) lattice$points[[name]], 0L)
    led <- lapply(lattice$ropes, function(rope) if (any(held %in% rope$node)) rope$node)
    above <- which(state$position[3, ] > greatest_freeboard)
    above <- setdiff(above, c(held, unlist(led)))
    if (!length(above)) return(list())
    most <- above[which.max(state$position[3, above])]
    height <- state$position[3, most]
    shown <- paste(figures(height), "m")
    list(finding(describe_node(lattice, most), height, shown,
      told("it is {height} above the surface, one of {n} nodes that do.", height = shown,
        n = length(above)),
      if (state$si$water$free_surface) {
        "Check what lifts the gear, and how much warp is out."
      } else {
        "The water has no surface here: give `water: {free_surface: yes}`, or more warp or weight."
      }))
  }
)

define_finding("boards", "state",
  "A free otter board or kite is stalled, back-winded or fallen over, or meets the flow at an angle
  of attack at which its polar was not tested, by more than 2 deg.",
  function(gear, state) {
    boards <- board_table(state)
    lapply(seq_len(nrow(boards)), function(k) {
      board <- boards[k, ]
      polar <- state$si$otter_boards[[k]]$polar
      tested <- range(polar$attack[polar$published])
      shown <- paste(figures(board$attack_deg), "deg")
      beyond <- board$attack_deg < tested[1] - 2 || board$attack_deg > tested[2] + 2
      if (board$condition == "flying" && !beyond) return(NULL)
      words <- if (board$condition != "flying") {
        told("it is {condition}, at an angle of attack of {attack} and a heel of {heel} deg.",
          condition = board$condition, attack = shown, heel = figures(board$heel_deg))
      } else {
        told("it meets the flow at {attack}, and its polar was tested from {least} to {most} deg.",
          attack = shown, least = figures(tested[1]), most = figures(tested[2]))
      }
      finding(gsub("_", " ", board$board), board$attack_deg, shown, words,
        "Move the points where warp and backstrops are fastened, or give a polar for that angle.")
    })
  }
)

define_finding("flutter", "state",
  "A free otter board or kite whose swings grow: with its mass, added mass and damping a small push
  is enough.",
  function(gear, state) {
    modes <- fluttering_modes(state)
    modes <- modes[!duplicated(modes$board), ]
    lapply(seq_len(nrow(modes)), function(k) {
      mode <- modes[k, ]
      finding(gsub("_", " ", mode$board), mode$growth_per_s,
        paste(figures(mode$growth_per_s), "/s"),
        told("it swings with a period of {period} s, and its swings grow by a factor of e in
          {time} s.", period = figures(mode$period_s), time = figures(1 / mode$growth_per_s)),
        "Move the points where warp and backstrops are fastened, or lower its weight.")
    })
  }
)
