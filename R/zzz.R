# Declares names after `$` in codend's code, because R CMD check mistakes them for variables.

names_after_dollar <- function(e) {
  if (is.function(e)) e <- call("{", formals(e), body(e))
  if (!is.call(e) && !is.pairlist(e)) return(NULL)
  own <- if (identical(e[[1L]], as.name("$"))) as.character(e[[3L]])
  c(own, unlist(lapply(e, names_after_dollar)))
}

utils::globalVariables(unique(unlist(
  lapply(mget(ls(topenv(), all.names = TRUE), topenv()), names_after_dollar)
)))

# Byte code is three times as large as its function. DESCRIPTION therefore leaves functions to R,
# which compiles them at their second call, except functions that nearly every session calls.
#' @importFrom compiler cmpfun
NULL

for (name in intersect(compiled_functions, ls(topenv(), all.names = TRUE))) {
  assign(name, cmpfun(get(name), list(suppressAll = TRUE)))
}
rm(name)
