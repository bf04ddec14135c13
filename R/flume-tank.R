# What one page of the flume tank holds: the last design that settled, the draft that is being
# changed, the designs that it keeps, what was done.
#
# `draft` is a design (list(plan, file, source)) that may be unfinished, `problems` what is wrong
# with it; `edited` counts its changes. `turn` counts the gears that were opened, `changed` the
# pictures, `kept_changed` changes of the kept designs. `serial` numbers the states. `slopes` and
# `uncertainty` are those found of the state on screen, `trajectory` the last tow, serialised.
# `own` are the user's own rows of the catalogue.
# The first of the designs that are kept is the one that others are compared with.

# start: list(gear, state, notes) to open with, or NULL for a page that begins at the gallery; say:
# as of new_say().
new_tank <- function(start, marked, nodes, say = new_say()) {
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
  tank$changed <- shiny::reactiveVal(0L)
  tank$kept_changed <- shiny::reactiveVal(0L)
  tank$slopes_changed <- shiny::reactiveVal(0L)
  tank$uncertainty_changed <- shiny::reactiveVal(0L)
  tank$history <- new_history()
  tank$preferred <- list()

  count <- function(value) value(shiny::isolate(value()) + 1L)
  screen <- function() as.list(tank)[c("gear", "state", "drawing", "measures", "notes")]
  tank$count_picture <- function() count(tank$changed)
  tank$count_slopes <- function() count(tank$slopes_changed)
  tank$count_uncertainty <- function() count(tank$uncertainty_changed)
  paths_of <- remembered(given_paths)
  tank$form <- function() {
    plan <- tank$draft$plan
    tank$laid_out <- paths_of(plan)
    form_message(plan, marked_of(marked, plan), tank$turn, say)
  }
  # The form is made anew, whether its fields are others or not.
  tank$lay_out <- function() tank$laid_out <- NULL
  # Whether the form has other fields than the draft.
  tank$form_is_old <- function() !identical(tank$laid_out, paths_of(tank$draft$plan))

  # A request of a worker that holds the state of a number.
  tank$request <- function(kind, said, holds = 0L, number = 0) {
    list(
      kind = kind, said = said, number = number, nodes = nodes, file = tank$gear$file,
      state = if (!identical(holds, tank$serial)) tank$state
    )
  }

  # Another draft in place of the last, which can be undone. gesture: number of a movement of a
  # control's, which is undone as one.
  tank$change <- function(design, gesture = -1) {
    again <- gesture >= 0 && gesture == tank$gesture
    tank$history <- history_after(tank$history, tank$draft, again)
    tank$gesture <- gesture
    tank$draft <- design
    tank$edited <- tank$edited + 1L
  }
  # ... what a page changes of it; what its numbers were understood as.
  tank$edit <- function(edits, gesture = -1) {
    found <- edited_plan(tank$draft$plan, edits)
    design <- tank$draft
    design$plan <- found$plan
    tank$change(design, gesture)
    found$understood
  }
  # ... a step back, or on; whether there was one.
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

  # Warnings of the design on screen, findings among them.
  tank$warnings <- function() {
    translate <- said_finding(say)
    c(as.character(tank$notes), finding_sentences(finding_rows(tank$worth, translate), translate))
  }

  # Puts on screen what a worker found. edited: of the draft that it was asked for.
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
  # Keeps a draft that does not settle: draft as draft_problems() gives it.
  tank$hold <- function(draft, edited = tank$edited) {
    if (!is.null(draft$design)) {
      tank$change(draft$design)
      tank$lay_out()
    }
    if (!is.null(draft$design) || edited == tank$edited) tank$problems <- draft$problems
  }

  tank$keep <- function(name = NULL, found = screen()) {
    if (length(tank$kept) >= most_kept) {
      abort_argument("A page keeps at most {most_kept} designs; remove one first.")
    }
    tank$ids <- tank$ids + 1L
    name <- design_name(name, paste("Design", tank$ids))
    tank$kept <- c(tank$kept, list(kept_design(tank$ids, name, found)))
    count(tank$kept_changed)
  }
  tank$kept_at <- function(id) {
    ids <- vapply(tank$kept, `[[`, 0L, "id")
    k <- if (is.numeric(id) && length(id) == 1L) match(id, ids)
    if (is.null(k) || is.na(k)) abort_argument("There is no such kept design.")
    k
  }
  tank$rename <- function(id, name) {
    k <- tank$kept_at(id)
    tank$kept[[k]]$name <- design_name(name, tank$kept[[k]]$name)
    count(tank$kept_changed)
  }
  # Whether a kept design is in the picture; the first one always is.
  tank$see <- function(id, seen) {
    k <- tank$kept_at(id)
    tank$kept[[k]]$seen <- seen || k == 1L
    count(tank$kept_changed)
  }
  # The design that others are compared with comes first.
  tank$compare <- function(id) {
    k <- tank$kept_at(id)
    tank$kept <- c(tank$kept[k], tank$kept[-k])
    tank$kept[[1L]]$seen <- TRUE
    count(tank$kept_changed)
  }
  tank$remove <- function(id) {
    k <- tank$kept_at(id)
    if (length(tank$kept) == 1L) abort_argument("One design stays, to compare with.")
    tank$kept <- tank$kept[-k]
    tank$kept[[1L]]$seen <- TRUE
    count(tank$kept_changed)
  }

  # passed: whether the page has the shape already.
  tank$picture <- function(passed = FALSE) {
    seen <- Filter(function(one) one$seen, tank$kept)
    message <- picture_message(tank$state, tank$drawing, seen, tank$known, passed)
    tank$known <- list(now = tank$drawing, kept = vapply(seen, `[[`, 0L, "id"))
    message
  }
  # The page draws what nobody here knows, or no longer.
  tank$forget_picture <- function() tank$known["now"] <- list(NULL)
  tank$code <- function() flume_code(tank$loaded, tank$kept[[1L]]$gear, tank$gear, nodes)
  # What the address says: the design on screen and those that are kept.
  tank$words <- function() {
    named <- lapply(tank$kept, function(kept) c(list(name = kept$name), design_words(kept$design)))
    draft <- if (length(tank$problems)) list(plan = draft_text(tank$draft))
    c(
      list(now = design_words(design_of(tank$gear)), kept = named, draft = draft),
      if (length(tank$own)) list(own = tank$own)
    )
  }

  if (!is.null(start)) tank$take("shipped", with_picture(start))
  tank
}

# Requests that open another gear, and so begin anew.
opening_requests <- c("plan_file", "shipped", "new", "words")

# Marked fields that a plan has.
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

# The first measures of a gear as a sentence, for those who listen.
spoken <- function(measures, say = new_say()) {
  shown <- intersect(unique(c(utils::head(names(measures), 3L), "total_drag_kN")), names(measures))
  said <- measure_words(measures[shown])
  text <- trimws(paste(
    said_measure(say, said$words), figures(plain_measures(measures[shown])),
    said_unit(say, said$unit), said$error
  ))
  say("settled_said", measures = paste(text, collapse = ", "))
}
