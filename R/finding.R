# Worth a look: all findings of a gear or a state.

#' Warnings
#'
#' A gear can be a valid plan and still be nonsense: a unit that was forgotten, a bridle that
#' carries nothing, a net that flies above the sea bed. This lists what of a gear or a settled
#' state lies outside what practice and tests know. [summary()][summary.codend_state], [report()],
#' [flume()] (but for swings of boards) and the command line show the same list under
#' 'Warnings'. None of it is an error: the numbers are computed as the plan says.
#'
#' @eval finding_help()
#'
#' @param x A gear ([read_gear()]), of which the plan alone is looked at, or a state ([settle()],
#'   [state_at()]).
#' @return A data frame with a row per finding, most important first, and the columns `check` (its
#'   name), `place` (a field of the plan, or parts of the gear), `value` (the number that is odd, in
#'   the unit of `shown`), `shown` (the number with its unit), `words` (what is odd), `advice` (what
#'   to try), `field` (the plan's field to change, `NA` where the plan has no one field for it),
#'   `rank` (1: the gear breaks or does not fish so; 2: it is out of proportion; 3: the model is
#'   used outside what it is known for) and `alike` (how many more of the same check concern the
#'   same field; the row is of the one that is farthest out); without rows where nothing is. A wrong
#'   `x` is an error of class `codend_error_argument`.
#' @examples
#' findings(read_gear("towed_cable"))
#' findings(update(read_gear("towed_cable"), ropes.cable.diameter = 17.3))
#' @export
findings <- function(x) {
  check_given("x")
  findings_by(x, sorted_checks())
}

# The findings of some checks.
findings_by <- function(x, checks) finding_rows(list_findings(x, checks))

# ... as a list, in no language yet.
list_findings <- function(x, checks) {
  if (inherits(x, "codend_state")) {
    found <- lapply(checks, found_by, x$gear, x)
  } else if (inherits(x, "codend_gear")) {
    of_plan <- Filter(function(check) check$of == "plan", checks)
    found <- lapply(of_plan, found_by, x, NULL)
  } else {
    abort_argument("{.arg x} must be a gear or a state, not {.cls {class(x)}}.")
  }
  unlist(unname(found), recursive = FALSE)
}

# A list of findings as a data frame; translate: as of told_in(), here and below.
finding_rows <- function(found, translate = identity) {
  column <- function(name, like) vapply(found, `[[`, like, name)
  texts <- function(name) vapply(found, function(one) told_in(one[[name]], translate), "")
  data.frame(
    check = column("check", ""), place = column("place", ""),
    value = vapply(found, function(one) as.double(one$value), 0), shown = texts("shown"),
    words = texts("words"), advice = texts("advice"), field = column("field", ""),
    rank = column("rank", 0L), alike = column("alike", 0L)
  )
}

sorted_checks <- function() {
  checks <- mget(sort(ls(finding_checks), method = "radix"), finding_checks)
  # what the plan tells is the cause of what the shape shows
  checks[order(vapply(checks, `[[`, 0L, "rank"), vapply(checks, `[[`, "", "of"))]
}

# What a check finds, as a list: of many that concern one field the first.
found_by <- function(check, gear, state) {
  found <- lapply(unname(Filter(length, check$test(gear, state))), function(one) {
    one["field"] <- finding_field(gear$plan, one$place, one$field)
    c(check = check$name, one, rank = check$rank)
  })
  about <- vapply(found, function(one) if (is.na(one$field)) one$place else one$field, "")
  unname(lapply(split(found, factor(about, unique(about))), function(group) {
    c(group[[1L]], alike = length(group) - 1L)
  }))
}

# One line a finding, for prints and pages.
finding_sentences <- function(found, translate = identity) {
  named <- !is.na(found$field) & found$field != found$place
  # the first word of a place may tell what it is: "rope", "panel"
  kind <- vapply(sub(" .*", "", found$place), translate, "", USE.NAMES = FALSE)
  place <- paste0(kind, sub("^[^ ]+", "", found$place))
  several <- vapply(found$alike, function(n) told_in(told(" and {n} more", n = n), translate), "")
  sprintf("%s%s: %s %s%s", place, ifelse(found$alike > 0, several, ""), found$words, found$advice,
    ifelse(named, sprintf(" (%s)", found$field), ""))
}

finding_help <- function() {
  checks <- sorted_checks()
  c(
    "@section What is looked at:",
    sprintf("- %s: %s", vapply(checks, `[[`, "", "name"),
      one_line(vapply(checks, function(check) {
        if (is.function(check$words)) check$words() else check$words
      }, "")))
  )
}
