# A synchronous worker in this process.
direct_worker <- function(...) {
  worker <- new.env(parent = emptyenv())
  memory <- new.env(parent = emptyenv())
  worker$holds <- 0
  worker$stop <- worker$cancel <- function() NULL
  worker$ask <- function(kind, make, then, pause = 0) {
    request <- make()
    then(if (!is.null(request)) flume_answer(request, memory))
  }
  worker
}

# Runs `test(session, sent)` in a flume tank without a browser. The session opens with a gear (NULL:
# with the gallery). sent() returns the messages of a type that the page received since the last
# call.
in_flume <- function(
  gear, test, fields = list(), nodes = 300, new_worker = direct_worker, folder = NULL
) {
  if (is.character(gear)) gear <- read_gear(gear)
  start <- if (!is.null(gear)) list(gear = gear, state = settle(gear, nodes = nodes))
  session <- shiny::MockShinySession$new()
  messages <- list()
  # the mock has no page to send to
  for (name in c("sendCustomMessage", "sendBinaryMessage")) unlockBinding(name, session)
  session$sendBinaryMessage <- function(type, message) {
    messages[[length(messages) + 1L]] <<- list(type = type, bytes = message)
  }
  session$sendCustomMessage <- function(type, message) {
    messages[[length(messages) + 1L]] <<- c(list(type = type), message)
  }
  sent <- function(type) {
    found <- Filter(function(message) message$type == type, messages)
    messages <<- list()
    found
  }
  shiny::testServer(
    flume_server(start, as.list(fields), nodes, new_worker, folder),
    {
      session$flushReact()
      test(session, sent, tank)
    },
    session = session
  )
}

# Sends the latest values of all moved controls, by path.
ask <- function(session, ..., number = 1, gesture = number) {
  session$setInputs(design = list(number = number, gesture = gesture, edits = list(...)))
}

# Checks that the server rejects each invalid input once, with a message at the input.
expect_asks_refused <- function(session, sent, input, wrong, where) {
  for (asked in wrong) {
    sent("flume_refused")
    do.call(session$setInputs, setNames(list(c(asked, said = stats::runif(1))), input))
    refused <- sent("flume_refused")
    expect_length(refused, 1L)
    expect_identical(refused[[1]]$where, where)
    expect_no_match(refused[[1]]$message, "failed", fixed = TRUE)
  }
}

# The gear after a page's changes to its plan.
edited_gear <- function(gear, edits) as_gear(edited_plan(gear$plan, edits)$plan, like = gear)
