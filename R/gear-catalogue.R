#' Published data of boards, floats, twines, ropes, wires and chains
#'
#' Returns published properties of products and tested gear, ready to copy into a plan. Nothing is
#' estimated: a property that the source does not give is `NA`.
#'
#' @param class Character: one or several of `"board"`, `"float"`, `"twine"`, `"rope"`, `"wire"` and
#'   `"chain"`. Default `NULL`: all classes.
#' @return A data frame with one row per item. An unknown class is an error of class
#'   `codend_error_argument`. Columns:
#' \describe{
#'   \item{class, maker, item}{Product class, maker and product name.}
#'   \item{material}{Material as named in plans, if plans have that material.}
#'   \item{diameter_mm}{Diameter (mm); for a chain, the diameter of its bar.}
#'   \item{area_m2}{Area of one board (m2).}
#'   \item{mass_kg, mass_per_length_kg_m}{Mass in air (kg; kg/m).}
#'   \item{buoyancy_kgf}{Buoyancy in sea water (kgf).}
#'   \item{depth_m}{Rated depth of a float (m).}
#'   \item{strength_kN}{Breaking load (kN).}
#'   \item{rtex}{Resultant linear density of a twine (g/km).}
#'   \item{lift_coefficient, drag_coefficient}{Coefficients of a board or a float.}
#'   \item{note}{Remarks, for example vessels that use the product.}
#'   \item{source}{Publication or web page of the values.}
#' }
#' @seealso [new_plan()] to start a plan, [update()][update.codend_gear] to change its fields.
#' @examples
#' wires <- catalogue("wire")
#' head(wires[c("item", "diameter_mm", "mass_per_length_kg_m", "strength_kN")])
#' nearest <- wires[which.min(abs(wires$diameter_mm - 16)), ]
#' update(read_gear("small_midwater_trawl"),
#'   warps.mass_per_length = paste(nearest$mass_per_length_kg_m, "kg/m"))
#' @export
catalogue <- function(class = NULL) {
  table <- known_catalogue()
  classes <- unique(table$class)
  if (is.null(class)) return(table)
  wrong <- !is.character(class) || anyNA(class) || !all(class %in% classes)
  if (wrong) {
    abort_argument("{.arg class} must be one or several of {.val {classes}}, or NULL.")
  }
  table_rows(table, table$class %in% class)
}

known_catalogue <- remembered(function() {
  table <- package_table("catalogue.csv", na.strings = "")
  words <- c("class", "maker", "item", "material", "note", "source")
  numbers <- setdiff(names(table), words)
  table[numbers] <- lapply(table[numbers], as.double)
  table[words] <- lapply(table[words], as.character)
  table
})
