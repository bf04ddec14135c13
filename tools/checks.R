# Checks of the sources that run no test of codend: style, layers, generated files. Each is a
# command that prints what is wrong and fails; the last line counts them as
# "N passed, N failed, N skipped".

checks <- c(
  "style of R (.lintr)" = "Rscript tools/check-style.R",
  "order of R's rooms" = "Rscript tools/check-layers.R",
  "format of C++ (.clang-format)" = "tools/check-format",
  "objects in src/Makevars; includes, words and headers of the engine" = "tools/check-engine.sh",
  "engine.wasm, where it is made, is of these sources" = "tools/wasm/check.sh",
  "schema of plans and its parts" = "make -s schema-check",
  "an example on every help page; help and guides grouped (_pkgdown.yml)" =
    "Rscript tools/check-help.R",
  "words of help, guides, README and NEWS (tools/words.csv)" = "Rscript tools/check-words.R",
  "help, NAMESPACE and the binding's registration in step" = "Rscript tools/check-generated.R"
)

passes <- function(name) {
  cat("checking", name, "... ")
  said <- suppressWarnings(system(paste(checks[[name]], "2>&1"), intern = TRUE))
  ok <- is.null(attr(said, "status"))
  cat(if (ok) "ok" else c("FAILED", paste0("  ", said)), sep = "\n")
  ok
}

ok <- vapply(names(checks), passes, NA)
cat(sprintf("%d passed, %d failed, 0 skipped\n", sum(ok), sum(!ok)))
quit(status = !all(ok))
