# Answers of a flume-tank worker to requests, in a process without a page.

# Largest number of nodes of a design, unless `2 * nodes` of the tank is larger.
flume_nodes <- 20000

# request: list(kind, `said` (the page's data; for a design its draft), number, file (of the gear on
# screen), nodes, state). The default state is the one in `memory`, an environment. Returns
# list(found, problem, problems): `problem` from flume_problem(), `problems` from draft_problems().
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
    } else if (request$kind == "prediction") {
      prediction_message(request$said, memory)
    } else {
      displayed_design(request, memory)
    }
  })
  problems <- if (!is.null(problem) && request$kind == "design") {
    draft_problems(request$said, memory, problem)
  }
  list(found = found, problem = problem, problems = problems)
}

# Returns the problems of a draft that does not settle, as in draft_gear().
draft_problems <- function(design, memory, problem) {
  problems <- draft_gear(design$plan, memory$state$gear)$problems
  if (length(problems)) problems else list(problem[c("path", "message")])
}

# Products of the state on screen. These functions do not change the state.
made_of_state <- list(
  save = function(state, said) {
    tank_files()[[said$name]]$write(first_of(said$trajectory, state), said$file)
  },
  # draws the consistent parts of a draft
  drawing = function(state, said) {
    drawing_svg(draft_gear(said$plan, state$gear)$gear, drawing_page)
  },
  slopes = function(state, said) requested_sensitivities(state, said),
  uncertainty = function(state, said) uncertainty(state),
  target = function(state, said) found_target(state, said),
  vary = function(state, said) varied_measures(state, said),
  tow = function(state, said) requested_tow(state, said)
)

# Settles the requested gear and stores its state. Returns list(gear, state, notes, worth, drawing,
# measures). If the fields are the same as before, returns only the shape, list(moved, anew) from
# moved_message(); the page then requests rest_of_design().
displayed_design <- function(request, memory) {
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
  if (is.null(passing)) {
    abort_argument("The process that settled this design has ended. Change the design to settle it
      again.")
  }
  complete_design(passing$found, passing$shape)
}

# Returns list(gear, state, notes = warnings), extended by complete_design() if `complete`.
settled_design <- function(request, memory, complete = TRUE) {
  said <- request$said
  gear <- switch(request$kind,
    design = gear_of_design(said, memory$state$gear),
    plan_file = read_opened(said),
    new = read_new(said),
    words = , kept = gear_of_words(said)
  )
  like <- if (request$kind == "design") memory$state
  found <- c(list(gear = gear), settle_noted(gear, request$nodes, like))
  if (complete) complete_design(found) else found
}

# Adds the findings (`worth`, not translated), the drawing and the measures.
complete_design <- function(found, shape = flume_shape(found$state)) {
  # the check of board oscillations is too slow for a page
  checks <- sorted_checks()
  worth <- list_findings(found$state, checks[names(checks) != "flutter"])
  c(found, list(worth = worth, drawing = flume_drawing(found$state, shape),
    measures = measures(found$state)))
}

settled_start <- function(gear, nodes) {
  complete_design(c(list(gear = gear), settle_noted(gear, nodes, NULL)))
}

# Settles from a state with the same parts, otherwise from scratch. Returns list(state, notes).
# `nodes`: number of nodes of each net.
settle_noted <- function(gear, nodes, from) {
  notes <- character()
  nodes <- nodes * net_count(gear)
  check_mesh_size(gear_si(gear), nodes, most = max(flume_nodes, 2 * nodes))
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

# Returns NULL if an expression succeeds, otherwise list(message, path of the wrong field or NULL).
# An unexpected R error is logged and returned, so that the session continues.
flume_problem <- function(expression) {
  tryCatch(
    {
      force(expression)
      NULL
    },
    codend_error = function(e) list(message = plain_message(e), path = e$path),
    error = function(e) {
      message("codend flume: ", conditionMessage(e))
      list(message = paste0("Internal error of codend: ", plain_message(e)), path = NULL)
    }
  )
}
