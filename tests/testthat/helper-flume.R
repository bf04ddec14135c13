# A flume tank without a browser: runs `test(session, sent)` in a session that opens with a gear
# (NULL: with the gallery).
# sent() gives the messages of a type that the page has been sent since it was last asked.
in_flume <- function(gear, test, fields = list(), nodes = 300, new_worker = direct_worker) {
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
    flume_server(start, as.list(fields), nodes, new_worker),
    {
      session$flushReact()
      test(session, sent, tank)
    },
    session = session
  )
}

# What controls send: the latest values of all that were moved, by path.
ask <- function(session, ..., number = 1, gesture = number) {
  session$setInputs(design = list(number = number, gesture = gesture, edits = list(...)))
}

# The gear with what a page changes of its plan.
edited_gear <- function(gear, edits) as_gear(edited_plan(gear$plan, edits)$plan, like = gear)
