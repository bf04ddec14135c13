# Computes the quick cases of the validation book and compares their errors with stored errors.
#   Rscript tests/ratchets/accuracy.R           compares with accuracy.csv
#   Rscript tests/ratchets/accuracy.R --accept  stores the errors
# `error_percent` is the mean size of the errors of a quantity.
source("tools/ratchet.R")
suppressPackageStartupMessages(library(codend))

book <- new.env(parent = asNamespace("codend"))
for (file in c("validation/manifest.R", "validation/judge.R",
  list.files("validation/cases", "\\.R$", full.names = TRUE))) sys.source(file, book)
manifest <- book$read_manifest("validation/manifest.yaml")
# Two tows of a purse seine take as long as all other cases.
quick <- setdiff(names(manifest), "java_seine")

rows <- do.call(rbind, lapply(quick, function(id) {
  before <- sum(proc.time()[1:2])
  rows <- suppressWarnings(book[[book$runner(id)]]())
  message(sprintf("%-30s %5.1f s", id, sum(proc.time()[1:2]) - before))
  cbind(case = id, rows)
}))
judged <- book$judge(rows, manifest)
judged <- judged[judged$kind == "quantity", ]
table <- data.frame(case = judged$case, quantity = judged$quantity,
  error_percent = signif(judged$misfit, 6))
# Without the engine's kernels for AVX2 and AVX-512, errors differ by up to 3 %. The absolute
# tolerance is for exact cases, whose errors are rounding alone.
ratchet(table, "tests/ratchets/accuracy.csv", c("case", "quantity"),
  list(error_percent = lower(relative = 0.05, absolute = 1e-4)))
