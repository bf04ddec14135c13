# The data of one page of the flume tank: the last design that settled, the draft, the stored
# designs and the history.
#
# `draft` is a design (list(plan, file, source)), which may be incomplete, and `problems` are its
# errors. The counters are `edited` (changes of the draft), `turn` (opened gears) and `serial`
# (states). `slopes` and `uncertainty` belong to the state on screen; `with_intervals` is TRUE if
# the page shows the uncertainty. `trajectory` is the last tow, serialised. `own` has user-defined
# rows of the catalogue. The first design of `kept` is the reference of comparisons.

# start: list(gear, state, notes) to open with, or NULL to start at the gallery. `say`: translator
# from make_translator().
new_tank <- function(start, marked, nodes, say = make_translator()) {
  tank <- new.env(parent = emptyenv())
  tank$known <- list()
  tank$turn <- 0L
  tank$serial <- 1L
  tank$edited <- 0L
  tank$problems <- list()
  tank$gesture <- -1
  tank$ids <- 0L
  tank$kept <- list()
  tank$own <- list()
  tank$with_intervals <- FALSE
  tank$history <- new_history()
  tank$preferred <- list()

  screen <- function() as.list(tank)[c("gear", "state", "drawing", "measures", "notes")]
  paths_of <- remembered(given_paths)
  tank$form <- function() {
    plan <- tank$draft$plan
    tank$laid_out <- paths_of(plan)
    form_message(plan, marked_of(marked, plan), tank$turn, say)
  }
  # The next message rebuilds the form, even if its fields are the same.
  tank$lay_out <- function() tank$laid_out <- NULL
  # TRUE if the fields of the form differ from the draft.
  tank$form_is_old <- function() !identical(tank$laid_out, paths_of(tank$draft$plan))

  # holds: number of the state that the worker has. That state is not sent again.
  tank$request <- function(kind, said, holds = 0L, number = 0) {
    list(
      kind = kind, said = said, number = number, nodes = nodes, file = tank$gear$file,
      state = if (!identical(holds, tank$serial)) tank$state
    )
  }

  # Replaces the draft; the change can be undone. gesture: number of a slider movement, which is
  # undone as one change.
  tank$change <- function(design, gesture = -1) {
    again <- gesture >= 0 && gesture == tank$gesture
    tank$history <- history_after(tank$history, tank$draft, again)
    tank$gesture <- gesture
    tank$draft <- design
    tank$edited <- tank$edited + 1L
  }
  # Returns the interpretation of typed numbers.
  tank$edit <- function(edits, gesture = -1) {
    found <- edited_plan(tank$draft$plan, edits)
    design <- tank$draft
    design$plan <- found$plan
    tank$change(design, gesture)
    found$understood
  }
  # Returns FALSE if there is no step to undo or redo.
  tank$step <- function(name) {
    last <- utils::tail(tank$history[[if (name == "undo") "past" else "future"]], 1L)
    if (!length(last)) return(FALSE)
    tank$history <- history_back(tank$history, tank$draft, name == "redo")
    tank$draft <- last[[1L]]
    tank$gesture <- -1
    tank$edited <- tank$edited + 1L
    tank$lay_out()
    TRUE
  }

  tank$warnings <- function() {
    translate <- translated_finding(say)
    c(as.character(tank$notes), finding_sentences(finding_rows(tank$worth, translate), translate))
  }

  # Displays a worker's result. edited: count of draft changes when the result was requested.
  tank$take <- function(kind, found, edited = tank$edited) {
    list2env(found[c("gear", "state", "notes", "worth", "drawing", "measures")], tank)
    tank$serial <- tank$serial + 1L
    tank$slopes <- tank$uncertainty <- NULL
    if (kind %in% opening_requests) {
      tank$loaded <- tank$gear
      tank$draft <- design_of(tank$gear)
      tank$history <- new_history()
      tank$edited <- tank$edited + 1L
      tank$turn <- tank$turn + 1L
      tank$lay_out()
      tank$kept <- list()
      tank$keep("As opened")
      tank$problems <- list()
    } else if (kind == "plan_text") {
      tank$change(design_of(tank$gear))
      tank$lay_out()
      tank$problems <- list()
    } else if (edited == tank$edited) {
      tank$draft <- design_of(tank$gear)
      tank$problems <- list()
    }
  }
  # Stores a draft that does not settle. draft: from draft_problems().
  tank$hold <- function(draft, edited = tank$edited) {
    if (!is.null(draft$design)) {
      tank$change(draft$design)
      tank$lay_out()
    }
    if (!is.null(draft$design) || edited == tank$edited) tank$problems <- draft$problems
  }

  tank$keep <- function(name = NULL, found = screen()) {
    if (length(tank$kept) >= most_stored_designs) {
      abort_argument("A page can have at most {most_stored_designs} kept designs; remove one.")
    }
    tank$ids <- tank$ids + 1L
    name <- design_name(name, paste("Design", tank$ids))
    tank$kept <- c(tank$kept, list(stored_design(tank$ids, name, found)))
  }
  tank$kept_at <- function(id) {
    ids <- vapply(tank$kept, `[[`, 0L, "id")
    k <- if (is.numeric(id) && length(id) == 1L) match(id, ids)
    if (is.null(k) || is.na(k)) abort_argument("This kept design no longer exists.")
    k
  }
  tank$rename <- function(id, name) {
    k <- tank$kept_at(id)
    tank$kept[[k]]$name <- design_name(name, tank$kept[[k]]$name)
  }
  # The first design is always visible.
  tank$see <- function(id, seen) {
    k <- tank$kept_at(id)
    tank$kept[[k]]$seen <- seen || k == 1L
  }
  # The reference of comparisons is the first design.
  tank$compare <- function(id) {
    k <- tank$kept_at(id)
    tank$kept <- c(tank$kept[k], tank$kept[-k])
    tank$kept[[1L]]$seen <- TRUE
  }
  tank$remove <- function(id) {
    k <- tank$kept_at(id)
    if (length(tank$kept) == 1L) {
      abort_argument("The last kept design cannot be removed: it is the reference for
        comparisons.")
    }
    tank$kept <- tank$kept[-k]
    tank$kept[[1L]]$seen <- TRUE
  }

  # passed: TRUE if the page already has the shape.
  tank$picture <- function(passed = FALSE) {
    seen <- Filter(function(one) one$seen, tank$kept)
    message <- picture_message(tank$state, tank$drawing, seen, tank$known, passed)
    tank$known <- list(now = tank$drawing, kept = vapply(seen, `[[`, 0L, "id"))
    message
  }
  # The next picture is sent completely, because the page has another shape.
  tank$forget_picture <- function() tank$known["now"] <- list(NULL)
  tank$code <- function() flume_code(tank$loaded, tank$kept[[1L]]$gear, tank$gear, nodes)
  # Returns the content of the address: the design on screen and the stored designs.
  tank$words <- function() {
    named <- lapply(tank$kept, function(kept) c(list(name = kept$name),
      design_strings(kept$design)))
    draft <- if (length(tank$problems)) list(plan = draft_text(tank$draft))
    c(
      list(now = design_strings(design_of(tank$gear)), kept = named, draft = draft),
      if (length(tank$own)) list(own = tank$own)
    )
  }

  if (!is.null(start)) tank$take("shipped", with_picture(start))
  tank
}

# Requests that open another gear and start a new history.
opening_requests <- c("plan_file", "shipped", "new", "words")

marked_of <- function(marked, plan) {
  Filter(function(paths) all(!vapply(paths, function(path) {
    is.null(plan_field(plan, path))
  }, NA)), marked)
}

with_picture <- function(start) {
  if (is.null(start$drawing)) start$drawing <- flume_drawing(start$state)
  if (is.null(start$measures)) start$measures <- measures(start$state)
  start
}

# Returns the main measures as a sentence for screen readers.
spoken <- function(measures, say = make_translator()) {
  shown <- intersect(unique(c(utils::head(names(measures), 3L), "total_drag_kN")), names(measures))
  said <- measure_labels(measures[shown])
  text <- trimws(paste(
    label_of_measure(say, said$words), figures(plain_measures(measures[shown])),
    label_of_unit(say, said$unit), said$error
  ))
  say("settled_said", measures = paste(text, collapse = ", "))
}
