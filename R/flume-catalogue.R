# The catalogue in the flume tank: what of it fits which part of a plan, and what a pick changes.

# Fields of a plan that a thing of a class gives: columns of the catalogue by name.
picked_fields <- list(
  board = c(area = "area_m2", mass = "mass_kg", lift_coefficient = "lift_coefficient",
    drag_coefficient = "drag_coefficient"),
  float = c(diameter = "diameter_mm", buoyancy = "buoyancy_kgf",
    drag_coefficient = "drag_coefficient"),
  twine = c(diameter = "diameter_mm", material = "material", rtex = "rtex"),
  rope = c(diameter = "diameter_mm", material = "material",
    mass_per_length = "mass_per_length_kg_m", strength = "strength_kN")
)
picked_fields$wire <- picked_fields$chain <- picked_fields$rope

# Units of the catalogue's columns.
picked_units <- c(
  diameter_mm = "mm", area_m2 = "m2", mass_kg = "kg", mass_per_length_kg_m = "kg/m",
  buoyancy_kgf = "kgf", strength_kN = "kN"
)

# Classes of the catalogue that fit a part, by what its schema allows; none: character().
picked_classes <- function(node) {
  has <- function(...) all(c(...) %in% names(node$properties))
  if (has("lift_coefficient", "area", "mass")) return("board")
  if (has("buoyancy", "diameter")) return("float")
  if (has("rtex")) return("twine")
  if (has("mass_per_length", "material", "strength")) return(c("rope", "wire", "chain"))
  character()
}

# What a page offers: a list of list(class, title, says, values (texts of plan fields by name),
# source).
offered_catalogue <- remembered(function() {
  table <- catalogue()
  lapply(seq_len(nrow(table)), function(k) {
    row <- table[k, ]
    columns <- picked_fields[[row$class]]
    columns <- columns[!is.na(unlist(row[columns]))]
    values <- lapply(columns, function(column) {
      value <- row[[column]]
      if (is.character(value)) return(value)
      unit <- picked_units[column]
      trimws(paste(shortest_decimal(value), if (is.na(unit)) "" else unit))
    })
    about <- c(
      row$note, if (!is.na(row$depth_m)) paste("to", shortest_decimal(row$depth_m), "m deep")
    )
    list(
      class = row$class, title = paste(stats::na.omit(c(row$maker, row$item)), collapse = " "),
      says = paste(stats::na.omit(about), collapse = "; "), values = values, source = row$source
    )
  })
})

catalogue_json <- function() {
  escape_json(as.character(jsonlite::toJSON(offered_catalogue(), auto_unbox = TRUE)))
}
