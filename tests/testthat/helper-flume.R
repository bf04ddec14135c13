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

# Returns the lines of an interface of web/src/protocol.ts, NULL without the repository.
protocol_lines <- function(interface) {
  place <- test_path("..", "..", "web", "src", "protocol.ts")
  if (!file.exists(place)) return(NULL)
  lines <- readLines(place, encoding = "UTF-8")
  first <- grep(paste("^export interface", interface), lines)
  ends <- grep("^}", lines)
  lines[seq(first + 1L, ends[ends > first][1L] - 1L)]
}

# Returns the fields of each message that R sends: a logical by field, TRUE if the message must have
# the field.
declared_messages <- function(lines = protocol_lines("FromR")) {
  if (is.null(lines)) return(NULL)
  message <- grepl("^  \\w+:", lines)
  name <- sub("^ +(\\w+).*", "\\1", lines)
  field <- grepl("^    \\w+[?]?:", lines)
  lapply(split(seq_along(lines), name[message][cumsum(message)]), function(at) {
    own <- at[field[at]]
    stats::setNames(!grepl("^    \\w+[?]", lines[own]), name[own])
  })
}

# Fails unless the page's protocol declares a message and its fields.
expect_declared <- function(type, message, declared = declared_messages()) {
  if (is.null(declared)) return(invisible())
  fields <- declared[[type]]
  if (is.null(fields)) return(testthat::fail(paste("protocol.ts does not declare", type)))
  wrong <- c(setdiff(names(message), names(fields)), setdiff(names(fields)[fields], names(message)))
  if (length(wrong)) testthat::fail(paste0(type, " differs from protocol.ts: ", toString(wrong)))
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
  declared <- declared_messages()
  # the mock has no page to send to
  for (name in c("sendCustomMessage", "sendBinaryMessage")) unlockBinding(name, session)
  session$sendBinaryMessage <- function(type, message) {
    messages[[length(messages) + 1L]] <<- list(type = type, bytes = message)
  }
  session$sendCustomMessage <- function(type, message) {
    expect_declared(type, message, declared)
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
