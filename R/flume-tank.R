# The data of one page of the flume tank: the last design that settled and the draft. The page keeps
# its history and its stored designs.
#
# `draft` is a design (list(plan, file, source)), which may be incomplete, and `problems` are its
# errors. `edited` is the number of the request that changed the draft last, and `shown` the number
# of the last change in the design on screen. The counters are `turn` (opened gears) and `serial`
# (states). `uncertainty` belongs to the state on screen; `with_intervals` is TRUE if the page shows
# it. `trajectory` is the last tow, serialised.

# start: from settled_start(), or NULL to start at the gallery. `say`: translator from
# make_translator().
new_tank <- function(start, marked, nodes, say = make_translator()) {
  tank <- new.env(parent = emptyenv())
  tank$nodes <- nodes
  tank$turn <- 0L
  tank$serial <- 1L
  tank$edited <- 0
  tank$problems <- list()
  tank$with_intervals <- FALSE

  paths_of <- remembered(given_paths)
  tank$form <- function() {
    plan <- tank$draft$plan
    tank$laid_out <- paths_of(plan)
    form_message(plan, marked, tank$turn)
  }
  # The next message rebuilds the form, even if its fields are the same.
  tank$lay_out <- function() tank$laid_out <- NULL
  # TRUE if the fields of the form differ from the draft.
  tank$form_is_old <- function() !identical(tank$laid_out, paths_of(tank$draft$plan))

  # holds: number of the state that the worker has. That state is not sent again.
  tank$request <- function(kind, said, holds = 0L, number = 0) {
    list(
      kind = kind, said = said, number = number, nodes = nodes,
      state = if (!identical(holds, tank$serial)) tank$state
    )
  }

  # Replaces the draft. number: of the request.
  tank$change <- function(design, number) {
    tank$draft <- design
    tank$edited <- number
  }
  # Returns the interpretation of typed numbers.
  tank$edit <- function(edits, number) {
    found <- edited_plan(tank$draft$plan, edits)
    tank$draft$plan <- found$plan
    tank$edited <- number
    found$understood
  }

  tank$warnings <- function() {
    translate <- translated_finding(say)
    c(as.character(tank$notes), finding_sentences(finding_rows(tank$worth, translate), translate))
  }

  # Displays a worker's result. edited: number of the last change in it.
  tank$take <- function(kind, found, edited) {
    list2env(found[c("gear", "state", "notes", "worth", "drawing", "measures")], tank)
    tank$serial <- tank$serial + 1L
    tank$shown <- edited
    tank$uncertainty <- NULL
    opens <- kind %in% opening_requests
    if (opens) {
      tank$turn <- tank$turn + 1L
      tank$lay_out()
    }
    if (opens || edited == tank$edited) {
      tank$change(design_of(tank$gear), edited)
      tank$problems <- list()
    }
  }

  # passed: TRUE if the page already has the shape.
  tank$picture <- function(passed = FALSE) {
    scene <- picture_scene(tank$state, tank$drawing, tank$known, passed)
    tank$known <- tank$drawing$fixed
    scene
  }
  # The next picture is sent completely, because the page has another shape.
  tank$forget_picture <- function() tank$known <- NULL

  if (!is.null(start)) tank$take("words", start, 0)
  tank
}

# Requests that open another gear.
opening_requests <- c("plan_file", "new", "words")
