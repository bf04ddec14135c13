# Checks of the laws for the drag of netting: whether the netting lies as they were measured.

# Angle (deg) between the netting's normal and the flow from which twines stand in each other's
# wake; cage netting, on which the screens' formulas were fitted, mostly stands across the flow.
steep_angle <- 70
# Share of a towed gear's netting that lies steeper than that.
greatest_steep_share <- 0.5
# Screens' laws with a least drag: those that are not taken below a least solidity.
constant_screens <- function() {
  least <- law_column("least_solidity", "netting", "screen")
  names(least)[least > 0]
}

define_finding("drag law", "state",
  function() {
    paste0("More than half of a towed gear's netting with `netting_drag` ",
      paste0("`", constant_screens(), "`", collapse = " or "), " lies more than ", steep_angle,
      " deg from across the flow. They have a least drag, fitted to cage netting across the flow,
      that gives trawls up to four times the drag they have.")
  },
  function(gear, state) {
    if (!has_towing(state)) return(list())
    law <- vapply(state$si$panels, `[[`, "", "netting_drag")
    if (!any(law %in% constant_screens())) return(list())
    cells <- cells_with_drag(state$si, state$lattice, constant_screens())
    if (!length(cells)) return(list())
    lies <- netting_to_flow(state, cells)
    share <- sum(lies$area[lies$angle > steep_angle]) / sum(lies$area)
    if (share <= greatest_steep_share) return(list())
    shown <- sprintf("%.0f %%", 100 * share)
    used <- intersect(constant_screens(), law)[1]
    list(finding("netting_drag", 100 * share, shown,
      told("{law} was fitted to netting across the flow; {share} of it lies along the flow here, and
        has too much drag.", law = used, share = shown),
      "Use blended, or twines."))
  },
  rank = 3L
)

define_finding("solidity", "state",
  function() {
    paste0("More than half of the panels of a part whose `netting_drag` is a screen's are so
    closed or so open that their solidity is outside that of the netting which the law was fitted
    to: ",
      screen_ranges(), ".")
  },
  function(gear, state) {
    law <- screened_panels(state)
    if (!length(law)) return(list())
    solidity <- solidity_of_panels(state, names(law))
    greatest_solidity <- law_column("most_solidity", "netting", "screen")
    least_solidity <- law_column("least_solidity", "netting", "screen")
    # what has no area has no solidity
    solidity[is.na(solidity)] <- least_solidity[law[is.na(solidity)]]
    # Where a current folds a part, some of its panels close.
    off <- mostly_of_part(state, names(law),
      pmax(solidity / greatest_solidity[law], least_solidity[law] / pmax(solidity, 1e-6)))
    worst <- which.max(off)
    if (off[worst] <= 1) return(list())
    used <- law[[worst]]
    shown <- figures(solidity[[worst]])
    closed <- solidity[[worst]] > greatest_solidity[[used]]
    words <- if (closed) {
      told("its solidity is {solidity}; {law} was fitted to at most {bound}.", solidity = shown,
        law = used, bound = format(greatest_solidity[[used]]))
    } else {
      told("its solidity is {solidity}; {law} was fitted to at least {bound}.", solidity = shown,
        law = used, bound = format(least_solidity[[used]]))
    }
    wider <- names(which.max(greatest_solidity))
    advice <- if (!closed) {
      "Use twines: there one twine hardly shields another."
    } else if (greatest_solidity[[wider]] >= solidity[[worst]]) {
      told("Check mesh size and twine, or use {law}, fitted up to {bound}.", law = wider,
        bound = format(greatest_solidity[[wider]]))
    } else {
      "Check mesh size and twine; its drag may be off by tens of percent."
    }
    list(finding(paste("panel", names(law)[worst]), solidity[[worst]], shown, words, advice))
  },
  rank = 3L
)

define_finding("Reynolds number", "state",
  function() {
    rows <- screens_by_reynolds()
    paste0("More than half of the panels of a part whose `netting_drag` goes by a Reynolds number
    have twine whose Reynolds number, that of the free flow, is outside the law's range, at whose
    ends its drag of a cylinder is held: ", paste0("`", rows$name, "` from ",
    rows$least_reynolds, " to ",
      rows$most_reynolds, collapse = ", "), ".")
  },
  function(gear, state) {
    rows <- screens_by_reynolds()
    law <- screened_panels(state)
    law <- law[law %in% rows$name]
    current <- state$si$water$current
    speed <- max(state$si$towing$speed, sqrt(current$x^2 + current$y^2))
    if (!length(law) || speed == 0) return(list())
    rows <- rows[match(law, rows$name), ]
    diameter <- vapply(state$si$panels[names(law)], `[[`, 0, "twine_diameter")
    solidity <- solidity_of_panels(state, names(law))
    solidity[is.na(solidity)] <- 0
    reynolds <- speed * diameter / state$si$water$viscosity /
      (1 - pmin(solidity, rows$most_solidity))
    off <- mostly_of_part(state, names(law),
      pmax(reynolds / rows$most_reynolds, rows$least_reynolds / reynolds))
    worst <- which.max(off)
    if (off[worst] <= 1) return(list())
    shown <- figures(reynolds[[worst]])
    list(finding(paste("panel", names(law)[worst]), reynolds[[worst]], shown,
      told("its twine has a Reynolds number of {number}; {law} is for {least} to {most}.",
        number = shown, law = law[[worst]], least = format(rows$least_reynolds[worst]),
        most = format(rows$most_reynolds[worst])),
      "Check speed, viscosity and twine, or use twines with choo_casarella."))
  },
  rank = 3L
)

# The rows of the screens' laws that have a range of Reynolds numbers.
screens_by_reynolds <- function() {
  laws[laws$of == "netting" & laws$form == "screen" & !is.na(laws$most_reynolds), ]
}

# The screens' laws of a state's panels by name, where they have one.
screened_panels <- function(state) {
  law <- vapply(state$si$panels, `[[`, "", "netting_drag")
  law[law %in% law_names("netting", "screen")]
}

# What is above 1 in these panels (by name), but 0 in parts of which no more than half is.
mostly_of_part <- function(state, names, off) {
  part <- vapply(state$si$panels[names], function(panel) first_of(unless_na(panel$part), ""), "")
  part[part == ""] <- names[part == ""]
  off[stats::ave(off > 1, part) <= 0.5] <- 0
  off
}

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
  for (check in c("drag law", "solidity", "Reynolds number")) {
    found <- finding_rows(found_by(finding_checks[[check]], state$gear, state))
    if (!nrow(found)) next
    cli::cli_warn(finding_sentences(found)[1],
      class = c("codend_warning_drag_law", "codend_warning"), call = NULL)
    return(invisible())
  }
}
