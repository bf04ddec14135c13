# Thickest and thinnest twine (m) in use. The thickest is in the front meshes of large midwater
# trawls; thicker lines between knots are ropes. No thinner twine or monofilament is sold.
thickest_twine <- 0.024
thinnest_twine <- 5e-5
# Twine diameter divided by bar length. Netting of codends and cages has up to 0.11, double twine in
# small meshes up to 0.2. The largest front meshes in use (14 mm twine, bars of 16 to 32 m) have
# 0.0004 to 0.0009.
greatest_twine_ratio <- 0.25
least_twine_ratio <- 1.5e-4

define_finding("twine", "plan",
  "A twine is thicker than 24 mm or thinner than 0.05 mm, or its diameter is more than 25 % or less
  than 0.015 % of the bar length. No known netting is like that; a unit may be missing.",
  function(gear, state) {
    panels <- gear_si(gear)$panels
    odd <- Filter(Negate(is.null), lapply(names(panels), function(name) {
      panel <- panels[[name]]
      twine <- panel$twine_diameter
      ratio <- twine / (panel$mesh_size / 2)
      if (twine <= thickest_twine && twine >= thinnest_twine && ratio <= greatest_twine_ratio &&
        ratio >= least_twine_ratio) return(NULL)
      list(panel = name, part = first_of(unless_na(panel$part), name), twine = twine,
        mesh = panel$mesh_size)
    }))
    once <- odd[!duplicated(lapply(odd, function(x) x[c("part", "twine", "mesh")]))]
    lapply(once, function(x) {
      thick <- in_unit(x$twine, "mm")
      finding(paste("panel", x$panel), thick, paste(figures(thick), "mm"),
        template("its twine is {thick} mm thick in meshes of {mesh}.",
          thick = figures(thick),
          mesh = format_si(x$mesh, "length")),
        "Check the unit: a number without a unit is in metres.", field = "twine")
    })
  },
  rank = 1L
)

# Thickest ropes and bodies (discs, bobbins, poles) and thinnest ropes (m) in use on gear.
thickest_rope <- 0.2
thickest_body <- 1.5
thinnest_rope <- 2e-4
rollers <- c("ground_gear", "footrope", "footrope_extension")

define_finding("rope diameter", "plan",
  "A rope is thicker than 200 mm (ground gear and poles: 1.5 m) or thinner than 0.2 mm: a unit may
  be missing.",
  function(gear, state) {
    ropes <- gear_si(gear)$ropes
    odd <- Filter(function(name) {
      rope <- ropes[[name]]
      most <- if (rope$strut || rope$role %in% rollers) thickest_body else thickest_rope
      rope$diameter > most || rope$diameter < thinnest_rope
    }, names(ropes))
    lapply(odd, function(name) {
      label <- format_si(ropes[[name]]$diameter, "length")
      finding(paste("rope", name), in_unit(ropes[[name]]$diameter, "mm"), label,
        template("its diameter is {diameter}.", diameter = label),
        "Check the unit: a number without a unit is in metres.", field = "diameter")
    })
  },
  rank = 1L
)

# Maximum speed (m/s) of towed survey instruments (12 knots; no fishing gear reaches 10 knots), and
# maximum current.
greatest_speed <- 6.2
greatest_current <- 3

define_finding("speed", "plan",
  "The towing speed is above 12 knot, or a current is above 3 m/s. Fishing gear is towed at up to
  7 knot.",
  function(gear, state) {
    si <- gear_si(gear)
    in_knots <- si$towing$speed / plan_units$speed[["knot"]]
    knots <- template("{n} knot", n = figures(in_knots))
    out <- list()
    # Other kinds have a band with its own warning.
    if (si$towing$speed > greatest_speed && is.null(band_of("towing speed", si_by_net(si)[[1L]]))) {
      out <- list(finding("towing.speed", in_knots, knots,
        template("the gear is towed at {speed}.", speed = knots),
        "Check the unit: a number without a unit is in m/s."))
    }
    current <- current_speeds(si)
    if (max(current) > greatest_current) {
      label <- paste(figures(max(current)), "m/s")
      out <- c(out, list(finding("water.current", max(current), label,
        template("the current runs at {speed}.", speed = label),
        "Check the unit: a number without a unit is in m/s.")))
    }
    out
  },
  rank = 1L
)

# Bounds of coefficients. The largest published lift coefficients are 2.54 for boards (high_lift),
# 1.2 for lifting canvas and about 1.5 for kites.
greatest_lift <- 3
greatest_drag <- 2.5

define_finding("lift coefficient", "plan",
  "A lift coefficient is above 3, or a drag coefficient above 2.5. The largest published coefficient
  of an otter board is 2.54.",
  function(gear, state) {
    si <- gear_si(gear)
    of_pieces <- lapply(si$pieces, function(piece) {
      c(lift = piece$lift_area, drag = piece$drag_area) / piece$area
    })
    of_boards <- lapply(si$otter_boards, function(board) {
      c(lift = max(board$polar$lift), drag = max(board$polar$drag))
    })
    bound <- c(lift = greatest_lift, drag = greatest_drag)
    of <- c(of_pieces, of_boards)
    unlist(lapply(names(of), function(name) {
      odd <- names(bound)[is.finite(of[[name]]) & of[[name]] > bound]
      lapply(odd, function(force) {
        value <- of[[name]][[force]]
        finding(gsub("_", " ", name), value, figures(value),
          if (force == "lift") {
            template("its lift coefficient is {n}; tested boards have up to 2.5.",
              n = figures(value))
          } else {
            template("its drag coefficient is {n}; tested boards have up to 1.5.",
              n = figures(value))
          },
          "Check the coefficient and its reference area.")
      })
    }), recursive = FALSE)
  }
)

define_finding("number of panels", "plan",
  "The plan of a trawl omits `panels`. The default is 2 for a bottom trawl and 4 for a midwater
  trawl.",
  function(gear, state) {
    if (!first_of(gear$plan$kind, "") %in% trawls_of_panels || !is.null(gear$plan$panels) ||
      !is.null(gear$plan$net)) {
      return(list())
    }
    taken <- plan_node(gear$plan)$properties$panels[["default"]]
    list(finding("panels", taken, template("{n} panels", n = taken),
      template("the field is missing; codend assumes {n} panels for this trawl.", n = taken),
      "Add the number of panels of the net."))
  }
)

define_finding("warp end", "plan",
  "A warp of a rig of several nets ends without a door, clump or weight.",
  function(gear, state) {
    si <- gear_si(gear)
    if (length(si$nets) < 2L || is.null(si$ground)) return(list())
    of_nets <- vapply(names(si$ropes), function(name) {
      any(startsWith(name, paste0(names(si$nets), "_")))
    }, NA)
    warps <- setdiff(ropes_of_role(si, "warp"), names(si$ropes)[of_nets])
    loaded <- unlist(c(lapply(si$pieces, `[[`, "at"), lapply(si$otter_boards, `[[`, "points")))
    lapply(warps, function(name) {
      if (any(c(si$ropes[[name]]$from, si$ropes[[name]]$to) %in% loaded)) return(NULL)
      finding(paste("rope", name), 0, "0 kg",
        template("its end has no door, clump or weight."),
        "Add a piece or an otter board at this point.", field = "to")
    })
  },
  rank = 1L
)

# Kinds whose field `panels` is the number of panels around a section.
trawls_of_panels <- c("bottom_trawl", "pair_trawl", "midwater_trawl")

# Seams take up a few percent. A larger ratio means gathered netting, as at a bosom, or a wrong
# count.
greatest_seam_ratio <- 1.2

define_finding("seam", "plan",
  "A seam joins edges that differ in stretched length by more than 20 %.",
  function(gear, state) {
    si <- gear_si(gear)
    lapply(names(si$seams), function(name) {
      seam <- si$seams[[name]]
      if (!is.null(seam$gathered_at) || length(seam$edges) < 2L) return(NULL)
      long <- vapply(seam$edges, chain_length, 0, panels = si$panels)
      if (min(long) <= 0 || max(long) <= greatest_seam_ratio * min(long)) return(NULL)
      ratio <- max(long) / min(long)
      finding(paste("seam", name), ratio, template("ratio {n}", n = figures(ratio)),
        template("it joins an edge of {short} to an edge of {long} (stretched).",
          short = format_si(min(long), "length"), long = format_si(max(long), "length")),
        "Check the mesh counts along both edges.")
    })
  }
)

unless_na <- function(x) if (is.na(x)) NULL else x
