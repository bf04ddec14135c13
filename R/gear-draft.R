# Plans that may be unfinished: all that is wrong with one, and as much of a gear as can be drawn.

# Problems told of one plan, at most.
most_problems <- 20L

# The gear of a plan that may contradict itself. like: the last gear that had no problem, as in
# as_gear(). Returns list(gear, problems): problems a list of list(path (NULL where no one field is
# wrong), message); with problems the gear is for drawing alone: wrong fields are as in `like`,
# contradictions stay, and where that gives no gear it is `like` itself.
draft_gear <- function(plan, like = NULL) {
  found <- tried_gear(plan, like)
  if (!length(found$problems)) return(found)
  if (is.null(found$gear) && !is.null(like)) found$gear <- mended_gear(plan, like, found$problems)
  if (is.null(found$gear)) found$gear <- like
  found
}

# A plan with the fields that are wrong in themselves as they were.
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

# Checks go on behind a problem (abort_plan()). What comes behind one of a single field may be made
# by it, and is left out, as is the gear.
tried_gear <- function(plan, like) {
  problems <- list()
  of_fields <- FALSE
  gear <- tryCatch(
    withCallingHandlers(
      as_gear(plan, file = like$file, like = like),
      codend_error_plan = function(e) {
        ways <- Filter(function(way) way$name == "codend_go_on", computeRestarts())
        # an error of parts is told again in the words of the plan
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
  # of the plan's own fields, where there are such
  own <- vapply(problems, function(problem) {
    path <- dotted_path(first_of(problem$path, ""))
    nzchar(path) && !is.null(path_node(plan, path))
  }, NA)
  if (any(own)) problems <- problems[own]
  key <- vapply(problems, function(problem) paste(problem$path, problem$message), "")
  list(gear = if (!of_fields) gear, problems = problems[!duplicated(key)])
}
