# Unfinished plans: collects all problems and builds as much of the gear as can be drawn.

most_problems <- 20L

# Builds a gear from a plan that may be inconsistent. `like`: the last gear without problems, as in
# `as_gear()`. Returns list(gear, problems). `problems` is a list of list(path, message); `path` is
# NULL if the problem has no single field. If there are problems, use `gear` only for drawing: wrong
# fields have the value of `like`, and inconsistent fields remain. If this fails, `gear` is `like`.
draft_gear <- function(plan, like = NULL) {
  found <- tried_gear(plan, like)
  if (!length(found$problems)) return(found)
  if (is.null(found$gear) && !is.null(like)) found$gear <- mended_gear(plan, like, found$problems)
  if (is.null(found$gear)) found$gear <- like
  found
}

# Returns the gear of the plan with its wrong fields reset to the values of `like`.
mended_gear <- function(plan, like, problems) {
  for (problem in problems) {
    path <- dotted_path(first_of(problem$path, ""))
    if (!nzchar(path)) return(NULL)
    before <- at_path(like$plan, path_steps(path))
    plan <- tryCatch(set_plan_field(plan, path, before), error = function(e) NULL)
    if (is.null(plan)) return(NULL)
  }
  tried_gear(plan, like)$gear
}

# Checks continue after a problem (restart of `abort_plan()`). A problem in a single field can cause
# later problems in the assembly. These are omitted, and so is the gear.
tried_gear <- function(plan, like) {
  problems <- list()
  of_fields <- FALSE
  gear <- tryCatch(
    withCallingHandlers(
      as_gear(plan, file = like$file, like = like),
      codend_error_plan = function(e) {
        ways <- Filter(function(way) way$name == "codend_go_on", computeRestarts())
        # An error in the assembly is raised a second time with the field names of the plan.
        own <- length(ways) < 2L
        if (own || !of_fields) {
          problems <<- c(problems, list(list(path = e$path, message = plain_message(e))))
        }
        of_fields <<- of_fields || own
        if (length(ways) && length(problems) < most_problems) invokeRestart(ways[[length(ways)]])
      }
    ),
    error = function(e) {
      if (!length(problems)) {
        problems <<- list(list(path = NULL, message = plain_message(e)))
      }
      NULL
    }
  )
  # Prefer problems that name a field of the plan.
  own <- vapply(problems, function(problem) {
    path <- dotted_path(first_of(problem$path, ""))
    nzchar(path) && !is.null(path_node(plan, path))
  }, NA)
  if (any(own)) problems <- problems[own]
  key <- vapply(problems, function(problem) paste(problem$path, problem$message), "")
  list(gear = if (!of_fields) gear, problems = problems[!duplicated(key)])
}
