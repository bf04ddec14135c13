# A study on disk: a folder that any number of processes, on any number of machines, write to.
#
#   study.json    the gear's plan, the designs, nodes and netting; written once
#   base.nc       the state that every run starts from; not there where the gear does not settle
#   rows/N.json   the row of design N, as row_text() gives it
#   tasks/*.json  rows of whole tasks, one a line; those in rows/ are then taken away
#
# Every file is written whole beside its place and renamed (write_file()), so that no reader ever
# sees part of one, whoever is killed when.

study_file_version <- 1L

store_file <- function(store, ...) file.path(store, ...)

# ---- beginning -----------------------------------------------------------------------------------

# Makes a store, or finds one of the same study.
open_or_create <- function(study, store) {
  if (is_text(store) && file.exists(store_file(store, "study.json"))) {
    check_same_study(study, store)
  } else {
    create_store(study, store)
  }
}

create_store <- function(study, store) {
  check_netcdf()
  check_store_path(store)
  if (file.exists(store)) {
    abort_file(store, "exists and is no study; choose a new name.")
  }
  if (file.access(dirname(store), 2L) != 0L) {
    abort_file(store, "lies in no folder that can be written.")
  }
  base <- base_state(study)
  write_file(store, function(path) {
    dir.create(path)
    write_text(study_text(study), store_file(path, "study.json"))
    if (!is.null(base)) write_state(base, store_file(path, "base.nc"))
  })
  for (folder in c("rows", "tasks")) dir.create(store_file(store, folder), showWarnings = FALSE)
}

# A study as text, the same for the same study.
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
  jsonlite::toJSON(
    list(
      codend_study = one(study_file_version),
      codend = one(as.character(utils::packageVersion("codend"))),
      plan = one(enc2utf8(format(study$gear))), plan_file = one(first_of(study$gear$file, NA)),
      nodes = one(study$nodes), netting = one(first_of(study$netting, NA)),
      chosen = lapply(kept, one), factors = as.list(attr(designs, "factors")),
      distributions = lapply(as.list(attr(designs, "distributions")), one), columns = columns
    ),
    na = "null", digits = NA, pretty = TRUE
  )
}

check_same_study <- function(study, store) {
  there <- jsonlite::fromJSON(read_store_text(store), simplifyVector = FALSE)
  here <- jsonlite::fromJSON(study_text(study), simplifyVector = FALSE)
  # where the plan came from does not matter
  parts <- c(
    codend = "was begun by another version of codend", plan = "is of another plan",
    columns = "has other designs", nodes = "has other `nodes`", netting = "has another `netting`"
  )
  for (part in names(parts)) {
    if (!identical(here[[part]], there[[part]])) {
      abort_file(store, "{why}; choose a new name.", why = parts[[part]])
    }
  }
}

# ---- reading -------------------------------------------------------------------------------------

# The study of a store.
read_store <- function(store) {
  kept <- jsonlite::fromJSON(read_store_text(store), simplifyVector = FALSE)
  designs <- lapply(kept$columns, function(column) {
    values <- first_of(column$numbers, column$texts)
    text <- vapply(values, function(value) {
      if (is.null(value)) NA_character_ else as.character(value)
    }, "")
    # jsonlite reads decimals to the last bit, R's own reader may not
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
    nodes = as.double(kept$nodes), netting = kept$netting
  )
}

number_of <- function(value) if (!is.null(value)) as.double(value)

exact_numbers <- function(text) {
  text[is.na(text)] <- "null"
  as.double(jsonlite::fromJSON(paste0("[", paste(text, collapse = ","), "]")))
}

check_store_path <- function(store) {
  if (is_text(store) && nzchar(basename(store))) return(invisible())
  said <- if (is_text(store)) store else class(store)
  abort_argument("{.arg store} is {.val {said}}; it must be the path of a study's folder.")
}

read_store_text <- function(store) {
  check_store_path(store)
  file <- store_file(store, "study.json")
  if (!file.exists(file)) abort_file(store, "is no study: it holds no {.file study.json}.")
  text <- paste(readLines(file, encoding = "UTF-8", warn = FALSE), collapse = "\n")
  version <- tryCatch(jsonlite::fromJSON(text, simplifyVector = FALSE)$codend_study,
    error = function(e) NULL)
  if (!identical(version, study_file_version)) {
    abort_file(store, "is a study of another format, or damaged.")
  }
  text
}

# Texts of all rows that are done. Rows first: a row that is gathered meanwhile is in its task.
stored_rows <- function(store) {
  single <- lapply(row_files(store), read_lines_of)
  tasks <- lapply(task_files(store), read_lines_of)
  text <- unlist(c(single, tasks))
  text[!duplicated(row_designs(text))]
}

# The designs of rows.
row_designs <- function(text) as.integer(sub("^[{]\"design\":([0-9]+),.*", "\\1", text))

# None where it was gathered and taken away meanwhile.
read_lines_of <- function(file) {
  tryCatch(
    withCallingHandlers(
      readLines(file, encoding = "UTF-8", warn = FALSE),
      warning = function(w) invokeRestart("muffleWarning")
    ),
    error = function(e) character()
  )
}

row_files <- function(store) {
  list.files(store_file(store, "rows"), "^[0-9]+[.]json$", full.names = TRUE)
}

task_files <- function(store) {
  list.files(store_file(store, "tasks"), "^[A-Za-z0-9-]+[.]json$", full.names = TRUE)
}

# Which designs are done.
designs_done <- function(store) done_finder(store)()

# A function() that gives the designs that are done; it reads each task once.
done_finder <- function(store) {
  known <- list()
  function() {
    single <- as.integer(sub("[.]json$", "", basename(row_files(store))))
    for (file in setdiff(task_files(store), names(known))) {
      known[[file]] <<- row_designs(read_lines_of(file))
    }
    sort(unique(c(single, unlist(known, use.names = FALSE))))
  }
}

# ---- one task ------------------------------------------------------------------------------------

# What a process read last of a store: tasks follow one another.
opened_store <- new.env(parent = emptyenv())

open_store <- function(store) {
  mark <- tools::md5sum(store_file(store, "study.json"))
  if (!identical(opened_store$mark, mark)) {
    opened_store$study <- read_store(store)
    base <- store_file(store, "base.nc")
    opened_store$base <- if (file.exists(base)) read_state(base)
    # of a run, about
    opened_store$seconds <- max(first_of(opened_store$base$report$cpu_seconds, 1), 0.01)
    opened_store$mark <- mark
  }
  opened_store
}

# Settles designs of a store and writes their rows. Returns how many.
run_task <- function(store, designs, told = function(done) NULL) {
  read_store_text(store)
  opened <- open_store(store)
  for (folder in c("rows", "tasks")) dir.create(store_file(store, folder), showWarnings = FALSE)
  rows <- character(length(designs))
  files <- store_file(store, "rows", sprintf("%07d.json", designs))
  for (k in seq_along(designs)) {
    rows[k] <- run_design(opened$study, opened$base, designs[k])
    write_text(c(rows[k], ""), files[k])
    told(k)
  }
  if (length(designs) > 1L) {
    # no other process has this name
    name <- sprintf("%07d-%s-%d.json", designs[1L],
      gsub("[^A-Za-z0-9]+", "-", Sys.info()[["nodename"]]), Sys.getpid())
    write_text(c(rows, ""), store_file(store, "tasks", name))
    unlink(files)
  }
  length(designs)
}
