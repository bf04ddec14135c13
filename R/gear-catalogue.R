#' A catalogue of boards, floats, twines, ropes, wires and chains
#'
#' Figures of things that can be bought or were used, as they were published, to put into plans.
#' Nothing is estimated: what a source does not say is `NA`.
#'
#' @param class One or several of `"board"`, `"float"`, `"twine"`, `"rope"`, `"wire"`, `"chain"`, or
#'   `NULL` for all.
#' @return A data frame with a row for each thing:
#' \describe{
#'   \item{class, maker, item}{What it is.}
#'   \item{material}{As plans name it, where it is one of those.}
#'   \item{diameter_mm}{Of a chain that of its bar.}
#'   \item{area_m2}{Of one board.}
#'   \item{mass_kg, mass_per_length_kg_m}{In air.}
#'   \item{buoyancy_kgf}{In sea water.}
#'   \item{depth_m}{The depth that a float is made for.}
#'   \item{strength_kN}{Breaking load.}
#'   \item{rtex}{Of a twine, g/km.}
#'   \item{lift_coefficient, drag_coefficient}{Of a board or a float.}
#'   \item{note}{What else is to be known.}
#'   \item{source}{Where these figures were read.}
#' }
#' An unknown class is a `codend_error_argument`.
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
  file <- system.file("extdata", "catalogue.csv", package = "codend")
  table <- utils::read.csv(file, comment.char = "#", na.strings = "", encoding = "UTF-8")
  words <- c("class", "maker", "item", "material", "note", "source")
  numbers <- setdiff(names(table), words)
  table[numbers] <- lapply(table[numbers], as.double)
  table[words] <- lapply(table[words], as.character)
  table
})
