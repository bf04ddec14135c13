# Writes R/zzz-compiled.R, the list of functions to compile when the package is installed. It runs a
# common session, in which R's own compiler selects the functions that are called more than once.
#   Rscript tools/compiled.R   takes a minute; run it after changes to commonly called functions

library(codend)
package <- asNamespace("codend")
names <- ls(package, all.names = TRUE)
names <- names[vapply(names, function(name) is.function(package[[name]]), NA)]
methods <- package[[".__S3MethodsTable__."]]

# Remove compiled code first: assigning an environment does so.
for (table in list(package, methods)) {
  for (name in intersect(ls(table, all.names = TRUE), names)) {
    plain <- table[[name]]
    environment(plain) <- environment(plain)
    if (bindingIsLocked(name, table)) unlockBinding(name, table)
    assign(name, plain, table)
  }
}

invisible(utils::capture.output({
  for (gear in gears()$name) {
    state <- settle(gear, nodes = 300)
    print(state)
    print(findings(state))
  }
}))

compiled <- function(name) {
  found <- c(package[[name]], methods[[name]])
  any(vapply(found, function(f) any(grepl("^<bytecode", utils::capture.output(print(f)))), NA))
}
listed <- sort(names[vapply(names, compiled, NA)], method = "radix")
lines <- strwrap(toString(dQuote(listed, FALSE)), 98, indent = 2, exdent = 2)
writeLines(c(
  "# Written by tools/compiled.R; do not edit.", "", "compiled_functions <- c(", lines, ")"
), "R/zzz-compiled.R")
