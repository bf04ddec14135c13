# Copies the guides knitted by `make guides` into package sources, as R CMD build does.
#   Rscript tools/guides.R KNITTED FOLDER

knitted <- normalizePath(commandArgs(TRUE)[1L])
setwd(commandArgs(TRUE)[2L])
dir.create(file.path("inst", "doc"))
for (guide in list.files(knitted, "[.]Rmd$", full.names = TRUE)) {
  rmarkdown::render(guide, output_dir = "vignettes", quiet = TRUE)
}
guides <- tools::pkgVignettes(dir = ".", output = TRUE)
invisible(file.copy(guides$docs, file.path("inst", "doc")))
invisible(file.rename(guides$outputs, file.path("inst", "doc", basename(guides$outputs))))
dir.create("build")
saveRDS(tools:::.build_vignette_index(guides), file.path("build", "vignette.rds"), version = 2L)
