# The flume tank's server: one session is one browser with a gear of its own.

# Pages at most at a time, each with a process of its own.
flume_sessions <- 30L

# start: list(gear, state, notes) to open with; new_worker: a function() that gives a worker.
flume_server <- function(start, marked, nodes, new_worker = process_worker) {
  pages <- 0L
  function(input, output, session) {
    said <- function(what, ...) session$sendCustomMessage(what, list(...))
    if (pages >= flume_sessions) {
      said("flume_refused", answers = 0, where = "controls", path = NULL, control = NULL,
        message = "The tank has as many visitors as it can serve; try again later.")
      return(session$close())
    }
    bound_messages(session)
    tank <- new_tank(start, marked, nodes)
    worker <- new_worker()
    pages <<- pages + 1L
    session$onSessionEnded(function() {
      pages <<- pages - 1L
      worker$stop()
    })

    # A picture goes out before the tables are made.
    show <- function(answers = 0) {
      message <- tank$picture()
      session$sendCustomMessage("flume_picture", c(list(
        answers = answers, said = spoken(tank$measures), notes = I(as.character(tank$notes))
      ), message))
      tank$changed(shiny::isolate(tank$changed()) + 1L)
    }
    refuse <- function(problem, where, answers = 0) {
      said("flume_refused", answers = answers, where = where, message = problem$message,
        path = problem$path, control = control_of_path(tank$controls, problem$path))
    }

    # Asks the worker for another gear. A design that is wrong or does not settle changes nothing,
    # and so does one of controls that have been laid out anew since.
    ask_worker <- function(kind, asked, where = kind, answers = 0) {
      # of now, in the observer
      force(asked)
      turn <- tank$turn
      worker$ask(
        kind, function() if (tank$turn == turn) tank$request(kind, asked, worker$holds),
        function(answer) {
          if (session$isClosed()) return()
          if (is.null(answer) || tank$turn != turn) return(show(answers))
          if (!is.null(answer$problem)) return(refuse(answer$problem, where, answers))
          tank$take(kind, answer$found)
          worker$holds <- tank$serial
          show(answers)
        }
      )
    }

    session$onFlushed(function() show())

    shiny::observeEvent(input$design, {
      given <- as.list(input$design)
      answers <- if (is.numeric(given$number)) given$number[1] else 0
      ask_worker("design", as.list(given$values), "controls", answers)
    })
    shiny::observeEvent(input$plan_file, ask_worker("plan_file", input$plan_file))
    shiny::observeEvent(input$plan_text, ask_worker("plan_text", input$plan_text))
    shiny::observeEvent(input$mark, {
      problem <- flume_problem(tank$mark(input$mark))
      if (is.null(problem)) show() else refuse(problem, "mark")
    })
    shiny::observeEvent(input$pin, {
      tank$pin()
      show()
    })
    shiny::observeEvent(input$reset, {
      tank$reset()
      show()
    })

    output$controls <- shiny::renderUI({
      tank$laid_out()
      controls_html(tank$controls)
    })
    output$markable <- shiny::renderUI({
      tank$laid_out()
      markable_html(tank$gear$plan, tank$controls)
    })
    of_state <- function(make) {
      shiny::renderUI({
        tank$changed()
        make()
      })
    }
    output$measures <- of_state(function() measures_html(tank$measures, tank$pinned$measures))
    output$tensions <- of_state(function() tensions_html(tank$state))
    output$drag <- of_state(function() drag_html(tank$state))
    output$differences <- of_state(function() differences_html(tank$pinned$gear, tank$gear))
    output$code <- shiny::renderText({
      tank$changed()
      tank$code()
    })
    # The plan is a text of the user's once it is being changed: the page decides what to do with
    # it.
    shiny::observe({
      tank$changed()
      if (identical(input$shown, "Plan")) said("flume_plan", text = format(tank$gear))
    })
    flume_saves(output, tank, worker)
  }
}

# What a session holds. `changed` counts the pictures, `laid_out` and `turn` how often the controls
# were laid out: with the values of the gear `base`, which those that are moved since change.
# `serial` numbers the states.
new_tank <- function(start, marked, nodes) {
  tank <- new.env(parent = emptyenv())
  tank$loaded <- start$gear
  tank$gear <- start$gear
  tank$state <- start$state
  tank$drawing <- if (is.null(start$drawing)) flume_drawing(start$state) else start$drawing
  tank$measures <- if (is.null(start$measures)) measures(start$state) else start$measures
  tank$notes <- start$notes
  tank$known <- list()
  tank$turn <- 0L
  tank$serial <- 1L
  tank$changed <- shiny::reactiveVal(0L)
  tank$laid_out <- shiny::reactiveVal(0L)

  lay_out <- function() {
    tank$base <- tank$gear
    tank$controls <- plan_controls(tank$gear$plan, marked)
    tank$turn <- tank$turn + 1L
    tank$laid_out(shiny::isolate(tank$laid_out()) + 1L)
  }
  # A request of a worker that holds the state of a number.
  tank$request <- function(kind, said, holds = 0L) {
    list(
      kind = kind, said = said, base = tank$base, controls = tank$controls, nodes = nodes,
      file = tank$gear$file, state = if (!identical(holds, tank$serial)) tank$state
    )
  }
  # Puts on screen what a worker found.
  tank$take <- function(kind, found) {
    list2env(found[c("gear", "state", "notes", "drawing", "measures")], tank)
    tank$serial <- tank$serial + 1L
    if (kind == "plan_file") tank$loaded <- tank$gear
    if (kind != "design") lay_out()
    if (kind == "plan_file") tank$pin()
  }
  tank$mark <- function(path) {
    if (!is_text(path)) abort_argument("A field is marked by its path.")
    marked <<- c(marked, check_marked(path, tank$gear$plan))
    lay_out()
  }
  tank$pin <- function() {
    tank$pinned <- as.list(tank)[c("gear", "state", "drawing", "measures")]
  }
  tank$reset <- function() {
    list2env(tank$pinned, tank)
    tank$notes <- character()
    tank$serial <- tank$serial + 1L
    lay_out()
  }
  tank$picture <- function() {
    message <- picture_message(tank$state, tank$drawing, tank$pinned$drawing, tank$known)
    tank$known <- list(now = tank$drawing, pinned = tank$pinned$drawing)
    message
  }
  tank$code <- function() flume_code(tank$loaded, tank$pinned$gear, tank$gear, nodes)
  lay_out()
  tank$pin()
  tank
}

# The first measures of a gear as a sentence, for those who listen.
spoken <- function(measures) {
  shown <- unique(c(utils::head(names(measures), 3L), "total_drag_kN"))
  paste0("Settled. ", paste(measure_text(measures[shown]), collapse = ", "), ".")
}

# What can be saved of what is on screen. The worker writes what takes long.
flume_saves <- function(output, tank, worker) {
  save <- function(name, extension, write) {
    shiny::downloadHandler(
      filename = function() paste0(file_words(tank$gear$plan$name), name, ".", extension),
      content = write
    )
  }
  table <- function(make) function(file) write_csv(make(), file)
  by_worker <- function(format) {
    function(file) {
      promises::promise(function(resolve, reject) {
        worker$ask(
          "save",
          function() tank$request("save", list(format = format, file = file), worker$holds),
          function(answer) {
            if (is.null(answer$problem)) resolve(file) else reject(answer$problem$message)
          }
        )
      })
    }
  }
  output$save_plan <- save("", "yaml", function(file) write_gear(tank$gear, file))
  output$save_measures <- save("-measures", "csv", table(function() {
    measure_changes(tank$measures, tank$pinned$measures)
  }))
  lapply(formats_of("state"), function(format) {
    output[[paste0("save_", format$name)]] <- save(
      paste0("-", format$name), sub(".", "", format$extension, fixed = TRUE),
      by_worker(format$name)
    )
  })
  output$save_drag <- save("-drag", "csv", table(function() {
    as.data.frame(tank$state, what = "drag")
  }))
  output$save_code <- save("", "R", function(file) write_text(c(tank$code(), ""), file))
  output$save_report <- save("", "html", by_worker("report"))
}

# A gear's name as part of a file's.
file_words <- function(name) {
  words <- gsub("[^a-z0-9]+", "-", tolower(iconv(name, to = "ASCII//TRANSLIT", sub = "")))
  words <- gsub("^-|-$", "", substr(words, 1, 60))
  if (is.na(words) || !nzchar(words)) "gear" else words
}
