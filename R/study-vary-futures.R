# Studies on workers of the package future. Missing designs are repeated.

# Limits of a study on workers:
#   `task_seconds`: target duration of a task on this machine and of a cluster job (s).
#   `most_deaths`: number of ended workers after which a design is given up.
#   `most_idle`: number of rounds without a new row before an error.
#   `most_delay`: longest wait for files from other machines (s).
#   `expired_delay`: longest wait for rows of jobs reported as expired (s).
task_seconds <- c(here = 10, cluster = 60)
most_deaths <- 2L
most_idle <- 3L
most_delay <- 60
expired_delay <- 10

# Returns the number of workers, or NULL if the plan runs in this process.
future_workers <- function() {
  if (!isNamespaceLoaded("future")) return(NULL)
  plan <- future::plan()
  if (inherits(plan, c("sequential", "uniprocess"))) return(NULL)
  future::nbrOfWorkers()
}

future_cluster <- function() inherits(future::plan(), "batchtools")

# Settles the missing designs of a store.
vary_stored <- function(store, tasks) {
  all <- nrow(open_store(store)$study$designs)
  left <- setdiff(seq_len(all), designs_done(store))
  show <- study_progress(all, all - length(left))
  if (is.null(future_workers())) {
    if (length(left)) run_task(store, left, function(done) show(all - length(left) + done))
    return(invisible())
  }
  deaths <- integer(all)
  idle <- 0L
  while (length(left)) {
    done <- done_finder(store)
    ended <- run_futures(store, deal_out(left, tasks), function() show(length(done())))
    before <- length(left)
    left <- missing_designs(store, left, ended)
    # The worker ended at the first missing design of its task.
    suspect <- unlist(lapply(ended, function(one) utils::head(intersect(one$designs, left), 1L)))
    deaths[suspect] <- deaths[suspect] + 1L
    deadly <- left[deaths[left] >= most_deaths]
    for (k in deadly) {
      found <- list(problem = paste("Its worker process ended", most_deaths, "times."))
      mark <- store_mark(store)
      write_text(c(row_text(k, found, mark), ""), row_file(store, k, mark))
    }
    left <- setdiff(left, deadly)
    idle <- if (length(left) < before) 0L else idle + 1L
    if (idle >= most_idle) {
      why <- ended[[1L]]$why
      abort_argument("The workers of {.fn future::plan} end before a design is settled: {why}")
    }
    # Setting the plan again restarts ended workers.
    plans <- future::plan("list")
    if (length(left)) future::plan(plans)
  }
  show(all)
}

# Returns designs by task, distributed in rotation.
deal_out <- function(left, tasks) {
  if (is.null(tasks)) {
    workers <- future_workers()
    seconds <- length(left) * opened_store$seconds
    tasks <- if (future_cluster()) {
      ceiling(seconds / task_seconds[["cluster"]])
    } else {
      max(4 * workers, ceiling(seconds / task_seconds[["here"]]))
    }
  }
  tasks <- min(tasks, length(left))
  unname(split(left, (seq_along(left) - 1L) %% tasks))
}

# Runs tasks as futures, one per worker. No task starts after a worker has ended. Returns a list per
# failed task: designs (empty if it did not start), why.
run_futures <- function(store, tasks, show) {
  store <- normalizePath(store)
  pause <- if (future_cluster()) 1 else 0.05
  running <- list()
  failed <- list()
  shown <- -Inf
  fail <- function(designs, e) {
    # An error raised by the task would occur in all tasks.
    if (!inherits(e, "FutureError")) stop(e)
    failed[[length(failed) + 1L]] <<- list(designs = designs, why = plain_message(e))
    tasks <<- list()
  }
  while (length(tasks) || length(running)) {
    while (length(tasks) && length(running) < future_workers()) {
      designs <- tasks[[1L]]
      tasks <- tasks[-1L]
      tryCatch(
        running[[length(running) + 1L]] <- list(future = start_task(store, designs),
          designs = designs),
        error = function(e) fail(integer(), e)
      )
    }
    # If the worker has ended, `future::value()` raises the error below.
    over <- vapply(running, function(one) {
      tryCatch(future::resolved(one$future), FutureError = function(e) TRUE)
    }, NA)
    for (one in running[over]) {
      tryCatch(future::value(one$future), error = function(e) fail(one$designs, e))
    }
    running <- running[!over]
    if (proc.time()[["elapsed"]] - shown > 0.5) {
      show()
      shown <- proc.time()[["elapsed"]]
    }
    if (length(running) && !any(over)) Sys.sleep(pause)
  }
  failed
}

# Listing the globals prevents a search, and sends only these objects to the worker.
start_task <- function(store, designs) {
  future::future(
    get("run_task", asNamespace("codend"))(store, designs),
    substitute = TRUE, envir = list2env(list(store = store, designs = designs), parent = baseenv()),
    globals = list(store = store, designs = designs), packages = "codend", seed = NULL,
    stdout = FALSE, conditions = character(), lazy = FALSE
  )
}

# Returns the designs of `left` without a row. Rows of finished tasks may appear late, and jobs
# reported as expired may still run. Ended workers write no more rows, so there is no wait.
missing_designs <- function(store, left, failed) {
  missing <- left
  quiet <- 0
  repeat {
    before <- length(missing)
    missing <- setdiff(left, designs_done(store))
    quiet <- if (length(missing) < before) 0 else quiet + 1
    patience <- if (!length(failed)) most_delay else if (future_cluster()) expired_delay else 0
    if (!length(missing) || quiet > patience) return(missing)
    Sys.sleep(1)
  }
}
