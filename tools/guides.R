# Builds the guides of a package's sources, each in an R session of its own, with the installed
# codend, and puts them where R CMD build puts them. R CMD build itself uses one session for all
# guides, so a guide could use what an earlier one made or attached.
#   Rscript tools/guides.R FOLDER   prints the CPU seconds of each guide; fails if a guide fails

setwd(commandArgs(TRUE)[1L])
guides <- tools::pkgVignettes(dir = ".")
dir.create(file.path("inst", "doc"))
setwd("vignettes")
cpu <- function() sum(proc.time()[c("user.child", "sys.child")])
failed <- vapply(basename(guides$docs), function(file) {
  before <- cpu()
  call <- sprintf("tools::buildVignette('%s')", file)
  output <- suppressWarnings(system2(file.path(R.home("bin"), "Rscript"),
    c("--vanilla", "-e", shQuote(call)), stdout = TRUE, stderr = TRUE, stdin = "/dev/null"))
  failed <- !is.null(attr(output, "status"))
  cat(sprintf("%s %5.1f s  %s\n", if (failed) "FAILED" else "built ", cpu() - before, file))
  if (failed) cat(paste("   ", utils::tail(output, 40L)), sep = "\n")
  failed
}, NA)
if (any(failed)) quit(status = 1L)
setwd("..")
guides <- tools::pkgVignettes(dir = ".", output = TRUE, source = TRUE)
made <- c(guides$outputs, unlist(guides$sources))
invisible(file.copy(guides$docs, file.path("inst", "doc")))
invisible(file.rename(made, file.path("inst", "doc", basename(made))))
dir.create("build")
saveRDS(tools:::.build_vignette_index(guides), file.path("build", "vignette.rds"), version = 2L)
