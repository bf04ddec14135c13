# Writes pages of share(), and R's results for the same moves, for share.test.js:
#   Rscript share.R FOLDER GEAR=MOVES...
# Writes FOLDER/GEAR.html and FOLDER/GEAR.json. The JSON has an entry for the shared state and for
# every move. An entry has slider values, R's measures, the residual as a fraction of the largest
# tension, and the drawn points (m) and tensions (N).
library(codend)
ns <- asNamespace("codend")
arguments <- commandArgs(TRUE)
folder <- arguments[1]
moves <- strsplit(arguments[-1], "=")
# The residual must be smaller than the tolerance of the comparison; rounding limits stiff gears.
assignInNamespace("settle_tolerance", 1e-11, "codend")
# the sliders of the page that share() wrote last
slider_series <- ns$slider_series
series <- NULL
assignInNamespace("slider_series", function(...) series <<- slider_series(...), "codend")
set.seed(38)
result <- function(state, values) {
  shape <- ns$scene_shape(state)
  list(
    values = I(values), measures = as.list(setNames(ns$plain_measures(measures(state)),
      names(measures(state)))), residual = state$report$residual,
    drawn = list(points = I(as.vector(shape$points)), rope_tension = I(shape$ropes),
      u = I(as.vector(shape$u)), v = I(as.vector(shape$v)))
  )
}
# Returns a gear; the codend's catch is given by a volume beyond its capacity.
plan_of <- function(name) {
  if (name != "t90_codend_by_volume") return(read_gear(name))
  update(read_gear("t90_codend"), catch.blocked_meshes = NULL, catch.volume = "1.3 m3")
}
for (asked in moves) {
  name <- asked[1]
  gear <- plan_of(name)
  if (name == "towed_cable") {
    gear <- update(gear, name = paste0("Cable </script><script>window.hurt = 1</script>",
      "<img src=x onerror='hurt=1'>"))
  }
  state <- suppressWarnings(settle(gear, nodes = 600))
  file <- file.path(folder, paste0(name, ".html"))
  tow <- if (name == "towed_cable") tow(state, until = "20 s", every = "2 s")
  by_volume <- name == "t90_codend_by_volume"
  share(state, file, tow = tow,
    sliders = if (by_volume) c("catch.volume", "towing.speed"),
    ranges = if (by_volume) list(catch.volume = c("1 m3", "30 m3")))
  fields <- series$fields
  values <- ns$own_values(fields)
  first <- list(result(state, values))
  log <- lapply(seq_len(as.integer(asked[2])), function(k) {
    repeat {
      at <- sample(length(fields), 1L)
      field <- fields[[at]]
      to <- values[at] + sample(c(-1, 1), 1L) * 0.08 * (field$upper - field$lower)
      to <- min(max(to, field$lower), field$upper)
      moved <- replace(values, at, if (field$whole) round(to) else signif(to, 6))
      after <- tryCatch(
        suppressWarnings(settle(ns$set_free(gear, fields, moved), from = state)),
        codend_error_plan = function(e) NULL # anchors farther apart than the lines reach
      )
      if (!is.null(after)) break
    }
    values <<- moved
    state <<- after
    result(state, values)
  })
  text <- jsonlite::toJSON(c(first, log), auto_unbox = TRUE, digits = NA, na = "null")
  writeLines(text, file.path(folder, paste0(name, ".json")))
}
