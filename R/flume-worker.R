# Where a session of the flume tank settles its designs: an R process of its own, so that no user
# waits for another's design, none takes more than its time and memory, and one that hangs is ended.
#
# A worker is an environment of
#   ask(kind, make, then, pause)
#                          asks for what flume_answer() answers: make() gives the request when its
#                          turn comes, or NULL when it is out of date; then(answer) is called once,
#                          with NULL for a request that is out of date or that a later one takes the
#                          place of; it waits `pause` s [0] unless others wait behind it
#   cancel()               ends what it is about and all that waits, which are answered so
#   stop()                 ends it
#   holds                  a number for the tank: the state that the worker remembers (0: none)

# Seconds that the answer to one request may take: of what moves the net, and of what somebody asks
# for and waits (reports, drawings, tows); and bytes that a worker may take.
flume_seconds <- 30
clerk_seconds <- 300
flume_memory <- 4e9

# Bytes that all workers of this process may take together: a share of the machine's, or of what the
# system gives to a service or container.
tank_memory_share <- 0.75
tank_memory <- function() {
  all <- ps::ps_system_memory()[["total"]]
  group <- "/sys/fs/cgroup/memory.max"
  bound <- if (file.exists(group)) suppressWarnings(as.double(readLines(group, 1L, warn = FALSE)))
  tank_memory_share * min(all, bound, na.rm = TRUE)
}

# The workers that have a process, by their names, and how often their memory is summed up, s.
tank_workers <- new.env(parent = emptyenv())
memory_every <- 0.5
memory_clock <- new.env(parent = emptyenv())
memory_clock$next_look <- 0

# Where all workers together take more than they may, the one that takes most ends what it is about.
bound_memory <- function(most = tank_memory()) {
  now <- proc.time()[["elapsed"]]
  if (now < memory_clock$next_look) return(invisible())
  memory_clock$next_look <- now + memory_every
  taken <- vapply(as.list(tank_workers), function(worker) worker$memory(), 0)
  if (sum(taken) > most) tank_workers[[names(taken)[which.max(taken)]]]$give_up()
}

# Seconds that a process may take to start.
start_seconds <- 120

# Requests that may wait for a worker beside the one that it is about.
most_waiting <- 4L

# When a process that works is looked at first and how much later at least each time, s; and how
# much longer than it has worked already. A look takes a millisecond.
look_first <- 0.02
look_every <- 0.005
look_share <- 0.15

# Requests of one of these a later one takes the place of while they wait.
replaced_requests <- list(
  c("design", "plan_text", "plan_file", "shipped", "new", "words"), "drawing", "slopes",
  "uncertainty", "tow", "vary"
)

# Kinds of requests that one of a kind takes the place of. Of a shape that a slider has passed
# nobody needs the rest.
replaced_by <- function(kind) {
  alike <- unlist(Filter(function(kinds) kind %in% kinds, replaced_requests))
  if (kind == "design") c(alike, "rest") else alike
}

# What is told of a request that is cancelled.
cancelled_answer <- list(problem = list(message = "Cancelled.", cancelled = TRUE))

# late: whether its process starts with the first request, and gives way to those of other workers.
process_worker <- function(seconds = flume_seconds, bytes = flume_memory, late = FALSE) {
  worker <- new.env(parent = emptyenv())
  id <- basename(tempfile("worker-"))
  process <- NULL
  idle <- FALSE
  waiting <- list()
  current <- NULL
  stopped <- FALSE
  end_pause <- function() NULL  # forgets that go_on() is to come once a pause is over

  start <- function() {
    process <<- answering_process(bytes, gives_way = late)
    tank_workers[[id]] <- worker
    worker$holds <- 0
    idle <<- FALSE
    current <<- list(since = now(), until = now() + start_seconds)
    look_later(look_first)
  }
  now <- function() proc.time()[["elapsed"]]
  # an error here, outside of every session, would end the tank for all
  tell <- function(job, answer) {
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
    # one that has ended is found so when it is looked at
    tryCatch(process$write_input(paste0(file, "\n")), error = function(e) NULL)
    look_later(look_first)
  }
  go_on <- function() {
    end_pause()
    if (stopped) return()
    # one that was ended from elsewhere has lost nothing but time
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
      if (is.null(request)) tell(job, NULL) else call(job, request)
    }
  }
  finish <- function() {
    job <- current
    current <<- NULL
    idle <<- TRUE
    if (!is.null(job$then)) {
      answer <- unpacked_answer(read_whole(job$file))
      unlink(job$file)
      tell(job, answer)
    }
    go_on()
  }
  # Its answer is what is wrong; another process takes its place, at the next request where this one
  # did not even start.
  replace_process <- function(message) replace_with(list(problem = list(message = message)))
  replace_with <- function(answer) {
    end_process()
    unlink(current$file)
    jobs <- if (is.null(current$then)) waiting else list(current)
    if (is.null(current$then)) waiting <<- list() else start()
    for (job in jobs) tell(job, answer)
  }
  end_process <- function() {
    if (!is.null(process)) process$kill()
    process <<- NULL
    remove(list = intersect(id, names(tank_workers)), envir = tank_workers)
  }
  # Bytes that its process takes.
  worker$memory <- function() {
    if (is.null(process)) return(0)
    tryCatch(process$get_memory_info()[["rss"]], error = function(e) 0)
  }
  # Frees its memory; what it was about is answered so.
  worker$give_up <- function() {
    if (!idle) {
      return(replace_process("The tank's users need more memory than it has; try again later."))
    }
    end_process()
    worker$holds <- 0
  }
  look <- function() {
    if (stopped || idle || is.null(process)) return()
    if (has_answered(process)) return(finish())
    bound_memory()
    # it may have been the one that gave up
    if (stopped || idle || is.null(process)) return()
    if (!process$is_alive()) {
      return(replace_process("The process that settles ended at this; a new one takes its place."))
    }
    if (now() < current$until) return(look_later())
    replace_process(sprintf(
      "This takes longer than %s s, which is all that the tank gives it.", format(seconds)
    ))
  }
  worker$ask <- function(kind, make, then, pause = 0) {
    # of designs the latest counts
    old <- vapply(waiting, function(job) job$kind %in% replaced_by(kind), NA)
    passed <- waiting[old]
    waiting <<- waiting[!old]
    for (job in passed) tell(job, NULL)
    if (length(waiting) >= most_waiting) {
      then(list(problem = list(message = "Too much is asked for at once; try again in a while.")))
      return(invisible())
    }
    waiting <<- c(waiting, list(list(kind = kind, make = make, then = then, from = now() + pause)))
    if (is.null(process)) start() else go_on()
  }
  worker$cancel <- function() {
    jobs <- waiting
    waiting <<- list()
    if (!idle && !is.null(current$then)) replace_with(cancelled_answer)
    for (job in jobs) tell(job, cancelled_answer)
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

# A process that says a line when it is ready, then reads names of files, each a request, and says
# the line again once its answer stands in the file's place. (A call of callr's sessions takes as
# long as a design takes to settle.)
answering_process <- function(bytes, gives_way) {
  serve <- function(...) asNamespace("codend")$answer_requests(...)
  # without this frame, which would be sent along
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

# Until nobody asks any more.
answer_requests <- function(bytes, gives_way) {
  prepare_worker(bytes)
  if (gives_way) tools::psnice(value = 10L)
  memory <- new.env(parent = emptyenv())
  asks <- file("stdin", "r")
  on.exit(close(asks))
  say <- function() {
    cat(answered_line, "\n", sep = "")
    flush(stdout())
  }
  say()
  while (length(file <- readLines(asks, 1L))) {
    answer <- tryCatch(flume_answer(read_whole(file), memory), error = function(e) {
      list(problem = list(message = paste0("codend failed at this: ", plain_message(e))))
    })
    write_whole(packed_answer(answer), file)
    say()
  }
}

# ---- between the two -----------------------------------------------------------------------------

# A state has its gear, which an answer has beside it: it is sent once.
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

# ---- what a page may send ------------------------------------------------------------------------

# Bytes of a message: a plan as JSON. Messages at once and a second after that.
most_message_bytes <- 6 * 1024^2
message_burst <- 200
message_rate <- 40

# A function(bytes) that says whether a message may pass; now(): s.
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

# Ends a session whose page sends more than a page does. Shiny has no limit of its own for messages;
# they are counted at its connection. Returns whether that was found.
bound_messages <- function(session) {
  socket <- tryCatch(session$.__enclos_env__$private$websocket, error = function(e) NULL)
  if (!is.environment(socket) || !is.list(socket$messageCallbacks)) return(FALSE)
  pass <- message_gate()
  open <- TRUE
  handlers <- socket$messageCallbacks
  socket$messageCallbacks <- list(function(binary, message) {
    if (!open) return()
    open <<- pass(if (is.raw(message)) length(message) else nchar(message, "bytes"))
    if (open) for (handler in handlers) handler(binary, message) else session$close()
  })
  TRUE
}
