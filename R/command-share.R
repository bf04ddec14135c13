run_share <- function(plan, options) {
  file <- plan[2L]
  check_place(file, NULL, ".html")
  asked <- slider_options(options$slider)
  check_can_share()
  gear <- read_changed(plan[1L], options)
  options$nodes <- requested_nodes(gear, options$nodes)
  state <- do.call(settle, c(list(gear), settle_arguments(options)))
  share(state, file, asked$sliders, asked$ranges)
  write_output(0L, "Written: ", file)
}

# Converts values of --slider to list(sliders, ranges); `ranges` is NULL if there are no ranges.
slider_options <- function(given) {
  if (is.null(given)) return(list())
  texts <- trimws(given)
  name <- trimws(sub("=.*", "", texts))
  with_range <- grepl("=", texts)
  ranges <- lapply(strsplit(sub("^[^=]*=", "", texts[with_range]), ","), trimws)
  wrong <- which(lengths(ranges) != 2L)
  if (length(wrong) || !all(nzchar(name))) {
    abort_usage("--slider is ", c(texts[with_range][wrong], texts)[1L],
      "; it must be FIELD or FIELD=LOW, HIGH.")
  }
  ranges <- lapply(ranges, function(ends) lapply(ends, plan_value))
  list(sliders = name, ranges = if (any(with_range)) setNames(ranges, name[with_range]))
}
