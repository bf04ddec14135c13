# Writes pages of view_3d() for save.test.js and gallery.js.
#
#   Rscript view.R FOLDER NODES GEAR...   a page of each settled gear (NODES 0: see gallery.R)
#   Rscript view.R FOLDER tow GEAR        a page of a tow of ten seconds
library(codend)
here <- dirname(sub("^--file=", "", grep("^--file=", commandArgs(), value = TRUE)))
source(file.path(here, "gallery.R"))
arguments <- commandArgs(TRUE)
for (name in arguments[-(1:2)]) {
  shown <- if (arguments[2] == "tow") {
    tow(settle(name, nodes = 300), until = "10 s", every = "1 s")
  } else if (arguments[2] == "0") {
    gallery_state(name)
  } else {
    settle(name, nodes = as.integer(arguments[2]))
  }
  view_3d(shown, file.path(arguments[1], paste0(name, ".html")))
}
