# Materials of ropes and twines. A rope is not a solid circle. Mass, stiffness and breaking load
# therefore refer to the square of its nominal diameter d:
# `density`: of the solid (kg/m3), which gives the displaced volume from the mass.
# `mass`: mass per length / d^2 (kg/m3).
# `stiffness`: EA / d^2 (Pa).
# `strength`: breaking load / d^2 (Pa).
#
# Sources:
# MoorPy: NREL MoorPy, library/MoorProps_default.yaml (leading terms in d^2).
# Wilson: twine law T = d^2 C1 e^C2 of Wilson (1967), nearly linear for polyethylene.
# EN 12385-4: 6x36 wire rope with steel core, grade 1770 (0.356 x 1770 MPa).
# Assumed: typical for the trade, without a publication.
gear_materials <- rbind(
  # 4.1 kg/m and EA = 48 MN at 32 mm, a typical trawl warp (assumed); strength EN 12385-4
  steel_wire = c(density = 7850, mass = 4004, stiffness = 46.9e9, strength = 630e6),
  # MoorPy, studless chain; d is the diameter of the bar
  steel_chain = c(7850, 20000, 85.6e9, 1.21e9),
  # mass and strength assumed from laid rope; stiffness Wilson
  polyethylene = c(950, 480, 345e6, 87e6),
  # MoorPy
  polyamide = c(1140, 585, 5 * 207e6, 207e6),
  # MoorPy
  polyester = c(1380, 679, 14 * 308e6, 308e6),
  # assumed
  polypropylene = c(910, 450, 1.06e9, 133e6),
  # MoorPy
  hmpe = c(975, 496, 56 * 580e6, 580e6),
  # steel core under fibre, assumed
  combination_rope = c(2250, 1100, 11.8e9, 216e6)
)

# ISO 1346 and trade abbreviations.
material_abbreviations <- c(
  PE = "polyethylene", PA = "polyamide", PES = "polyester", PP = "polypropylene", HMPE = "hmpe"
)

# Trade names for hints in errors. Plans use the names above.
material_trade_names <- c(
  nylon = "PA", perlon = "PA", kapron = "PA", courlene = "PE", polythene = "PE",
  polyethene = "PE", nymplex = "PE", hdpe = "PE", terylene = "PES",
  dacron = "PES", trevira = "PES", tergal = "PES", polysteel = "PP",
  dyneema = "HMPE", spectra = "HMPE", uhmwpe = "HMPE", steel = "steel_wire", wire = "steel_wire",
  wire_rope = "steel_wire", chain = "steel_chain", iron = "steel_chain",
  combination = "combination_rope", compound = "combination_rope", taifun = "combination_rope"
)

# Returns the known material with a similar name or this trade name, or NULL.
material_meant <- function(name, known) {
  word <- gsub("[ -]+", "_", tolower(name))
  if (word %in% names(material_trade_names)) return(material_trade_names[[word]])
  nearest(name, known)
}

# Returns the row of `gear_materials` for a name, or of the plan's own materials (solid circles).
find_material <- function(name, own, path) {
  if (!is.null(own[[name]])) {
    given <- own[[name]]
    strength <- if (is.null(given$strength)) NA_real_ else given$strength
    circle <- pi / 4
    return(c(
      density = given$density, mass = given$density * circle,
      stiffness = given$modulus * circle, strength = strength * circle
    ))
  }
  if (name %in% names(material_abbreviations)) name <- material_abbreviations[[name]]
  if (!name %in% rownames(gear_materials)) {
    known <- c(names(own), rownames(gear_materials), names(material_abbreviations))
    abort_field(path, name, paste("one of", word_list(known)), hint = material_meant(name, known))
  }
  gear_materials[name, ]
}

# Returns mass, volume, stiffness, damping and strength of a rope or twine with a diameter. Explicit
# values take precedence over the material's. The displaced volume equals the solid material, or the
# full circle if no material is given.
line_properties <- function(given, own, path) {
  material <- if (!is.null(given$material)) {
    find_material(given$material, own, join(path, "material"))
  } else {
    c(density = NA_real_, mass = NA_real_, stiffness = NA_real_, strength = NA_real_)
  }
  square <- given$diameter^2
  mass <- first_of(given$mass_per_length, material[["mass"]] * square)
  volume <- if (is.null(given$material)) {
    pi / 4 * square
  } else {
    mass / material[["density"]]
  }
  table <- load_table(given, path)
  stiffness <- if (is.null(table)) {
    first_of(given$axial_stiffness, material[["stiffness"]] * square)
  } else {
    table$load[1L] / table$strain[1L]
  }
  list(
    axial_stiffness = stiffness, load_table = table,
    # Damping by strain rate, per length of a bar: see elements/twine.hpp.
    damping = given$damping_ratio * sqrt(stiffness * mass),
    mass_per_length = mass,
    volume_per_length = first_of(given$volume_per_length, volume),
    strength = first_of(given$strength, material[["strength"]] * square)
  )
}

# Returns the load curve of a rope or twine in the plan: list(strain, load (N)), or NULL.
load_table <- function(given, path) {
  rows <- given$load_by_elongation
  if (is.null(rows)) return(NULL)
  path <- join(path, "load_by_elongation")
  if (!is.null(given$axial_stiffness)) {
    abort_plan(sprintf(
      "Plan field `%s` is given together with `axial_stiffness`; remove one.", path
    ), path, rows)
  }
  table <- list(
    strain = vapply(rows, `[[`, 0, "elongation"), load = vapply(rows, `[[`, 0, "load")
  )
  for (row in seq_along(rows)[-1L]) {
    if (all(vapply(table, function(column) column[row] > column[row - 1L], NA))) next
    abort_field(sprintf("%s.%d", path, row), rows[[row]],
      "a greater elongation and load than the row before")
  }
  table
}

# Returns the factor on normal drag of a line with strumming: 1 + 1.043 (2 Y/d)^0.65. `amplitude` is
# Y/d, root mean square amplitude over diameter (J. K. Vandiver, Drag coefficients of long flexible
# cylinders, Offshore Technology Conference, OTC 4490, 1983).
strumming_factor <- function(amplitude) if (amplitude > 0) 1 + 1.043 * (2 * amplitude)^0.65 else 1

# Returns the drag coefficients of a line with strumming.
strummed <- function(law, amplitude, path) {
  if (is.null(amplitude) || amplitude == 0) return(law)
  if (law$law != "constant") {
    abort_field(join(path, "strumming"), amplitude,
      "omitted if coefficients depend on the Reynolds number; give the rope `coefficients`")
  }
  law$normal <- law$normal * strumming_factor(amplitude)
  law
}
