# The start page of the flume tank: all shipped gears, a new gear, or the user's own plan.

flume_gallery <- function(say, shares) {
  tags <- shiny::tags
  tags$main(
    id = "gallery", `aria-labelledby` = "gallery_heading", hidden = NA,
    tags$h2(id = "gallery_heading", say("begin")),
    tags$div(id = "gallery_refused", class = "alert alert-danger", role = "alert", hidden = NA),
    tags$div(class = "cards", lapply(gallery_gears(), gear_card, say)),
    tags$div(
      class = "beginnings",
      tags$section(
        class = "panel", `aria-labelledby` = "new_heading",
        tags$h2(id = "new_heading", say("new_heading")), new_gear_form(say)
      ),
      tags$section(
        class = "panel", `aria-labelledby` = "own_heading",
        tags$h2(id = "own_heading", say("own_heading")), open_plan_field(say)
      ),
      if (shares) tags$section(class = "panel", shared_list(say))
    )
  )
}

gallery_gears <- remembered(read_gallery)

read_gallery <- function(version = 1) {
  table <- gears()
  lapply(seq_len(nrow(table)), function(k) {
    gear <- read_gear(table$name[k])
    list(
      name = table$name[k], title = table$title[k], kind = table$kind[k], size = gear_size(gear)
    )
  })
}

# Returns list(panels, ropes, speed [m/s]) from a gear's plan, 0 if not given.
gear_size <- function(gear) {
  si <- gear_si(gear)
  speed <- si$towing$speed
  list(
    panels = length(si$panels), ropes = length(si$ropes),
    speed = if (is.numeric(speed)) speed else 0
  )
}

# Returns a string such as "19 panels, 12 ropes, 4 knot".
gear_size_text <- function(size, say) {
  paste(c(
    if (size$panels == 1) say("panels_one", n = 1),
    if (size$panels > 1) say("panels_many", n = size$panels),
    if (size$ropes == 1) say("ropes_one", n = 1),
    if (size$ropes > 1) say("ropes_many", n = size$ropes),
    if (size$speed > 0) {
      paste(shortest_decimal(round(in_unit(size$speed, "knot"), 1)), label_of_unit(say, "knot"))
    }
  ), collapse = ", ")
}

gear_card <- function(gear, say) {
  tags <- shiny::tags
  size <- gear_size_text(gear$size, say)
  tags$button(
    type = "button", class = "card gear-card", `data-gear` = gear$name,
    tags$img(src = paste0("codend-app/gears/", gear$name, ".webp"), alt = "", loading = "lazy",
      width = "320", height = "200"),
    tags$span(class = "card-title", lang = "en", gear$title),
    tags$span(class = "note", paste0(say(paste0("kind.", gear$kind)),
      if (nzchar(size)) paste0(": ", size)))
  )
}

new_gear_form <- function(say) {
  tags <- shiny::tags
  kinds <- new_plan_kinds()
  numbers <- function(kind) {
    requests <- kinds[[kind]]$requests
    tags$fieldset(
      class = "new-numbers", `data-kind` = kind, hidden = if (kind != names(kinds)[1]) NA,
      tags$legend(class = "visually-hidden", say(paste0("kind.", kind))),
      if (!length(requests)) tags$p(class = "note", say("as_shipped")),
      Map(function(name, value) {
        tags$label(
          capital(label_of_field(say, name)),
          tags$input(type = "text", class = "form-control form-control-sm", value = value,
            `data-ask` = name, autocomplete = "off")
        )
      }, names(requests), unname(requests))
    )
  }
  tags$div(
    id = "new_gear",
    tags$label(
      say("kind"),
      tags$select(
        id = "new_kind", class = "form-select form-select-sm",
        lapply(names(kinds), function(kind) tags$option(value = kind, say(paste0("kind.", kind))))
      )
    ),
    lapply(names(kinds), numbers),
    tags$p(id = "new_error", class = "field-error", role = "alert", hidden = NA),
    # a submit button would make Shiny hold back all inputs of the page
    tags$button(type = "button", id = "make_gear", class = "btn btn-primary btn-sm", say("make_it"))
  )
}

open_plan_field <- function(say) {
  tags <- shiny::tags
  tags$div(
    id = "plan_drop",
    # Shiny ignores a field without an id: the page reads the file and sends its content
    tags$label(
      say("open_plan"),
      tags$input(type = "file", class = "form-control plan-file", accept = ".yaml,.yml,.json")
    ),
    tags$p(class = "note", say("plan_limits")),
    tags$p(id = "plan_file_error", class = "field-error", role = "alert", hidden = NA)
  )
}
