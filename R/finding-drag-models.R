# Checks that netting is within the tested range of its drag model.

# Angle (deg) between the netting's normal and the flow above which twines are in each other's wake.
# The screen drag models were fitted to cage netting, mostly across the flow.
steep_angle <- 70
# Maximum fraction of a towed gear's netting beyond that angle.
greatest_steep_share <- 0.5
# Returns the screen drag models with a minimum drag: models with a lower bound of solidity.
constant_screens <- function() {
  least <- drag_model_column("least_solidity", "netting", "screen")
  names(least)[least > 0]
}

define_finding("drag model", function(gear, state) {
  if (!has_towing(state)) return(list())
  law <- vapply(state$si$panels, `[[`, "", "netting_drag")
  if (!any(law %in% constant_screens())) return(list())
  cells <- cells_with_drag(state$si, state$mesh, constant_screens())
  if (!length(cells)) return(list())
  lies <- netting_to_flow(state, cells)
  share <- sum(lies$area[lies$angle > steep_angle]) / sum(lies$area)
  if (share <= greatest_steep_share) return(list())
  label <- sprintf("%.0f %%", 100 * share)
  list(finding("drag model", "netting_drag", 100 * share, label, share = label,
    law = intersect(constant_screens(), law)[1]))
}, function() {
  list(models = paste0("`", constant_screens(), "`", collapse = " or "), angle = steep_angle)
})

define_finding("solidity", function(gear, state) {
  law <- screened_panels(state)
  if (!length(law)) return(list())
  solidity <- solidity_of_panels(state, names(law))
  greatest_solidity <- drag_model_column("most_solidity", "netting", "screen")
  least_solidity <- drag_model_column("least_solidity", "netting", "screen")
  solidity[is.na(solidity)] <- least_solidity[law[is.na(solidity)]]
  off <- mostly_of_part(state, names(law),
    pmax(solidity / greatest_solidity[law], least_solidity[law] / pmax(solidity, 1e-6)))
  worst <- which.max(off)
  if (off[worst] <= 1) return(list())
  used <- law[[worst]]
  value <- solidity[[worst]]
  closed <- value > greatest_solidity[[used]]
  wider <- names(which.max(greatest_solidity))
  found <- finding("solidity", paste("panel", names(law)[worst]), value, figures(value),
    solidity = figures(value), law = used,
    bound = format(if (closed) greatest_solidity[[used]] else least_solidity[[used]]),
    case = if (!closed) "open" else if (greatest_solidity[[wider]] >= value) "closed" else {
      "beyond all"
    })
  found$advice$values <- list(law = wider, bound = format(greatest_solidity[[wider]]))
  list(found)
}, function() list(ranges = screen_ranges()))

define_finding("Reynolds number", function(gear, state) {
  rows <- screens_by_reynolds()
  law <- screened_panels(state)
  law <- law[law %in% rows$name]
  speed <- flow_speed(state$si)
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
  label <- figures(reynolds[[worst]])
  list(finding("Reynolds number", paste("panel", names(law)[worst]), reynolds[[worst]], label,
    number = label, law = law[[worst]], least = format(rows$least_reynolds[worst]),
    most = format(rows$most_reynolds[worst])))
}, function() {
  rows <- screens_by_reynolds()
  list(ranges = paste0("`", rows$name, "` from ", rows$least_reynolds, " to ", rows$most_reynolds,
    collapse = ", "))
})

screens_by_reynolds <- function() {
  laws[laws$of == "netting" & laws$form == "screen" & !is.na(laws$most_reynolds), ]
}

screened_panels <- function(state) {
  law <- vapply(state$si$panels, `[[`, "", "netting_drag")
  law[law %in% drag_model_names("netting", "screen")]
}

# Returns `off` by panel, set to 0 in parts in which at most half of the panels exceed 1.
mostly_of_part <- function(state, names, off) {
  part <- vapply(state$si$panels[names], `[[`, "", "part")
  part <- ifelse(is.na(part) | part == "", names, part)
  off[stats::ave(off > 1, part) <= 0.5] <- 0
  off
}

# Returns list(angle (deg, 0 to 90, between normal and flow), area (m2)) of cells.
netting_to_flow <- function(state, cells) {
  node <- cell_corners(state$mesh, cells)
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

# Warns if a drag model is used outside its tested range, for the first such check.
warn_of_drag_models <- function(state) {
  for (check in mget(c("drag model", "solidity", "Reynolds number"), finding_checks)) {
    if (warn_of_check(check, state, "drag_model")) return(invisible())
  }
}
