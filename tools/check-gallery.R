# Checks the scene of every shipped gear that the viewer receives, without drawing it.
#
#   Rscript tools/check-gallery.R           checks, and compares the scenes with gallery/scenes.csv
#   Rscript tools/check-gallery.R --accept  checks and stores them; `make gallery` does so
#
# Faults:
#
# - Netting has a gap at a seam, or drawn twines do not meet on a seam across the net.
#
# - Points of netting are farther apart than their twines reach, or lie outside their panel.
#
# - The purse wire leaves the pursed seine open.
#
# - A gear has no picture, or its scene differs from the scene of its picture.
suppressMessages(library(codend))
codend <- asNamespace("codend")
source("tests/browser/gallery.R")
pictures <- list(cards = "inst/app/gears", stored = "gallery/scenes.csv", most_bytes = 2.5e5)

unpacked <- function(text, type) {
  bytes <- jsonlite::base64_dec(text)
  readBin(bytes, type, length(bytes) %/% 4L, size = 4L, endian = "little")
}

# Returns list(at, lines, part, panels).
#
# at: points (3 x n, m). lines: indices of the points of each line (2 x n). part: part of each line.
#
# panels: a list for each panel. bar: length of a bar (m). point: indices of its points. mesh and
# drawn: twine and drawn coordinates of its points (2 x n).
read_scene <- function(state) {
  scene <- codend$viewed_scene(state)
  part <- scene$parts$name
  panels <- lapply(scene$netting, function(panel) {
    mesh <- matrix(unpacked(panel$mesh, "double"), 2L)
    list(bar = scene$parts$bar[panel$part + 1L], point = unpacked(panel$point, "integer") + 1L,
      mesh = mesh, drawn = mesh / panel$scale + panel$offset)
  })
  names(panels) <- part[vapply(scene$netting, `[[`, 0, "part") + 1]
  list(
    at = matrix(unpacked(scene$points$floats, "double"), 3L),
    lines = matrix(unpacked(scene$ropes$ends, "integer") + 1L, 2L),
    part = part[unpacked(scene$ropes$part, "integer") + 1L], panels = panels
  )
}

# Returns the points of a scene on a stretch of a panel's edge, in order. One row per point:
# fraction of the stretch, x, y, z (m) and both drawn coordinates.
edge_points <- function(scene, si, panel, edge, from, to) {
  drawn <- scene$panels[[panel]]
  ends <- codend$edge_twines(si$panels[[panel]], edge, c(from, to))
  along <- ends[, 2L] - ends[, 1L]
  off <- drawn$mesh - ends[, 1L]
  fraction <- colSums(off * along) / sum(along^2)
  distance <- sqrt(colSums((off - outer(along, fraction))^2))
  on <- which(distance < 1e-3 & fraction > -1e-4 & fraction < 1 + 1e-4)
  on <- on[order(fraction[on])]
  at <- scene$at[, drawn$point[on], drop = FALSE]
  cbind(fraction[on], t(at), t(drawn$drawn[, on, drop = FALSE]))
}

# Returns the largest distance between two edges as a fraction of the length of the first edge.
edge_gap <- function(one, other) {
  if (nrow(one) < 2L || nrow(other) < 2L) return(Inf)
  fraction <- c(one[, 1L], other[, 1L])
  place <- function(edge) {
    vapply(2:4, function(k) {
      stats::approx(edge[, 1L], edge[, k], fraction, rule = 2, ties = "ordered")$y
    }, fraction)
  }
  apart <- sqrt(rowSums((place(one) - place(other))^2))
  max(apart) / sum(sqrt(rowSums(diff(one[, 2:4])^2)))
}

# Returns the positions of drawn twine ends along an edge (fractions): at most 16 per family.
twine_ends <- function(edge) {
  sort(unlist(lapply(5:6, function(column) {
    x <- edge[c(1L, nrow(edge)), column]
    run <- x[2L] - x[1L]
    if (abs(run) < 1e-3) return(NULL)
    step <- 2^ceiling(log2(abs(run) / 16) - 1e-6)
    (step * seq(ceiling(min(x) / step - 1e-4), floor(max(x) / step + 1e-4)) - x[1L]) / run
  })))
}

# TRUE if every drawn twine of the edge with fewer ends meets a drawn twine of the other edge.
twines_meet <- function(one, other) {
  ends <- list(twine_ends(one), twine_ends(other))
  ends <- ends[order(lengths(ends))]
  inner <- ends[[1L]][ends[[1L]] > 0.01 & ends[[1L]] < 0.99]
  all(vapply(inner, function(end) min(abs(ends[[2L]] - end)), 0) < 1e-3)
}

# Returns a data frame with a row per seam joint: place (its panels), across (TRUE if it runs across
# the net), gap (fraction of its length), meet (TRUE if drawn twines meet there). Twines of sides
# with different cuts cannot all meet.
seams_of_scene <- function(scene, si) {
  joints <- codend$seam_joints(si)
  joints <- joints[seq_len(nrow(joints) / 2), ]
  across <- c("upper", "lower")
  rows <- lapply(seq_len(nrow(joints)), function(k) {
    joint <- joints[k, ]
    one <- edge_points(scene, si, joint$panel, joint$edge, joint$from, joint$to)
    other <- edge_points(scene, si, joint$other, joint$other_edge, joint$other_from, joint$other_to)
    gap <- edge_gap(one, other)
    data.frame(place = paste(joint$panel, joint$edge, "to", joint$other, joint$other_edge),
      across = joint$edge %in% across && joint$other_edge %in% across, gap = gap,
      meet = is.finite(gap) && twines_meet(one, other))
  })
  do.call(rbind, c(list(data.frame(place = "", across = NA, gap = 0, meet = NA)[0L, ]), rows))
}

# Returns the largest distance between neighbours in a panel, as a fraction of the length of twine
# between them.
panel_stretch <- function(scene, panel) {
  many <- length(panel$point)
  nearest <- as.vector(vapply(seq_len(many), function(k) {
    order(colSums(abs(panel$mesh - panel$mesh[, k])))[2:5]
  }, integer(4L)))
  own <- rep(seq_len(many), each = 4L)
  bars <- colSums(abs(panel$mesh[, nearest] - panel$mesh[, own]))
  apart <- scene$at[, panel$point[nearest]] - scene$at[, panel$point[own]]
  max(sqrt(colSums(apart^2)) / (panel$bar * bars + 1e-3))
}

# Returns the area of a polygon.
polygon_area <- function(x, y) {
  following <- c(seq_along(x)[-1L], 1L)
  abs(sum(x * y[following] - y * x[following])) / 2
}

# TRUE if the points of a panel reach its corners and lie inside the panel.
fills_panel <- function(panel, si) {
  corners <- cbind(codend$edge_twines(si, "upper", 0:1), codend$edge_twines(si, "lower", 1:0))
  hull <- grDevices::chull(t(panel$mesh))
  covered <- polygon_area(panel$mesh[1L, hull], panel$mesh[2L, hull])
  abs(covered / polygon_area(corners[1L, ], corners[2L, ]) - 1) < 1e-3
}

# Returns the area enclosed by a rope, seen from above (m2).
area_within <- function(scene, rope) {
  lines <- scene$lines[, scene$part == rope, drop = FALSE]
  points <- c(lines[1L, ], lines[2L, ncol(lines)])
  polygon_area(scene$at[1L, points], scene$at[2L, points])
}

# Returns a message for each fault of a scene.
scene_faults <- function(name, scene, si, seams) {
  gap <- seams$gap > 1e-3
  apart <- seams$across & !seams$meet & !gap
  stretch <- vapply(scene$panels, panel_stretch, 0, scene = scene)
  filled <- vapply(names(scene$panels), function(panel) {
    fills_panel(scene$panels[[panel]], si$panels[[panel]])
  }, NA)
  open <- if ("purse_wire" %in% scene$part) {
    100 * area_within(scene, "lead_line") / area_within(scene, "float_line")
  }
  # Coarse meshes with long bars and netting that snaps taut reach up to 1.5.
  torn <- stretch > 2
  texts <- c(
    sprintf("the netting has a gap of %.2g seam lengths at %s", seams$gap[gap], seams$place[gap]),
    sprintf("drawn twines break at the seam %s", seams$place[apart]),
    sprintf("points of %s are %.1f twine lengths apart", names(stretch), stretch)[torn],
    sprintf("the drawn netting does not fill %s", names(filled))[!filled],
    sprintf("the lead line encloses %.1f %% of the area in the float line", open)[open > 2]
  )
  sprintf("%s: %s.", name, texts)
}

# Returns one row of numbers for the comparison of two scenes.
scene_numbers <- function(name, scene, seams) {
  drawn <- vapply(scene$panels, function(panel) {
    sum(apply(panel$drawn, 1L, function(x) diff(range(x))))
  }, 0)
  size <- apply(scene$at, 1L, function(x) diff(range(x)))
  data.frame(gear = name, points = ncol(scene$at), lines = ncol(scene$lines),
    panels = length(scene$panels), twines = signif(sum(drawn), 6), seams = nrow(seams),
    unmet_seams = sum(!seams$meet),
    as.list(signif(c(size = size, mean = rowMeans(scene$at)), 5)))
}

# Returns a message for each number of a scene that differs from the stored value by more than 1 %
# of the number or, for positions, 1 % of the largest extent.
changes <- function(now, was) {
  if (!nrow(was)) return(sprintf("%s is not in %s.", now$gear, pictures$stored))
  columns <- setdiff(names(now), "gear")
  size <- max(unlist(now[grepl("^size", columns)]))
  limit <- vapply(columns, function(column) {
    0.01 * if (grepl("^(size|mean)", column)) size else abs(now[[column]])
  }, 0)
  differs <- abs(unlist(now[columns]) - unlist(was[columns])) > limit
  texts <- sprintf("%s: %s of its scene was %s, is %s.", now$gear, columns, was[columns],
    now[columns])
  texts[differs]
}

picture_faults <- function(gears) {
  cards <- file.path(pictures$cards, paste0(gears, ".webp"))
  readme <- readLines("README.md")
  files <- c(cards, unlist(regmatches(readme, gregexpr("gallery/[a-z_]+[.]webp", readme))))
  extra <- setdiff(list.files(pictures$cards, full.names = TRUE), cards)
  bytes <- sum(file.size(cards), na.rm = TRUE)
  c(
    sprintf("%s is missing.", files)[!file.exists(files)],
    sprintf("%s is not a picture of a shipped gear.", extra),
    sprintf("%s takes %.0f bytes, more than %.0f.", pictures$cards, bytes,
      pictures$most_bytes)[bytes > pictures$most_bytes]
  )
}

gears <- gears()$name
found <- lapply(gears, function(name) {
  # Each net of a rig has as many nodes as a single net.
  nets <- length(codend$gear_si(read_gear(name))$nets)
  state <- gallery_state(name, nodes = 300 * max(1, nets))
  scene <- read_scene(state)
  seams <- seams_of_scene(scene, state$si)
  list(
    faults = scene_faults(name, scene, state$si, seams), numbers = scene_numbers(name, scene, seams)
  )
})
now <- do.call(rbind, lapply(found, `[[`, "numbers"))
faults <- unlist(lapply(found, `[[`, "faults"))
if (length(faults)) faults <- c(faults, "Correct these scenes (R/scene-*.R) or plans.")
if ("--accept" %in% commandArgs(TRUE)) {
  utils::write.csv(now, pictures$stored, row.names = FALSE)
} else {
  was <- if (file.exists(pictures$stored)) utils::read.csv(pictures$stored) else now[0L, ]
  changed <- c(picture_faults(gears), unlist(lapply(seq_along(gears), function(k) {
    changes(now[k, ], was[was$gear == gears[k], ])
  })))
  if (length(changed)) changed <- c(changed, "Run `make gallery` and look at every picture.")
  faults <- c(faults, changed)
}
writeLines(as.character(faults))
cat(sprintf("%d scenes, %d seams\n", nrow(now), sum(now$seams)))
quit(status = as.integer(length(faults) > 0L))
