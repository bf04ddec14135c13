# Nets as tables: one row per piece of the field `net`.

# Fields of a piece by column of a table; other columns are named after their field.
piece_columns <- c(
  pair = "pair", mesh_size = "mesh_size", mesh = "mesh_size", twine = "twine.diameter",
  material = "twine.material", double = "twine.double", rtex = "twine.rtex",
  front = "meshes.front", rear = "meshes.rear", deep = "meshes.deep", cutting = "cutting",
  left = "cutting.left", right = "cutting.right", inner = "cutting.inner",
  outer = "cutting.outer", flying = "flying", joined = "joined"
)

#' Read a net from a table
#'
#' Reads the field `net` of a trawl from a table with one row per piece of netting. [write_gear()]
#' writes such a table to a file whose name ends in `.csv`.
#'
#' The table has the columns `panel` (upper, lower, side, ...), `row` (name of the piece) and any of
#' these columns, each for a field of a piece:
#' `r toString(sprintf("\\code{%s} (\\code{%s})", names(piece_columns), piece_columns))`.
#'
#' Other columns are named after their field, such as `orientation` or `covers.chafer.mesh_size`.
#' A header may contain a unit for its column: `mesh_size (mm)` or `mesh_size_mm`. Empty cells leave
#' a field out; an empty cell in `panel` repeats the panel above. Spaces in `row` become
#' underscores. The rows of a panel run from front to rear.
#'
#' @param x Path of a file, text with several lines as copied from a spreadsheet, or a data frame.
#'   Columns are separated by commas, semicolons or tabs.
#' @return The value of the field `net`, for [update()][update.codend_gear] or [gear()].
#' @seealso [assembly()] for the field `net` of a short form with wings and sections,
#'   [plot()][plot.codend_gear] for the drawing.
#' @export
#' @examples
#' trawl <- read_gear(system.file("extdata", "two_seam_trawl.yaml", package = "codend"))
#' file <- tempfile(fileext = ".csv")
#' write_gear(trawl, file)
#' net <- read_net(file)
#' update(trawl, net = net)
read_net <- function(x) {
  check_given("x")
  table <- net_table(x)
  missing <- setdiff(c("panel", "row"), names(table))
  if (length(missing)) {
    abort_argument("{.arg x} has no column {.val {missing[1L]}}; it has {.val {names(table)}}.")
  }
  # Spreadsheets may name the panel in its first row only, and pieces with spaces.
  for (k in seq_len(nrow(table))[-1L]) {
    if (!nzchar(table$panel[k])) table$panel[k] <- table$panel[k - 1L]
  }
  table$panel <- tolower(table$panel)
  table$row <- gsub("[^A-Za-z0-9_-]+", "_", table$row)
  net <- list()
  for (k in seq_len(nrow(table))) {
    values <- table[k, setdiff(names(table), c("panel", "row")), drop = FALSE]
    piece <- list()
    for (column in names(values)[nzchar(unlist(values))]) {
      steps <- strsplit(column, ".", fixed = TRUE)[[1L]]
      piece <- put_in(piece, steps, cell_value(values[[column]]))
    }
    place <- c(table$panel[k], table$row[k])
    if (place[2L] %in% names(net[[place[1L]]])) {
      abort_argument(
        "{.arg x} has two rows of the panel {.val {place[1L]}} named {.val {place[2L]}}."
      )
    }
    if (is.null(net[[place[1L]]])) net[[place[1L]]] <- list()
    net[[place[1L]]][place[2L]] <- list(if (length(piece)) piece else nothing)
  }
  net
}

# Returns a plan whose field `net` names a table with the net of this table. The path is relative to
# the folder of the plan `file`.
with_net_file <- function(tree, file) {
  if (!is_text(tree$net)) return(tree)
  absolute <- grepl("^(/|~|[A-Za-z]:)", tree$net)
  path <- if (absolute) tree$net else file.path(dirname(file), tree$net)
  if (!file.exists(path)) {
    abort_field("net", tree$net, sprintf(
      "a table in the folder of the plan, %s, or the pieces of the net", dirname(file)
    ), is = sprintf("is \"%s\", a file that does not exist", tree$net))
  }
  tree$net <- tryCatch(read_net(path), codend_error_argument = function(e) {
    abort_plan(sprintf("Plan field `net`, \"%s\": %s", tree$net,
      sub("^`x`", "The table", conditionMessage(e))), "net", tree$net)
  })
  tree
}

#' Write the plan of a gear
#'
#' Writes a plan file that [read_gear()] reads back as an identical plan. If the gear was read from
#' a file, remarks and layout remain, and only fields changed with [update()][update.codend_gear]
#' are rewritten. The file is written atomically.
#'
#' @param gear A gear of class `codend_gear` ([read_gear()], [gear()]).
#' @param file Character: path of the file to write. A name ending in `.json` gives JSON, and one
#'   ending in `.csv` the net as a table for [read_net()]. Any other name gives YAML.
#' @return `file`, invisibly (character).
#' @seealso [read_gear()] to read the file, [update()][update.codend_gear] to change a gear,
#'   [new_plan()] to start a plan.
#' @export
#' @examples
#' file <- tempfile(fileext = ".yaml")
#' write_gear(read_gear("towed_cable"), file)
#' cat(readLines(file), sep = "\n")
write_gear <- function(gear, file) {
  check_given("gear", "file")
  check_is_gear(gear)
  check_file_path(file)
  if (grepl("[.]csv$", file, ignore.case = TRUE)) {
    write_net(gear, file)
    return(invisible(file))
  }
  json <- grepl("[.]json$", file, ignore.case = TRUE)
  write_text(if (json) c(json_plan(gear), "") else format(gear, remarks = TRUE), file)
}

# Writes the net of a gear as a table.
write_net <- function(gear, file) {
  net <- gear$plan$net
  if (is.null(net)) {
    abort_argument("{.arg gear} has no field {.field net}; convert it with
      {.code assembly(gear, only = \"net\")}.")
  }
  rows <- list()
  for (panel in names(net)) {
    for (row in names(net[[panel]])) {
      leaves <- plan_leaves(net[[panel]][[row]])
      leaves <- lapply(leaves, `[`, nzchar(leaves$path))
      values <- vapply(leaves$value, function(value) {
        if (is.logical(value)) c("no", "yes")[value + 1L] else as.character(value)
      }, "")
      names(values) <- leaves$path
      rows <- c(rows, list(c(panel = panel, row = row, values)))
    }
  }
  columns <- unique(unlist(lapply(rows, names)))
  known <- match(columns, c("panel", "row", piece_columns))
  columns <- columns[order(known)]
  table <- as.data.frame(do.call(rbind, lapply(rows, function(row) unname(row[columns]))))
  short <- match(columns, piece_columns)
  names(table) <- ifelse(is.na(short), columns, names(piece_columns)[short])
  write_csv(table, file)
}

# Returns a table of strings with the fields of pieces as names of its columns, from a file, text or
# a data frame. Quantities in columns with a unit get this unit.
net_table <- function(x) {
  if (!is.data.frame(x)) {
    if (!is_text(x)) abort_argument("{.arg x} must be a file, text or a data frame.")
    lines <- if (grepl("\n", x, fixed = TRUE)) strsplit(x, "\r?\n")[[1L]] else {
      if (!file.exists(x)) abort_argument("{.file {x}} does not exist.")
      readLines(x, warn = FALSE, encoding = "UTF-8")
    }
    lines <- lines[nzchar(trimws(lines))]
    separators <- c("\t", ";", ",")
    fields <- strsplit(rep(lines[1L], 3L), separators, fixed = TRUE)
    x <- utils::read.table(text = lines, sep = separators[which.max(lengths(fields))],
      header = TRUE, colClasses = "character", check.names = FALSE, quote = "\"", fill = TRUE,
      comment.char = "", strip.white = TRUE)
  }
  x[] <- lapply(x, function(column) {
    column <- trimws(if (is.numeric(column)) vapply(column, shortest_decimal, "") else column)
    ifelse(is.na(column) | column == "NA", "", column)
  })
  header <- gsub("[ \u00a0]+", "_", sub("^\ufeff", "", tolower(trimws(names(x)))))
  pattern <- "^(.*?)_*(?:[(\\[]([^)\\]]*)[)\\]]|_(mm|cm|m|tex))$"
  unit <- sub(pattern, "\\2\\3", header, perl = TRUE)
  unit[!grepl(pattern, header, perl = TRUE)] <- ""
  header <- sub(pattern, "\\1", header, perl = TRUE)
  for (k in which(nzchar(unit) & unit != "tex")) {
    bare <- grepl("^[0-9.,]+$", x[[k]])
    x[[k]][bare] <- paste(sub(",", ".", x[[k]][bare], fixed = TRUE), unit[k])
  }
  fields <- piece_columns[header]
  names(x) <- ifelse(is.na(fields), header, fields)
  x
}

# Returns a cell of a table as a value of a plan.
cell_value <- function(text) {
  if (tolower(text) %in% c("yes", "true")) return(TRUE)
  if (tolower(text) %in% c("no", "false")) return(FALSE)
  number <- suppressWarnings(as.double(sub(",", ".", text, fixed = TRUE)))
  if (is.na(number)) text else number
}
