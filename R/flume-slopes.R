# What a little more of a field would do to the measures of the design on screen: the clerk finds
# the slopes, a field at a time or those that people change first.

# The slopes of a state by the fields of one control, which change together; said: their paths, or
# NULL for those that people change first.
slopes_asked <- function(state, said) {
  said <- unlist(said)
  if (is.null(said)) return(sensitivities(state))
  if (!is.character(said) || length(said) > most_edits || any(nchar(said) > most_characters)) {
    abort_argument("A field is asked for by its path.")
  }
  sensitivities(state, to = list(unname(said)))
}

# Slopes found later, joined to those that there are; a field counts once.
with_slopes <- function(known, found) {
  if (is.null(known)) return(found)
  rbind(known[!known$field %in% found$field, ], found)
}

# The words of a field of sensitivities().
slope_words <- function(field, say) {
  vapply(strsplit(field, " + ", fixed = TRUE), function(paths) said_path(say, paths[1L]), "",
    USE.NAMES = FALSE)
}

# With input$with_intervals the clerk finds how far the measures of the design on screen may be from
# the truth, once it has come to rest.
flume_intervals <- function(input, tank, ask_clerk) {
  shiny::observe({
    tank$changed()
    if (!isTRUE(input$with_intervals) || is.null(tank$gear) || !is.null(tank$uncertainty)) return()
    serial <- tank$serial
    ask_clerk("uncertainty", NULL, function(found) {
      if (tank$serial != serial) return()
      tank$uncertainty <- found
      tank$count_uncertainty()
    })
  })
}

# What the page is told: of every field its paths, value, unit, how much more of it to begin with,
# and of every measure how much one unit more of the field adds to it, in preferred units.
slopes_message <- function(slopes, preferred, say = new_say()) {
  lapply(unique(slopes$field), function(field) {
    rows <- slopes[slopes$field == field & is.finite(slopes$slope), ]
    unit <- slope_measure_units(rows)
    told <- lapply(unit, function(one) preferred_number(1, one, preferred))
    factor <- vapply(told, `[[`, 0, "value")
    value <- rows$value[1L]
    whole <- grepl("[.]number$", field)
    list(
      paths = I(strsplit(field, " + ", fixed = TRUE)[[1L]]), words = slope_words(field, say),
      value = value, unit = rows$unit[1L],
      more = if (whole) max(1, round_step(abs(value) / 4)) else round_step(abs(value) / 20),
      measures = I(said_measure(say, words_of(rows$measure, unit))),
      units = I(said_unit(say, vapply(told, `[[`, "", "unit"))),
      slope = I(rows$slope * factor), below = I(rows$secant_below * factor),
      above = I(rows$secant_above * factor), smooth = I(rows$smooth)
    )
  })
}

# The units of the measures of rows of sensitivities().
slope_measure_units <- function(rows) sub(" per [^ ]*$", "", rows$slope_unit)

# All slopes beside each other: percent of a measure for a tenth more of a field.
slopes_html <- function(slopes, say = new_say()) {
  if (is.null(slopes)) return(NULL)
  fields <- unique(slopes$field)
  measures <- unique(slopes$measure)
  # of every field a row for each measure
  by_field <- lapply(fields, function(field) {
    rows <- slopes[slopes$field == field, ]
    rows[match(measures, rows$measure), ]
  })
  columns <- lapply(by_field, function(rows) {
    small <- !is.na(rows$elasticity) & abs(rows$elasticity) < 0.1
    text <- signed(10 * rows$elasticity, ifelse(small, 2L, 1L))
    paste0(text, ifelse(nzchar(text) & text != "0" & !rows$smooth, " *", ""))
  })
  unit <- slope_measure_units(by_field[[1L]])
  words <- said_measure(say, words_of(measures, unit))
  table <- do.call(data.frame, c(list(words), columns, stringsAsFactors = FALSE))
  # what no field moves is left out
  told <- Reduce(`|`, lapply(columns, function(column) nzchar(column) & column != "0"))
  shiny::tagList(
    html_table(say("slopes_caption"), c(say("measure"), slope_words(fields, say)),
      text_rows(table[told, ])),
    shiny::tags$p(class = "note", say("slopes_star"))
  )
}

# Answers a page that asks for slopes: input$slopes_wanted = list(paths) of one control, or without
# any for those that people change first.
flume_slopes <- function(input, output, session, tank, ask_clerk, said, say) {
  show <- function() {
    said("flume_slopes", fields = slopes_message(tank$slopes, tank$preferred, say))
    tank$count_slopes()
  }
  shiny::observeEvent(input$slopes_wanted, {
    if (is.null(tank$gear)) return()
    serial <- tank$serial
    paths <- as.list(input$slopes_wanted)$paths
    ask_clerk("slopes", paths, function(found) {
      if (tank$serial != serial) return()
      tank$slopes <- with_slopes(tank$slopes, found)
      show()
    })
  })
  shiny::observeEvent(input$preferred, if (!is.null(tank$slopes)) show())
  output$slopes <- shiny::renderUI({
    tank$slopes_changed()
    tank$changed()
    slopes_html(tank$slopes, say)
  })
}
