# Typical proportions by kind of gear, compared with bands in inst/extdata/bands.csv, which lists
# the sources. A new proportion needs an entry here and a row there for each kind.

# Returns the bands by quantity and kind. A value outside `least` to `greatest` gets a warning.
# `usual_least` and `usual_greatest` are published values, which starters must meet.
read_bands <- function() {
  utils::read.csv(system.file("extdata", "bands.csv", package = "codend"), check.names = FALSE)
}

known_bands <- remembered(read_bands)

# si: SI numbers of one net (`si_by_net()`).
band_of <- function(quantity, si) {
  bands <- known_bands()
  kind <- if (length(si$nets) == 1L) si$nets[[1L]]$kind else "assembly"
  # Pair trawls off the seabed have the proportions of midwater trawls.
  if (kind == "pair_trawl" && is.null(si$ground)) kind <- "midwater_trawl"
  row <- which(bands$quantity == quantity & bands$kind == kind)
  if (length(row)) bands[row, ]
}

# Defines the check of a proportion of each net. `value(si, state)`: the number in the band's unit,
# or NULL if undefined; `si`: SI numbers of the net. `location`: as in `finding()`, or a function of
# the gear; `field`: as in `finding()`. `low`, `high`: advice for values below and above the band.
define_band <- function(quantity, of, message, value, location, low, high, field = NULL,
  rank = 2L) {
  define_finding(quantity, of, paste(message, "Range: `bands.csv`."),
    function(gear, state) {
      nets <- si_by_net(if (of == "state") state$si else gear_si(gear))
      Map(function(si, net) {
        band <- band_of(quantity, si)
        if (is.null(band)) return(NULL)
        found <- value(si, state)
        if (!length(found) || !is.finite(found)) return(NULL)
        below <- !is.na(band$least) && found < band$least
        above <- !is.na(band$greatest) && found > band$greatest
        if (!below && !above) return(NULL)
        if (is.function(location)) location <- location(gear)
        unusual_number(quantity, found, band$unit, band$usual_least, band$usual_greatest,
          location_in_net(location, net, gear$plan), if (below) low else high, field)
      }, nets, first_of(names(nets), ""))
    },
    rank = rank
  )
}

# Returns the finding of a number outside its usual range. `unit`: as text; `least`, `greatest`: of
# the usual range. Other arguments: as in define_band() and finding().
unusual_number <- function(quantity, value, unit, least, greatest, location, advice, field) {
  with_unit <- trimws(paste("{n}", unit))
  label <- template(with_unit, n = figures(value))
  finding(location, value, label,
    template("{quantity} is {value}; usual is {band}.", quantity = quantity, value = label,
      band = template(with_unit, n = band_text(least, greatest))),
    advice, field = field)
}

# An end of a usual range without limit is NA or infinite.
band_text <- function(least, greatest) {
  number <- function(x) format(x, trim = TRUE)
  if (!is.finite(least)) return(template("at most {n}", n = number(greatest)))
  if (is.infinite(greatest)) return(template("at least {n}", n = number(least)))
  template("{least} to {most}", least = number(least), most = number(greatest))
}

# Returns the location of a finding with the name of its net in a rig ("" for a single net).
location_in_net <- function(location, net, plan) {
  if (!nzchar(net)) return(location)
  if (grepl("^rope ", location)) return(sub("^rope ", paste0("rope ", net, "_"), location))
  of <- intersect(c(net, sub("_[0-9]+$", "", net)), names(plan$gears))
  own <- if (length(of)) gear_field_path(plan$gears, of[1L], location) else location
  if (is.null(plan_field(plan, own))) location else own
}

# Returns a measure of a net (`si`) in a state.
measure_of <- function(si, state, name) {
  measure <- si$measures[[name]]
  if (!is.null(measure)) measure_values(state, list(measure))
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

define_band("towing speed", "plan", "The towing speed is unusual for this kind of gear.",
  function(si, state) si$towing$speed / plan_units$speed[["knot"]],
  location = "towing.speed", low = "Check the speed and its unit.",
  high = "Check the speed and its unit: a number without a unit is in m/s.", rank = 1L
)

define_band("footrope over headline", "plan",
  "The footrope with its extensions is too short or too long for the headline.",
  function(si, state) {
    lower <- si$ropes[ropes_of_role(si, c("footrope", "footrope_extension"))]
    whole <- headline_of(si)
    if (length(lower) && !is.null(whole)) sum(vapply(lower, `[[`, 0, "length")) / whole
  },
  location = "footrope.length",
  low = "Lengthen the footrope or shorten the headline; a short footrope runs ahead.",
  high = "Shorten the footrope or lengthen the headline."
)

define_band("warp over depth", "plan",
  "The warp of a bottom trawl is too short or too long for the depth of the sea bed.",
  function(si, state) {
    warp <- ropes_of_role(si, "warp")
    depth <- if (!is.null(si$ground)) height_above_ground(si$ground, cbind(numeric(3)))
    # In shallow water a minimum warp length applies instead.
    if (length(warp) && isTRUE(depth > 15)) si$ropes[[warp[1L]]]$length / depth
  },
  location = "warps.length", low = "Pay out more warp.", high = "Pay out less warp."
)

define_band("ground gear weight", "plan",
  "The weight of the ground gear per metre in water is unusually low or high.",
  function(si, state) {
    name <- ropes_of_role(si, "ground_gear")
    if (!length(name)) return(NULL)
    gear <- loaded_parts(si)$ropes[[name[1L]]]
    (gear$mass - si$water$density * gear$volume) / si$ropes[[name[1L]]]$length
  },
  location = "ground_gear", low = "Check its mass in water and the unit.",
  high = "Check its mass in water and the unit."
)

define_band("board weight over area", "plan",
  "The otter boards are too light or too heavy for their area.",
  function(si, state) {
    boards <- Filter(function(piece) identical(piece$role, "otter_board"), si$pieces)
    if (length(boards)) boards[[1L]]$mass / boards[[1L]]$area
  },
  location = "otter_boards.mass", low = "Check the mass of one board, in air, and its area.",
  high = "Check the mass of one board, in air, and its area."
)

define_band("headline height over headline", "state",
  "The centre of the headline is too low or too high for the length of the headline.",
  height_over_headline,
  location = "rope headline", rank = 1L,
  low = "Add floats or buoyancy, lengthen the upper bridles, or reduce the spread.",
  high = "Remove floats, shorten the upper bridles, or increase the spread.", field = "floats"
)

define_band("mouth height over headline", "state",
  "The mouth of a midwater trawl is too low or too high for its headline.",
  height_over_headline,
  location = "rope headline", rank = 1L,
  low = "Use heavier hammers, a longer lower hand rope, more floats, or less spread.",
  high = "Use lighter hammers, a shorter lower hand rope, or more spread.", field = "hammers"
)

define_band("spread over headline", "state",
  "The upper wing spread of a trawl is too small or too large for its headline. A net with straight
  wings cannot open upward.",
  function(si, state) {
    line <- ropes_of_role(si, "headline")
    if (!has_towing(state) || length(line) != 1L) return(NULL)
    node <- state$mesh$ropes[[line]]$node
    ends <- state$position[1:2, c(node[1L], node[length(node)])]
    sqrt(sum((ends[, 2L] - ends[, 1L])^2)) / si$ropes[[line]]$length
  },
  location = "rope headline", field = "otter_boards",
  low = "Increase the area or lift of the boards, pay out more warp, or shorten the headline.",
  high = "Reduce the area or lift of the boards, shorten the warp, or lengthen the headline."
)

define_band("bridle angle", "state",
  "The angle of sweeps or bridles to the course is unusually small or large.",
  function(si, state) in_unit(first_of(measure_of(si, state, "bridle_angle"), NA_real_), "deg"),
  location = function(gear) if (is.null(gear$plan$sweeps)) "bridles" else "sweeps.length",
  low = "Shorten sweeps and bridles, or increase the door spread.",
  high = "Lengthen sweeps and bridles, or reduce the door spread."
)

define_band("ground friction over drag", "state",
  "Friction on the sea bed is an unusually large fraction of the drag.",
  function(si, state) {
    if (!is.null(state$si$ground)) 100 * measure_value(state, "ground_friction")
  },
  location = "ground_gear", low = "", high = "Check the weight in water of the gear on the sea bed."
)

define_band("boards' drag over drag", "state",
  "The otter boards have an unusually small or large fraction of the drag.",
  function(si, state) {
    totals <- drag_totals(drag_table(state))
    drag <- stats::setNames(totals$drag_kN, totals$group)
    if ("otter boards" %in% names(drag)) 100 * drag[["otter boards"]] / drag[["total"]]
  },
  location = "otter_boards.area",
  low = "The boards may be too small for the net: check their area.",
  high = "The boards may be too large for the net, or their drag coefficient too high: check both."
)

define_band("hammers' weight over drag", "state",
  "The weight of the hammers of a midwater trawl is an unusually large fraction of its drag.",
  function(si, state) {
    of_hammers <- state$mesh$parts$role %in% "hammer"
    drag <- measure_value(state, "total_drag")
    if (any(of_hammers) && drag > 0) 100 * sum(part_weight(state)[of_hammers]) / drag
  },
  location = "hammers.mass", low = "", high = "Check the mass of the weight on one side."
)

define_band("net height over hung height", "state",
  "A gillnet lies down: its height is much less than its hung height.",
  function(si, state) {
    wall <- si$panels[["wall"]]
    hung <- gillnet_hung_height(si, wall)
    height <- measure_of(si, state, "net_height")
    if (!is.null(height) && is.finite(hung) && hung > 0) height / hung
  },
  location = "float_line", low = "Add buoyancy along the float line, or check the current.",
  high = "Check the height of the wall.", rank = 1L
)

# Returns the height (m) of a wall hung on its float line, from its stretched height and hanging
# ratio.
gillnet_hung_height <- function(si, wall) {
  if (is.null(wall)) return(NA_real_)
  across <- wall$upper * wall$mesh_size
  ratio <- min(1, si$ropes$float_line$length / across)
  wall$deep * wall$mesh_size * sqrt(1 - ratio^2)
}

define_band("volume left", "state", "A cage loses much of its volume in the current.",
  function(si, state) measure_of(si, state, "volume_left"),
  location = "water.current.speed",
  low = "Add weight along the foot of the net, or check the current.",
  high = "Check the dimensions of the net.", rank = 1L
)
