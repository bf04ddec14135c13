# Errors: each kind has one class and one function that raises it.

# kind: see help("codend-conditions"); if several apply, the most special first.
error_class <- function(kind) c(paste0("codend_error_", kind), "codend_error")

# Raises an error that names the exported function that the user called. message: for cli, with
# values from `envir`; `...`: fields of the condition.
abort_as <- function(kind, message, ..., envir) {
  cli::cli_abort(message, class = error_class(kind), ..., call = outer_call(), .envir = envir)
}

# Returns the outermost call of a function of this package, without arguments, or NULL.
outer_call <- function() {
  home <- topenv()
  for (k in seq_len(sys.nframe())) {
    if (!identical(environment(sys.function(k)), home)) next
    name <- sys.call(k)[[1L]]
    if (is.call(name) && length(name) == 3L) name <- name[[3L]]
    if (!is.name(name)) return(NULL)
    # Users call the generic, so the class of the method is dropped.
    return(as.call(list(as.name(sub("[.]codend_.*", "", as.character(name))))))
  }
  NULL
}

# Checks that the named arguments of the calling function are present. An argument that is missing,
# or that is a bare name of an undefined variable, is an error. Measures are given as strings or
# formulas.
check_given <- function(...) {
  frame <- parent.frame()
  for (name in c(...)) {
    if (eval(call("missing", as.name(name)), frame)) abort_argument("{.arg {name}} is missing.")
    tryCatch(get(name, frame), error = function(e) {
      said <- eval(call("substitute", as.name(name)), frame)
      if (inherits(e, "codend_error") || !is.name(said)) stop(e)
      abort_argument("{.arg {name}} is {.code {as.character(said)}}, but no such variable exists.
        Write names of measures, fields and plans as strings: {.val {as.character(said)}}.")
    })
  }
}

# Raises an error about a function argument. `message` takes its values from the caller's variables.
abort_argument <- function(message) abort_as("argument", message, envir = parent.frame())

# Warns with the class `codend_warning_KIND`.
warn_as <- function(kind, message) {
  cli::cli_warn(message, class = c(paste0("codend_warning_", kind), "codend_warning"), call = NULL,
    .envir = parent.frame())
}

abort_not_converged <- function(message, ...) {
  abort_as("not_converged", message, ..., envir = parent.frame())
}

abort_package <- function(message) abort_as("package", message, envir = parent.frame())

# `what` names the part of codend that needs the package: a singular noun phrase that starts a
# sentence.
check_package <- function(package, what) {
  if (requireNamespace(package, quietly = TRUE)) return(invisible())
  abort_package("{what} needs the package {.pkg {package}}, which is not installed:
    {.code install.packages(\"{package}\")}.")
}

abort_usage <- function(...) stop(errorCondition(paste0(...), class = error_class("usage")))

# Raises the error that codend's own mesh violates a requirement of the engine or the plan. field:
# the wrong field, such as "bars.rest", or NA.
abort_mesh <- function(message, field = NA_character_) {
  abort_as("engine", message, field = field, envir = parent.frame())
}

# The binding calls this for every exception of the engine. field: "" if the exception names none.
abort_engine <- function(message, field) {
  abort_mesh("Engine error: {message}.", if (nzchar(field)) field else NA_character_)
}
