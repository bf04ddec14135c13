# The server of the flume tank. A session is one browser with its own gear.

# Largest number of sessions at a time, each with its own processes.
flume_sessions <- 30L

# While a slider moves, each shape is sent at once. Measures follow after a pause of `rest_pause` s,
# and every `rest_every` s during a long movement.
rest_pause <- 0.08
rest_every <- 0.5

# start: from settled_start(), or NULL; marked: fields with additional controls;
# new_worker: a function(seconds, late) that returns a worker; folder: of shared designs, or NULL;
# hosts: names under which a proxy serves the page, or NULL.
#
# Returns a function(request, send, send_bytes, close) that opens a page and returns list(hear,
# leave, handlers, tank), or NULL if it rejects the page. request: HTTP request of the connection;
# send(type, message) and send_bytes(bytes) send messages; close() ends the connection.
# hear(type, message) receives a message, and leave() ends the page.
flume_server <- function(
  start, marked, nodes, new_worker = process_worker, folder = NULL, hosts = NULL
) {
  pages <- 0L
  visitors <- new_visitors()
  shared <- if (!is.null(folder)) new_shared(folder)
  function(request, send, send_bytes, close) {
    said <- function(type, ...) send(type, list(...))
    if (!same_origin(request) || !known_host(request, hosts)) return(NULL)
    visitor <- visitors(visitor_of(request))
    full <- if (pages >= flume_sessions) {
      "The tank has reached its maximum number of visitors; try again later."
    } else if (!visitor$enter()) {
      "You have too many pages of the tank open; close one and reload this page."
    }
    say <- make_translator(page_language(request$QUERY_STRING, request$HTTP_ACCEPT_LANGUAGE))
    # after a lost connection, the page opens its own design again
    if (continues(request$QUERY_STRING)) start <- NULL
    send("flume_begin", begin_message(say, !is.null(start), !is.null(folder)))
    if (!is.null(full)) {
      said("flume_refused", answers = 0, where = "gallery", path = NULL, message = full)
      return(NULL)
    }
    tank <- new_tank(start, marked, nodes, say)
    worker <- new_worker()
    # second worker for slow requests (reports, tows), so that the 3D view stays responsive
    clerk <- new_worker(seconds = slow_worker_seconds, late = TRUE)
    pages <<- pages + 1L
    open <- TRUE
    leave <- function() {
      if (!open) return()
      open <<- FALSE
      pages <<- pages - 1L
      visitor$leave()
      if (!is.null(shared)) shared$ignore(id)
      worker$stop()
      clerk$stop()
    }
    # what the functions for parts of the page use
    page <- list2env(list(
      tank = tank, said = said, clerk = clerk, send_bytes = send_bytes,
      closed = function() !open
    ))

    # The page keeps the list of measures until the list changes.
    listed <- NULL
    page$show_measures <- function() {
      about <- measures_about(tank$measures)
      now <- measures_numbers(tank$measures, if (tank$with_intervals) tank$uncertainty)
      send("flume_measures", c(if (!identical(about, listed)) list(about = about), now))
      listed <<- about
      if (!tank$with_intervals || !is.null(tank$uncertainty)) return()
      page$request_slow_worker("uncertainty", NULL, function(found) {
        tank$uncertainty <- found
        page$show_measures()
      })
    }
    page$show <- function(answers = 0, passed = FALSE) {
      if (is.null(tank$gear)) return(said("flume_idle", answers = answers))
      said("flume_picture",
        answers = answers, edited = tank$shown, notes = I(tank$warnings()),
        towed = !is.null(tank$gear$plan$tow), scene = tank$picture(passed)
      )
      page$show_measures()
    }
    # Sends the form if its fields changed, interpreted numbers, and problems.
    page$show_draft <- function(understood = list(), settling = FALSE) {
      if (is.null(tank$gear)) return()
      said("flume_draft",
        form = if (tank$form_is_old()) tank$form(), understood = understood,
        problems = tank$problems, settling = settling
      )
    }
    refuse <- function(problem, where, answers = 0) {
      said("flume_refused", answers = answers, where = where, message = problem$message,
        path = problem$path, cancelled = isTRUE(problem$cancelled))
    }
    # An error in a request is reported in its part of the page. Returns TRUE on success.
    page$trying <- function(where, expression, answers = 0) {
      problem <- flume_problem(expression)
      if (!is.null(problem)) refuse(problem, where, answers)
      is.null(problem)
    }

    # Requests the rest of the shape that the page has (NULL if the page has all data); and the time
    # since which data are missing [s].
    owed <- NULL
    passed <- 0L  # number of shapes that arrived alone
    since <- 0
    seconds <- function() proc.time()[["elapsed"]]

    # If the page changes its design again before an answer, one answer covers all these changes. A
    # moving slider waits for each answer.
    under_way <- FALSE
    asked_again <- NULL  # number of the last change
    # given: list(number, turn, and either edits or design)
    take_design <- function(given) {
      number <- request_number(given)
      of_this_gear <- is.null(given$turn) || identical(as.double(given$turn), as.double(tank$turn))
      if (is.null(tank$gear) || !of_this_gear) return(said("flume_idle", answers = number))
      edits <- if (is.list(given$edits)) given$edits else list()
      understood <- NULL
      taken <- page$trying("design", answers = number, if (is.null(given$design)) {
        understood <- tank$edit(edits, number)
      } else {
        tank$change(sent_design(given$design), number)
      })
      if (!taken) return()
      # the user changed the design outside the form
      if (isTRUE(given$anew) || !is.null(given$design)) tank$lay_out()
      if (!under_way) return(ask_design(number, understood))
      if (!is.null(asked_again)) said("flume_idle", answers = asked_again)
      asked_again <<- number
    }
    ask_design <- function(number, understood = list()) {
      under_way <<- TRUE
      page$show_draft(understood, settling = TRUE)
      page$request_worker("design", NULL, number)
    }
    design_answered <- function() {
      under_way <<- FALSE
      number <- asked_again
      asked_again <<- NULL
      if (!is.null(number)) ask_design(number)
    }

    show_opened <- function(answers = 0) {
      said("flume_opened", answers = answers, design = page_design(tank$gear))
    }

    # Requests another gear, or the draft at the time when the worker is free (kind "design"). An
    # invalid gear changes nothing. If a draft does not settle, it is stored and the last shape
    # stays. A shape that arrives alone is displayed before the rest is requested.
    page$request_worker <- function(kind, asked, answers = 0) {
      force(asked)
      force(answers)
      edited <- answers
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
          if (page$closed()) return()
          if (kind == "design") on.exit(design_answered())
          # a later request has replaced this one
          if (is.null(answer)) return(said("flume_idle", answers = answers))
          if (!is.null(answer$problem)) {
            if (is.null(answer$problems)) {
              refuse(answer$problem, kind, answers)
            } else {
              if (edited == tank$edited) tank$problems <- answer$problems
              page$show_draft()
              said("flume_idle", answers = answers)
            }
            if (is.null(owed)) return()
            if (kind == "design" && worker$holds > 0) return(owed())
            # the worker has lost this shape, so the last complete design is displayed again
            owed <<- NULL
            tank$forget_picture()
            page$show()
          } else {
            found_is(answer$found)
          }
        })
      }
      complete <- function(found, passed = FALSE) {
        tank$take(kind, found, edited)
        worker$holds <- tank$serial
        owed <<- NULL
        if (kind %in% opening_requests) show_opened(answers)
        page$show(answers, passed)
        page$show_draft()
      }
      ask(kind, function(found) {
        if (is.null(found$moved)) return(complete(found))
        send_bytes(found$moved)
        passed <<- passed + 1L
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

    # Requests a product of the state on screen, then calls then(product), if it is of_state only
    # for the same state. A later request of this kind replaces a waiting request.
    page$request_slow_worker <- function(kind, asked, then, of_state = kind %in% of_one_state) {
      force(asked)
      serial <- tank$serial
      said("flume_clerk", busy = TRUE, what = kind)
      clerk$ask(
        kind, function() tank$request(kind, asked),
        function(answer) {
          if (page$closed() || is.null(answer)) return()
          said("flume_clerk", busy = FALSE, what = kind)
          if (!is.null(answer$problem)) return(refuse(answer$problem, kind))
          if (!of_state || tank$serial == serial) then(answer$found)
        }
      )
    }

    # messages that open a gear
    opens <- lapply(stats::setNames(nm = opening_requests), function(kind) function(given) {
        page$request_worker(kind, as.list(given)$asked, request_number(given))
      })
    handlers <- c(opens, list(
      design = function(given) take_design(as.list(given)),
      cancel = function(given) {
        worker$cancel()
        clerk$cancel()
      },
      intervals_wanted = function(given) {
        tank$with_intervals <- isTRUE(given)
        if (!is.null(tank$gear)) page$show_measures()
      }
    ), flume_keeping(page), lapply(c(
      flume_display(page), flume_products(page), flume_varies(page), flume_saves(page),
      flume_predicts(page, worker, function() passed)
    ), function(handler) function(given) if (!is.null(tank$gear)) handler(given)))
    if (!is.null(shared)) {
      id <- shared$listen(function(designs) said("flume_shared", designs = designs))
      handlers <- c(handlers, flume_shares(page, shared, visitor))
    }
    if (!is.null(tank$gear)) {
      show_opened()
      page$show()
      page$show_draft()
    }
    hear <- function(type, given) {
      handler <- handlers[[type]]
      if (!open || is.null(handler)) return()
      # an error here, outside every request, would end the tank for all users
      tryCatch(handler(given), error = function(e) {
        message("codend flume: ", conditionMessage(e))
      })
    }
    list(hear = hear, leave = leave, handlers = handlers, tank = tank)
  }
}

# Returns the handlers of stored designs, which the page keeps, and of user-defined rows of the
# catalogue: `kept` = list(number, design) settles a design.
flume_keeping <- function(page) {
  list(
    own = function(given) {
      rows <- NULL
      if (page$trying("own", rows <- own_rows(as.list(given)$rows))) {
        page$said("flume_own", rows = rows)
      }
    },
    kept = function(given) {
      given <- as.list(given)
      request <- page$tank$request("kept", given$design, page$tank$serial)
      page$clerk$ask("kept", function() request, function(answer) {
        if (page$closed()) return()
        found <- answer$found
        page$said("flume_kept",
          number = request_number(given),
          design = if (!is.null(found)) list(
            scene = picture_scene(found$state, found$drawing),
            about = measures_about(found$measures),
            numbers = measures_numbers(found$measures)
          )
        )
      })
    }
  )
}

# TRUE if the address of a page says that it continues after a lost connection.
continues <- function(query) isTRUE(grepl("[?&]continues(&|=|$)", query))

# Returns the number of a request, 0 without one.
request_number <- function(given) {
  number <- as.list(given)$number
  if (is.numeric(number) && length(number) == 1L) number else 0
}

# Returns the names of the parts that a plan field describes, or whose description contains it.
parts_of_field <- function(gear, path) {
  kinds <- gear_si(gear)[c("ropes", "panels", "pieces")]
  parts <- as.character(unlist(lapply(unname(kinds), names)))
  # a gear like another one has the fields of the other one
  steps <- path_steps(path)
  if (length(steps) == 2L && steps[1L] == "gears") {
    return(grep(paste0("^", steps[2L], "(_[0-9]+)?_"), parts, value = TRUE))
  }
  field <- vapply(parts, function(part) finding_field(gear$plan, part, NULL), "")
  of <- function(inner, outer) startsWith(paste0(inner, "."), paste0(outer, "."))
  unique(parts[of(path, field) | of(field, path)])
}

# Returns the handlers of tables, texts and parts. The page requests them once nothing moves.
flume_display <- function(page) {
  tank <- page$tank
  said <- page$said
  list(
    table_wanted = function(given) {
      name <- as.list(given)$name
      make <- if (is_text(name)) tank_tables[[name]]
      tables <- NULL
      if (is.null(make)) return()
      if (page$trying("table", tables <- make(tank, as.list(given)$kept))) {
        said("flume_table", name = name, tables = tables)
      }
    },
    plan_wanted = function(given) said("flume_plan", text = draft_text(tank$draft)),
    code_wanted = function(given) {
      text <- NULL
      good <- page$trying("code", text <- flume_code(
        gear_of_words(as.list(given)$opened), gear_of_words(as.list(given)$kept), tank$gear,
        tank$nodes
      ))
      if (good) said("flume_code", text = text)
    },
    # the user chose a part by its name in the picture, or by its path in the form or the drawing
    part_wanted = function(given) {
      given <- as.list(given)
      clicked <- is.null(given$path)
      wanted <- if (clicked) given$name else given$path
      if (!is_text(wanted) || nchar(wanted) > if (clicked) most_name else most_characters) return()
      path <- if (clicked) clicked_field(tank$gear, wanted) else wanted
      if (is.na(path)) return()
      said("flume_part", path = path, names = I(parts_of_field(tank$gear, path)), clicked = clicked)
    },
    offers = function(given) {
      asked <- as.list(given)
      if (!is_text(asked$path) || !is_text(asked$title)) return()
      offers <- NULL
      problem <- flume_problem(offers <- form_offers(tank$draft$plan, asked$path, asked$title))
      if (is.null(problem)) {
        said("flume_offers", path = asked$path, title = asked$title, offers = offers)
      }
    }
  )
}

# Products that are discarded if another state is on screen.
of_one_state <- c("uncertainty", "slopes", "target")

# Returns the handlers of products of the slow worker.
flume_products <- function(page) {
  tank <- page$tank
  list(
    drawing_wanted = function(given) {
      edited <- tank$edited
      page$request_slow_worker("drawing", tank$draft, function(found) {
        # if the draft has changed, the page requests a new drawing
        if (edited == tank$edited) page$said("flume_drawing", svg = found)
      })
    },
    # the fields `paths`, or the fields that users change first if there are no paths
    slopes_wanted = function(given) {
      page$request_slow_worker("slopes", as.list(given)$paths, function(found) {
        page$said("flume_sensitivities", fields = sensitivities_message(found))
      })
    },
    target_wanted = function(given) {
      page$request_slow_worker("target", as.list(given), function(found) {
        found$measure <- label_of(found$measure, found$measure_unit)
        found$paths <- I(found$paths)
        do.call(page$said, c("flume_target", found))
      })
    },
    tow_wanted = function(given) {
      page$request_slow_worker("tow", as.list(given), function(found) {
        tank$trajectory <- found$trajectory
        page$said("flume_tow", scene = found$scene)
      })
    }
  )
}
