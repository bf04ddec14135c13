# Materials of ropes and twines (inst/extdata/materials.csv) and their abbreviations of ISO 1346 and
# the trade. Trade names are for hints in errors; plans use the other names.
material_table <- package_table("materials.csv")
gear_materials <- as.matrix(material_table[c("density", "mass", "stiffness", "strength")])
rownames(gear_materials) <- material_table$name
material_abbreviations <- local({
  short <- material_table[nzchar(material_table$abbreviation), ]
  setNames(short$name, short$abbreviation)
})
material_trade_names <- local({
  names <- strsplit(material_table$trade_names, " ", fixed = TRUE)
  plain <- ifelse(nzchar(material_table$abbreviation), material_table$abbreviation,
    material_table$name)
  setNames(rep(plain, lengths(names)), unlist(names))
})

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
    abort_field(path, rows, NULL, "is given together with `axial_stiffness`; remove one")
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

# Returns the drag coefficients of a line with strumming. It multiplies the normal drag by 1 + 1.043
# (2 Y/d)^0.65. `amplitude` is Y/d, root mean square amplitude over diameter (J. K. Vandiver, Drag
# coefficients of long flexible cylinders, Offshore Technology Conference, OTC 4490, 1983).
strummed <- function(law, amplitude, path) {
  if (is.null(amplitude) || amplitude == 0) return(law)
  if (law$law != "constant") {
    abort_field(join(path, "strumming"), amplitude,
      "omitted if coefficients depend on the Reynolds number; give the rope `coefficients`")
  }
  law$normal <- law$normal * (1 + 1.043 * (2 * amplitude)^0.65)
  law
}
