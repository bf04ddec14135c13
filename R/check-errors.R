# How codend stops: every kind of error has one class, and one function that raises it.

# kind: which error, the most special first where it is of several; see help("codend-conditions").
error_class <- function(kind) c(paste0("codend_error_", kind), "codend_error")

# message: for cli, with values from `envir`; `...`: the condition's fields. The error names the
# function of codend that was called from outside.
abort_as <- function(kind, message, ..., envir) {
  cli::cli_abort(message, class = error_class(kind), ..., call = outer_call(), .envir = envir)
}

# The outermost call of a function of the package, without its arguments, or NULL.
outer_call <- function() {
  home <- topenv()
  for (k in seq_len(sys.nframe())) {
    if (!identical(environment(sys.function(k)), home)) next
    name <- sys.call(k)[[1L]]
    if (is.call(name) && length(name) == 3L) name <- name[[3L]]
    if (!is.name(name)) return(NULL)
    # of a method, as users call it
    return(as.call(list(as.name(sub("[.]codend_.*", "", as.character(name))))))
  }
  NULL
}

# Arguments of the calling function that must be there. One that is missing, or names what is no
# variable (measures are given as texts or formulas), is an error of codend's.
check_given <- function(...) {
  frame <- parent.frame()
  for (name in c(...)) {
    if (eval(call("missing", as.name(name)), frame)) abort_argument("{.arg {name}} is missing.")
    tryCatch(get(name, frame), error = function(e) {
      said <- eval(call("substitute", as.name(name)), frame)
      if (inherits(e, "codend_error") || !is.name(said)) stop(e)
      abort_argument("{.arg {name}} is {.code {as.character(said)}}, of which there is no variable.
        Names of measures, fields and plans are texts: {.val {as.character(said)}}.")
    })
  }
}

# An argument of a function is wrong. The message takes its values from the caller's variables.
abort_argument <- function(message) abort_as("argument", message, envir = parent.frame())

# A gear or a motion finds no balance; `...`: the condition's fields, its report first.
abort_not_converged <- function(message, ...) {
  abort_as("not_converged", message, ..., envir = parent.frame())
}

# A package is not installed.
abort_package <- function(message) abort_as("package", message, envir = parent.frame())

# what: what needs the package, as the beginning of a sentence, in the singular.
check_package <- function(package, what) {
  if (requireNamespace(package, quietly = TRUE)) return(invisible())
  abort_package("{what} needs the package {.pkg {package}}, which is not installed:
    {.code install.packages(\"{package}\")}.")
}

# A command of the command line is used wrongly; `...`: pieces of the message, as they are.
abort_usage <- function(...) stop(errorCondition(paste0(...), class = error_class("usage")))

# Codend's own lattice is not what the engine, or the plan, asks for. field: what is wrong, such as
# "bars.rest", or NA.
abort_lattice <- function(message, field = NA_character_) {
  abort_as("engine", message, field = field, envir = parent.frame())
}

# Called by the binding for every exception of the engine; field: "" where it names none.
abort_engine <- function(message, field) {
  abort_lattice("The engine stopped: {message}.", if (nzchar(field)) field else NA_character_)
}
