# Proportions that gear of a kind is known to have: each computed of a gear or a state and compared
# with its band in inst/extdata/bands.csv, where the sources are. A new one is a new entry here, and
# a row there for each kind that it is known of.

# Least and greatest of each quantity by kind, beyond which a gear gets a warning; `usual_*` is what
# sources print, which starters are checked against.
read_bands <- function() {
  utils::read.csv(system.file("extdata", "bands.csv", package = "codend"), check.names = FALSE)
}

known_bands <- remembered(read_bands)

# The band of a quantity for a gear's kind, or NULL.
band_of <- function(quantity, gear) {
  bands <- known_bands()
  row <- which(bands$quantity == quantity & bands$kind == first_of(gear$plan$kind, "assembly"))
  if (length(row)) bands[row, ]
}

# quantity: as in the table; of: "plan" or "state"; words: what is compared; value(gear, state): the
# number in the table's unit, or NULL where the gear has none; place, field: as in finding(), or
# functions of the gear that give them; low, high: what to try.
define_band <- function(quantity, of, words, value, place, low, high, field = NULL, rank = 2L) {
  define_finding(quantity, of, paste(words, "The bands by kind of gear, with their sources, are in
    the file `bands.csv` of `system.file(\"extdata\", package = \"codend\")`."),
    function(gear, state) {
      band <- band_of(quantity, gear)
      if (is.null(band)) return(list())
      found <- value(gear, state)
      if (!length(found) || !is.finite(found)) return(list())
      below <- !is.na(band$least) && found < band$least
      above <- !is.na(band$greatest) && found > band$greatest
      if (!below && !above) return(list())
      # "{n} knot"
      with_unit <- trimws(paste("{n}", band$unit))
      shown <- told(with_unit, n = figures(found))
      if (is.function(place)) place <- place(gear)
      list(finding(place, found, shown,
        told("{quantity} is {value}; usual is {band}.", quantity = quantity, value = shown,
          band = told(with_unit, n = band_words(band$usual_least, band$usual_greatest))),
        if (below) low else high, field = field))
    },
    rank = rank
  )
}

band_words <- function(least, greatest) {
  number <- function(x) format(x, trim = TRUE)
  if (is.na(least)) return(told("at most {n}", n = number(greatest)))
  told("{least} to {most}", least = number(least), most = number(greatest))
}

# One of the plan's own measures of a state by its name without unit, SI, or NULL.
measure_of <- function(state, name) {
  measure <- state$si$measures[[name]]
  if (!is.null(measure)) measure_values(state, list(measure))
}

# The head line's length (m) of a gear that has one such rope, or NULL.
head_line_of <- function(si) {
  line <- ropes_of_role(si, "head_line")
  if (length(line) == 1L) si$ropes[[line]]$length
}

# The mouth's height over the head line's length; a mouth that is closed has another finding.
height_over_head_line <- function(gear, state) {
  whole <- head_line_of(state$si)
  height <- measure_of(state, "net_mouth_height")
  if (!is.null(whole) && !is.null(height) && height > 0) height / whole
}

define_band("towing speed", "plan", "The towing speed is out of the range of its kind of gear.",
  function(gear, state) gear_si(gear)$towing$speed / plan_units$speed[["knot"]],
  place = "towing.speed", low = "Check the speed and its unit.",
  high = "Check the speed and its unit: a number without one is in m/s.", rank = 1L
)

define_band("footrope over head line", "plan",
  "A footrope, with its extensions, is short or long for its head line.",
  function(gear, state) {
    si <- gear_si(gear)
    lower <- si$ropes[ropes_of_role(si, c("footrope", "footrope_extension"))]
    whole <- head_line_of(si)
    if (length(lower) && !is.null(whole)) sum(vapply(lower, `[[`, 0, "length")) / whole
  },
  place = "footrope.length",
  low = "Lengthen the footrope, or shorten the head line: a short footrope runs ahead of it.",
  high = "Shorten the footrope, or lengthen the head line."
)

define_band("warp over depth", "plan",
  "A bottom trawl's warp is short or long for the depth of the sea bed.",
  function(gear, state) {
    si <- gear_si(gear)
    warp <- ropes_of_role(si, "warp")
    # below the vessel
    depth <- if (!is.null(si$ground)) height_above_ground(si$ground, cbind(numeric(3)))
    # by the shore warps have a least length
    if (length(warp) && isTRUE(depth > 15)) si$ropes[[warp[1L]]]$length / depth
  },
  place = "warps.length", low = "Pay out more warp.", high = "Pay out less warp."
)

define_band("ground gear weight", "plan",
  "The ground gear weighs little or much per metre, in water.",
  function(gear, state) {
    si <- gear_si(gear)
    name <- ropes_of_role(si, "ground_gear")
    if (!length(name)) return(NULL)
    rope <- si$ropes[[name[1L]]]
    discs <- Filter(function(piece) identical(piece$role, "disc"), si$pieces)
    of_discs <- sum(vapply(discs, function(piece) {
      first_of(piece$number, 1) * (piece$mass - si$water$density * piece$volume)
    }, 0))
    rope$mass_per_length - si$water$density * rope$volume_per_length + of_discs / rope$length
  },
  place = "ground_gear", low = "Check its mass in water and the unit.",
  high = "Check its mass in water and the unit."
)

define_band("board weight over area", "plan", "Otter boards are light or heavy for their area.",
  function(gear, state) {
    si <- gear_si(gear)
    boards <- Filter(function(piece) identical(piece$role, "otter_board"), si$pieces)
    if (length(boards)) boards[[1L]]$mass / boards[[1L]]$area
  },
  place = "otter_boards.mass", low = "Check the mass of one board, in air, and its area.",
  high = "Check the mass of one board, in air, and its area."
)

define_band("headline height over head line", "state",
  "The head line's middle is low or high for its length.",
  height_over_head_line,
  place = "rope head_line", rank = 1L,
  low = "Give more floats or buoyancy, longer upper bridles, or less spread.",
  high = "Give fewer floats, shorter upper bridles, or more spread.", field = "floats"
)

define_band("mouth height over head line", "state",
  "A midwater trawl's mouth is low or high for its head line.",
  height_over_head_line,
  place = "rope head_line", rank = 1L,
  low = "Give heavier hammers, a longer lower hand rope, more floats, or less spread.",
  high = "Give lighter hammers, a shorter lower hand rope, or more spread.", field = "hammers"
)

define_band("spread over head line", "state",
  "The spread between a trawl's upper wing ends is small or large for its head line: a net whose
  wings are pulled straight has no room to open upward.",
  function(gear, state) {
    line <- ropes_of_role(state$si, "head_line")
    if (!has_towing(state) || length(line) != 1L) return(NULL)
    node <- state$lattice$ropes[[line]]$node
    ends <- state$position[1:2, c(node[1L], node[length(node)])]
    sqrt(sum((ends[, 2L] - ends[, 1L])^2)) / state$si$ropes[[line]]$length
  },
  place = "rope head_line", field = "otter_boards",
  low = "Give the boards more area or lift, more warp, or shorten the head line.",
  high = "Give the boards less area or lift, shorten the warp, or lengthen the head line."
)

define_band("bridle angle", "state",
  "Sweeps or bridles run at a small or a large angle to the course.",
  function(gear, state) in_unit(first_of(measure_of(state, "bridle_angle"), NA_real_), "deg"),
  place = function(gear) if (is.null(gear$plan$sweeps)) "bridles" else "sweeps.length",
  low = "Shorten sweeps and bridles, or spread the boards more.",
  high = "Lengthen sweeps and bridles, or spread the boards less."
)

define_band("ground friction over drag", "state",
  "Friction on the sea bed is a large share of the drag.",
  function(gear, state) {
    if (!is.null(state$si$ground)) 100 * measure_value(state, "ground_friction")
  },
  place = "ground_gear", low = "", high = "Check the weights in water of what lies on the bed."
)

define_band("boards' drag over drag", "state",
  "The otter boards have a small or a large share of the drag.",
  function(gear, state) {
    totals <- drag_totals(drag_table(state))
    drag <- stats::setNames(totals$drag_kN, totals$group)
    if ("otter boards" %in% names(drag)) 100 * drag[["otter boards"]] / drag[["total"]]
  },
  place = "otter_boards.area", low = "Check whether the boards are too small for the net.",
  high = "Check whether the boards are too large for the net, or their drag coefficient too high."
)

define_band("hammers' weight over drag", "state",
  "The weights at a midwater trawl's lower wing tips are a large share of its drag.",
  function(gear, state) {
    of_hammers <- state$lattice$parts$role %in% "hammer"
    drag <- measure_value(state, "total_drag")
    if (any(of_hammers) && drag > 0) 100 * sum(part_weight(state)[of_hammers]) / drag
  },
  place = "hammers.mass", low = "", high = "Check the mass of one side's weight."
)

define_band("net height over hung height", "state",
  "A gillnet lies down: it is much lower than it is hung.",
  function(gear, state) {
    wall <- gear_si(gear)$panels[["wall"]]
    hung <- gillnet_hung_height(gear_si(gear), wall)
    height <- measure_of(state, "net_height")
    if (!is.null(height) && is.finite(hung) && hung > 0) height / hung
  },
  place = "float_line", low = "Give more buoyancy along the float line, or check the current.",
  high = "Check the height of the wall.", rank = 1L
)

# Height (m) of a wall between a float line as long as it is hung: of its stretched height.
gillnet_hung_height <- function(si, wall) {
  if (is.null(wall)) return(NA_real_)
  across <- wall$upper * wall$mesh_size
  ratio <- min(1, si$ropes$float_line$length / across)
  wall$deep * wall$mesh_size * sqrt(1 - ratio^2)
}

define_band("volume left", "state", "A cage loses much of its volume.",
  function(gear, state) measure_of(state, "volume_left"),
  place = "water.current.speed", low = "Give more weight along the foot, or check the current.",
  high = "Check the dimensions of the net.", rank = 1L
)
