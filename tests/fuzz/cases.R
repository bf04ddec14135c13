# One case: an attempt, and the criteria of a finding.

# Stops the case as a finding.
found <- function(what, ...) {
  condition <- list(message = paste0(what, ...), call = NULL)
  stop(structure(condition, class = c("fuzz_found", "error", "condition")))
}

# Returns the result of an expression, or NULL if codend rejects it properly. Anything else is a
# finding: an error without a class, a foreign warning, a message with NaN.
judged <- function(expression) {
  refused <- function(e) {
    if (length(class(e)) < 4L) found("no class of its own: ", class(e)[1L])
    said <- conditionMessage(e)
    of_plan <- grepl("[\"`][^\"`]*(NaN|NA|NULL)| is (NaN|NA)", said)
    if (grepl("NaN|\\bNA\\b|character\\(0\\)|NULL", said) && !of_plan) {
      found("says: ", said)
    }
    NULL
  }
  withCallingHandlers(
    tryCatch(expression, codend_error = refused, error = function(e) {
      if (inherits(e, "fuzz_found")) stop(e)
      where <- paste(deparse(conditionCall(e))[1L], collapse = "")
      found("plain error: ", conditionMessage(e), " in ", where)
    }),
    warning = function(w) {
      if (!inherits(w, "codend_warning")) {
        found("plain warning: ", conditionMessage(w), " in ", deparse(conditionCall(w))[1L])
      }
      invokeRestart("muffleWarning")
    }
  )
}

# Checks that an accepted gear is identical after writing and reading, in any order of its fields.
check_taken <- function(gear) {
  text <- judged(format(gear))
  file <- tempfile(fileext = ".yaml")
  on.exit(unlink(file))
  judged(write_gear(gear, file))
  again <- judged(read_gear(file))
  if (is.null(again)) found("cannot be read again")
  if (!identical(again$plan, gear$plan)) found("is read as another plan")
  turned <- gear$plan[rev(seq_along(gear$plan))]
  turned <- judged(codend:::as_gear(turned))
  if (is.null(turned) || !same_numbers(codend:::gear_si(turned), codend:::gear_si(gear))) {
    found("the order of fields matters")
  }
  invisible(text)
}

same_numbers <- function(a, b) {
  sorted <- function(x) {
    if (is.list(x) && !is.null(names(x))) lapply(x[order(names(x))], sorted) else x
  }
  parts <- c("water", "ropes", "panels", "pieces")
  identical(lapply(a[parts], sorted), lapply(b[parts], sorted))
}

check_settled <- function(gear, nodes) {
  state <- judged(settle(gear, nodes = nodes))
  if (is.null(state)) return(FALSE)
  numbers <- c(state$position, state$force, state$bar_tension, state$u_tension, state$v_tension)
  if (!all(is.finite(numbers))) found("a settled state holds what is not finite")
  asked <- judged(measures(state))
  if (any(is.nan(unlist(asked)))) found("a measure is NaN")
  judged(utils::capture.output(print(summary(state))))
  TRUE
}

# The kinds of case with their frequencies; each run returns "refused", "taken" or "settled".
kinds <- list(
  plan_changed = list(share = 5, run = function() try_plan(changed_plan())),
  plan_made = list(share = 5, run = function() try_plan(made_plan())),
  plan_file = list(share = 2, run = function() {
    file <- changed_plan_file()
    on.exit(unlink(file))
    gear <- judged(read_gear(file))
    if (is.null(gear)) "refused" else {
      check_taken(gear)
      "taken"
    }
  }),
  state_file = list(share = 1, run = function() try_kept(kept()$state, function(state) {
    judged(measures(state))
    if (chance(0.2)) judged(settle(state$gear, nodes = 60, from = state))
  })),
  tow_file = list(share = 0.5, run = function() try_kept(kept()$tow, function(x) {
    if (chance(0.2)) judged(tow(x, until = 22, every = 1))
  })),
  model = list(share = 2, run = function() {
    model <- one_of(kept()$models)
    fields <- model$fields
    for (k in seq_len(1L + stats::rpois(1L, 0.5))) fields <- changed_model(fields)
    mesh <- judged(codend:::engine_model(fields))
    if (is.null(mesh)) return("refused")
    evaluated <- judged(codend:::engine_evaluate(mesh, model$start, 0 * model$start))
    if (is.null(evaluated)) return("refused")
    quiet <- function(...) NULL
    judged(codend:::engine_settle(
      mesh, model$start, "crude", numeric(), integer(), 1e-8, 3L, quiet
    ))
    "taken"
  }),
  message = list(share = 2, run = function() try_messages())
)

# Tries a changed copy of a file. use: function applied to the result of reading, so
# that a forged index would reach the engine.
try_kept <- function(files, use) {
  file <- changed_kept(one_of(files), chance(0.7))
  on.exit(unlink(file))
  found <- judged(codend::read_result(file))
  if (is.null(found)) return("refused")
  use(found)
  "taken"
}

try_plan <- function(tree) {
  gear <- judged(codend:::as_gear(tree))
  if (is.null(gear)) return("refused")
  check_taken(gear)
  if (chance(settle_share) && check_settled(gear, one_of(c(30, 60, 150)))) "settled" else "taken"
}

# Fraction of plans that are settled.
settle_share <- 0.3

# The files are written once per process, without random numbers.
kept <- local({
  made <- NULL
  function() {
    if (is.null(made)) {
      state <- .Random.seed
      made <<- kept_files()
      assign(".Random.seed", state, globalenv())
    }
    made
  }
})

# ---- messages to the tank ------------------------------------------------------------------------

tank <- local({
  made <- NULL
  function() {
    if (is.null(made)) {
      state <- .Random.seed
      gear <- read_gear("midwater_trawl")
      start <- codend:::settled_start(gear, 150)
      made <<- function() codend:::new_tank(start, list(), 150)
      assign(".Random.seed", state, globalenv())
    }
    made()
  }
})

try_messages <- function() {
  tank <- tank()
  memory <- new.env()
  went_well <- function(problem) {
    internal <- !is.null(problem) && grepl("Internal error of codend", problem$message)
    if (internal) found(problem$message)
    is.null(problem)
  }
  ask <- function(kind, said) {
    answer <- codend:::flume_answer(tank$request(kind, said), memory)
    if (is.null(answer$problem)) tank$take(kind, answer$found, 0)
    went_well(answer$problem)
  }
  paths <- c(codend:::given_paths(tank$gear$plan), "towing.speed.speed", "", odd_texts)
  edit <- function() {
    switch(sample.int(4L, 1L),
      any_value(),
      list(gone = if (chance(0.8)) TRUE else any_value()),
      list(like = if (chance(0.5)) one_of(paths) else any_value()),
      list(
        value = if (chance(0.5)) stats::runif(1L, 0, 20) else any_value(),
        unit = one_of(c("m", "knot", "m2", "kg", odd_texts))
      )
    )
  }
  edits <- function() {
    stats::setNames(lapply(1:2, function(k) edit()), vapply(1:2, function(k) one_of(paths), ""))
  }
  sent <- function() {
    if (chance(0.3)) return(any_value())
    base <- one_of(c("towed_cable", "flat_panel", odd_texts))
    c(if (chance(0.5)) list(base = base) else list(plan = typed_plan()),
      list(edits = if (chance(0.5)) edits() else list(edits(), edits())))
  }
  good <- vapply(1:3, function(k) {
    switch(sample.int(5L, 1L),
      went_well(codend:::flume_problem(tank$edit(edits(), k))),
      ask("plan_file", list(name = any_value(), text = typed_plan())),
      ask("words", sent()),
      went_well(codend:::flume_problem({
        tank$change(codend:::sent_design(sent()), k)
        ask("design", tank$draft)
      })),
      ask("new", any_value())
    )
  }, NA)
  judged({
    codend:::measures_about(tank$measures)
    codend:::measures_numbers(tank$measures)
  })
  if (all(good)) "taken" else "refused"
}

typed_plan <- function() {
  if (chance(0.2)) return(any_value())
  bytes <- changed_bytes(one_of(plan_bytes[c("towed_cable", "longline", "flat_panel")]))
  rawToChar(bytes[bytes != as.raw(0)])
}
