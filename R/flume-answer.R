# What a worker of the flume tank answers to a request. It knows no page: it may run in a process of
# its own.

# Most nodes of a design, whatever its plan asks for.
flume_nodes <- 20000

# request: list(kind, said (of the page; of a design the draft), number (of the question), file (of
# the gear on screen), nodes, state (to settle from, or that something is made of)); without `state`
# it is the one that the memory, an environment, holds. Returns list(found, problem, draft): found
# NULL where there is a problem, problem as flume_problem() gives it, draft as draft_problems()
# does.
flume_answer <- function(request, memory) {
  if (!is.null(request$state)) {
    memory$state <- request$state
    memory$fixed <- NULL
  }
  found <- NULL
  problem <- flume_problem({
    made <- made_of_state[[request$kind]]
    found <- if (!is.null(made)) {
      made(memory$state, request$said)
    } else if (request$kind == "kept") {
      settled_design(request, memory)
    } else if (request$kind == "rest") {
      rest_of_design(memory)
    } else {
      shown_design(request, memory)
    }
  })
  draft <- if (!is.null(problem) && request$kind %in% c("design", "plan_text")) {
    draft_problems(request, memory, problem)
  }
  list(found = found, problem = problem, draft = draft)
}

# What keeps a draft from settling: list(problems (of draft_gear()), design (the draft, where it was
# typed)), or NULL where a typed text is no plan at all.
draft_problems <- function(request, memory, problem) {
  of_settling <- list(problem[c("path", "message")])
  if (request$kind == "design") {
    problems <- draft_gear(request$said$plan, memory$state$gear)$problems
    return(list(problems = if (length(problems)) problems else of_settling))
  }
  tree <- tryCatch(
    split_uncertain(plain_tree(plan_of_bytes(charToRaw(enc2utf8(request$said)), "on this page"))),
    error = function(e) NULL
  )
  if (is.null(tree)) return(NULL)
  problems <- draft_gear(tree, memory$state$gear)$problems
  list(
    problems = if (length(problems)) problems else of_settling,
    design = list(plan = tree, file = request$file, source = request$said)
  )
}

# What is made of the state on screen and leaves it as it is.
made_of_state <- list(
  save = function(state, said) save_state(state, said),
  # of a draft as much as fits together
  drawing = function(state, said) {
    drawing_svg(draft_gear(said$plan, state$gear)$gear, drawing_page)
  },
  slopes = function(state, said) slopes_asked(state, said),
  uncertainty = function(state, said) uncertainty(state),
  vary = function(state, said) varied_measures(state, said),
  tow = function(state, said) tow_asked(state, said),
  save_tow = function(state, said) save_tow(said)
)

# What the page asks for, settled and remembered: list(gear, state, notes, worth, drawing,
# measures). Of a design that has the fields of the one before only what moves, list(moved, anew),
# as moved_message() gives it: rest_of_design() is asked for next.
shown_design <- function(request, memory) {
  found <- settled_design(request, memory, complete = FALSE)
  memory$state <- found$state
  before <- memory$paths
  memory$paths <- given_paths(found$gear$plan)
  passing <- request$kind == "design" && !is.null(memory$fixed) && identical(memory$paths, before)
  if (passing) {
    shape <- flume_shape(found$state)
    memory$passing <- list(found = found, shape = shape)
    message <- moved_message(found$state, shape, memory$fixed, request$number)
    memory$fixed <- message$fixed
    return(message[c("moved", "anew")])
  }
  found <- complete_design(found)
  memory$fixed <- found$drawing$fixed
  found
}

rest_of_design <- function(memory) {
  passing <- memory$passing
  memory$passing <- NULL
  if (is.null(passing)) abort_argument("The process that settled this design has ended.")
  complete_design(passing$found, passing$shape)
}

# list(gear, state, notes = warnings), and with `complete` what complete_design() adds.
settled_design <- function(request, memory, complete = TRUE) {
  said <- request$said
  gear <- switch(request$kind,
    design = gear_of_design(said, memory$state$gear),
    plan_text = read_typed(said, request$file),
    plan_file = read_opened(said),
    shipped = read_shipped(said),
    new = read_new(said),
    words = , kept = gear_of_words(said)
  )
  like <- request$kind %in% c("design", "plan_text")
  found <- c(list(gear = gear), settle_noted(gear, request$nodes, if (like) memory$state))
  if (complete) complete_design(found) else found
}

# ... with its findings, in no language yet (worth), the drawing and the measures.
complete_design <- function(found, shape = flume_shape(found$state)) {
  # a page does not wait for swings of boards
  checks <- sorted_checks()
  worth <- list_findings(found$state, checks[names(checks) != "flutter"])
  c(found, list(worth = worth, drawing = flume_drawing(found$state, shape),
    measures = measures(found$state)))
}

settled_start <- function(gear, nodes) {
  complete_design(c(list(gear = gear), settle_noted(gear, nodes, NULL)))
}

# said: list(format, file).
save_state <- function(state, said) {
  if (said$format == "report") return(report(state, said$file))
  if (said$format == "share") return(share(state, said$file))
  if (said$format == "drawing") return(plot(state$gear, file = said$file, page = drawing_page))
  Find(function(format) format$name == said$format, formats_of("state"))$write(state, said$file)
}

# Settles from a state where it has the same parts, else anew: list(state, notes = warnings).
settle_noted <- function(gear, nodes, from) {
  notes <- character()
  check_lattice_size(gear_si(gear), nodes, most = max(flume_nodes, 2 * nodes))
  settle_from <- function(from) settle_gear(gear, nodes, NULL, from)
  state <- withCallingHandlers(
    tryCatch(settle_from(from), codend_error_argument = function(e) settle_from(NULL)),
    codend_warning = function(w) {
      notes <<- c(notes, plain_message(w))
      invokeRestart("muffleWarning")
    }
  )
  list(state = state, notes = notes)
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
