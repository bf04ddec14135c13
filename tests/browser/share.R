# Pages that share() writes, and what R has after the same moves, for share.test.js:
#   Rscript share.R FOLDER MOVES GEAR...
# Writes FOLDER/GEAR.html and FOLDER/GEAR.json: of every move the sliders' values, R's measures and
# the share of the largest tension that R's balance leaves.
library(codend)
ns <- asNamespace("codend")
arguments <- commandArgs(TRUE)
folder <- arguments[1]
moves <- as.integer(arguments[2])
# balances closer than the comparison; stiff gears come as close as rounding lets them
assignInNamespace("settle_tolerance", 1e-11, "codend")
set.seed(38)
for (name in arguments[-(1:2)]) {
  gear <- read_gear(name)
  if (name == "towed_cable") {
    gear <- update(gear, name = paste0("Cable </script><script>window.hurt = 1</script>",
      "<img src=x onerror='hurt=1'>"))
  }
  state <- suppressWarnings(settle(gear, nodes = 600))
  file <- file.path(folder, paste0(name, ".html"))
  tow <- if (name == "towed_cable") tow(state, until = "20 s", every = "2 s")
  share(state, file, tow = tow)
  series <- ns$slider_series(state, ns$slider_fields(gear, NULL, NULL),
    ns$shared_measures(state)$standard)
  fields <- series$fields
  values <- ns$own_values(fields)
  log <- lapply(seq_len(moves), function(k) {
    at <- sample(length(fields), 1L)
    field <- fields[[at]]
    to <- values[at] + sample(c(-1, 1), 1L) * 0.08 * (field$upper - field$lower)
    to <- min(max(to, field$lower), field$upper)
    before <- values[at]
    values[at] <<- if (field$whole) round(to) else signif(to, 6)
    after <- tryCatch(
      suppressWarnings(settle(ns$set_free(gear, fields, values), from = state)),
      codend_error_plan = function(e) NULL # anchors farther apart than lines reach
    )
    if (is.null(after)) values[at] <<- before else state <<- after
    list(values = I(values), measures = as.list(ns$plain_measures(measures(state)) |>
      setNames(names(measures(state)))), residual = state$report$residual)
  })
  text <- jsonlite::toJSON(log, auto_unbox = TRUE, digits = NA)
  writeLines(text, file.path(folder, paste0(name, ".json")))
}
