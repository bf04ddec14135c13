#' Run a study on disk
#'
#' `run_study()` settles designs in the `store` of a study that [vary()] created with `tasks = 0`:
#' in jobs of a cluster without R on its login node, or from a shell. Any number of tasks can run
#' simultaneously on any number of machines with access to the folder. [read_result()] reads the
#' finished designs.
#'
#' - Processes that run the same designs share the work: each design is settled by one process.
#' - If a process ends early, another process settles its unfinished design last.
#' - A store never replaces another file or folder.
#'
#' This Slurm job array follows `codend study new boards.study PLAN --designs designs.csv`:
#'
#' ```sh
#' #!/bin/sh
#' #SBATCH --array=1-40
#' codend study run boards.study --task $SLURM_ARRAY_TASK_ID --of 40
#' ```
#'
#' `codend study status boards.study` shows the progress, and `codend study table boards.study`
#' prints the finished designs as CSV. Submit the same array again to run the missing designs. A
#' task should take a minute or more, because submitting a job takes some seconds.
#'
#' @param store Path of the folder of the study. All machines must have access to it.
#' @param task,of Number of this task and of all tasks. Design `k` is in task `(k - 1) %% of + 1`.
#'   Default: 1 of 1.
#' @return The number of designs that the call settled, invisibly. Designs that another process has
#'   finished do not count. A folder without a study raises an error of class `codend_error_file`.
#' @seealso [vary()], [designs()], [read_result()], [effects()][effects.codend_variations];
#'   `vignette("command-line", package = "codend")`.
#' @export
#' @examplesIf requireNamespace("RNetCDF", quietly = TRUE)
#' store <- tempfile(fileext = ".study")
#' vary("towed_cable", towing.speed = paste(3:6, "knot"), store = store, tasks = 0)
#' run_study(store, task = 1, of = 2)
#' summary(read_result(store))
#' run_study(store)
#' read_result(store)[1:4]
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

#' @rdname write_result
#' @export
read_result <- function(file) {
  check_given("file")
  if (is_text(file) && dir.exists(file)) read_study(file) else read_netcdf(file)
}

# Returns the result of vary() for the finished designs of a store.
read_study <- function(store) {
  read_store_text(store)
  study_table(open_study(store), read_rows(stored_rows(store)))
}
