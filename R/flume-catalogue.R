# The catalogue in the flume tank: rows that fit a part, and fields that a selected row sets.

# Plan fields that a row of each class sets: catalogue columns by field name.
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

picked_units <- c(
  diameter_mm = "mm", area_m2 = "m2", mass_kg = "kg", mass_per_length_kg_m = "kg/m",
  buoyancy_kgf = "kgf", strength_kN = "kN"
)

# Returns list(class, title, `says` (a note), values (strings by plan field), source) for each row.
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

# Adds the unit of each field that a class sets.
catalogue_lists <- function() {
  fields <- lapply(picked_fields, function(columns) {
    lapply(columns, function(column) first_of(as.list(picked_units)[[column]], ""))
  })
  list(things = offered_catalogue(), fields = fields)
}

most_own_rows <- 100L

# Returns user-defined rows as in offered_catalogue(). A later row replaces an earlier row of the
# same class and name. given: list of list(class, title, values) from a page, which may send
# anything.
own_rows <- function(given) {
  rows <- lapply(as.list(given), function(row) own_row(as.list(row)))
  keys <- vapply(rows, function(row) paste(row$class, row$title), "")
  rows <- rows[!duplicated(keys, fromLast = TRUE)]
  if (length(rows) > most_own_rows) {
    abort_argument("A page can have at most {most_own_rows} rows of your own.")
  }
  rows
}

own_row <- function(given) {
  columns <- if (is_text(given$class)) picked_fields[[given$class]]
  if (is.null(columns)) {
    abort_argument("The kind of a row must be one of {.val {names(picked_fields)}}.")
  }
  title <- design_name(given$title, "")
  if (!nzchar(title)) abort_argument("The row has no name; enter one.")
  values <- as.list(given$values)
  values <- values[intersect(names(columns), names(values))]
  values <- Filter(function(value) !is_text(value) || nzchar(trimws(value)), values)
  if (!length(values)) abort_argument("The row has no numbers; enter at least one.")
  list(
    class = given$class, title = title, says = "",
    values = Map(own_value, values, names(values), columns[names(values)]), source = "own"
  )
}

# Returns the value with its unit.
own_value <- function(text, name, column) {
  if (column == "material" && is_text(text) && nchar(text) <= most_name) return(trimws(text))
  like <- trimws(paste("1", stats::na.omit(picked_units[column])))
  found <- typed_number(text, like, gsub("_", " ", name, fixed = TRUE))
  if (found$si < 0) abort_argument("The {name} is {.val {text}}; it must be at least 0.")
  found$text
}
