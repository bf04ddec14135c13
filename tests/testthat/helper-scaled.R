# Gears in scaled units, or in a rotated and translated frame.

# Exponents of length, time and mass in each dimension of a plan.
exponents <- list(
  length = c(1, 0, 0), area = c(2, 0, 0), volume = c(3, 0, 0), mass = c(0, 0, 1),
  force = c(1, -2, 1), speed = c(1, -1, 0), density = c(-3, 0, 1), mass_per_length = c(-1, 0, 1),
  bending_stiffness = c(3, -2, 1), viscosity = c(2, -1, 0), stress = c(-1, -2, 1),
  angle = c(0, 0, 0), time = c(0, 1, 0), number = c(0, 0, 0)
)

# Exponents of length, time and mass in each unit of measures.
unit_exponents <- list(
  m = c(1, 0, 0), m2 = c(2, 0, 0), m3 = c(3, 0, 0), mm = c(1, 0, 0), kN = c(1, -2, 1),
  N = c(1, -2, 1), deg = c(0, 0, 0), "%" = c(0, 0, 0), kW = c(2, -3, 1), "m3/h" = c(3, -1, 0),
  "km2/h" = c(2, -1, 0), "m/s" = c(1, -1, 0)
)

# Returns checked fields with every quantity times scale^exponents. Keeps the fields of `given`, a
# plan, and adds the quantities that the plan leaves to the schema's defaults.
scaled_fields <- function(value, node, given, scale) {
  factor <- function(node) prod(scale^exponents[[node[["x-dimension"]]]])
  switch(node$shape,
    quantity = value * factor(node),
    object = {
      for (name in names(value)) {
        below <- first_of(node$properties[[name]], node$additionalProperties)
        has_unit <- below$shape == "quantity" && below[["x-dimension"]] != "number"
        written <- name %in% names(given) || below$shape == "object" ||
          (has_unit && value[[name]] != 0)
        value[name] <- if (written) {
          list(scaled_fields(value[[name]], below, given[[name]], scale))
        }
      }
      value
    },
    array = if (is.list(value)) {
      Map(scaled_fields, value, list(node$items), given, list(scale))
    } else if (node$items$shape == "quantity") {
      value * factor(node$items)
    } else {
      value
    },
    any = scaled_fields(value, choose_node(value, node, ""), given, scale),
    value
  )
}

# Returns a gear as an assembly in other units. Stiffness, mass and density of its materials, and
# the ground's stiffness (Pa/m) and slip distance, become fields of the plan, so that all scale.
#
# scale: factors of length, time and mass.
gear_in_units <- function(gear, scale) {
  whole <- gear_checked(gear)
  given <- first_of(whole$tree, whole$plan)
  fields <- whole$assembly
  si <- whole$si
  own_material <- function(name) {
    scaled <- paste0(name, "_scaled")
    density <- find_material(name, fields$materials, "")[["density"]]
    fields$materials[[scaled]] <<- c(list(density = density, modulus = 1),
      fields$materials[[name]]["coefficients"])
    given$materials[[scaled]] <<- fields$materials[[scaled]]
    scaled
  }
  made_of <- function(line, numbers, count = 1) {
    if (!is.null(line$material)) line$material <- own_material(line$material)
    line$mass_per_length <- numbers$mass_per_length / count
    if (is.null(line$load_by_elongation)) line$axial_stiffness <- numbers$axial_stiffness / count
    line
  }
  for (name in names(fields$ropes)) {
    fields$ropes[[name]] <- made_of(fields$ropes[[name]], si$ropes[[name]])
    given$ropes[[name]][c("mass_per_length", "axial_stiffness")] <- 1
  }
  for (name in names(fields$panels)) {
    fields$panels[[name]]$twine <- made_of(
      fields$panels[[name]]$twine, si$panels[[name]], si$panels[[name]]$twine_count
    )
  }
  fields$materials <- lapply(fields$materials, function(material) Filter(length, material))
  out <- scaled_fields(fields, kind_node("assembly"), given, scale)
  out$kind <- "assembly"
  for (name in names(si$otter_boards)) {
    out$otter_boards[[name]]$shoe_area <- 2 * si$otter_boards[[name]]$shoe_area * scale[1]^2
  }
  if (!is.null(si$ground)) {
    out$seabed$stiffness <- si$ground$stiffness * prod(scale^c(-2, -2, 1))
    out$seabed$slip_distance <- si$ground$slip_distance * scale[1]
  }
  as_gear(out[setdiff(names(out), c("method", "vessel"))])
}

# Factors of length, time and mass for a length ratio: Froude's scaling. `density`: ratio of the
# densities of water and materials.
froude <- function(length, density = 1) c(length, sqrt(length), density * length^3)

# Returns an assembly in a frame rotated about z by `angle` (rad) and moved by `move` (m).
moved_gear <- function(gear, angle, move) {
  plan <- gear$plan
  turn <- matrix(c(cos(angle), sin(angle), 0, -sin(angle), cos(angle), 0, 0, 0, 1), 3)
  plan$points <- lapply(plan$points, function(point) {
    for (field in intersect(c("position", "near"), names(point))) {
      point[[field]] <- drop(turn %*% unlist(point[[field]])) + c(move, 0)
    }
    if (!is.null(point$load)) point$load <- drop(turn %*% unlist(point$load))
    point
  })
  current <- plan$water$current
  turned <- function(layer) {
    layer$toward <- layer$toward + angle
    layer
  }
  plan$water$current <- if (is.null(names(current))) lapply(current, turned) else turned(current)
  as_gear(plan)
}

# Expects the measures of `now` to equal the scaled measures of `then` within 1e-6. Measures that
# are zero except for rounding (below 1e-9 of the largest in their unit) are left out.
expect_scaled <- function(now, then, scale, label) {
  was <- as.data.frame(measures(then))
  is <- as.data.frame(measures(now))
  factor <- vapply(unit_exponents[was$unit], function(e) prod(scale^e), 0)
  largest <- ave(abs(was$value), was$unit, FUN = max)
  counts <- abs(was$value) > 1e-9 * largest
  off <- abs(is$value / factor / was$value - 1)[counts]
  worst <- which.max(off)
  expect_lt(off[worst], 1e-6, label = paste(label, was$measure[counts][worst]))
}
