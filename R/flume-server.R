# The flume tank's server: one session is one browser with a gear of its own.

# Steps of the solver from a crude start, at most, before a design counts as one that does not
# settle: someone is waiting.
flume_steps <- 1000L

# Most nodes of a design, whatever its plan asks for.
flume_nodes <- 20000

# Seconds that the answer to one message may take: others wait meanwhile.
flume_seconds <- 30

# start: list(gear, state, notes) to open with.
flume_server <- function(start, marked, nodes) {
  function(input, output, session) {
    tank <- new_tank(start, marked, nodes)
    said <- function(what, ...) session$sendCustomMessage(what, list(...))

    # A picture goes out before the tables are made.
    show <- function(answers = 0) {
      message <- tank$picture()
      session$sendCustomMessage("flume_picture", c(list(
        answers = answers, said = spoken(tank$measures), notes = I(as.character(tank$notes))
      ), message))
      tank$changed(shiny::isolate(tank$changed()) + 1L)
    }

    # try: what changes the tank. A design that is wrong or does not settle changes nothing.
    attempt <- function(try, where, answers = 0) {
      problem <- flume_problem(in_time(try()))
      if (is.null(problem)) {
        show(answers)
        return(TRUE)
      }
      said("flume_refused", answers = answers, where = where, message = problem$message,
        path = problem$path, control = control_of_path(tank$controls, problem$path))
      FALSE
    }

    session$onFlushed(function() {
      session$sendCustomMessage("flume_palettes", flume_palettes())
      show()
    })

    shiny::observeEvent(input$design, {
      given <- as.list(input$design)
      answers <- if (is.numeric(given$number)) given$number[1] else 0
      attempt(function() tank$design(as.list(given$values)), "controls", answers)
    })
    shiny::observeEvent(input$plan_file, {
      attempt(function() tank$open(read_opened(input$plan_file)), "plan_file")
    })
    shiny::observeEvent(input$plan_text, {
      attempt(function() tank$replace(read_typed(input$plan_text, tank$gear)), "plan_text")
    })
    shiny::observeEvent(input$mark, {
      attempt(function() tank$mark(input$mark), "mark")
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
    flume_saves(output, tank)
  }
}

# What a session holds. `changed` counts the pictures, `laid_out` how often the controls were laid
# out: with the values of the gear `base`, which those that are moved since change.
new_tank <- function(start, marked, nodes) {
  tank <- new.env(parent = emptyenv())
  tank$loaded <- start$gear
  tank$gear <- start$gear
  tank$state <- start$state
  tank$drawing <- flume_drawing(start$state)
  tank$measures <- measures(start$state)
  tank$notes <- start$notes
  tank$known <- list()
  tank$changed <- shiny::reactiveVal(0L)
  tank$laid_out <- shiny::reactiveVal(0L)

  # Puts a gear that settles on screen; what fails leaves everything as it is.
  put <- function(gear, from) {
    # Checked before it is asked for: a gear just checked is not checked again.
    force(gear)
    found <- settle_noted(gear, nodes, from)
    drawing <- flume_drawing(found$state)
    tank$gear <- gear
    tank$state <- found$state
    tank$notes <- found$notes
    tank$drawing <- drawing
    tank$measures <- measures(found$state)
  }
  lay_out <- function() {
    tank$base <- tank$gear
    tank$controls <- plan_controls(tank$gear$plan, marked)
    tank$laid_out(shiny::isolate(tank$laid_out()) + 1L)
  }
  tank$design <- function(values) {
    put(apply_controls(tank$base, tank$controls, values), tank$state)
  }
  tank$replace <- function(gear) {
    put(gear, tank$state)
    lay_out()
  }
  tank$open <- function(gear) {
    put(gear, NULL)
    tank$loaded <- gear
    lay_out()
    tank$pin()
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

# Settles from a state where it has the same parts, else anew: list(state, notes = warnings,
# then what is worth a look).
settle_noted <- function(gear, nodes, from) {
  notes <- character()
  check_lattice_size(gear_si(gear), nodes, most = max(flume_nodes, 2 * nodes))
  settle_from <- function(from) settle_gear(gear, nodes, NULL, from, flume_steps)
  state <- withCallingHandlers(
    tryCatch(settle_from(from), codend_error_argument = function(e) settle_from(NULL)),
    codend_warning = function(w) {
      notes <<- c(notes, plain_message(w))
      invokeRestart("muffleWarning")
    }
  )
  list(state = state, notes = c(notes, finding_sentences(findings(state))))
}

# NULL when an expression goes well, else list(message, path = of the plan's wrong field or NULL). A
# mistake of the program's own is told and logged, and the page lives on.
flume_problem <- function(expression) {
  tryCatch(
    {
      force(expression)
      NULL
    },
    codend_error = function(e) list(message = plain_message(e), path = e$path),
    error = function(e) {
      message("codend flume: ", conditionMessage(e))
      list(message = paste0("codend failed at this: ", plain_message(e)), path = NULL)
    }
  )
}

# The value of an expression that ends in time.
in_time <- function(expression, seconds = flume_seconds) {
  setTimeLimit(elapsed = seconds, transient = TRUE)
  on.exit(setTimeLimit())
  tryCatch(expression, error = function(e) {
    if (!inherits(e, "codend_error") && grepl("time limit", conditionMessage(e), fixed = TRUE)) {
      abort_argument("This takes longer than {seconds} s, which is all that the tank gives it.")
    }
    stop(e)
  })
}

# The gear of a file that the page has read: list(name, text). The page sends what is in it and
# never a path, which could be any file of this computer's. It is nowhere that R code could read it
# from.
read_opened <- function(given) {
  given <- as.list(given)
  name <- if (is_text(given$name)) substr(given$name, 1L, 100L) else "on this page"
  read_sent(given$text, name)
}

# The gear of a plan typed on the page; like: the gear whose plan it was.
read_typed <- function(text, like) {
  gear <- read_sent(text, "on this page")
  gear["file"] <- list(like$file)
  gear
}

read_sent <- function(text, name) {
  if (!is_text(text)) abort_plan("A plan is text.", NULL)
  as_gear(plan_of_bytes(charToRaw(enc2utf8(text)), name))
}

# The first measures of a gear as a sentence, for those who listen.
spoken <- function(measures) {
  shown <- unique(c(utils::head(names(measures), 3L), "total_drag_kN"))
  paste0("Settled. ", paste(measure_text(measures[shown]), collapse = ", "), ".")
}

# What can be saved of what is on screen.
flume_saves <- function(output, tank) {
  save <- function(name, extension, write) {
    shiny::downloadHandler(
      filename = function() paste0(file_words(tank$gear$plan$name), name, ".", extension),
      content = write
    )
  }
  table <- function(make) function(file) write_csv(make(), file)
  output$save_plan <- save("", "yaml", function(file) write_gear(tank$gear, file))
  output$save_measures <- save("-measures", "csv", table(function() {
    measure_changes(tank$measures, tank$pinned$measures)
  }))
  lapply(formats_of("state"), function(format) {
    output[[paste0("save_", format$name)]] <- save(
      paste0("-", format$name), sub(".", "", format$extension, fixed = TRUE),
      function(file) format$write(tank$state, file)
    )
  })
  output$save_drag <- save("-drag", "csv", table(function() {
    as.data.frame(tank$state, what = "drag")
  }))
  output$save_code <- save("", "R", function(file) write_text(c(tank$code(), ""), file))
  output$save_report <- save("", "html", function(file) report(tank$state, file))
}

# A gear's name as part of a file's.
file_words <- function(name) {
  words <- gsub("[^a-z0-9]+", "-", tolower(iconv(name, to = "ASCII//TRANSLIT", sub = "")))
  words <- gsub("^-|-$", "", substr(words, 1, 60))
  if (is.na(words) || !nzchar(words)) "gear" else words
}
