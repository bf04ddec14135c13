# Workers of the flume tank, in separate processes.

for (package in c("callr", "later")) skip_if_not_installed(package)
skip_on_os("windows")

# Runs the event loop until done() is TRUE, or for a maximum time.
wait_until <- function(done, seconds = 120) {
  end <- proc.time()[["elapsed"]] + seconds
  while (!done() && proc.time()[["elapsed"]] < end) later::run_now(0.05)
  done()
}

# A worker with its answers in order of arrival, by the name of the requester.
asking <- function(...) {
  worker <- process_worker(...)
  answers <- list()
  list(
    worker = worker,
    ask = function(name, request, kind = "design", pause = 0) {
      force(name)
      force(request)
      worker$ask(kind, function() request, pause = pause, then = function(answer) {
        answers[[length(answers) + 1L]] <<- list(name = name, answer = answer)
      })
    },
    answers = function() answers,
    wait = function(n) wait_until(function() length(answers) >= n)
  )
}

start <- settled_start(settled_gear("towed_cable"), 300)
tank <- new_tank(start, list(), 300)
towed_at <- function(speed) {
  draft <- tank$draft
  draft$plan$towing$speed <- paste(speed, "knot")
  tank$request("design", draft)
}

test_that("worker process returns the same results and keeps its state", {
  one <- asking()
  on.exit(one$worker$stop())
  one$ask("first", towed_at(5))
  expect_true(one$wait(1))
  expect_null(one$answers()[[1]]$answer$problem)
  memory <- new.env()
  here <- flume_answer(towed_at(5), memory)
  expect_identical(one$answers()[[1]]$answer$found$measures, here$found$measures)
  # without a state the worker starts from its own
  next_one <- towed_at(5.2)
  next_one["state"] <- list(NULL)
  one$ask("second", next_one)
  expect_true(one$wait(2))
  expect_identical(
    one$answers()[[2]]$answer$found$measures, flume_answer(next_one, memory)$found$measures
  )
  # errors are the same as in this process
  one$ask("wrong", towed_at(-1))
  expect_true(one$wait(3))
  expect_match(one$answers()[[3]]$answer$problem$message, "`towing.speed`", fixed = TRUE)
})

test_that("worker answers the latest design and rejects too many files", {
  one <- asking()
  on.exit(one$worker$stop())
  for (speed in 3:6) one$ask(speed, towed_at(speed))
  folder <- test_folder()
  for (k in 1:6) {
    file <- file.path(folder, paste0(k, ".vtu"))
    one$ask(
      paste("save", k), kind = "save",
      tank$request("save", list(name = "vtu", file = file))
    )
  }
  expect_true(one$wait(10))
  came <- vapply(one$answers(), function(answer) as.character(answer$name), "")
  problem <- lapply(one$answers(), function(answer) answer$answer$problem$message)
  # the process was still starting, so all requests waited
  expect_identical(came[1:3], c("3", "4", "5"))
  refused <- grepl("Too many", vapply(problem, function(x) paste(x, collapse = ""), ""))
  expect_identical(came[refused], paste("save", 4:6))
  expect_length(list.files(folder, "vtu$"), 3L)
})

test_that("worker delays the remaining picture until its pause or a design", {
  one <- asking()
  on.exit(one$worker$stop())
  one$ask("whole", towed_at(5))
  expect_true(one$wait(1))
  going_on <- function(speed) {
    request <- towed_at(speed)
    request["state"] <- list(NULL)
    request
  }
  one$ask("second", going_on(5.1))
  # the second request returns only its shape, because the worker knows the first
  expect_true(one$wait(2))
  expect_type(one$answers()[[2]]$answer$found$moved, "raw")
  rest <- list(kind = "rest")
  # longer than any test waits
  one$ask("rest of the second", rest, "rest", pause = 1e4)
  one$ask("third", going_on(5.2))
  expect_true(one$wait(4))
  expect_identical(one$answers()[[3]], list(name = "rest of the second", answer = NULL))
  expect_type(one$answers()[[4]]$answer$found$moved, "raw")
  # a later request ends its pause
  one$ask("rest of the third", rest, "rest", pause = 1e4)
  drawing <- tank$request("drawing", tank$draft)
  drawing["state"] <- list(NULL)
  one$ask("drawing", drawing, "drawing")
  expect_true(one$wait(6))
  came <- vapply(one$answers(), `[[`, "", "name")
  expect_identical(came[5:6], c("rest of the third", "drawing"))
  anew <- settle(update(read_gear("towed_cable"), towing.speed = "5.2 knot"), nodes = 300)
  # both to 1e-8 of the largest tension; the cable's sag increases that a few times
  expect_equal(one$answers()[[5]]$answer$found$measures, measures(anew), tolerance = 1e-6)
  # a pause ends automatically
  one$ask("fourth", going_on(5.3))
  expect_true(one$wait(7))
  one$ask("rest of the fourth", rest, "rest", pause = 0.05)
  expect_true(one$wait(8))
  expect_null(one$answers()[[8]]$answer$problem)
  # the worker discards a pending pause when it stops
  one$ask("fifth", going_on(5.4))
  expect_true(one$wait(9))
  one$ask("rest of the fifth", rest, "rest", pause = 1e4)
  one$worker$stop()
  while (later::next_op_secs() < 10) later::run_now(10)
  expect_identical(later::next_op_secs(), Inf)
})

# TRUE if a process exists: signal 0 only checks.
ps_there <- function(pid) tools::pskill(pid, 0L)

test_that("worker ends slow requests without delaying others", {
  slow <- asking(seconds = 15)
  quick <- asking()
  on.exit({
    slow$worker$stop()
    quick$worker$stop()
  })
  slow$ask("before", towed_at(4))
  quick$ask("quick", towed_at(4))
  expect_true(slow$wait(1) && quick$wait(1))
  first <- slow$worker$process()$get_pid()
  # a stopped process is sure to exceed the limit
  tools::pskill(first, tools::SIGSTOP)
  slow$ask("slow", towed_at(5))
  quick$ask("quick", towed_at(5))
  expect_true(quick$wait(2))
  expect_length(slow$answers(), 1L)
  expect_true(slow$wait(2))
  expect_match(slow$answers()[[2]]$answer$problem$message, "longer than 15 s", fixed = TRUE)
  expect_identical(slow$worker$holds, 0)
  second <- slow$worker$process()$get_pid()
  expect_false(identical(first, second))
  expect_false(ps_there(first))
  slow$ask("after", towed_at(5))
  expect_true(slow$wait(3))
  expect_null(slow$answers()[[3]]$answer$problem)
  # an externally killed process is replaced too
  tools::pskill(slow$worker$process()$get_pid(), tools::SIGKILL)
  expect_true(wait_until(function() !slow$worker$process()$is_alive()))
  slow$ask("again", towed_at(4))
  expect_true(slow$wait(4))
  expect_null(slow$answers()[[4]]$answer$problem)
})

test_that("cancel() ends a request and the next has a new process", {
  one <- asking()
  on.exit(one$worker$stop())
  one$ask("before", towed_at(4))
  expect_true(one$wait(1))
  first <- one$worker$process()$get_pid()
  # a stopped process would take its 30 s
  tools::pskill(first, tools::SIGSTOP)
  one$ask("long", towed_at(5))
  one$ask("waits", kind = "save", tank$request("save", list(format = "vtu", file = tempfile())))
  one$worker$cancel()
  expect_length(one$answers(), 3L)
  for (answer in one$answers()[2:3]) expect_true(answer$answer$problem$cancelled)
  expect_false(ps_there(first))
  one$ask("after", towed_at(5))
  expect_true(one$wait(4))
  expect_null(one$answers()[[4]]$answer$problem)
  # nothing to cancel
  one$worker$cancel()
  expect_length(one$answers(), 4L)
})

test_that("late worker starts its process with the first request", {
  late <- process_worker(late = TRUE)
  on.exit(late$stop())
  expect_null(late$process())
  late$cancel()
  found <- NULL
  late$ask("design", function() towed_at(5), function(answer) found <<- answer)
  expect_true(wait_until(function() !is.null(found)))
  expect_null(found$problem)
})

test_that("worker process has a memory limit", {
  skip_on_os(c("mac", "windows"))
  # the command requests 2.4 GB on top of its own needs
  said <- callr::r(function() {
    asNamespace("codend")$prepare_worker(1.5e9)
    tryCatch(length(numeric(3e8)), error = conditionMessage)
  })
  expect_match(said, "cannot allocate")
  one <- asking(bytes = 1.5e9)
  on.exit(one$worker$stop())
  one$ask("small", towed_at(5))
  expect_true(one$wait(1))
  expect_null(one$answers()[[1]]$answer$problem)
})

test_that("message_gate() blocks only a page that sends too much", {
  time <- 0
  pass <- message_gate(function() time)
  expect_true(pass(1000))
  expect_false(pass(most_message_bytes + 1))
  # a slider that moves as fast as answers arrive, for a minute
  passed <- vapply(1:1800, function(k) {
    time <<- time + 1 / 30
    pass(200)
  }, NA)
  expect_true(all(passed))
  passed <- vapply(1:1000, function(k) pass(200), NA)
  expect_lte(sum(passed), message_burst)
  time <- time + 10
  expect_true(pass(200))
})

test_that("bound_memory() ends the largest worker above the total limit", {
  memory_clock$next_look <- 0
  one <- asking()
  two <- asking()
  on.exit({
    one$worker$stop()
    two$worker$stop()
  })
  one$ask("one", towed_at(5))
  two$ask("two", towed_at(4))
  expect_true(one$wait(1) && two$wait(1))
  taken <- one$worker$memory() + two$worker$memory()
  expect_gt(taken, 5e7)
  memory_clock$next_look <- 0
  bound_memory(1.1 * taken)
  expect_length(ls(tank_workers), 2L)
  memory_clock$next_look <- 0
  bound_memory(0.9 * taken)
  expect_length(ls(tank_workers), 1L)
  # both continue, one in a new process
  one$ask("one", towed_at(4.5))
  two$ask("two", towed_at(4.5))
  expect_true(one$wait(2) && two$wait(2))
  expect_null(one$answers()[[2]]$answer$problem)
  expect_null(two$answers()[[2]]$answer$problem)
  # a busy worker returns this error
  two$worker$stop()
  memory_clock$next_look <- 0
  one$ask("one", towed_at(4.6))
  bound_memory(1)
  expect_true(one$wait(3))
  expect_match(one$answers()[[3]]$answer$problem$message, "no free memory", fixed = TRUE)
})
