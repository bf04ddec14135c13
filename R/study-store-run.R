#' Studies on disk
#'
#' What [vary()] writes to a `store`, for those who run a study by other means: on a cluster without
#' R where jobs are handed in, or from a shell. Any number of tasks may run at the same time, on any
#' number of machines that see the folder.
#'
#' @details
#' Several processes that run the same designs share them: each design is settled by one of them.
#' What a process was settling as it ended, another settles last. A store is never made in place of
#' another file or folder.
#'
#' A job array of Slurm, after `codend study new boards.study PLAN --designs designs.csv`:
#'
#' ```sh
#' #!/bin/sh
#' #SBATCH --array=1-40
#' codend study run boards.study --task $SLURM_ARRAY_TASK_ID --of 40
#' ```
#'
#' `codend study status boards.study` says how far it is, `codend study table boards.study` gives
#' what is done as CSV. The same array again runs what is missing. A task is best a minute or more:
#' handing in a job takes some seconds.
#'
#' @param gear,nodes,netting As in [vary()].
#' @param designs From [designs()].
#' @param store The folder of the study. It lies where all machines see it, not on one's own disk.
#' @param task,of Which of how many tasks: design `k` is in task `(k - 1) %% of + 1`.
#' @return `write_study()` gives `store`, invisibly; `run_study()` how many designs it ran,
#'   invisibly: those of the task that no other process had done. `read_study()` gives what
#'   [vary()] does,
#'   of the designs that are done. `study_status()` gives a list of class `codend_study_status`:
#'   `designs`, `done`, `settled`, `warned`, `last` (when the last row was written) and `problems`,
#'   a table of why designs did not settle.
#'
#'   A folder that is no study is an error of class `codend_error_file`. A damaged row is left out
#'   with a warning of class `codend_warning_study`.
#' @name studies
#' @examplesIf requireNamespace("RNetCDF", quietly = TRUE)
#' store <- tempfile(fileext = ".study")
#' write_study("towed_cable", designs(towing.speed = paste(3:6, "knot")), store)
#' run_study(store, task = 1, of = 2)
#' study_status(store)
#' run_study(store)
#' read_study(store)[1:4]
NULL

#' @rdname studies
#' @export
write_study <- function(gear, designs, store, nodes = 1500, netting = NULL) {
  check_given("gear", "designs", "store")
  study <- new_study(gear, list(designs), nodes, netting)
  create_store(study, store)
  invisible(store)
}

#' @rdname studies
#' @export
run_study <- function(store, task = 1, of = 1) {
  check_given("store")
  check_count("of", of, 1)
  check_count("task", task, 1)
  if (task > of) abort_argument("{.arg task} is {task}, of {of} task{?s}.")
  read_store_text(store)
  all <- seq_len(nrow(open_store(store)$study$designs))
  mine <- setdiff(all[(all - 1) %% of == task - 1], designs_done(store))
  if (!length(mine)) return(invisible(0L))
  invisible(run_task(store, mine, study_progress(length(mine))))
}

#' @rdname studies
#' @export
read_study <- function(store) {
  check_given("store")
  read_store_text(store)
  study_table(open_study(store), read_rows(stored_rows(store)))
}

# The study of a store without its state.
open_study <- function(store) {
  mark <- c(store = normalizePath(store), mark = store_mark(store))
  if (identical(opened_store$mark, mark)) opened_store$study else read_store(store)
}

#' @rdname studies
#' @export
study_status <- function(store) {
  check_given("store")
  read_store_text(store)
  rows <- read_rows(stored_rows(store))
  times <- file.mtime(c(row_files(store), task_files(store)))
  problem <- rows$problem[!is.na(rows$problem)]
  counts <- sort(table(sub("(: after|, near|; ).*", "", problem)), decreasing = TRUE)
  structure(
    list(
      store = store, designs = nrow(open_study(store)$designs), done = length(rows$design),
      settled = sum(is.na(rows$problem)), warned = sum(!is.na(rows$warning)),
      last = if (length(times)) max(times, na.rm = TRUE),
      problems = data.frame(problem = as.character(names(counts)), designs = as.integer(counts))
    ),
    class = "codend_study_status"
  )
}

#' @export
print.codend_study_status <- function(x, ...) {
  cat(x$done, " of ", x$designs, " designs done, ", x$settled, " settled, ", x$warned,
    " with a warning\n", sep = "")
  if (!is.null(x$last)) cat("last row ", format(x$last, "%Y-%m-%d %H:%M:%S"), "\n", sep = "")
  if (nrow(x$problems)) {
    cat("not settled:\n", sprintf("  %d  %s\n", x$problems$designs, x$problems$problem), sep = "")
  }
  invisible(x)
}
