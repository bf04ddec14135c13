# R session in which tools/examples.R runs the R code of a document (example.R).

# Examples may install only packages that DESCRIPTION lists.
assign("install.packages", function(packages) {
  known <- utils::packageDescription("codend", fields = c("Imports", "Suggests"))
  stopifnot(packages %in% unlist(strsplit(unlist(known), "[ ,\n]+")))
})

source("example.R", echo = TRUE, max.deparse.length = Inf, spaced = FALSE)
