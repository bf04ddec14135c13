# The gear with a field of its plan times a factor, in the plan's unit.
scaled <- function(gear, field, factor) {
  value <- Reduce(`[[`, strsplit(field, ".", fixed = TRUE)[[1]], gear$plan)
  text <- paste(as.numeric(sub(" .*", "", value)) * factor, sub("^[^ ]* ", "", value))
  do.call(update, c(list(gear), stats::setNames(list(text), field)))
}
