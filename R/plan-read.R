# Reads a plan file into a plain tree: named lists, strings, doubles, logicals. Nothing in the file
# is evaluated. Malicious files are rejected before they use time or memory.

plan_bytes_limit <- 2 * 1024^2
plan_depth_limit <- 20
plan_values_limit <- 5e4
# A plan with a hundred panels has two thousand.
plan_marks_limit <- 5e3

# Returns the paths of the shipped plans, named by file name.
shipped_plans <- function() {
  files <- list.files(
    system.file("gears", package = "codend"), pattern = "[.]yaml$", full.names = TRUE
  )
  stats::setNames(files, sub("[.]yaml$", "", basename(files)))
}

read_plan <- function(file) plan_of_bytes(plan_bytes(file), file)

# Returns the tree of a plan. `bytes`: raw YAML; `file`: name in messages.
plan_of_bytes <- function(bytes, file) {
  text <- plan_text_of(bytes, file)
  # The parser would catch an error raised inside it and report it as its own.
  warned <- NULL
  tree <- tryCatch(
    withCallingHandlers(
      yaml::yaml.load(text, eval.expr = FALSE, handlers = yaml_handlers),
      warning = function(w) {
        warned <<- c(warned, conditionMessage(w))
        invokeRestart("muffleWarning")
      }
    ),
    error = function(e) abort_yaml(file, text, conditionMessage(e))
  )
  if (length(warned)) abort_yaml(file, text, warned[1])
  tree <- plain_tree(tree)
  if (!is_map(tree) || length(tree) == 0) {
    abort_plan_file(file, "must be a map of fields such as `codend: 1` and `name`.")
  }
  tree
}

# Returns the bytes of a file. Only regular files are opened: a pipe would block.
plan_bytes <- function(file) {
  size <- file_size(file)
  if (is.na(size)) abort_plan(sprintf("\"%s\" is not a plan file.", file), NULL)
  check_plan_size(size, file)
  tryCatch(
    suppressWarnings(readBin(file, "raw", plan_bytes_limit + 1)),
    error = function(e) abort_plan_file(file, "cannot be read.")
  )
}

# Throws an error about a plan's file. `what`: the rest of the sentence; `...`: fields of the
# condition.
abort_plan_file <- function(file, what, ...) {
  abort_plan(sprintf("Plan file \"%s\" %s", file, what), NULL, ...)
}

check_plan_size <- function(size, file) {
  if (size > plan_bytes_limit) {
    abort_plan_file(file, sprintf("has %.1f MB; it must have at most 2 MB.", size / 1024^2))
  }
}

plan_text_of <- function(bytes, file) {
  check_plan_size(length(bytes), file)
  if (any(bytes == 0)) abort_plan_file(file, "is not text: it has NUL bytes.")
  text <- rawToChar(bytes)
  Encoding(text) <- "UTF-8"
  if (!validUTF8(text)) abort_plan_file(file, "is not UTF-8 text.")
  check_marks(bytes, text, file)
  check_one_document(text, file)
  check_no_merge(text, file)
  sub("^\ufeff", "", text)
}

# The parser's time grows with the square of the nesting and of the fields in a map. Files far
# beyond the needs of a plan are rejected before parsing.
check_marks <- function(bytes, text, file) {
  opens <- bytes == 0x5b | bytes == 0x7b
  closes <- bytes == 0x5d | bytes == 0x7d
  deep <- max(0, cumsum(opens - closes)) > 10 * plan_depth_limit ||
    grepl(sprintf("(?m)^[ \\t]*(?:[-?][ \\t]+){%d}", plan_depth_limit), text, perl = TRUE)
  if (deep) {
    abort_plan_file(file, sprintf(
      "is nested too deeply; at most %d levels of lists or maps are allowed.", plan_depth_limit
    ))
  }
  if (sum(opens) > plan_marks_limit || sum(bytes == 0x3a) > plan_marks_limit) {
    abort_plan_file(file,
      sprintf("has too many fields; at most %d are allowed.", plan_marks_limit))
  }
}

# The parser reads only the first document.
check_one_document <- function(text, file) {
  lines <- strsplit(text, "\r\n|\r|\n", perl = TRUE)[[1]]
  begins <- grep("^---([ \t]|$)", lines)
  if (!length(begins)) return(invisible())
  before <- utils::head(lines, begins[1] - 1L)
  if (length(begins) > 1 || !all(grepl("^\ufeff?[ \t]*(#.*)?$|^%", before, perl = TRUE))) {
    abort_plan_file(file, "has several YAML documents; it must have one.")
  }
}

# Rejects merge keys (`<<`) and their tag: the order of fields would then decide their values.
check_no_merge <- function(text, file) {
  lines <- strsplit(text, "\r\n|\r|\n", perl = TRUE)[[1]]
  # without remarks and quoted strings
  bare <- gsub("(^|[[:space:]])#.*$|\"[^\"]*\"|'[^']*'", "", lines)
  merges <- grep("(^|[[:space:]{,?\\[-])<<[[:space:]]*(:|$)|![^[:space:]]*merge", bare)
  if (!length(merges)) return(invisible())
  abort_plan_file(file,
    sprintf("has, in line %d, a merge key `<<`; write every field in full.", merges[1]),
    line = merges[1])
}

# Throws an error with line and column. `problem`: message of the YAML parser.
abort_yaml <- function(file, text, problem) {
  doubled <- if (grepl("Duplicate map key", problem, fixed = TRUE)) doubled_key(text)
  place <- if (is.null(doubled)) yaml_place(problem, text) else doubled[c("line", "column")]
  line <- if (!is.null(place)) strsplit(text, "\n", fixed = TRUE)[[1]][place$line]
  why <- if (!is.null(doubled)) {
    sprintf("the field `%s` is given twice, first in line %d", doubled$path, doubled$first)
  } else if (!is.null(place) && !is.na(line) && grepl("^ *\t", line)) {
    "a line starts with a tab; indent with spaces"
  } else if (grepl("mapping values are not allowed", problem, fixed = TRUE)) {
    paste(
      "a colon is not allowed here: text with a colon needs quotes, and the fields of one map need",
      "the same indentation"
    )
  } else if (grepl("did not find expected ',' or ']'", problem, fixed = TRUE)) {
    paste(
      "a closing ] is missing; an edge with a mesh range inside [ ] needs quotes, such as",
      "[\"belly.upper[0:6]\"]"
    )
  } else if (grepl("did not find expected ',' or '}'", problem, fixed = TRUE)) {
    "a closing } is missing, or a comma between fields"
  } else if (grepl("while scanning a quoted scalar", problem, fixed = TRUE)) {
    "a closing quote is missing"
  } else if (grepl("did not find expected key", problem, fixed = TRUE)) {
    "the indentation of a field differs from the fields around it"
  } else {
    gsub("[[:space:]]+", " ", sub(" at line [0-9]+, column [0-9]+[[:space:]]*$", "", problem))
  }
  where <- if (!is.null(place)) sprintf(", line %d, column %d,", place$line, place$column) else ""
  abort_plan(
    sprintf("Plan file \"%s\"%s is not valid YAML: %s.", file, where, sub("[.]$", "", trimws(why))),
    doubled$path, line = place$line, column = place$column
  )
}

# Returns the position at the end of a parser message, where parsing stopped.
yaml_place <- function(problem, text) {
  found <- regmatches(problem, gregexpr("line ([0-9]+), column ([0-9]+)", problem))[[1]]
  if (!length(found)) return(NULL)
  # Report the start of an unterminated quoted string.
  pick <- if (grepl("quoted scalar", problem, fixed = TRUE)) found[1] else found[length(found)]
  numbers <- as.integer(regmatches(pick, gregexpr("[0-9]+", pick))[[1]])
  list(line = numbers[1], column = numbers[2])
}

# Limits YAML 1.1: only yes, no, true and false are logicals, numbers are decimal, no tags.
yaml_handlers <- list(
  "bool#yes" = function(x) if (tolower(x) %in% c("yes", "true")) TRUE else x,
  "bool#no" = function(x) if (tolower(x) %in% c("no", "false")) FALSE else x,
  "int" = function(x) yaml_number(x),
  "float#fix" = function(x) yaml_number(x),
  "float#exp" = function(x) yaml_number(x),
  "int#oct" = function(x) x,
  "int#hex" = function(x) x,
  "float#nan" = function(x) NaN,
  "seq" = function(x) x,
  # Rejected by plain_tree(): an error inside a handler would only be printed.
  "expr" = function(x) as.symbol(x)
)

# A comma may separate thousands (YAML 1.1) or decimals: such a number is a string.
yaml_number <- function(text) if (grepl(",", text, fixed = TRUE)) text else as.double(text)

# Returns the plain form of any tree of R lists and vectors; equal plans then are identical. It has
# no attributes except names, doubles instead of integers, and vectors instead of lists of scalars
# of one type. `depth`, `path`: position of the tree in its plan.
plain_tree <- function(tree, depth = 0, path = "") {
  count <- 0
  # Paths are evaluated only for errors.
  plain <- function(value, depth, path) {
    count <<- count + 1
    if (count > plan_values_limit || depth > plan_depth_limit) {
      abort_plan(sprintf("A plan must have at most %d levels and %d values.", plan_depth_limit,
        plan_values_limit), NULL)
    }
    if (is.null(value)) return(NULL)
    if (is.null(attributes(value)) && length(value) == 1L) {
      if (is.double(value) || is.logical(value)) return(value)
      if (is.character(value)) return(enc2utf8(value))
    }
    keys <- names(value)
    if (is.atomic(value)) value <- given_value(value, path)
    if (is.character(value)) value <- enc2utf8(value)
    if (is.integer(value)) value <- as.double(value)
    if (is.atomic(value)) {
      if (is.null(keys)) return(as.vector(value))
      value <- as.list(value)
    }
    if (is.language(value)) {
      abort_plan("A plan cannot contain code: the tag `!expr` is not allowed.", NULL)
    }
    if (!is.list(value)) {
      abort_plan(paste0("A plan contains text, numbers, yes and no, lists and maps, but no ",
        class(value)[1], "."), NULL)
    }
    value <- lapply(seq_along(value), function(k) {
      plain(value[[k]], depth + 1, join(path, if (is.null(keys)) k else keys[k]))
    })
    if (!is.null(keys)) return(stats::setNames(value, keys))
    if (length(value) > 1 && all(lengths(value) == 1)) {
      types <- unique(vapply(value, typeof, ""))
      if (length(types) == 1 && types != "list") return(unlist(value))
    }
    value
  }
  plain(tree, depth, path)
}

# Returns a plan in plain form if only the fields at the paths `changed` (as steps) may not be in
# it. For a group that is a map, only the changed part is converted: a net has a hundred parts.
plain_again <- function(plan, changed) {
  for (steps in changed) {
    name <- steps[1]
    group <- plan[[name]]
    part <- steps[2]
    if (length(steps) > 1L && is.list(group) && part %in% names(group)) {
      group[part] <- list(plain_tree(group[[part]], 2, join(name, part)))
    } else {
      group <- plain_tree(group, 1, name)
    }
    if (name %in% names(plan)) plan[name] <- list(group)
  }
  plan
}
