# What one page of the flume tank holds: the design on screen, those that it keeps, what was done.
#
# `base` is the gear that changes of its form are told of; `turn` counts how often the form was made
# anew, `changed` the pictures, `kept_changed` changes of the kept designs. `serial` numbers the
# states. `slopes` and `uncertainty` are those found of the state on screen, `trajectory` the last
# tow, serialised. `pinned` is the kept design that others are compared with.

# start: list(gear, state, notes) to open with, or NULL for a page that begins at the gallery.
new_tank <- function(start, marked, nodes) {
  tank <- new.env(parent = emptyenv())
  tank$known <- list()
  tank$turn <- 0L
  tank$serial <- 1L
  tank$gesture <- -1
  tank$ids <- 0L
  tank$kept <- list()
  tank$changed <- shiny::reactiveVal(0L)
  tank$kept_changed <- shiny::reactiveVal(0L)
  tank$slopes_changed <- shiny::reactiveVal(0L)
  tank$uncertainty_changed <- shiny::reactiveVal(0L)
  tank$history <- new_history()
  tank$preferred <- list()

  count <- function(value) value(shiny::isolate(value()) + 1L)
  screen <- function() as.list(tank)[c("gear", "state", "drawing", "measures", "notes")]
  # The form is made anew, from the gear on screen.
  tank$lay_out <- function() {
    tank$base <- tank$gear
    tank$turn <- tank$turn + 1L
  }
  tank$count_picture <- function() count(tank$changed)
  tank$count_slopes <- function() count(tank$slopes_changed)
  tank$count_uncertainty <- function() count(tank$uncertainty_changed)
  tank$form <- function() form_message(tank$gear$plan, marked_of(marked, tank$gear$plan), tank$turn)

  # A request of a worker that holds the state of a number and the gear of a form.
  tank$request <- function(kind, said, holds = 0L, turn = -1L, number = 0) {
    list(
      kind = kind, said = said, number = number, nodes = nodes, file = tank$gear$file,
      base = if (!identical(turn, tank$turn)) tank$base,
      state = if (!identical(holds, tank$serial)) tank$state
    )
  }

  # Puts on screen what a worker found; whether the form is to be made anew.
  # step: "do", "undo" or "redo"; gesture: number of a movement of a control's.
  tank$take <- function(kind, found, step = "do", gesture = -1) {
    before <- if (!is.null(tank$gear)) design_of(tank$gear)
    opened <- kind %in% opening_requests
    fields <- if (!is.null(before)) given_paths(before$plan)
    list2env(found[c("gear", "state", "notes", "drawing", "measures")], tank)
    tank$serial <- tank$serial + 1L
    tank$slopes <- tank$uncertainty <- NULL
    if (opened) {
      tank$loaded <- tank$gear
      tank$history <- new_history()
      tank$kept <- list()
      tank$keep("As opened")
    } else if (step == "do") {
      again <- kind == "design" && gesture >= 0 && gesture == tank$gesture
      tank$history <- history_after(tank$history, before, again)
    } else {
      tank$history <- history_back(tank$history, before, step == "redo")
    }
    tank$gesture <- if (kind == "design") gesture else -1
    anew <- kind != "design" || !identical(fields, given_paths(tank$gear$plan))
    if (anew) tank$lay_out()
    anew
  }

  tank$keep <- function(name = NULL, found = screen()) {
    if (length(tank$kept) >= most_kept) {
      abort_argument("A page keeps at most {most_kept} designs; remove one first.")
    }
    tank$ids <- tank$ids + 1L
    name <- design_name(name, paste("Design", tank$ids))
    tank$kept <- c(tank$kept, list(kept_design(tank$ids, name, found)))
    if (length(tank$kept) == 1L) tank$pinned <- tank$kept[[1L]]
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
  # The design that others are compared with comes first.
  tank$compare <- function(id) {
    k <- tank$kept_at(id)
    tank$kept <- c(tank$kept[k], tank$kept[-k])
    tank$pinned <- tank$kept[[1L]]
    count(tank$kept_changed)
  }
  tank$remove <- function(id) {
    k <- tank$kept_at(id)
    if (length(tank$kept) == 1L) abort_argument("One design stays, to compare with.")
    tank$kept <- tank$kept[-k]
    tank$pinned <- tank$kept[[1L]]
    count(tank$kept_changed)
  }

  # passed: whether the page has the shape already.
  tank$picture <- function(passed = FALSE) {
    message <- picture_message(tank$state, tank$drawing, tank$pinned$drawing, tank$known, passed)
    tank$known <- list(now = tank$drawing, pinned = tank$pinned$drawing)
    message
  }
  # The page draws what nobody here knows, or no longer.
  tank$forget_picture <- function() tank$known["now"] <- list(NULL)
  tank$code <- function() flume_code(tank$loaded, tank$pinned$gear, tank$gear, nodes)
  # What the address says: the design on screen and those that are kept.
  tank$words <- function() {
    named <- lapply(tank$kept, function(kept) c(list(name = kept$name), design_words(kept$design)))
    list(now = design_words(design_of(tank$gear)), kept = named)
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
spoken <- function(measures) {
  shown <- intersect(unique(c(utils::head(names(measures), 3L), "total_drag_kN")), names(measures))
  paste0("Settled. ", paste(measure_text(measures[shown]), collapse = ", "), ".")
}
