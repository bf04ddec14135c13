# Where a page of the flume tank begins: all gears that codend ships, a new one, a plan of one's
# own.

flume_gallery <- function() {
  tags <- shiny::tags
  tags$main(
    id = "gallery", `aria-labelledby` = "gallery_heading", hidden = NA,
    tags$h2(id = "gallery_heading", "Begin with a gear"),
    tags$div(id = "gallery_refused", class = "alert alert-danger", role = "alert", hidden = NA),
    tags$div(class = "cards", lapply(gallery_gears(), gear_card)),
    tags$div(
      class = "beginnings",
      tags$section(
        class = "panel", `aria-labelledby` = "new_heading",
        tags$h2(id = "new_heading", "A new gear from a few numbers"), new_gear_form()
      ),
      tags$section(
        class = "panel", `aria-labelledby` = "own_heading",
        tags$h2(id = "own_heading", "A plan of your own"), open_plan_field()
      )
    )
  )
}

# list(name, title, kind, size, about) of every shipped gear.
gallery_gears <- remembered(read_gallery)

read_gallery <- function(version = 1) {
  table <- gears()
  lapply(seq_len(nrow(table)), function(k) {
    gear <- read_gear(table$name[k])
    list(
      name = table$name[k], title = table$title[k], kind = gsub("_", " ", table$kind[k]),
      size = gear_size_words(gear)
    )
  })
}

# How large a gear is, as far as its plan says: "19 panels, 2 otter boards, 100 floats".
gear_size_words <- function(gear) {
  si <- gear_si(gear)
  panels <- length(si$panels)
  ropes <- length(si$ropes)
  count <- function(n, word) if (n > 0) sprintf("%d %s%s", n, word, if (n > 1) "s" else "")
  speed <- si$towing$speed
  paste(c(
    count(panels, "panel"), count(ropes, "rope"),
    if (is.numeric(speed) && speed > 0) paste(shown_speed(speed), "knot")
  ), collapse = ", ")
}

shown_speed <- function(speed) {
  shortest_decimal(round(in_unit(speed, "knot"), 1))
}

gear_card <- function(gear) {
  tags <- shiny::tags
  tags$button(
    type = "button", class = "card gear-card", `data-gear` = gear$name,
    tags$img(src = paste0("codend-app/gears/", gear$name, ".jpg"), alt = "", loading = "lazy",
      width = "320", height = "200"),
    tags$span(class = "card-title", gear$title),
    tags$span(class = "note", paste0(gear$kind, if (nzchar(gear$size)) paste0(": ", gear$size)))
  )
}

# A field for each number that new_plan() asks for, by kind.
new_gear_form <- function() {
  tags <- shiny::tags
  kinds <- new_plan_kinds()
  numbers <- function(kind) {
    asks <- kinds[[kind]]$asks
    tags$fieldset(
      class = "new-numbers", `data-kind` = kind, hidden = if (kind != names(kinds)[1]) NA,
      tags$legend(class = "visually-hidden", gsub("_", " ", kind)),
      if (!length(asks)) tags$p(class = "note", "Begins as the shipped one, to be changed."),
      Map(function(name, value) {
        tags$label(
          capital(gsub("[._]", " ", name)),
          tags$input(type = "text", class = "form-control form-control-sm", value = value,
            `data-ask` = name, autocomplete = "off")
        )
      }, names(asks), unname(asks))
    )
  }
  tags$div(
    id = "new_gear",
    tags$label(
      "Kind",
      tags$select(
        id = "new_kind", class = "form-select form-select-sm",
        lapply(names(kinds), function(kind) tags$option(value = kind, gsub("_", " ", kind)))
      )
    ),
    lapply(names(kinds), numbers),
    tags$p(id = "new_error", class = "field-error", role = "alert", hidden = NA),
    # no button of type submit: Shiny would hold back every input of the page for it
    tags$button(type = "button", id = "make_gear", class = "btn btn-primary btn-sm", "Make it")
  )
}

open_plan_field <- function() {
  tags <- shiny::tags
  tags$div(
    id = "plan_drop",
    # without an id Shiny leaves it alone: the page reads the file and sends what is in it
    tags$label(
      "Open a plan, or designs that were saved here (or drop the file on the page)",
      tags$input(type = "file", class = "form-control plan-file", accept = ".yaml,.yml,.json")
    ),
    tags$p(class = "note", "YAML or JSON, at most 2 MB"),
    tags$p(id = "plan_file_error", class = "field-error", role = "alert", hidden = NA)
  )
}
