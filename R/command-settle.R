run_settle <- function(plan, options) {
  json <- options$json
  check_place(json, "--json")
  state <- tryCatch(settle_changed(plan, options), codend_error_not_converged = function(e) {
    report <- e$report[c("converged", "iterations", "residual")]
    if (!is.null(json)) {
      write_json(c(codend = "unsettled", report, message = conditionMessage(e)), json)
    }
    stop(e)
  })
  how_sure <- if (options$uncertainty) uncertainty(state)
  if (!identical(json, "-")) print_settled(state, how_sure)
  if (!is.null(json)) write_json(state_json(state, how_sure), json)
  if (!is.null(options$out)) write_settled(state, options$out)
}

print_settled <- function(state, how_sure) {
  print(summary(state, uncertainty = how_sure), n = Inf)
  for (name in if (!is.null(how_sure)) main_rows(how_sure, NULL)) {
    cat("", bold(paste0(name, ": largest sources")), source_lines(how_sure, name),
      next_measurement_lines(how_sure, name), sep = "\n")
  }
}

# record: a list, or JSON text. file: a path, or "-" for standard output.
write_json <- function(record, file) {
  text <- if (is.character(record)) record else {
    jsonlite::toJSON(record, auto_unbox = TRUE, digits = NA, na = "null", pretty = TRUE)
  }
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
