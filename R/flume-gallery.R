# The lists on the start page of the flume tank: shipped gears, and kinds of new gears.

gallery_gears <- remembered(read_gallery)

read_gallery <- function(version = 1) {
  table <- gears()
  lapply(seq_len(nrow(table)), function(k) {
    gear <- read_gear(table$name[k])
    c(list(name = table$name[k], title = table$title[k], kind = table$kind[k]), gear_size(gear))
  })
}

# Returns list(panels, ropes, speed [knot]) from a gear's plan, 0 if not given.
gear_size <- function(gear) {
  si <- gear_si(gear)
  speed <- si$towing$speed
  list(
    panels = length(si$panels), ropes = length(si$ropes),
    speed = if (is.numeric(speed)) round(in_unit(speed, "knot"), 1) else 0
  )
}

# Returns list(name, values) of each kind: defaults of the numbers that a new gear needs.
new_gear_kinds <- function() {
  kinds <- new_plan_kinds()
  lapply(names(kinds), function(name) {
    list(name = name, values = as.list(kinds[[name]]$requests))
  })
}
