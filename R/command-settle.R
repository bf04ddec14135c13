run_settle <- function(plan, options) {
  json <- options$json
  check_place(json, "--json")
  asked <- list(plan = plan, set = setNames(as.list(options$set), names(options$set)))
  write <- function(...) if (!is.null(json)) write_json(c(asked, ...), json)
  state <- tryCatch(settle_changed(plan, options), codend_error_not_converged = function(e) {
    write(e$report[c("converged", "iterations", "residual")])
    stop(e)
  })
  how_sure <- if (options$uncertainty) uncertainty(state)
  if (!identical(json, "-")) print_settled(state, how_sure)
  write(c(state_record(state), uncertainty_record(how_sure)))
  if (!is.null(options$out)) write_settled(state, options$out)
}

print_settled <- function(state, how_sure) {
  print(summary(state, uncertainty = how_sure))
  for (name in if (!is.null(how_sure)) main_rows(how_sure, NULL)) {
    cat("", bold(paste0(name, ": largest sources")), source_lines(how_sure, name),
      narrow_lines(how_sure, name), sep = "\n")
  }
}

# What JSON has of it: the interval and the standard uncertainties of every measure.
uncertainty_record <- function(how_sure) {
  if (is.null(how_sure)) return(NULL)
  table <- how_sure$measures
  table$freedom[!is.finite(table$freedom)] <- NA
  list(uncertainty = setNames(row_records(table[-1L]), table$measure))
}

# file: a path, or "-" for standard output.
write_json <- function(record, file) {
  text <- jsonlite::toJSON(record, auto_unbox = TRUE, digits = NA, na = "null", pretty = TRUE)
  if (file == "-") cat(text, "\n", sep = "") else write_text(c(text, ""), file)
}

write_settled <- function(state, folder) {
  dir.create(folder, showWarnings = FALSE, recursive = TRUE)
  tables <- write_tables(state, c("measures", "tensions"), folder)
  planes <- c("xy", "xz", "yz")
  pictures <- paste0(planes, ".png")
  for (k in 1:3) plot(state, planes = planes[k], file = file.path(folder, pictures[k]))
  view_3d(state, file = file.path(folder, "view.html"))
  tell(0L, "Written to ", folder, ": ",
    paste(c(tables, pictures, "view.html"), collapse = ", "))
}

# What the command line writes as JSON: whether and how the gear settled, the lattice's size, and
# the measures by name, and what is worth a look.
state_record <- function(state) {
  mesh <- state$lattice$mesh
  found <- measures(state)
  list(
    converged = state$report$converged, iterations = state$report$iterations,
    residual = state$report$residual,
    nodes = mesh$nodes, bars = length(mesh$bars$rest),
    cells = length(mesh$cells$rest),
    cpu_seconds = state$report$cpu_seconds,
    measures = as.list(found), errors = as.list(attr(found, "error")),
    main_error = main_error(found),
    findings = row_records(findings(state))
  )
}

# A list for each row of a data frame: a JSON array of objects, empty where there are no rows.
row_records <- function(table) lapply(seq_len(nrow(table)), function(k) as.list(table[k, ]))
