#' @keywords internal
#' @useDynLib codend, .registration = TRUE
#' @importFrom stats setNames
"_PACKAGE"
