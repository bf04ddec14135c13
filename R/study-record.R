# Records of settled gears on disk, from which an interrupted calibration or optimisation resumes.
#
# The search repeats its steps and reads recorded results instead of settling the gears. Each line
# after the header is a JSON object that ends with the MD5 sum of its text (`sealed_json()`):
#
#   `key`: the MD5 sum of codend's version, gear, values of the fields, mesh and kind of result.
#   `n_solves`: number of settled gears.
#   `names`, `numbers`: measures, or their derivatives by each field; empty if it does not settle.
#
# Damaged lines are ignored. The file is written atomically. Workers add their lines to those in
# the file.

record_header <- "{\"codend_record\":1}"

# Returns an environment with `file` and `lines` (by key); NULL without a file.
open_record <- function(file) {
  if (is.null(file)) return(NULL)
  check_file_path(file)
  list2env(list(file = file, lines = read_record(file)), parent = emptyenv())
}

read_record <- function(file) {
  if (!file.exists(file)) return(character())
  lines <- read_lines_of(file)
  if (!identical(lines[1L], record_header)) {
    abort_file(file, "exists and is not a record of a search; choose a new name.")
  }
  lines <- lines[is_sealed(lines)]
  setNames(lines, sub("^[{]\"key\":\"([0-9a-f]+)\".*", "\\1", lines))
}

# Returns the key of a result. kind: text.
record_key <- function(points, values, kind) {
  if (is.null(points$shared$record)) return("")
  cli::hash_md5(paste(c(
    as.character(utils::packageVersion("codend")), format(points$gear), points$nodes,
    points$netting, field_names(points$fields), sprintf("%.17g", values), kind
  ), collapse = "\n"))
}

# Returns list(names, numbers, n_solves), or NULL.
recorded <- function(record, key) {
  if (is.null(record) || !key %in% names(record$lines)) return(NULL)
  found <- jsonlite::fromJSON(record$lines[[key]], simplifyVector = FALSE)
  list(
    names = as.character(unlist(found$names)), n_solves = found$n_solves,
    numbers = vapply(found$numbers, function(x) if (is.null(x)) NA_real_ else as.double(x), 0)
  )
}

# Adds results, list(key, names, numbers, n_solves), and writes the file.
add_to_record <- function(record, results) {
  if (is.null(record) || !length(results)) return(invisible())
  lines <- vapply(results, function(one) {
    numbers <- ifelse(is.finite(one$numbers), sprintf("%.17g", one$numbers), "null")
    sealed_json(sprintf("{\"key\":\"%s\",\"n_solves\":%d,\"names\":%s,\"numbers\":[%s]}", one$key,
      as.integer(one$n_solves), jsonlite::toJSON(as.character(one$names)),
      paste(numbers, collapse = ",")))
  }, "")
  lines <- c(read_record(record$file), record$lines, setNames(lines, vapply(results, `[[`, "",
    "key")))
  record$lines <- lines[!duplicated(names(lines))]
  write_text(c(record_header, unname(record$lines), ""), record$file)
}

# ---- steps ---------------------------------------------------------------------------------------

# Returns an environment that counts the steps of a search. most: expected number of steps.
new_steps <- function(most, frame = parent.frame()) {
  show <- if (isNamespaceLoaded("progressr")) progressr::progressor(steps = most, envir = frame)
  # Guides would otherwise print every step.
  wanted <- getOption("codend.steps", !isTRUE(getOption("knitr.in.progress")))
  list2env(list(number = 0L, show = show, wanted = wanted), parent = emptyenv())
}

# Reports a step of a search by a message, and to progressr. text: of the objective.
report_step <- function(steps, text, value, scaled) {
  if (is.null(steps)) return(invisible())
  steps$number <- steps$number + 1L
  change <- if (!is.null(steps$last)) max(abs(scaled - steps$last))
  steps$last <- scaled
  said <- paste0("Step ", steps$number, ": ", text, " ", four_figures(value),
    if (!is.null(change)) paste0(", largest change ", percent_text(change), " of a range"))
  if (!is.null(steps$show)) steps$show(message = said)
  if (steps$wanted) cli::cli_inform("{said}", class = "codend_message_step")
}

# ---- workers -------------------------------------------------------------------------------------

# Calls a function of codend, by its name, for each element of `items` and of `others`. With
# workers of the package future, they share the calls; results are the same. Returns a list.
on_workers <- function(name, items, others, ...) {
  run <- get(name, asNamespace("codend"))
  workers <- first_of(future_workers(), 1L)
  if (workers == 1L || length(items) < 2L) {
    return(unname(Map(run, items, others, MoreArgs = list(...))))
  }
  before <- options(future.globals.maxSize = Inf)
  on.exit(options(before))
  parts <- unname(split(seq_along(items), (seq_along(items) - 1L) %% workers))
  futures <- lapply(parts, function(part) {
    given <- list(name = name, items = items[part], others = others[part], more = list(...))
    future::future(
      Map(get(name, asNamespace("codend")), items, others, MoreArgs = more), substitute = TRUE,
      envir = list2env(given, parent = baseenv()), globals = given, packages = "codend",
      seed = NULL, lazy = FALSE
    )
  })
  found <- vector("list", length(items))
  for (k in seq_along(parts)) found[parts[[k]]] <- unname(future::value(futures[[k]]))
  found
}
