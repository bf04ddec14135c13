# R code that reproduces the designs in the flume tank.

# loaded: the gear as opened; kept: the gear to compare with; design: the gear on screen; nodes:
# number of nodes of each net.
flume_code <- function(loaded, kept, design, nodes) {
  settle_call <- function(name, gear) {
    paste0("settle(", name, ", nodes = ", shortest_decimal(nodes * net_count(gear)), ")")
  }
  differ <- !identical(kept$plan, design$plan)
  lines <- c(
    "library(codend)", "", gear_code("gear", loaded, design, "loaded"),
    paste("state <-", settle_call("gear", design)), "",
    "summary(state)", "plot(state)", "view_3d(state)"
  )
  if (differ) {
    lines <- c(
      lines, "", "# compared with the kept design", gear_code("kept", loaded, kept, "loaded_kept"),
      paste("reference <-", settle_call("kept", kept)),
      "named <- intersect(names(measures(state)), names(measures(reference)))",
      "measures(state)[named] - measures(reference)[named]"
    )
  }
  paste(c(lines, ""), collapse = "\n")
}

# Returns code that makes a gear: update() of a shipped plan if possible, otherwise the full plan.
gear_code <- function(name, loaded, gear, plan_name) {
  shipped <- loaded_shipped(loaded)
  changes <- if (!is.null(shipped)) update_arguments(loaded$plan, gear$plan)
  if (is.null(changes)) {
    return(c(
      paste(plan_name, "<- tempfile(fileext = \".yaml\")"),
      paste0("writeLines(", code_text(strsplit(format(gear), "\n", fixed = TRUE)[[1]]), ", ",
        plan_name, ", useBytes = TRUE)"),
      sprintf("%s <- read_gear(%s)", name, plan_name)
    ))
  }
  read <- sprintf("read_gear(%s)", code_text(shipped))
  if (!length(changes)) return(paste(name, "<-", read))
  c(sprintf("%s <- update(%s,", name, read), paste0("  ", paste(changes, collapse = ",\n  ")), ")")
}

# Returns the name of a gear's shipped plan, or NULL.
loaded_shipped <- function(gear) {
  shipped <- shipped_plans()
  if (is.null(gear$file) || !gear$file %in% shipped) return(NULL)
  names(shipped)[match(gear$file, shipped)]
}

# Returns NULL if update() cannot turn plan `from` into plan `to`.
update_arguments <- function(from, to) {
  found <- plan_changes(from, to)
  plain <- vapply(found, function(d) {
    is.atomic(d$value) && length(d$value) == 1L && is.null(names(d$value))
  }, NA)
  if (!all(plain)) return(NULL)
  as.character(lapply(found, function(d) {
    path <- if (make.names(d$path) == d$path) d$path else code_text(d$path)
    value <- if (is.character(d$value)) code_text(d$value) else if (is.logical(d$value)) {
      as.character(d$value)
    } else {
      shortest_decimal(d$value)
    }
    paste(path, "=", value)
  }))
}

# Returns ASCII code whose value is exactly these strings.
code_text <- function(texts) {
  quoted <- vapply(texts, function(text) {
    codes <- utf8ToInt(enc2utf8(text))
    paste0("\"", paste(vapply(codes, code_character, ""), collapse = ""), "\"")
  }, "", USE.NAMES = FALSE)
  if (length(quoted) == 1L) return(quoted)
  paste0("c(\n  ", paste(quoted, collapse = ",\n  "), "\n)")
}

code_character <- function(code) {
  if (code == 0x22 || code == 0x5c) return(paste0("\\", intToUtf8(code)))
  if (code >= 0x20 && code < 0x7f) return(intToUtf8(code))
  sprintf(if (code > 0xffff) "\\U%08x" else "\\u%04x", code)
}
