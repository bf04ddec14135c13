# The flume tank's server: one session is one browser with a gear of its own.

# Pages at most at a time, each with processes of its own.
flume_sessions <- 30L

# A shape that a slider passes through is told whole, with its measures, once nothing else was asked
# for so long (s), and during a long movement so often (s): the net itself moves more often.
rest_pause <- 0.08
rest_every <- 0.5

# start: list(gear, state, notes) to open with, or NULL; new_worker: a function(seconds, late) that
# gives a worker; folder: of shared designs, or NULL.
flume_server <- function(start, marked, nodes, new_worker = process_worker, folder = NULL) {
  pages <- 0L
  shared <- if (!is.null(folder)) new_shared(folder)
  shared_changed <- shiny::reactiveVal(0L)
  function(input, output, session) {
    said <- function(what, ...) session$sendCustomMessage(what, list(...))
    request <- session$request
    if (!same_origin(request)) return(session$close())
    if (pages >= flume_sessions) {
      said("flume_refused", answers = 0, where = "gallery", path = NULL,
        message = "The tank has as many visitors as it can serve; try again later.")
      return(session$close())
    }
    bound_messages(session)
    # its page has the same address and headers
    say <- new_say(page_language(
      shiny::isolate(session$clientData$url_search), request$HTTP_ACCEPT_LANGUAGE
    ))
    tank <- new_tank(start, marked, nodes, say)
    worker <- new_worker()
    # what is asked for and waited for: the net moves on meanwhile
    clerk <- new_worker(seconds = clerk_seconds, late = TRUE)
    pages <<- pages + 1L
    session$onSessionEnded(function() {
      pages <<- pages - 1L
      worker$stop()
      clerk$stop()
    })

    # A picture goes out before the tables are made.
    show <- function(answers = 0, passed = FALSE) {
      if (is.null(tank$gear)) return(said("flume_idle", answers = answers))
      message <- tank$picture(passed)
      session$sendCustomMessage("flume_picture", c(list(
        answers = answers, said = spoken(tank$measures, say), notes = I(tank$warnings()),
        towed = !is.null(tank$gear$plan$tow)
      ), message))
      tank$count_picture()
    }
    # What the page is told of its draft: its form where that has other fields, what was understood
    # of it, what is wrong, which steps there are.
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
    # A mistake of what the page asks is told there, and changes nothing.
    trying <- function(where, expression, answers = 0) {
      problem <- flume_problem(expression)
      if (!is.null(problem)) refuse(problem, where, answers)
      is.null(problem)
    }
    number_of <- function(given) {
      number <- as.list(given)$number
      if (is.numeric(number) && length(number) == 1L) number else 0
    }

    # Asks for the rest of the shape that the page has, or NULL where it has all; and since when it
    # lacks some, s.
    owed <- NULL
    since <- 0
    seconds <- function() proc.time()[["elapsed"]]

    # A page that changes its design before it was answered, which a hand at a slider does not, is
    # answered once for all these changes.
    under_way <- FALSE
    asked_again <- NULL  # the number of the last of them
    take_design <- function(given) {
      number <- number_of(given)
      gesture <- if (is.numeric(given$gesture)) given$gesture[1] else -1
      of_this_gear <- is.null(given$turn) || identical(as.double(given$turn), as.double(tank$turn))
      if (is.null(tank$gear) || !of_this_gear) return(said("flume_idle", answers = number))
      edits <- if (is.list(given$edits)) given$edits else list()
      understood <- NULL
      if (!trying("design", understood <- tank$edit(edits, gesture), number)) return()
      # of what was not changed in the form
      if (isTRUE(given$anew)) tank$lay_out()
      if (!under_way) return(ask_design(number, understood))
      if (!is.null(asked_again)) said("flume_idle", answers = asked_again)
      asked_again <<- number
    }
    ask_design <- function(number, understood = list()) {
      under_way <<- TRUE
      show_draft(understood, settling = TRUE)
      ask_worker("design", NULL, number)
    }
    design_answered <- function() {
      under_way <<- FALSE
      number <- asked_again
      asked_again <<- NULL
      if (!is.null(number)) ask_design(number)
    }

    # Asks the worker for another gear, or for the draft as it is when its turn comes (kind
    # "design"). A gear that is wrong changes nothing; a draft that does not settle stays, and so
    # does the last shape. Where only its shape has come, that is shown before the rest is asked
    # for.
    ask_worker <- function(kind, asked, answers = 0, then = NULL) {
      # of now, in the observer
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
          # a later one has its place
          if (is.null(answer)) return(said("flume_idle", answers = answers))
          if (!is.null(answer$problem)) {
            held <- !is.null(answer$draft)
            if (held) {
              tank$hold(answer$draft, edited)
              show_draft()
            }
            # what was typed as a text is marked there too
            if (held && kind == "design") {
              said("flume_idle", answers = answers)
            } else {
              refuse(answer$problem, kind, answers)
            }
            if (is.null(owed)) return()
            if (kind %in% c("design", "plan_text") && worker$holds > 0) return(owed())
            # nobody has the shape on screen any more
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
        # it goes on from this shape, told whole or not
        worker$holds <- tank$serial
        if (is.null(owed)) since <<- seconds()
        # of no shape that another has taken the place of
        rest <- function() {
          ask("rest", function(found) complete(found, passed = TRUE),
            wanted = function() identical(owed, rest))
        }
        owed <<- rest
        owed()
      })
    }

    # Asks the clerk for something of the state on screen; then(what it found). A later question of
    # the kind takes the place of one that waits.
    ask_clerk <- function(kind, asked, then) {
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
          ask_worker(kind, asked, number_of(given))
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
          ask_worker("design", NULL, number)
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
      input, tank, clerk, show, show_draft, trying, ask_worker, said, session
    )
    if (!is.null(shared)) {
      flume_shares(input, tank, shared, shared_changed, said, trying, open_words)
    }
    flume_shown(input, output, tank, said, say)
    flume_draws(input, tank, ask_clerk, said)
    flume_slopes(input, output, session, tank, ask_clerk, said, say)
    flume_intervals(input, tank, ask_clerk)
    flume_varies(input, tank, clerk, said, session, say)
    flume_tows(input, output, tank, clerk, ask_clerk, said)
    flume_saves(output, tank, clerk)
  }
}

# Whether a connection comes from the tank's own page. Browsers let any page open one to any server,
# and name the page's origin with it; other programs name none.
same_origin <- function(request) {
  origin <- request$HTTP_ORIGIN
  if (is.null(origin)) return(TRUE)
  host <- request$HTTP_HOST
  if (!is_text(origin) || !is_text(host)) return(FALSE)
  plain <- function(place, scheme) {
    sub(if (scheme == "https") ":443$" else ":80$", "", tolower(place))
  }
  scheme <- tolower(sub("://.*", "", origin))
  grepl("^https?://", tolower(origin)) &&
    plain(sub("^[^/]*//", "", origin), scheme) == plain(host, scheme)
}

# Designs that are kept: input$keep = list(name), input$kept = list(id, act, name), and the words of
# an address. Returns the function(words, number) that opens what an address says.
flume_keeping <- function(
  input, tank, clerk, show, show_draft, trying, ask_worker, said, session
) {
  # rows of the catalogue, as they are kept
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
        ask_worker("design", NULL, if (is.numeric(asked$number)) asked$number[1] else 0)
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
  # An address opens its design, then settles those that it keeps, one after the other. They are
  # asked for as they are told, and a design that somebody opens meanwhile ends it.
  open_words <- function(words, number) {
    others <- utils::head(as.list(words$kept), most_kept)
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
            # in place of the one that was kept as the address was opened
            if (!begun) tank$kept <- list()
            begun <<- TRUE
            trying("keep", tank$keep(words$name, answer$found))
          }
          show()
          settle_next(opened)
        }
      )
    }
    ask_worker("words", first_words, number, then = function() {
      if (is_text(draft)) ask_worker("plan_text", draft)
      settle_next(tank$loaded)
    })
  }
  shiny::observeEvent(input$words, {
    asked <- as.list(input$words)
    open_words(as.list(asked$asked), if (is.numeric(asked$number)) asked$number[1] else 0)
  })
  open_words
}

# The plan's field of a part or a support: where the plan names it, else of a rope that ends there.
clicked_field <- function(gear, name) {
  path <- finding_field(gear$plan, name, NULL)
  if (!is.na(path)) return(path)
  ends_there <- Filter(function(rope) name %in% c(rope$from, rope$to), gear_si(gear)$ropes)
  if (!length(ends_there)) return(NA_character_)
  finding_field(gear$plan, names(ends_there)[1L], NULL)
}

# Tables and texts of what is on screen.
flume_shown <- function(input, output, tank, said, say) {
  of_state <- function(make) {
    shiny::renderUI({
      tank$changed()
      if (!is.null(tank$gear)) make()
    })
  }
  measured <- function(key) {
    of_state(function() {
      tank$uncertainty_changed()
      measures_html(tank$measures, tank$kept[[1L]]$measures, tank$preferred,
        if (isTRUE(input$with_intervals)) tank$uncertainty, key, say)
    })
  }
  output$measures <- measured(key = TRUE)
  output$other_measures <- measured(key = FALSE)
  # they are there as soon as the page opens them
  shiny::outputOptions(output, "other_measures", suspendWhenHidden = FALSE)
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
  # The page asks for texts once nothing moves: they take longer than a picture.
  shiny::observeEvent(input$plan_wanted, {
    if (!is.null(tank$gear)) said("flume_plan", text = draft_text(tank$draft))
  })
  shiny::observeEvent(input$words_wanted, {
    words <- if (!is.null(tank$gear)) tank$words()
    said("flume_words", words = words, number = input$words_wanted)
  })
  # of a part that was clicked in the picture
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
