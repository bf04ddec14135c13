# Returns a table of the package, a CSV file in inst/extdata. Constants of the package read their
# tables when the package is built.
package_table <- function(name, ...) {
  file <- system.file("extdata", name, package = "codend", mustWork = TRUE)
  utils::read.csv(file, comment.char = "#", encoding = "UTF-8", ...)
}
