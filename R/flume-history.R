# Designs as the flume tank keeps them: what was done and undone, and what an address says of one.

# A design is list(plan, file, source) of a gear, which as_gear() makes one again.
design_of <- function(gear) list(plan = gear$plan, file = gear$file, source = gear$source)

gear_of_design <- function(design, like = NULL) {
  as_gear(design$plan, file = design$file, like = like, source = design$source)
}

# Steps back at most.
most_past <- 60L

# What was done: list(past, future), designs, the last one last.
new_history <- function() list(past = list(), future = list())

# ... after a change of a design. again: whether it goes on with the last change, as a slider does
# while it moves.
history_after <- function(history, design, again = FALSE) {
  if (again) return(history)
  list(past = utils::tail(c(history$past, list(design)), most_past), future = list())
}

# ... after a step back (or on) from a design.
history_back <- function(history, design, on = FALSE) {
  from <- if (on) "future" else "past"
  to <- if (on) "past" else "future"
  history[[to]] <- c(history[[to]], list(design))
  history[[from]] <- utils::head(history[[from]], -1L)
  history
}

# The text of a draft, with the remarks of its source where it can keep them.
draft_text <- function(design) edited_text(design$source, design$plan)

# What an address says of a design: list(base = name of a shipped plan, edits = changed fields by
# path), else list(plan = its text).
design_words <- function(design) {
  base <- loaded_shipped(design)
  if (!is.null(base)) {
    found <- plan_changes(split_uncertain(read_plan(design$file)), design$plan)
    plain <- vapply(found, function(d) {
      # paths in `uncertain` have points of their own
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

# The gear of what an address says, checked as anything that a page sends.
gear_of_words <- function(words) {
  words <- as.list(words)
  if (is.null(words$base)) return(read_sent(words$plan, "in this address"))
  if (!is_text(words$base) || !words$base %in% names(shipped_plans())) {
    abort_argument("This address names a gear that codend does not ship.")
  }
  gear <- read_gear(words$base)
  edits <- as.list(words$edits)
  if (!length(edits)) return(gear)
  if (!is_map(edits) || length(edits) > most_edits || any(nchar(names(edits)) > most_characters)) {
    abort_argument("This address does not say what of the gear changes.")
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
