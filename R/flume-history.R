# Designs of the flume tank: undo and redo, and designs in the address of the page.

# A design is list(plan, file, source) of a gear; gear_of_design() converts it back.
design_of <- function(gear) list(plan = gear$plan, file = gear$file, source = gear$source)

gear_of_design <- function(design, like = NULL) {
  as_gear(design$plan, file = design$file, like = like, source = design$source)
}

# Largest number of undo steps.
most_past <- 60L

# A history is list(past, future) of designs. The design of the next step is the last one.
new_history <- function() list(past = list(), future = list())

# again: TRUE if the change continues the previous change, such as the movement of a slider.
history_after <- function(history, design, again = FALSE) {
  if (again) return(history)
  list(past = utils::tail(c(history$past, list(design)), most_past), future = list())
}

# Returns the history after undo, or redo if `on`, of a design.
history_back <- function(history, design, on = FALSE) {
  from <- if (on) "future" else "past"
  to <- if (on) "past" else "future"
  history[[to]] <- c(history[[to]], list(design))
  history[[from]] <- utils::head(history[[from]], -1L)
  history
}

# The text contains the remarks of the source if possible.
draft_text <- function(design) edited_text(design$source, design$plan)

# Returns the design for a page address: list(base = name of a shipped plan, edits = changed fields
# by path) if possible, otherwise list(plan = text).
design_strings <- function(design) {
  base <- loaded_shipped(design)
  if (!is.null(base)) {
    found <- plan_changes(split_uncertain(read_plan(design$file)), design$plan)
    plain <- vapply(found, function(d) {
      # names in `uncertain` contain points, which separate the steps of a path
      !startsWith(d$path, "uncertain") &&
        (is.null(d$value) || is.atomic(d$value) && length(d$value) == 1L)
    }, NA)
    if (all(plain)) {
      edits <- lapply(found, function(d) if (is.null(d$value)) list(gone = TRUE) else d$value)
      names(edits) <- vapply(found, `[[`, "", "path")
      return(list(base = base, edits = edits))
    }
  }
  list(plan = edited_text(design$source, design$plan))
}

# Returns the gear of a page address. An address may contain anything, so all of it is checked.
gear_of_address <- function(words) {
  words <- as.list(words)
  if (is.null(words$base)) return(read_sent(words$plan, "in this address"))
  if (!is_text(words$base) || !words$base %in% names(shipped_plans())) {
    abort_argument("The gear in this address is not a shipped gear.")
  }
  gear <- read_gear(words$base)
  edits <- as.list(words$edits)
  if (!length(edits)) return(gear)
  if (!is_map(edits) || length(edits) > most_edits || any(nchar(names(edits)) > most_characters)) {
    abort_argument("This address has no list of changed fields.")
  }
  plan <- gear$plan
  for (path in names(edits)) {
    value <- edits[[path]]
    if (is.list(value)) value <- NULL else if (length(value) != 1L) {
      abort_field(path, value, "one value")
    }
    plan <- set_plan_field(plan, path, value)
  }
  as_gear(plan, file = gear$file, like = gear)
}
