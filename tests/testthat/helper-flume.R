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

# A flume tank whose page is the test instead of a browser. Returns list(page, hear, tank, sent):
# hear() sends messages by name. sent(type) returns the messages of a type that the page received
# since the last call.
open_flume <- function(server, request = list()) {
  messages <- list()
  declared <- declared_messages()
  add <- function(message) messages[[length(messages) + 1L]] <<- message
  page <- server(request,
    send = function(type, message) {
      expect_declared(type, message, declared)
      # as the browser receives it
      testthat::expect_true(jsonlite::validate(message_json(type, message)))
      add(c(list(type = type), message))
    },
    send_bytes = function(bytes) {
      size <- readBin(bytes, "integer", endian = "little")
      header <- jsonlite::parse_json(rawToChar(bytes[4L + seq_len(size)]))
      add(list(type = if (is.null(header$file)) "flume_moved" else "file", header = header,
        bytes = bytes, content = bytes[-seq_len(4L + size)]))
    },
    close = function() NULL
  )
  list(
    page = page, tank = page$tank,
    hear = function(...) {
      given <- list(...)
      for (name in names(given)) page$hear(name, given[[name]])
    },
    sent = function(type) {
      found <- Filter(function(message) message$type == type, messages)
      messages <<- list()
      found
    }
  )
}

# Runs `test(session, sent, tank)` in a flume tank without a browser. The session (open_flume())
# opens with a gear (NULL: with the gallery).
in_flume <- function(
  gear, test, fields = list(), nodes = 300, new_worker = direct_worker, folder = NULL
) {
  if (is.character(gear)) gear <- read_gear(gear)
  start <- if (!is.null(gear)) settled_start(gear, nodes)
  session <- open_flume(flume_server(start, as.list(fields), nodes, new_worker, folder))
  test(session, session$sent, session$tank)
}

# Returns the path of a file that the page saves.
saved_file <- function(session, name) {
  session$sent("file")
  session$hear(save_wanted = name)
  one <- session$sent("file")[[1L]]
  file <- file.path(tempfile("saved-"), one$header$file)
  dir.create(dirname(file))
  writeBin(one$content, file)
  file
}

# Returns the first table of a tab.
table_of <- function(session, name) {
  session$sent("flume_table")
  session$hear(table_wanted = list(name = name))
  session$sent("flume_table")[[1L]]$tables[[1L]]
}

# Sends the latest values of all moved controls, by path.
ask <- function(session, ..., number = 1) {
  session$hear(design = list(number = number, edits = list(...)))
}

# Checks that the server rejects each invalid input once, with a message at the input.
expect_asks_refused <- function(session, sent, input, wrong, where) {
  for (asked in wrong) {
    sent("flume_refused")
    do.call(session$hear, setNames(list(asked), input))
    refused <- sent("flume_refused")
    expect_length(refused, 1L)
    expect_identical(refused[[1]]$where, where)
    expect_no_match(refused[[1]]$message, "failed", fixed = TRUE)
  }
}

# The gear after a page's changes to its plan.
edited_gear <- function(gear, edits) as_gear(edited_plan(gear$plan, edits)$plan, like = gear)
