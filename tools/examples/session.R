# The R session in which tools/examples.R runs the blocks of R of a document, example.R.

# A block that installs packages must name packages that DESCRIPTION names.
assign("install.packages", function(packages) {
  known <- utils::packageDescription("codend", fields = c("Imports", "Suggests"))
  stopifnot(packages %in% unlist(strsplit(unlist(known), "[ ,\n]+")))
})
# The live tank ends as soon as a browser would open.
options(shiny.launch.browser = function(url) later::later(shiny::stopApp))

source("example.R", echo = TRUE, max.deparse.length = Inf, spaced = FALSE)
