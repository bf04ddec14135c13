# The server of the flume tank. A session is one browser with its own gear.

# Largest number of sessions at a time, each with its own processes.
flume_sessions <- 30L

# While a slider moves, each shape is sent at once. Measures follow after a pause of `rest_pause` s,
# and every `rest_every` s during a long movement.
rest_pause <- 0.08
rest_every <- 0.5

# start: list(gear, state, notes) to open with, or NULL; marked: fields with additional controls;
# new_worker: a function(seconds, late) that returns a worker; folder: of shared designs, or NULL;
# hosts: names under which a proxy serves the page, or NULL.
flume_server <- function(
  start, marked, nodes, new_worker = process_worker, folder = NULL, hosts = NULL
) {
  pages <- 0L
  visitors <- new_visitors()
  shared <- if (!is.null(folder)) new_shared(folder)
  shared_changed <- shiny::reactiveVal(0L)
  function(input, output, session) {
    said <- function(type, ...) session$sendCustomMessage(type, list(...))
    request <- session$request
    if (!same_origin(request) || !known_host(request, hosts)) return(session$close())
    visitor <- visitors(visitor_of(request))
    full <- if (pages >= flume_sessions) {
      "The tank has reached its maximum number of visitors; try again later."
    } else if (!visitor$enter()) {
      "You have too many pages of the tank open; close one and reload this page."
    }
    if (!is.null(full)) {
      said("flume_refused", answers = 0, where = "gallery", path = NULL, message = full)
      return(session$close())
    }
    bound_messages(session)
    # the page has the same language, because its address and headers are the same
    say <- make_translator(page_language(
      shiny::isolate(session$clientData$url_search), request$HTTP_ACCEPT_LANGUAGE
    ))
    tank <- new_tank(start, marked, nodes, say)
    worker <- new_worker()
    # second worker for slow requests (reports, tows), so that the 3D view stays responsive
    clerk <- new_worker(seconds = slow_worker_seconds, late = TRUE)
    pages <<- pages + 1L
    session$onSessionEnded(function() {
      pages <<- pages - 1L
      visitor$leave()
      worker$stop()
      clerk$stop()
    })

    # The picture is sent before the tables are made.
    show <- function(answers = 0, passed = FALSE) {
      if (is.null(tank$gear)) return(said("flume_idle", answers = answers))
      message <- tank$picture(passed)
      session$sendCustomMessage("flume_picture", c(list(
        answers = answers, said = spoken(tank$measures, say), notes = I(tank$warnings()),
        towed = !is.null(tank$gear$plan$tow)
      ), message))
      tank$count_picture()
    }
    # Sends the form if its fields changed, interpreted numbers, problems, and counts of undo steps.
    show_draft <- function(understood = list(), settling = FALSE) {
      if (is.null(tank$gear)) return()
      said("flume_draft",
        form = if (tank$form_is_old()) tank$form(), understood = understood,
        problems = tank$problems, settling = settling,
        undo = length(tank$history$past), redo = length(tank$history$future)
      )
    }
    refuse <- function(problem, where, answers = 0) {
      said("flume_refused", answers = answers, where = where, message = problem$message,
        path = problem$path, cancelled = isTRUE(problem$cancelled))
    }
    # An error in a request is reported in its part of the page. Returns TRUE on success.
    trying <- function(where, expression, answers = 0) {
      problem <- flume_problem(expression)
      if (!is.null(problem)) refuse(problem, where, answers)
      is.null(problem)
    }
    number_of <- function(given) {
      number <- as.list(given)$number
      if (is.numeric(number) && length(number) == 1L) number else 0
    }

    # Requests the rest of the shape that the page has (NULL if the page has all data); and the time
    # since which data are missing [s].
    owed <- NULL
    since <- 0
    seconds <- function() proc.time()[["elapsed"]]

    # If the page changes its design again before an answer, one answer covers all these changes. A
    # moving slider waits for each answer.
    under_way <- FALSE
    asked_again <- NULL  # number of the last change
    take_design <- function(given) {
      number <- number_of(given)
      gesture <- if (is.numeric(given$gesture)) given$gesture[1] else -1
      of_this_gear <- is.null(given$turn) || identical(as.double(given$turn), as.double(tank$turn))
      if (is.null(tank$gear) || !of_this_gear) return(said("flume_idle", answers = number))
      edits <- if (is.list(given$edits)) given$edits else list()
      understood <- NULL
      if (!trying("design", understood <- tank$edit(edits, gesture), number)) return()
      # the user changed the design outside the form
      if (isTRUE(given$anew)) tank$lay_out()
      if (!under_way) return(ask_design(number, understood))
      if (!is.null(asked_again)) said("flume_idle", answers = asked_again)
      asked_again <<- number
    }
    ask_design <- function(number, understood = list()) {
      under_way <<- TRUE
      show_draft(understood, settling = TRUE)
      request_worker("design", NULL, number)
    }
    design_answered <- function() {
      under_way <<- FALSE
      number <- asked_again
      asked_again <<- NULL
      if (!is.null(number)) ask_design(number)
    }

    # Requests another gear, or the draft at the time when the worker is free (kind "design"). An
    # invalid gear changes nothing. If a draft does not settle, it is stored and the last shape
    # stays. A shape that arrives alone is displayed before the rest is requested.
    request_worker <- function(kind, asked, answers = 0, then = NULL) {
      # evaluated now, in the observer
      force(asked)
      force(answers)
      edited <- tank$edited
      ask <- function(kind, found_is, wanted = function() TRUE) {
        make <- function() {
          if (!wanted()) return(NULL)
          if (kind == "design") {
            edited <<- tank$edited
            asked <- tank$draft
          }
          tank$request(kind, asked, worker$holds, answers)
        }
        pause <- if (kind == "rest" && seconds() - since < rest_every) rest_pause else 0
        worker$ask(kind, make, pause = pause, then = function(answer) {
          if (session$isClosed()) return()
          if (kind == "design") on.exit(design_answered())
          # a later request has replaced this one
          if (is.null(answer)) return(said("flume_idle", answers = answers))
          if (!is.null(answer$problem)) {
            held <- !is.null(answer$draft)
            if (held) {
              tank$hold(answer$draft, edited)
              show_draft()
            }
            # errors of a typed plan are also reported below its text
            if (held && kind == "design") {
              said("flume_idle", answers = answers)
            } else {
              refuse(answer$problem, kind, answers)
            }
            if (is.null(owed)) return()
            if (kind %in% c("design", "plan_text") && worker$holds > 0) return(owed())
            # the worker has lost this shape, so the last complete design is displayed again
            owed <<- NULL
            tank$forget_picture()
            show()
          } else {
            found_is(answer$found)
          }
        })
      }
      complete <- function(found, passed = FALSE) {
        tank$take(kind, found, edited)
        worker$holds <- tank$serial
        owed <<- NULL
        show(answers, passed)
        show_draft()
        if (!is.null(then)) then()
      }
      ask(kind, function(found) {
        if (is.null(found$moved)) return(complete(found))
        session$sendBinaryMessage("flume_moved", found$moved)
        if (found$anew) tank$forget_picture()
        # the worker continues from this shape, complete or not
        worker$holds <- tank$serial
        if (is.null(owed)) since <<- seconds()
        # skipped if a newer shape has replaced this shape
        rest <- function() {
          ask("rest", function(found) complete(found, passed = TRUE),
            wanted = function() identical(owed, rest))
        }
        owed <<- rest
        owed()
      })
    }

    # Requests a product of the state on screen, then calls then(product). A later request of this
    # kind replaces a waiting request.
    request_slow_worker <- function(kind, asked, then) {
      force(asked)
      said("flume_clerk", busy = TRUE, what = kind)
      clerk$ask(
        kind, function() tank$request(kind, asked),
        function(answer) {
          if (session$isClosed() || is.null(answer)) return()
          said("flume_clerk", busy = FALSE, what = kind)
          if (!is.null(answer$problem)) return(refuse(answer$problem, kind))
          then(answer$found)
        }
      )
    }

    session$onFlushed(function() {
      if (is.null(tank$gear)) return()
      show()
      show_draft()
    })

    shiny::observeEvent(input$design, take_design(as.list(input$design)))
    for (kind in c("plan_file", "plan_text", "shipped", "new")) {
      local({
        kind <- kind
        shiny::observeEvent(input[[kind]], {
          given <- input[[kind]]
          asked <- if (is.list(given) && "asked" %in% names(given)) given$asked else given
          request_worker(kind, asked, number_of(given))
        })
      })
    }
    for (name in c("undo", "redo")) {
      local({
        name <- name
        shiny::observeEvent(input[[name]], {
          number <- number_of(input[[name]])
          if (!tank$step(name)) return(said("flume_idle", answers = number))
          show_draft(settling = TRUE)
          request_worker("design", NULL, number)
        })
      })
    }
    shiny::observeEvent(input$cancel, {
      worker$cancel()
      clerk$cancel()
    })
    shiny::observeEvent(input$preferred, {
      tank$preferred <- preferred_of(input$preferred)
      if (!is.null(tank$gear)) tank$count_picture()
    })

    open_words <- flume_keeping(
      input, tank, clerk, show, show_draft, trying, request_worker, said, session
    )
    if (!is.null(shared)) {
      flume_shares(input, tank, shared, shared_changed, visitor, said, trying, open_words)
    }
    serve_display(input, output, tank, said, say)
    flume_draws(input, tank, request_slow_worker, said)
    serve_sensitivities(input, output, session, tank, request_slow_worker, said, say)
    flume_intervals(input, tank, request_slow_worker)
    flume_varies(input, tank, clerk, said, session, say)
    flume_targets(input, tank, request_slow_worker, said, say)
    flume_tows(input, output, tank, clerk, request_slow_worker, said)
    flume_saves(output, tank, clerk)
  }
}

# Handles stored designs and designs in an address: `input$keep` = list(name), `input$kept` =
# list(id, act, name). Returns the function(words, number) that opens the designs of an address.
flume_keeping <- function(
  input, tank, clerk, show, show_draft, trying, request_worker, said, session
) {
  # user-defined rows of the catalogue
  take_own <- function(rows) {
    if (trying("own", tank$own <- own_rows(rows))) said("flume_own", rows = tank$own)
  }
  shiny::observeEvent(input$own, take_own(as.list(input$own)$rows))
  shiny::observeEvent(input$keep, {
    if (!is.null(tank$gear) && trying("keep", tank$keep(as.list(input$keep)$name))) show()
  })
  shiny::observeEvent(input$kept, {
    asked <- as.list(input$kept)
    act <- if (is_text(asked$act)) asked$act else ""
    if (act == "open") {
      trying("keep", {
        tank$change(tank$kept[[tank$kept_at(asked$id)]]$design)
        tank$lay_out()
        show_draft(settling = TRUE)
        request_worker("design", NULL, if (is.numeric(asked$number)) asked$number[1] else 0)
      })
    } else {
      good <- trying("keep", switch(act,
        compare = tank$compare(asked$id), remove = tank$remove(asked$id),
        rename = tank$rename(asked$id, asked$name), show = tank$see(asked$id, TRUE),
        hide = tank$see(asked$id, FALSE)
      ))
      if (good && !is.null(tank$gear)) show()
    }
  })
  # Opens the design of an address, then settles its stored designs in sequence. The sequence ends
  # if the user opens another design.
  open_words <- function(words, number) {
    others <- utils::head(as.list(words$kept), most_stored_designs)
    first_words <- as.list(words$now)
    draft <- as.list(words$draft)$plan
    if (length(words$own)) take_own(c(tank$own, words$own))
    begun <- FALSE
    settle_next <- function(opened) {
      if (!length(others) || session$isClosed() || !identical(tank$loaded, opened)) {
        return(invisible())
      }
      words <- as.list(others[[1L]])
      others <<- others[-1L]
      clerk$ask(
        "kept", function() tank$request("kept", words, tank$serial),
        function(answer) {
          if (session$isClosed() || !identical(tank$loaded, opened)) return()
          if (is.null(answer$problem)) {
            # replaces the design that was stored when the address was opened
            if (!begun) tank$kept <- list()
            begun <<- TRUE
            trying("keep", tank$keep(words$name, answer$found))
          }
          show()
          settle_next(opened)
        }
      )
    }
    request_worker("words", first_words, number, then = function() {
      if (is_text(draft)) request_worker("plan_text", draft)
      settle_next(tank$loaded)
    })
  }
  shiny::observeEvent(input$words, {
    asked <- as.list(input$words)
    open_words(as.list(asked$asked), if (is.numeric(asked$number)) asked$number[1] else 0)
  })
  open_words
}

# Returns the plan field of a part or support. The fallback for a support is a rope that ends there.
clicked_field <- function(gear, name) {
  path <- finding_field(gear$plan, name, NULL)
  if (!is.na(path)) return(path)
  ends_there <- Filter(function(rope) name %in% c(rope$from, rope$to), gear_si(gear)$ropes)
  if (!length(ends_there)) return(NA_character_)
  finding_field(gear$plan, names(ends_there)[1L], NULL)
}

serve_display <- function(input, output, tank, said, say) {
  of_state <- function(make) {
    shiny::renderUI({
      tank$changed()
      if (!is.null(tank$gear)) make()
    })
  }
  # The page keeps the list of measures until the list changes.
  listed <- measures <- NULL
  described <- function(x) attributes(x)[c("names", "unit", "kind")]
  shiny::observe({
    tank$changed()
    tank$uncertainty_changed()
    if (is.null(tank$gear)) return()
    now <- tank$measures
    kept <- tank$kept[[1L]]$measures
    given <- list(described(now), described(kept), tank$preferred)
    if (!identical(given, listed)) {
      measures <<- displayed_measures(now, kept, tank$preferred, say)
      said("flume_measures_about", measures = measures)
    }
    listed <<- given
    do.call(said, c("flume_measures", displayed_numbers(
      measures, now, kept, if (isTRUE(input$with_intervals)) tank$uncertainty, say
    )))
  })
  output$tensions <- of_state(function() tensions_html(tank$state, say))
  output$drag <- of_state(function() drag_html(tank$state, say))
  output$differences <- of_state(function() {
    differences_html(tank$kept[[1L]]$gear, tank$gear, say)
  })
  output$designs <- of_state(function() {
    tank$kept_changed()
    on_screen <- list(list(name = say("on_screen"), measures = tank$measures))
    designs_html(c(tank$kept, on_screen), tank$preferred, say)
  })
  output$code <- shiny::renderText({
    tank$changed()
    if (is.null(tank$gear)) "" else tank$code()
  })
  # The page requests strings once nothing moves, because they take longer than a picture.
  shiny::observeEvent(input$plan_wanted, {
    if (!is.null(tank$gear)) said("flume_plan", text = draft_text(tank$draft))
  })
  shiny::observeEvent(input$words_wanted, {
    words <- if (!is.null(tank$gear)) tank$words()
    said("flume_words", words = words, number = input$words_wanted)
  })
  # the user clicked a part in the picture
  shiny::observeEvent(input$part_wanted, {
    name <- as.list(input$part_wanted)$name
    if (is.null(tank$gear) || !is_text(name) || nchar(name) > most_name) return()
    path <- clicked_field(tank$gear, name)
    if (!is.na(path)) said("flume_part", path = path)
  })
  shiny::observe({
    tank$kept_changed()
    said("flume_kept", kept = lapply(tank$kept, `[`, c("id", "name", "seen")))
  })
  shiny::observeEvent(input$offers, {
    asked <- as.list(input$offers)
    if (is.null(tank$gear) || !is_text(asked$path) || !is_text(asked$title)) return()
    offers <- NULL
    problem <- flume_problem(offers <- form_offers(tank$draft$plan, asked$path, asked$title, say))
    if (is.null(problem)) {
      said("flume_offers", path = asked$path, title = asked$title, offers = offers)
    }
  })
}
