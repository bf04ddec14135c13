# Added mass and damping moments of a rectangular plate that moves or turns. Added mass does not
# depend on which side meets the flow; its tables therefore use the shorter and longer side.
#
# The coefficients of the first table are from DNV. All others were computed with a vortex lattice
# method: vortex rings, and horseshoe vortices in a steady flow (J. Katz and A. Plotkin, Low-Speed
# Aerodynamics, 2001, ch. 12). Two or three resolutions were extrapolated to the limit; the error is
# about 1 %. The method reproduces DNV's coefficients to 1 %, and the analytical solutions quoted
# with the tables for narrow and for wide plates. tests/testthat/test-plate-coefficients.R contains
# the method.

# Added mass of a rectangular plate normal to its face, over rho pi/4 c^2 b. c: shorter side; b:
# longer side; ratio = b/c (DNV-RP-C205, table D-2).
plate_added_mass <- data.frame(
  ratio = c(1, 1.25, 1.59, 2, 2.5, 3.17, 4, 5, 6.25, 8, 10),
  coefficient = c(0.579, 0.642, 0.690, 0.757, 0.801, 0.840, 0.872, 0.897, 0.917, 0.934, 0.947)
)

# Squared radii of the added mass of a turning plate, by b/c: along the shorter side over c^2/32,
# along the longer side over b^2/12. Both are 1 for a long plate (two-dimensional solution of an
# ellipse of zero thickness, and strip theory).
plate_added_radius <- data.frame(
  ratio = c(1, 2, 4, 10), shorter = c(1.41, 1.20, 1.10, 1.04),
  longer = c(0.530, 0.655, 0.786, 0.907)
)

# Thin plate in a steady flow, by the ratio of span to chord:
# `slope`: normal force over 1/2 rho U^2 S, per rad of attack.
# `yaw`: moment about mid-chord at a yaw rate q, over 1/2 rho U S c^2 q.
# `roll`: moment about the chord at a roll rate p, over 1/2 rho U S s^2 p.
#
# Limits for narrow plates: pi/2 ratio and pi/64 ratio (R. T. Jones, NACA Report 835, 1946; H. S.
# Ribner, NACA TN 1423, 1947).
plate_turning <- data.frame(
  ratio = c(0.25, 0.5, 0.75, 1, 1.5, 2, 3, 4, 6),
  slope = c(0.392, 0.774, 1.133, 1.461, 2.023, 2.476, 3.148, 3.616, 4.221),
  yaw = c(0.0765, 0.1163, 0.1355, 0.1437, 0.1458, 0.1406, 0.1262, 0.1129, 0.0929),
  roll = c(0.0123, 0.0246, 0.0369, 0.0490, 0.0728, 0.0951, 0.135, 0.169, 0.221)
)

# Interpolates a column at a ratio of sides; clamped at the ends of the table.
at_ratio <- function(table, column, ratio) {
  stats::approx(log(table$ratio), table[[column]], log(ratio), rule = 2)$y
}

# Returns the added volume (m3): added mass normal to the face over the density of water.
plate_added_volume <- function(chord, span) {
  short <- min(chord, span)
  long <- max(chord, span)
  coefficient <- stats::approx(
    plate_added_mass$ratio, plate_added_mass$coefficient, long / short, rule = 2
  )$y
  coefficient * pi / 4 * short^2 * long
}

# Returns the radii of gyration (m) of the added mass along chord and span.
plate_added_radii <- function(chord, span) {
  short <- min(chord, span)
  long <- max(chord, span)
  shorter <- short * sqrt(at_ratio(plate_added_radius, "shorter", long / short) / 32)
  longer <- long * sqrt(at_ratio(plate_added_radius, "longer", long / short) / 12)
  if (chord <= span) c(chord = shorter, span = longer) else c(chord = longer, span = shorter)
}

# Returns the second moments of mass (kg m2) about the centre of gravity, by axis, for a plate of
# uniform thickness. Along chord and span the plate is straight. Across it is an arc with a camber
# of 12 % (8/15 - 4/9 times the squared camber).
plate_second_moment <- function(mass, chord, span) {
  mass * c(chord^2 / 12, (8 / 15 - 4 / 9) * (0.12 * chord)^2, span^2 / 12)
}
