# Tables of added mass and damping of a plate, compared with an independent vortex-mesh model and
# with analytical solutions.

# Velocity normal to the plane at points (x, y) by straight vortices of strength 1 from a to b in
# the same plane (Biot and Savart). Returns a matrix, points x vortices.
across_by_vortices <- function(x, y, from_x, from_y, to_x, to_y) {
  ax <- outer(x, from_x, "-")
  ay <- outer(y, from_y, "-")
  bx <- outer(x, to_x, "-")
  by <- outer(y, to_y, "-")
  twice_area <- ax * by - ay * bx
  along_x <- rep(to_x - from_x, each = length(x))
  along_y <- rep(to_y - from_y, each = length(x))
  ends <- along_x * (ax / sqrt(ax^2 + ay^2) - bx / sqrt(bx^2 + by^2)) +
    along_y * (ay / sqrt(ax^2 + ay^2) - by / sqrt(bx^2 + by^2))
  ifelse(abs(twice_area) < 1e-12, 0, ends / (4 * pi * twice_area))
}

# Midpoints of n x m equal panels of a plate of chord 1 and a span, with half their sides.
panels_of <- function(span, n, m) {
  middle <- expand.grid(x = (seq_len(n) - 0.5) / n - 0.5, y = ((seq_len(m) - 0.5) / m - 0.5) * span)
  c(middle, list(dx = 0.5 / n, dy = 0.5 * span / m))
}

# Added mass across the plate and its moments about the two axes in it, divided by the water's
# density.
mesh_added_mass <- function(span, n) {
  p <- panels_of(span, n, n)
  left <- p$y - p$dy
  right <- p$y + p$dy
  fore <- p$x - p$dx
  aft <- p$x + p$dx
  rings <- across_by_vortices(p$x, p$y, fore, left, aft, left) +
    across_by_vortices(p$x, p$y, aft, left, aft, right) +
    across_by_vortices(p$x, p$y, aft, right, fore, right) +
    across_by_vortices(p$x, p$y, fore, right, fore, left)
  motions <- cbind(1, p$x, p$y)
  abs(colSums(solve(rings, motions) * motions)) * 4 * p$dx * p$dy
}

# Force and moments (rows: across the plate, about the span, about the chord) over 1/2 rho U^2 S.
# Columns: attack and rotation rates in a steady flow. Horseshoe vortices are at a quarter of every
# panel's chord.
mesh_forces <- function(span, n, m) {
  p <- panels_of(span, n, m)
  bound <- p$x - p$dx / 2
  met <- p$x + p$dx / 2
  far <- rep(1e6, length(bound))
  horseshoes <- across_by_vortices(met, p$y, far, p$y - p$dy, bound, p$y - p$dy) +
    across_by_vortices(met, p$y, bound, p$y - p$dy, bound, p$y + p$dy) +
    across_by_vortices(met, p$y, bound, p$y + p$dy, far, p$y + p$dy)
  load <- 4 * p$dy * solve(horseshoes, cbind(1, met, p$y)) / span
  abs(rbind(colSums(load), colSums(load * bound), colSums(load * p$y)))
}

test_that("plate added mass equals DNV-RP-C205", {
  # C_A = 0.757 for sides of 2:1: 0.757 rho pi/4 c^2 b.
  expect_equal(1025 * plate_added_volume(2.45, 4.9), 0.757 * 1025 * pi / 4 * 2.45^2 * 4.9)
  expect_equal(plate_added_volume(1, 3), plate_added_volume(3, 1))
})

test_that("plate added masses equal a vortex-mesh model", {
  for (span in c(1, 2, 4)) {
    # The error is proportional to the panel size; extrapolation leaves 1 % with 16 panels a side.
    found <- 2 * mesh_added_mass(span, 16) - mesh_added_mass(span, 8)
    radii <- plate_added_radii(1, span)
    expect_equal(plate_added_volume(1, span), found[1], tolerance = 0.01)
    expect_equal(radii[["chord"]]^2, found[2] / found[1], tolerance = 0.03)
    expect_equal(radii[["span"]]^2, found[3] / found[1], tolerance = 0.03)
  }
  expect_equal(rev(plate_added_radii(1, 3)), plate_added_radii(3, 1), ignore_attr = TRUE)
})

test_that("forces on rotating plates equal a vortex-mesh model and theory", {
  of <- function(column, ratio) at_ratio(plate_turning, column, ratio)
  for (ratio in c(0.5, 1, 2, 4)) {
    found <- 2 * mesh_forces(ratio, 12, 24) - mesh_forces(ratio, 6, 12)
    expect_equal(of("slope", ratio), found[[1, 1]], tolerance = 0.01)
    expect_equal(of("yaw", ratio), found[[2, 2]], tolerance = 0.03)
    expect_equal(of("roll", ratio), found[[3, 3]] / ratio^2, tolerance = 0.02)
    # By the reverse-flow theorem, the force by rotation equals the moment by attack.
    expect_equal(found[[1, 2]], found[[2, 1]], tolerance = 1e-6)
  }
  # Slender wings: Jones 1946, Ribner 1947. The next term has the order of the ratio squared.
  expect_equal(of("slope", 0.25), pi / 2 * 0.25, tolerance = 0.02)
  expect_equal(of("roll", 0.25), pi / 64 * 0.25, tolerance = 0.02)
  # Helmbold's formula, within its known error of 7 %.
  ratio <- plate_turning$ratio
  expect_equal(plate_turning$slope, 2 * pi * ratio / (2 + sqrt(ratio^2 + 4)), tolerance = 0.07)
})
