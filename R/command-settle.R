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
  print(summary(state, uncertainty = how_sure), n = Inf)
  for (name in if (!is.null(how_sure)) main_rows(how_sure, NULL)) {
    cat("", bold(paste0(name, ": largest sources")), source_lines(how_sure, name),
      next_measurement_lines(how_sure, name), sep = "\n")
  }
}

# Returns the interval and the standard uncertainties of every measure for JSON.
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
  write_output(0L, "Written to ", folder, ": ",
    paste(c(tables, pictures, "view.html"), collapse = ", "))
}

# Returns the JSON record of a state: convergence, size of the model, measures and findings.
state_record <- function(state) {
  model <- state$mesh$model
  found <- measures(state)
  list(
    converged = state$report$converged, iterations = state$report$iterations,
    residual = state$report$residual,
    nodes = model$nodes, bars = length(model$bars$rest),
    cells = length(model$cells$rest),
    cpu_seconds = state$report$cpu_seconds,
    measures = as.list(found), errors = as.list(attr(found, "error")),
    main_error = main_error(found),
    findings = row_records(findings(state))
  )
}

# Returns a list for each row, for a JSON array of objects.
row_records <- function(table) lapply(seq_len(nrow(table)), function(k) as.list(table[k, ]))
