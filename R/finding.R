#' List warnings about a gear, state or tow
#'
#' A valid plan can still describe a useless gear: a unit is missing, a bridle carries no load, or
#' the net flies above the sea bed. `findings()` lists properties of a gear or settled state that
#' are outside practice and tests.
#'
#' Warnings are not errors: the results follow the plan. [summary()][summary.codend_state],
#' [report()], [flume()] and the command line show the same list under 'Warnings'. `flume()` omits
#' growing swings of boards.
#'
#' @eval finding_help()
#'
#' @param x A gear ([read_gear()]) for checks of the plan only; a state ([settle()], [state_at()]);
#'   or a trajectory ([tow()]) for checks of the tow and of the state at its start.
#' @return A data frame of class `codend_findings`, one row per warning, most important first. It
#'   has no rows if there are no warnings. Columns:
#'
#'   - `check`: name of the check;
#'   - `location`: a field of the plan, or parts of the gear;
#'   - `value`: the odd number, in the unit of `label`; `label`: the number with its unit;
#'   - `message`: the odd property; `advice`: possible changes;
#'   - `field`: the plan's field to change, `NA` if there is no single field;
#'   - `rank`: 1 if the gear breaks or does not fish, 2 if it is out of proportion, 3 if the model
#'     is used outside its tested range;
#'   - `n_similar`: number of further warnings of this check about the same field. The row shows the
#'     first.
#'
#'   A wrong `x` is an error of class `codend_error_argument`.
#' @seealso [summary()][summary.codend_gear], [measures()]; the guide
#'   `vignette("design-a-trawl", "codend")`.
#' @examples
#' findings(read_gear("towed_cable"))
#' findings(update(read_gear("towed_cable"), ropes.cable.diameter = 17.3))
#' @export
findings <- function(x) {
  check_given("x")
  structure(findings_by(x, sorted_checks()), class = c("codend_findings", "data.frame"))
}

#' @param n Largest number of printed lines. `Inf` prints all warnings.
#' @param ... Not used.
#' @rdname findings
#' @export
print.codend_findings <- function(x, n = 30, ...) {
  if (!all(c("location", "message", "advice", "field", "n_similar") %in% names(x))) {
    print(as.data.frame(unclass(x)))
  } else if (nrow(x)) {
    cat(bold(if (nrow(x) == 1L) "1 warning" else paste(nrow(x), "warnings")),
      limited_lines(finding_lines(x), n - 1), sep = "\n")
  } else {
    cat("No warnings: everything is within practice and tests.\n")
  }
  invisible(x)
}

finding_lines <- function(found) {
  unlist(lapply(finding_sentences(found), strwrap, width = 98, indent = 2, exdent = 4))
}

findings_by <- function(x, checks) finding_rows(list_findings(x, checks))

list_findings <- function(x, checks) {
  of <- function(...) Filter(function(check) check$of %in% c(...), checks)
  if (inherits(x, "codend_trajectory")) {
    # A gear that is shot or laid does not start in equilibrium.
    moved <- !isTRUE(x$mesh$let_go) && any(c("shooting", "laid") %in% names(x$si))
    start <- if (moved) x$gear else state_at(x, x$time[1L])
    found <- unlist(lapply(unname(of("tow")), found_by, x$gear, x), recursive = FALSE)
    return(c(found, list_findings(start, checks)))
  }
  if (inherits(x, "codend_state")) {
    found <- lapply(of("plan", "state"), found_by, x$gear, x)
  } else if (inherits(x, "codend_gear")) {
    found <- lapply(of("plan"), found_by, x, NULL)
  } else {
    abort_argument("{.arg x} must be a gear, a state or a trajectory, not {.cls {class(x)}}.")
  }
  unlist(unname(found), recursive = FALSE)
}

# Converts a list of findings to a data frame. translate: as for `fill_template()`.
finding_rows <- function(found, translate = identity) {
  column <- function(name, like) vapply(found, `[[`, like, name)
  texts <- function(name) vapply(found, function(one) fill_template(one[[name]], translate), "")
  data.frame(
    check = column("check", ""), location = column("location", ""),
    value = vapply(found, function(one) as.double(one$value), 0), label = texts("label"),
    message = texts("message"), advice = texts("advice"), field = column("field", ""),
    rank = column("rank", 0L), n_similar = column("n_similar", 0L)
  )
}

sorted_checks <- function() {
  checks <- mget(sort(ls(finding_checks), method = "radix"), finding_checks)
  # Problems of the plan come first because they cause problems of the shape.
  checks[order(vapply(checks, `[[`, 0L, "rank"), vapply(checks, `[[`, "", "of"))]
}

# Returns the findings of a check as a list. Several findings about a field are merged into the
# first.
found_by <- function(check, gear, state) {
  found <- lapply(unname(Filter(length, check$test(gear, state))), function(one) {
    one["field"] <- finding_field(gear$plan, one$location, one$field)
    c(check = check$name, one, rank = check$rank)
  })
  about <- vapply(found, function(one) if (is.na(one$field)) one$location else one$field, "")
  unname(lapply(split(found, factor(about, unique(about))), function(group) {
    c(group[[1L]], n_similar = length(group) - 1L)
  }))
}

# Raises a warning of class codend_warning_KIND about the first finding of a check. Returns TRUE if
# there is one.
warn_of_check <- function(check, state, kind) {
  text <- finding_sentences(finding_rows(found_by(check, state$gear, state)))
  if (!length(text)) return(FALSE)
  warn_as(kind, "{text[1L]}")
  TRUE
}

finding_sentences <- function(found, translate = identity) {
  named <- !is.na(found$field) & found$field != found$location
  # The first word of a location may be its kind: "rope", "panel".
  kind <- vapply(sub(" .*", "", found$location), translate, "", USE.NAMES = FALSE)
  location <- paste0(kind, sub("^[^ ]+", "", found$location))
  several <- vapply(found$n_similar, function(n) fill_template(template(" and {n} more",
    n = n), translate), "")
  sprintf("%s%s: %s %s%s", location, ifelse(found$n_similar > 0, several, ""), found$message,
    found$advice,
    ifelse(named, sprintf(" (%s)", found$field), ""))
}

finding_help <- function() {
  checks <- sorted_checks()
  c(
    "@section Checks:",
    sprintf("- %s: %s", vapply(checks, `[[`, "", "name"),
      vapply(checks, function(check) fill_places(check$message, check$values()), "")),
    "", paste("The files `ranges.csv` and `bands.csv` in",
      "`system.file(\"extdata\", package = \"codend\")` list the limits, and the usual ranges by",
      "kind of gear, with their sources.")
  )
}
