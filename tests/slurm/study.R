# Settles fifty gears through Slurm, with future.batchtools jobs and with a job array of the command
# line:
#   with-slurm Rscript study.R
# Fails unless both return the bytes of this process alone.
library(codend)
stopifnot(requireNamespace("future.batchtools"))

folder <- tempfile("slurm-")
dir.create(folder)
setwd(folder)
gears <- designs(towing.speed = value_range("3 knot", "5 knot"),
  ropes.cable.length = normal_value("1000 m",
  "100 m"), how = "latin", number = 50, seed = 3)
alone <- vary("towed_cable", gears)
stopifnot(nrow(alone) == 50L, all(alone$settled))

future::plan(future.batchtools::batchtools_slurm,
  template = system.file("slurm.tmpl", package = "codend"))
seconds <- system.time(jobs <- vary("towed_cable", gears, store = "jobs.study", tasks = 3))
stopifnot(identical(jobs, alone))
cat(sprintf("future.batchtools: 50 designs in 3 jobs, %.1f s\n", seconds[["elapsed"]]))
future::plan("sequential")

vary("towed_cable", gears, store = "array.study", tasks = 0)
codend <- Sys.which("codend")
if (!nzchar(codend)) codend <- system.file("exec", "codend", package = "codend")
script <- c("#!/bin/sh", "#SBATCH --array=1-4", "#SBATCH --output=array-%a.out", paste(
  "Rscript", shQuote(codend), "study run array.study --task $SLURM_ARRAY_TASK_ID --of 4"
))
writeLines(script, "array.sh")
seconds <- system.time(status <- system2("sbatch", c("--wait", "array.sh")))
if (status != 0L) writeLines(unlist(lapply(Sys.glob("array-*.out"), readLines)))
stopifnot(status == 0L, identical(read_result("array.study"), alone))
cat(sprintf("job array: 50 designs in 4 tasks, %.1f s\n", seconds[["elapsed"]]))
