# Gears with published particulars and performance.

particular_net <- function(name) {
  read_gear(system.file("extdata", paste0(name, "_trawl.yaml"), package = "codend"))
}

# The four-seam trawl is designed for a headline height of 4.5 to 5.5 m at 3 to 3.8 knot.
case_four_seam <- function() {
  speeds <- c(3, 3.4, 3.8)
  found <- settled_along(particular_net("four_seam"),
    list(towing.speed = paste(speeds, "knot")), "headline_height_m")
  compared("opening", paste(speeds, "knot"), rep(5, 3), drop(found))
}

# The institute's published drag of its lantern fish trawl, t at 2 and 3 knot.
case_myctophid <- function() {
  speeds <- c(2, 3)
  drag <- drop(settled_along(particular_net("myctophid"),
    list(towing.speed = paste(speeds, "knot")), "total_drag_kN")) / 9.80665
  printed <- c(4.9, 7.3)
  rbind(
    compared("drag", paste(speeds, "knot"), printed, drag),
    trend("drag", "speed", speeds, printed, drag)
  )
}

# A prawn trawl body shortened from 160 to 112 rows spreads the wing ends 4.7 to 5.6 % wider, with 0
# to 4.3 % less drag.
case_penaeid_body <- function() {
  found <- settled_along(particular_net("penaeid"),
    list(sections.body.meshes.deep = c(160, 112)), c("wing_end_spread_m", "total_drag_kN"))
  shares <- found[2, ] / found[1, ]
  rbind(
    compared("wing_spread", "short over long body", 1.0515, shares[1]),
    compared("drag", "short over long body", 0.9785, shares[2])
  )
}

# Between a beam's sleds its drag grows by up to 16 % if its spread increases from 0.5 to 0.8 of the
# headline.
case_penaeid_spread <- function() {
  gear <- update(particular_net("penaeid"), warps = NULL, otter_boards = NULL,
    towing_points = list(spread = "5 m", height = "0.4 m"))
  found <- settled_along(gear, list(towing_points.spread = paste(4:10, "m")),
    c("wing_end_spread_m", "total_drag_kN"))
  at <- stats::approx(found[, 1] / 7.35, found[, 2], c(0.5, 0.8))$y
  compared("drag", "0.8 over 0.5 of the headline", 1.16, at[2] / at[1])
}
