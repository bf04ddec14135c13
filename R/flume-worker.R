# Workers of the flume tank. A session settles its designs in R processes of its own, so that users
# do not wait for each other. A worker has limits of time and memory, and is ended if it hangs.
#
# A worker is an environment with these members.
#   `ask(kind, make, then, pause)` requests an answer of flume_answer(). The function make() returns
#   the request at its turn, or NULL if it is out of date. The function then(answer) is called once,
#   with NULL if the request is out of date or was replaced. A request waits `pause` s [0] unless
#   others wait behind it.
#   `cancel()` ends the current request and all waiting requests.
#   `stop()` ends the worker.
#   `holds` is the number of the state that the worker has stored (0: no state).

# Limits of one worker: seconds for a request that moves the net, seconds for a slow request
# (report, drawing, tow), and bytes.
flume_seconds <- 30
slow_worker_seconds <- 300
flume_memory <- 4e9

# Bytes for all workers together: a fraction of the memory of the machine, or of the limit for a
# service or container.
tank_memory_share <- 0.75
tank_memory <- function() {
  all <- ps::ps_system_memory()[["total"]]
  group <- "/sys/fs/cgroup/memory.max"
  bound <- if (file.exists(group)) suppressWarnings(as.double(readLines(group, 1L, warn = FALSE)))
  tank_memory_share * min(all, bound, na.rm = TRUE)
}

# Workers with a process, by name, and the interval [s] of checks of their memory.
tank_workers <- new.env(parent = emptyenv())
memory_every <- 0.5
memory_clock <- new.env(parent = emptyenv())
memory_clock$next_look <- 0

# If all workers exceed their common limit, the largest worker ends its current request.
bound_memory <- function(most = tank_memory()) {
  now <- proc.time()[["elapsed"]]
  if (now < memory_clock$next_look) return(invisible())
  memory_clock$next_look <- now + memory_every
  taken <- vapply(as.list(tank_workers), function(worker) worker$memory(), 0)
  if (sum(taken) > most) tank_workers[[names(taken)[which.max(taken)]]]$give_up()
}

# Seconds that a process may take to start.
start_seconds <- 120

# Largest number of requests that wait in addition to the current request.
most_waiting <- 4L

# Polls of a busy process: first delay [s], shortest interval [s], and interval as a fraction of the
# elapsed time. A poll takes a millisecond.
look_first <- 0.02
look_every <- 0.005
look_share <- 0.15

# While requests of a group wait, a later request of the group replaces them.
replaced_requests <- list(
  c("design", "plan_file", "new", "words"), "drawing", "slopes", "uncertainty", "tow",
  "vary", "target", "prediction"
)

# Returns the kinds of requests that a new request replaces. A new design replaces requests about an
# earlier shape.
replaced_by <- function(kind) {
  alike <- unlist(Filter(function(kinds) kind %in% kinds, replaced_requests))
  if (kind == "design") c(alike, "rest", "prediction") else alike
}

cancelled_answer <- list(problem = list(message = "Cancelled.", cancelled = TRUE))

# late: TRUE if the process starts with the first request and has a lower priority than others.
process_worker <- function(seconds = flume_seconds, bytes = flume_memory, late = FALSE) {
  worker <- new.env(parent = emptyenv())
  id <- basename(tempfile("worker-"))
  process <- NULL
  idle <- FALSE
  waiting <- list()
  current <- NULL
  stopped <- FALSE
  end_pause <- function() NULL  # cancels a scheduled go_on()

  start <- function() {
    process <<- answering_process(bytes, gives_way = late)
    tank_workers[[id]] <- worker
    worker$holds <- 0
    idle <<- FALSE
    current <<- list(since = now(), until = now() + start_seconds)
    look_later(look_first)
  }
  now <- function() proc.time()[["elapsed"]]
  # an error here, outside every session, would end the tank for all users
  deliver <- function(job, answer) {
    tryCatch(job$then(answer), error = function(e) {
      message("codend flume: ", conditionMessage(e))
    })
  }
  look_later <- function(delay = max(look_every, look_share * (now() - current$since))) {
    later::later(look, delay)
  }
  call <- function(job, request) {
    file <- tempfile("request-")
    write_whole(request, file)
    idle <<- FALSE
    current <<- c(job, list(since = now(), until = now() + seconds, file = file))
    # the next poll detects a process that has ended
    tryCatch(process$write_input(paste0(file, "\n")), error = function(e) NULL)
    look_later(look_first)
  }
  go_on <- function() {
    end_pause()
    if (stopped) return()
    # an idle process that was ended from outside has lost only time
    if (idle && length(waiting) && (is.null(process) || !process$is_alive())) return(start())
    while (idle && length(waiting)) {
      job <- waiting[[1L]]
      early <- job$from - now()
      if (early > 0 && length(waiting) == 1L) {
        end_pause <<- later::later(go_on, early)
        return()
      }
      waiting <<- waiting[-1L]
      request <- job$make()
      if (is.null(request)) deliver(job, NULL) else call(job, request)
    }
  }
  finish <- function() {
    job <- current
    current <<- NULL
    idle <<- TRUE
    if (!is.null(job$then)) {
      answer <- unpacked_answer(read_whole(job$file))
      unlink(job$file)
      deliver(job, answer)
    }
    go_on()
  }
  # Answers the current request with an error and starts another process. After a failed start, all
  # waiting requests get the error, and the next request starts a process.
  replace_process <- function(message) replace_with(list(problem = list(message = message)))
  replace_with <- function(answer) {
    end_process()
    unlink(current$file)
    jobs <- if (is.null(current$then)) waiting else list(current)
    if (is.null(current$then)) waiting <<- list() else start()
    for (job in jobs) deliver(job, answer)
  }
  end_process <- function() {
    if (!is.null(process)) process$kill()
    process <<- NULL
    remove(list = intersect(id, names(tank_workers)), envir = tank_workers)
  }
  worker$memory <- function() {
    if (is.null(process)) return(0)
    tryCatch(process$get_memory_info()[["rss"]], error = function(e) 0)
  }
  # Frees memory; the current request gets an error.
  worker$give_up <- function() {
    if (!idle) {
      return(replace_process("The tank has no free memory; try again later."))
    }
    end_process()
    worker$holds <- 0
  }
  look <- function() {
    if (stopped || idle || is.null(process)) return()
    if (has_answered(process)) return(finish())
    bound_memory()
    # bound_memory() may have ended this worker
    if (stopped || idle || is.null(process)) return()
    if (!process$is_alive()) {
      return(replace_process("The settling process stopped at this request and was restarted."))
    }
    if (now() < current$until) return(look_later())
    replace_process(sprintf(
      "This takes longer than %s s, the limit of the tank.", format(seconds)
    ))
  }
  worker$ask <- function(kind, make, then, pause = 0) {
    # only the latest design counts
    old <- vapply(waiting, function(job) job$kind %in% replaced_by(kind), NA)
    passed <- waiting[old]
    waiting <<- waiting[!old]
    for (job in passed) deliver(job, NULL)
    if (length(waiting) >= most_waiting) {
      then(list(problem = list(message = "Too many requests at once; try again later.")))
      return(invisible())
    }
    waiting <<- c(waiting, list(list(kind = kind, make = make, then = then, from = now() + pause)))
    if (is.null(process)) start() else go_on()
  }
  worker$cancel <- function() {
    jobs <- waiting
    waiting <<- list()
    if (!idle && !is.null(current$then)) replace_with(cancelled_answer)
    for (job in jobs) deliver(job, cancelled_answer)
  }
  worker$stop <- function() {
    stopped <<- TRUE
    end_pause()
    end_process()
  }
  worker$process <- function() process
  if (!late) start()
  worker
}

# Starts a process that prints a line when it is ready, then reads names of files with requests. It
# replaces each file by the answer and prints the line again. (A call of a callr session takes as
# long as settling a design.)
answering_process <- function(bytes, gives_way) {
  serve <- function(...) asNamespace("codend")$answer_requests(...)
  # this frame would be sent to the process
  environment(serve) <- baseenv()
  callr::r_process$new(callr::r_process_options(
    func = serve, args = list(bytes = bytes, gives_way = gives_way), stdout = "|", stderr = NULL,
    extra = list(stdin = "|")
  ))
}

answered_line <- "codend: answered"

has_answered <- function(process) {
  process$poll_io(0L)[["output"]] == "ready" && answered_line %in% process$read_output_lines()
}

write_whole <- function(x, file) writeBin(serialize(x, NULL, xdr = FALSE), file)
read_whole <- function(file) unserialize(readBin(file, "raw", file.size(file)))

# ---- in the worker's process ---------------------------------------------------------------------

prepare_worker <- function(bytes) {
  limit_memory(bytes)
  NULL
}

# Runs until its input is closed.
answer_requests <- function(bytes, gives_way) {
  prepare_worker(bytes)
  if (gives_way) tools::psnice(value = 10L)
  memory <- new.env(parent = emptyenv())
  requests <- file("stdin", "r")
  on.exit(close(requests))
  say <- function() {
    cat(answered_line, "\n", sep = "")
    flush(stdout())
  }
  say()
  while (length(file <- readLines(requests, 1L))) {
    answer <- tryCatch(flume_answer(read_whole(file), memory), error = function(e) {
      list(problem = list(message = paste0("Internal error of codend: ", plain_message(e))))
    })
    write_whole(packed_answer(answer), file)
    say()
  }
}

# ---- transfer ------------------------------------------------------------------------------------

# The answer has the gear twice, also in its state, but sends it once.
packed_answer <- function(answer) {
  if (has_state(answer$found)) answer$found$state$gear <- NULL
  answer
}

unpacked_answer <- function(answer) {
  if (!has_state(answer$found)) return(answer)
  without <- answer$found$state
  answer$found$state <- structure(
    c(list(gear = answer$found$gear), unclass(without)), class = class(without)
  )
  answer
}

has_state <- function(found) is.list(found) && all(c("gear", "state") %in% names(found))

# ---- limits of messages from a page --------------------------------------------------------------

# Bytes of a message (a plan as JSON), messages at once, and messages per second after that.
most_message_bytes <- 6 * 1024^2
message_burst <- 200
message_rate <- 40

# Returns a function(bytes) that returns TRUE if a message may pass. now: clock [s].
message_gate <- function(now = function() proc.time()[["elapsed"]]) {
  left <- message_burst
  last <- now()
  function(bytes) {
    time <- now()
    left <<- min(message_burst, max(left, 0) + message_rate * (time - last)) - 1
    last <<- time
    bytes <= most_message_bytes && left >= 0
  }
}
