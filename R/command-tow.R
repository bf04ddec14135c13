run_tow <- function(plan, options) {
  gear <- read_changed(plan, options)
  given <- Filter(Negate(is.null), options[c("until", "every")])
  file <- record_file(options$out)
  trajectory <- do.call(tow, c(list(gear, file = file), given, settle_arguments(options)))
  print(trajectory)
  print(summary(trajectory))
  if (!is.null(options$out)) {
    write_towed(trajectory, options$out, if (!is.null(file)) basename(file))
  }
  # an interrupted tow is written, but the command does not succeed
  if (trajectory$end == "interrupted") {
    stop(structure(class = c("interrupt", "condition"), list(message = "", call = NULL)))
  }
}

# Returns the file that records a tow, in a new folder. Returns NULL without a folder or RNetCDF.
record_file <- function(folder) {
  if (is.null(folder)) return(NULL)
  if (!requireNamespace("RNetCDF", quietly = TRUE)) {
    warning("trajectory.nc needs the R package RNetCDF, which is not installed.", call. = FALSE)
    return(NULL)
  }
  dir.create(folder, showWarnings = FALSE, recursive = TRUE)
  file.path(folder, "trajectory.nc")
}

write_towed <- function(trajectory, folder, recorded) {
  dir.create(folder, showWarnings = FALSE, recursive = TRUE)
  tables <- write_tables(trajectory, c("measures", "conditions", "tensions"), folder)
  plot(trajectory, file = file.path(folder, "measures.png"))
  view_3d(trajectory, file = file.path(folder, "view.html"))
  write_output(0L, "Written to ", folder, ": ",
    paste(c(tables, "measures.png", "view.html", recorded), collapse = ", "))
}
