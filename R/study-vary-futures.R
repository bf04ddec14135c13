# A study run by the package future: tasks handed out, what is missing handed out again.

# Seconds that a task should take, on this machine and as a job of a cluster; how often a design may
# end its worker, and how many rounds may pass without a row; how long a file written elsewhere may
# take to be seen, and how long no row may come of jobs said to have expired, seconds.
task_seconds <- c(here = 10, cluster = 60)
most_deaths <- 2L
most_idle <- 3L
most_delay <- 60
expired_delay <- 10

# How many workers the session's plan has; NULL where it runs in this process.
future_workers <- function() {
  if (!isNamespaceLoaded("future")) return(NULL)
  plan <- future::plan()
  if (inherits(plan, c("sequential", "uniprocess"))) return(NULL)
  future::nbrOfWorkers()
}

future_cluster <- function() inherits(future::plan(), "batchtools")

# Runs what is not done of a store.
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
    # the first that a task has not done is what its worker ended at
    suspect <- unlist(lapply(ended, function(one) utils::head(intersect(one$designs, left), 1L)))
    deaths[suspect] <- deaths[suspect] + 1L
    deadly <- left[deaths[left] >= most_deaths]
    for (k in deadly) {
      found <- list(problem = paste("Its worker ended", most_deaths, "times while settling it."))
      mark <- store_mark(store)
      write_text(c(row_text(k, found, mark), ""), row_file(store, k, mark))
    }
    left <- setdiff(left, deadly)
    idle <- if (length(left) < before) 0L else idle + 1L
    if (idle >= most_idle) {
      why <- ended[[1L]]$why
      abort_argument("The workers of {.fn future::plan} end before a design is settled: {why}")
    }
    # workers that are gone come back
    plans <- future::plan("list")
    if (length(left)) future::plan(plans)
  }
  show(all)
}

# Designs by task, dealt out in turn.
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

# Runs tasks as futures, as many at once as there are workers; none is begun any more where a worker
# has ended. Returns those tasks: lists of designs (none where it did not begin) and why.
run_futures <- function(store, tasks, show) {
  store <- normalizePath(store)
  pause <- if (future_cluster()) 1 else 0.05
  running <- list()
  failed <- list()
  shown <- -Inf
  fail <- function(designs, e) {
    # what a task itself says is said of all of them
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
    # the value of a future whose worker is gone is an error
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

# What a task needs is named: nothing is looked for, and nothing else goes along.
start_task <- function(store, designs) {
  future::future(
    get("run_task", asNamespace("codend"))(store, designs),
    substitute = TRUE, envir = list2env(list(store = store, designs = designs), parent = baseenv()),
    globals = list(store = store, designs = designs), packages = "codend", seed = NULL,
    stdout = FALSE, conditions = character(), lazy = FALSE
  )
}

# Designs of `left` without a row. Rows that are not seen yet are waited for: of tasks that say they
# are done, and of jobs said to have expired, which may go on; where workers ended, nothing comes.
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
