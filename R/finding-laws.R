# Checks of the laws for the drag of netting: whether the netting lies as they were measured.

# Angle (deg) between the netting's normal and the flow from which twines stand in each other's
# wake; cage netting, on which the screens' formulas were fitted, mostly stands across the flow.
steep_angle <- 70
# Share of a towed gear's netting that lies steeper than that.
greatest_steep_share <- 0.5
constant_screens <- c("loland", "aarsnes")

define_finding("drag law", "state",
  "More than half of a towed gear's netting with `netting_drag` `loland` or `aarsnes` lies more than
  70 deg from across the flow. Both have a least drag, fitted to cage netting across the flow, that
  gives trawls up to four times the drag they have.",
  function(gear, state) {
    if (!has_towing(state)) return(list())
    law <- vapply(state$si$panels, `[[`, "", "netting_drag")
    if (!any(law %in% constant_screens)) return(list())
    cells <- cells_with_drag(state$si, state$lattice, constant_screens)
    if (!length(cells)) return(list())
    lies <- netting_to_flow(state, cells)
    share <- sum(lies$area[lies$angle > steep_angle]) / sum(lies$area)
    if (share <= greatest_steep_share) return(list())
    shown <- sprintf("%.0f %%", 100 * share)
    used <- intersect(constant_screens, law)[1]
    list(finding("netting_drag", 100 * share, shown,
      sprintf("%s was fitted to netting across the flow; %s of it lies along the flow here, and has
        too much drag.", used, shown),
      "Use blended, or twines."))
  }
)

# Largest solidity of the netting that a screen's law was fitted to: cage netting of up to 0.35, for
# Kristiansen and Faltinsen (2012) up to 0.5.
greatest_solidity <- c(loland = 0.35, aarsnes = 0.35, kristiansen_faltinsen = 0.5)

define_finding("solidity", "state",
  "More than half of the panels of a part whose `netting_drag` is a screen's stand so closed that
  their solidity is above that of the netting which the law was fitted to: 0.35 (`loland`,
  `aarsnes`) or 0.5 (`kristiansen_faltinsen`).",
  function(gear, state) {
    law <- vapply(state$si$panels, `[[`, "", "netting_drag")
    law <- law[law %in% names(greatest_solidity)]
    if (!length(law)) return(list())
    solidity <- solidity_of_panels(state, names(law))
    over <- solidity / greatest_solidity[law]
    # what has no area has no solidity
    over[is.na(over)] <- 0
    part <- vapply(state$si$panels[names(law)], function(panel) {
      first_of(unless_na(panel$part), "")
    }, "")
    part[part == ""] <- names(law)[part == ""]
    # Where a current folds a part, some of its panels close.
    over[stats::ave(over > 1, part) <= 0.5] <- 0
    worst <- which.max(over)
    if (over[worst] <= 1) return(list())
    used <- law[[worst]]
    list(finding(paste("panel", names(law)[worst]), solidity[[worst]], figures(solidity[[worst]]),
      sprintf("its solidity is %s; %s was fitted to at most %s.", figures(solidity[[worst]]), used,
        format(greatest_solidity[[used]])),
      if (used == "kristiansen_faltinsen") {
        "Check mesh size and twine; its drag may be off by tens of percent."
      } else {
        "Check mesh size and twine, or use kristiansen_faltinsen, fitted up to 0.5."
      }))
  }
)

# Of cells by number: list(angle = between normal and flow (deg, 0 to 90), area (m2)).
netting_to_flow <- function(state, cells) {
  node <- cell_corners(state$lattice, cells)
  corner <- function(k) state$position[, node[k, ], drop = FALSE]
  a <- corner(3L) - corner(1L)
  b <- corner(4L) - corner(2L)
  across <- rbind(a[2, ] * b[3, ] - a[3, ] * b[2, ], a[3, ] * b[1, ] - a[1, ] * b[3, ],
    a[1, ] * b[2, ] - a[2, ] * b[1, ])
  twice <- sqrt(colSums(across^2))
  flow <- flow_axes(state$si)[, "flow"]
  list(
    angle = in_unit(acos(pmin(1, abs(drop(flow %*% across)) / pmax(twice, 1e-300))), "deg"),
    area = twice / 2
  )
}

# Warns where a law is used outside what it was measured for: of the first that is found.
warn_of_laws <- function(state) {
  for (check in c("drag law", "solidity")) {
    found <- do.call(rbind, found_by(finding_checks[[check]], state$gear, state))
    if (is.null(found)) next
    cli::cli_warn(finding_sentences(found)[1],
      class = c("codend_warning_drag_law", "codend_warning"), call = NULL)
    return(invisible())
  }
}
