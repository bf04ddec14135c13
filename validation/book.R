# Entry point of `make validate`: computes every case of manifest.yaml and compares it with
# measurements or exact solutions. Writes the page book.md with its pictures and misfits.csv. Fails
# if a case contradicts the manifest (held, missed or tuned). README.md explains how to add a case.
#
#   Rscript validation/book.R              all cases
#   Rscript validation/book.R ID [ID ...]  these cases only, printed and not written
#   Rscript validation/book.R page         the page again from misfits.csv
suppressPackageStartupMessages(library(codend))

room <- new.env(parent = asNamespace("codend"))
for (file in c("validation/manifest.R", "validation/judge.R", "validation/page.R",
  list.files("validation/cases", "\\.R$", full.names = TRUE))) sys.source(file, room)

# Rows of one case: measured and computed values, and CPU seconds.
run_case <- function(case) {
  before <- sum(proc.time()[1:2])
  rows <- suppressWarnings(room[[room$runner(case$id)]]())
  cat(sprintf("%-30s %5.1f s\n", case$id, sum(proc.time()[1:2]) - before))
  cbind(case = case$id, rows)
}

wanted <- commandArgs(TRUE)
again <- identical(wanted, "page")
if (again) wanted <- character()
manifest <- room$read_manifest("validation/manifest.yaml")
unknown <- setdiff(wanted, names(manifest))
if (length(unknown)) stop("no such case: ", paste(unknown, collapse = ", "))
# cases are independent
workers <- min(2L, parallel::detectCores())
chosen <- if (length(wanted)) manifest[wanted] else manifest
rows <- if (again) {
  utils::read.csv("validation/misfits.csv")
} else {
  found <- suppressWarnings(parallel::mclapply(chosen, run_case, mc.cores = workers,
    mc.preschedule = FALSE))
  failed <- vapply(found, inherits, NA, "try-error")
  if (any(failed)) stop(names(found)[failed][1], ": ", found[failed][[1]])
  do.call(rbind, unname(found))
}
judged <- room$judge(rows, chosen)

if (length(wanted)) {
  print(rows, digits = 5, row.names = FALSE)
  print(judged[c("case", "quantity", "values", "bias", "misfit", "band", "found", "status")],
    digits = 3, row.names = FALSE)
} else {
  room$write_page(rows, judged, manifest, "validation")
}
wrong <- judged[judged$found != judged$status, ]
if (nrow(wrong)) {
  cat(sprintf("%s, %s: manifest has %s, result is %s\n", wrong$case, wrong$quantity, wrong$status,
    wrong$found), sep = "")
  quit(status = 1)
}
