# A study on disk: a folder to which any number of processes on any number of machines write.
#
#   `study.json`: plan, designs, nodes and netting; written once.
#   `base.nc`, `base.none`: initial state of every run, or the reason why the gear does not settle.
#   `rows/N-MARK.json`: row of design N, from `row_text()`.
#   `tasks/*-MARK.json`: rows of a whole task, one per line; they replace the files in `rows/`.
#   `claims/N`: empty folder while a process settles design N.
#
# MARK is the start of the MD5 sum of `study.json`, so rows of an earlier study in the same folder
# are ignored. Rows and `study.json` end with the MD5 sum of their text (`sealed_json()`). Files are
# written atomically (`write_file()`). The folder is also created atomically and never replaces
# another: one process creates it, all others open it.

study_file_version <- 4L

# ---- creation ------------------------------------------------------------------------------------

# Creates a store, or opens a store of the same study.
open_or_create <- function(study, store) {
  check_netcdf()
  check_store_path(store)
  if (!is_store(store) && claim_store(study, store)) return(invisible(open_store(store)))
  if (!is_store(store)) abort_store(store, "exists and is not a study; choose a new name.")
  check_same_study(study, store)
  invisible(open_store(store))
}

is_store <- function(store) file.exists(file.path(store, "study.json"))

# Creates the folder atomically, with `study.json`. Returns FALSE if the name is taken.
claim_store <- function(study, store) {
  if (file.exists(store)) return(FALSE)
  if (file.access(dirname(store), 2L) != 0L) {
    abort_store(store, "must be in a writable folder.")
  }
  path <- unwritten_path(store)
  on.exit(unlink(path, recursive = TRUE))
  for (folder in c("", "rows", "tasks", "claims")) dir.create(file.path(path, folder))
  write_text(study_text(study), file.path(path, "study.json"))
  # Renaming fails if the target is a non-empty folder, such as another study.
  if (suppressWarnings(file.rename(path, store))) return(TRUE)
  if (!file.exists(store)) abort_store(store, "could not be created.")
  FALSE
}

# Returns a study as JSON text. Equal studies give identical text.
study_text <- function(study) {
  designs <- study$designs
  one <- function(value) jsonlite::unbox(value)
  columns <- lapply(names(designs), function(name) {
    values <- designs[[name]]
    if (is.numeric(values)) {
      values <- ifelse(is.na(values), NA, sprintf("%.17g", values))
      list(name = one(name), numbers = values)
    } else {
      list(name = one(name), texts = as.character(values))
    }
  })
  kept <- Filter(Negate(is.null), attributes(designs)[c("how", "number", "seed")])
  sealed_json(jsonlite::toJSON(
    list(
      codend_study = one(study_file_version),
      codend = one(as.character(utils::packageVersion("codend"))),
      plan = one(enc2utf8(format(study$gear))), plan_file = one(first_of(study$gear$file, NA)),
      nodes = one(first_of(study$nodes, NA)), netting = one(first_of(study$netting, NA)),
      accuracy = one(first_of(study$accuracy, NA)),
      chosen = lapply(kept, one), factors = as.list(attr(designs, "factors")),
      distributions = lapply(as.list(attr(designs, "distributions")), one), columns = columns
    ),
    na = "null", digits = NA, pretty = TRUE
  ))
}

check_same_study <- function(study, store) {
  there <- jsonlite::fromJSON(read_store_text(store), simplifyVector = FALSE)
  here <- jsonlite::fromJSON(study_text(study), simplifyVector = FALSE)
  # The file of the plan is ignored.
  parts <- c(
    codend = "was created by another version of codend", plan = "has another plan",
    columns = "has other designs", nodes = "has other `nodes`", netting = "has another `netting`",
    accuracy = "has another `accuracy`"
  )
  for (part in names(parts)) {
    if (!identical(here[[part]], there[[part]])) {
      abort_store(store, "{why}; choose a new name.", why = parts[[part]])
    }
  }
}

# ---- reading -------------------------------------------------------------------------------------

read_store <- function(store) {
  kept <- jsonlite::fromJSON(read_store_text(store), simplifyVector = FALSE)
  designs <- lapply(kept$columns, function(column) {
    values <- first_of(column$numbers, column$texts)
    text <- vapply(values, function(value) {
      if (is.null(value)) NA_character_ else as.character(value)
    }, "")
    # jsonlite reads decimals exactly; the parser of R may not.
    if (is.null(column$numbers)) text else exact_numbers(text)
  })
  names(designs) <- vapply(kept$columns, `[[`, "", "name")
  distributions <- unlist(kept$distributions)
  designs <- structure(
    as.data.frame(designs, optional = TRUE), class = c("codend_designs", "data.frame"),
    how = kept$chosen$how, number = number_of(kept$chosen$number),
    seed = number_of(kept$chosen$seed),
    distributions = distributions, factors = unlist(kept$factors)
  )
  list(
    gear = gear_of_text(kept$plan, kept$plan_file, NULL), designs = designs,
    nodes = number_of(kept$nodes), netting = kept$netting, accuracy = number_of(kept$accuracy)
  )
}

number_of <- function(value) if (!is.null(value)) as.double(value)

exact_numbers <- function(text) {
  text[is.na(text)] <- "null"
  as.double(jsonlite::fromJSON(paste0("[", paste(text, collapse = ","), "]")))
}

check_store_path <- function(store) {
  if (is_text(store) && nzchar(basename(store))) return(invisible())
  abort_argument("{.arg store} is {describe_value(store)}; it must be the path of a study's
    folder.")
}

abort_store <- function(store, what, ...) abort_file(store, what, ..., argument = "store")

read_store_text <- function(store) {
  check_store_path(store)
  file <- file.path(store, "study.json")
  if (!file.exists(file)) abort_store(store, "is not a study: it has no file {.file study.json}.")
  text <- paste(readLines(file, encoding = "UTF-8", warn = FALSE), collapse = "\n")
  version <- tryCatch(jsonlite::fromJSON(text, simplifyVector = FALSE)$codend_study,
    error = function(e) NULL)
  if (!identical(version, study_file_version) || !is_sealed(text)) {
    abort_store(store, "is a study of another format, or its {.file study.json} is damaged: start a
      new study.")
  }
  text
}

# Returns the text of all finished rows, and warns of damaged rows. Single rows come first: a row
# that moves to a task file meanwhile is then read there.
stored_rows <- function(store) {
  mark <- store_mark(store)
  single <- lapply(row_files(store, mark), read_lines_of)
  tasks <- lapply(task_files(store, mark), read_lines_of)
  text <- as.character(unlist(c(single, tasks)))
  # A renamed copy can contain rows of another study.
  other <- grepl("^[{]\"design\":[0-9]+,\"study\":\"[0-9a-f]+\",", text, useBytes = TRUE) &
    !grepl(sprintf("\"study\":\"%s\"", mark), text, fixed = TRUE, useBytes = TRUE)
  good <- is_sealed(text)
  if (!all(good) && !is_sealed(read_store_text(store))) good[] <- TRUE
  damaged <- sum(!good & !other)
  if (damaged) {
    warn_as("study", "{damaged} row{?s} of {.file {store}} {?is/are} damaged and omitted. Delete the
      damaged files in its folders {.file rows} and {.file tasks} and run the study again.")
  }
  text <- text[good & !other]
  text[!duplicated(row_designs(text))]
}

# Adds the MD5 sum of a JSON object as its last entry, `md5`.
sealed_json <- function(text) {
  sub("\\s*[}]$", paste0(",\"md5\":\"", cli::hash_md5(text), "\"}"), text, perl = TRUE)
}

# Returns TRUE for each text that matches its MD5 sum.
is_sealed <- function(text) {
  seal <- ",\"md5\":\"[0-9a-f]{32}\"[}]$"
  sealed <- validUTF8(text) & grepl(seal, text, perl = TRUE, useBytes = TRUE)
  # `sealed_json()` removes the last brace, and in `study.json` also the line break before it.
  before <- sub(seal, "", text[sealed], perl = TRUE)
  sum <- substring(text[sealed], nchar(text[sealed]) - 33L, nchar(text[sealed]) - 2L)
  sealed[sealed] <- sum == cli::hash_md5(paste0(before, "}")) |
    sum == cli::hash_md5(paste0(before, "\n}"))
  sealed
}

row_designs <- function(text) as.integer(sub("^[{]\"design\":([0-9]+),.*", "\\1", text))

# Returns character() if another process has removed the file.
read_lines_of <- function(file) {
  tryCatch(
    withCallingHandlers(
      readLines(file, encoding = "UTF-8", warn = FALSE),
      warning = function(w) invokeRestart("muffleWarning")
    ),
    error = function(e) character()
  )
}

# Returns the MARK in the file names of a study.
store_mark <- function(store) {
  substr(tools::md5sum(file.path(store, "study.json"))[[1L]], 1L, 12L)
}

row_file <- function(store, design, mark) {
  file.path(store, "rows", sprintf("%07d-%s.json", as.integer(design), mark))
}

row_files <- function(store, mark = store_mark(store)) {
  list.files(file.path(store, "rows"), sprintf("^[0-9]+-%s[.]json$", mark), full.names = TRUE)
}

task_files <- function(store, mark = store_mark(store)) {
  form <- sprintf("^[A-Za-z0-9-]+-%s[.]json$", mark)
  list.files(file.path(store, "tasks"), form, full.names = TRUE)
}

designs_done <- function(store) done_finder(store)()

# Returns a function(single) that lists finished designs; `single = FALSE` skips `rows/`.
done_finder <- function(store, mark = store_mark(store)) {
  known <- list()
  function(single = TRUE) {
    rows <- if (single) as.integer(sub("-.*", "", basename(row_files(store, mark))))
    for (file in setdiff(task_files(store, mark), names(known))) {
      known[[file]] <<- row_designs(read_lines_of(file))
    }
    sort(unique(c(rows, unlist(known, use.names = FALSE))))
  }
}

# ---- one task ------------------------------------------------------------------------------------

# Cache of the last opened store, because one process runs many tasks of a store.
opened_store <- new.env(parent = emptyenv())

# Returns the study of a store.
open_study <- function(store) {
  mark <- c(store = normalizePath(store), mark = store_mark(store))
  if (!identical(opened_store$mark, mark)) {
    rm(list = names(opened_store), envir = opened_store)
    opened_store$study <- read_store(store)
    opened_store$mark <- mark
  }
  opened_store$study
}

# Returns the cache with the initial state of every run (`base`).
open_store <- function(store) {
  study <- open_study(store)
  if (is.null(opened_store$seconds)) {
    opened_store$base <- store_base(store, study)
    # Estimated CPU time of one run (s).
    opened_store$seconds <- max(first_of(opened_store$base$report$cpu_seconds, 1), 0.01)
  }
  opened_store
}

# Returns the initial state of every run, or NULL. The first process that needs it settles it.
# Simultaneous processes write identical files.
store_base <- function(store, study) {
  file <- file.path(store, "base.nc")
  none <- file.path(store, "base.none")
  if (!file.exists(file) && !file.exists(none)) {
    found <- settle_first(study)
    if (is.null(found$state)) write_text(c(found$problem, ""), none) else {
      write_state(found$state, file)
    }
  }
  if (file.exists(file)) read_netcdf(file)
}

# Settles designs of a store and writes their rows. Designs claimed by another process come last and
# are settled only if still missing, because that process may have ended. Returns the number of
# settled designs.
run_task <- function(store, designs, told = function(done) NULL) {
  read_store_text(store)
  opened <- open_store(store)
  mark <- opened$mark[["mark"]]
  for (folder in c("rows", "tasks", "claims")) {
    dir.create(file.path(store, folder), showWarnings = FALSE)
  }
  done_tasks <- done_finder(store, mark)
  is_done <- function(design) {
    file.exists(row_file(store, design, mark)) || design %in% done_tasks(FALSE)
  }
  rows <- list()
  later <- integer()
  settle_design <- function(design) {
    row <- run_design(opened$study, opened$base, design, mark)
    write_text(c(row, ""), row_file(store, design, mark))
    rows[[as.character(design)]] <<- row
  }
  for (k in seq_along(designs)) {
    design <- designs[k]
    claim <- file.path(store, "claims", sprintf("%07d", as.integer(design)))
    if (!file.exists(row_file(store, design, mark))) {
      if (dir.create(claim, showWarnings = FALSE)) {
        tryCatch(if (!is_done(design)) settle_design(design),
          finally = unlink(claim, recursive = TRUE))
      } else {
        later <- c(later, design)
      }
    }
    told(k)
  }
  for (design in later) {
    if (!is_done(design)) settle_design(design)
    unlink(file.path(store, "claims", sprintf("%07d", as.integer(design))), recursive = TRUE)
  }
  if (length(rows) > 1L) {
    # Host and process number make the name unique.
    name <- sprintf("%07d-%s-%d-%s.json", as.integer(names(rows)[1L]), this_host(), Sys.getpid(),
      mark)
    write_text(c(unlist(rows, use.names = FALSE), ""), file.path(store, "tasks", name))
    unlink(row_file(store, as.integer(names(rows)), mark))
  }
  length(rows)
}
