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

# ... as JSON, with the unit of every field that a row of a class gives.
catalogue_json <- function() {
  fields <- lapply(picked_fields, function(columns) {
    lapply(columns, function(column) first_of(as.list(picked_units)[[column]], ""))
  })
  escape_json(as.character(jsonlite::toJSON(
    list(things = offered_catalogue(), fields = fields), auto_unbox = TRUE
  )))
}

# Rows of their own that a page may have.
most_own_rows <- 100L

# Rows that a page's user made, as offered_catalogue() has them; of two of a class and a name the
# last. given: a list of list(class, title, values), as a page sends them, which may be anything.
own_rows <- function(given) {
  rows <- lapply(as.list(given), function(row) own_row(as.list(row)))
  keys <- vapply(rows, function(row) paste(row$class, row$title), "")
  rows <- rows[!duplicated(keys, fromLast = TRUE)]
  if (length(rows) > most_own_rows) abort_argument("A page has at most {most_own_rows} own rows.")
  rows
}

own_row <- function(given) {
  columns <- if (is_text(given$class)) picked_fields[[given$class]]
  if (is.null(columns)) abort_argument("A row is of one of {.val {names(picked_fields)}}.")
  title <- design_name(given$title, "")
  if (!nzchar(title)) abort_argument("A row has a name.")
  values <- as.list(given$values)
  values <- values[intersect(names(columns), names(values))]
  values <- Filter(function(value) !is_text(value) || nzchar(trimws(value)), values)
  if (!length(values)) abort_argument("A row has at least one figure.")
  list(
    class = given$class, title = title, says = "",
    values = Map(own_value, values, names(values), columns[names(values)]), source = "own"
  )
}

# A figure of an own row, with its unit.
own_value <- function(text, name, column) {
  words <- gsub("_", " ", name, fixed = TRUE)
  if (!is_text(text) || nchar(text) > most_name) abort_argument("The {words} is a short text.")
  if (column == "material") return(trimws(text))
  like <- trimws(paste("1", stats::na.omit(picked_units[column])))
  value <- trimws(typed_quantity(text, like))
  dimension <- first_of(stats::na.omit(quantity_dimension(like)), "number")
  si <- tryCatch(quantity_si(value, dimension), error = function(e) NA)
  if (!isTRUE(si >= 0 && is.finite(si))) {
    abort_argument("The {words} is {.val {text}}; it must be a number such as {.val {like}}.")
  }
  value
}
