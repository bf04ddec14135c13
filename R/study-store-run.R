#' Run a study on disk
#'
#' These functions create, run and read the `store` of a study without [vary()]: in jobs of a
#' cluster without R on its login node, or from a shell. Any number of tasks can run simultaneously
#' on any number of machines with access to the folder.
#'
#' @details
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
#' @param gear,nodes,netting,accuracy As in [vary()].
#' @param designs A table of designs, from [designs()].
#' @param store Path of the folder of the study. All machines must have access to it.
#' @param task,of Number of this task and of all tasks. Design `k` is in task `(k - 1) %% of + 1`.
#'   Default: 1 of 1.
#' @return
#'
#'   - `write_study()`: the path `store`, invisibly.
#'   - `run_study()`: the number of designs that it settled, invisibly. Designs that another process
#'     has finished do not count.
#'   - `read_study()`: the result of [vary()] for the finished designs.
#'   - `study_status()`: a list of class `codend_study_status`. `designs`, `done`, `settled` and
#'     `warned` are counts, `last` is the time of the last row. `problems` is a data frame of the
#'     reasons why designs did not settle (`problem`) and their counts (`designs`).
#'
#'   A folder without a study raises an error of class `codend_error_file`. A damaged row is left
#'   out with a warning of class `codend_warning_study`.
#' @seealso [vary()], [designs()], [effects()][effects.codend_variations];
#'   `vignette("command-line", package = "codend")`.
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
write_study <- function(gear, designs, store, nodes = NULL, netting = NULL, accuracy = NULL) {
  check_given("gear", "designs", "store")
  study <- new_study(gear, list(designs), nodes, netting, accuracy)
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

#' @rdname studies
#' @export
study_status <- function(store) {
  check_given("store")
  read_store_text(store)
  rows <- read_rows(stored_rows(store))
  times <- file.mtime(c(row_files(store), task_files(store)))
  problem <- rows$problem[!is.na(rows$problem)]
  structure(
    list(
      store = store, designs = nrow(open_study(store)$designs), done = length(rows$design),
      settled = sum(is.na(rows$problem)), warned = sum(!is.na(rows$warning)),
      last = if (length(times)) max(times, na.rm = TRUE),
      problems = counted_problems(sub("(: after|, near|; ).*", "", problem))
    ),
    class = "codend_study_status"
  )
}

#' @export
print.codend_study_status <- function(x, ...) {
  cat(x$done, " of ", x$designs, " designs done, ", x$settled, " settled, ", x$warned,
    " with a warning\n", sep = "")
  if (!is.null(x$last)) cat("last row ", format(x$last, "%Y-%m-%d %H:%M:%S"), "\n", sep = "")
  cat_counted_problems(x$problems)
  invisible(x)
}
