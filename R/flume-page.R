# The flume tank's page.

flume_page <- function() {
  tags <- shiny::tags
  asset <- function(name) paste0("codend-app/", name)
  of_viewer <- function(name) paste0("codend-view/", name)
  bslib::page_fluid(
    theme = bslib::bs_theme(version = 5), title = "codend flume tank", lang = "en",
    tags$head(
      tags$meta(name = "viewport", content = "width=device-width, initial-scale=1"),
      tags$link(rel = "icon", href = "data:,"),
      tags$link(rel = "stylesheet", href = of_viewer("viewer.css")),
      tags$link(rel = "stylesheet", href = asset("flume.css")),
      lapply(c("three.js", "materials.js", "gear.js", "motion.js", "viewer.js"), function(name) {
        tags$script(src = of_viewer(name))
      }),
      tags$script(src = asset("tank.js")),
      tags$script(src = asset("controls.js"))
    ),
    tags$a(class = "skip-link", href = "#controls", "Skip to the controls"),
    tags$div(
      id = "flume",
      tags$header(
        tags$h1(id = "gear_name", "Flume tank"), tags$p(id = "gear_conditions", class = "note")
      ),
      tags$main(
        class = "flume-grid", flume_tank(), flume_controls(), flume_measures(), flume_tabs()
      ),
      tags$div(id = "said", class = "visually-hidden", role = "status", `aria-live` = "polite")
    )
  )
}

flume_tank <- function() {
  tags <- shiny::tags
  tags$section(
    class = "tank", `aria-label` = "The gear in three dimensions",
    tags$div(id = "tank"),
    tags$div(id = "working", class = "working", hidden = NA, "settling")
  )
}

flume_controls <- function() {
  tags <- shiny::tags
  tags$section(
    id = "controls", class = "panel controls", `aria-labelledby` = "controls_heading",
    tags$h2(id = "controls_heading", "Design"),
    tags$div(id = "refused", class = "alert alert-danger", role = "alert", hidden = NA),
    tags$div(id = "noted", class = "alert alert-warning", role = "status", hidden = NA),
    shiny::uiOutput("controls"),
    tags$div(
      class = "button-row",
      shiny::actionButton("pin", "Pin this design", class = "btn-primary btn-sm"),
      shiny::actionButton("reset", "Back to pinned", class = "btn-outline-secondary btn-sm")
    ),
    tags$details(
      tags$summary("Another field of the plan"),
      shiny::uiOutput("markable")
    ),
    tags$div(
      id = "plan_drop",
      # without an id Shiny leaves it alone: the page reads the file and sends what is in it
      tags$label(
        "Open a plan (or drop its file on the page)",
        tags$input(type = "file", class = "form-control plan-file", accept = ".yaml,.yml")
      ),
      tags$p(class = "note", "YAML, at most 2 MB"),
      tags$p(id = "plan_file_error", class = "field-error", role = "alert", hidden = NA)
    )
  )
}

flume_measures <- function() {
  shiny::tags$section(
    class = "panel measures", `aria-label` = "Measures", shiny::uiOutput("measures")
  )
}

flume_tabs <- function() {
  tags <- shiny::tags
  tab <- function(title, ...) shiny::tabPanel(title, value = title, ...)
  plane <- function(name, words) {
    tags$figure(
      tags$figcaption(words),
      tags$canvas(class = "plane", id = paste0("plane_", name), role = "img", `aria-label` = words)
    )
  }
  tags$section(
    class = "panel more", `aria-label` = "More of the gear",
    shiny::tabsetPanel(
      id = "shown",
      tab("Planes", tags$div(class = "planes", plane("xy", "From above (XY)"),
        plane("xz", "From the port side (XZ)"), plane("yz", "From astern (YZ)"))),
      tab("Tensions", shiny::uiOutput("tensions")),
      tab("Drag", shiny::uiOutput("drag")),
      tab("Changes", shiny::uiOutput("differences")),
      tab("Plan", flume_plan_editor()),
      tab("R code", shiny::tags$p("This settles the same gear again:"),
        tags$div(tabindex = "0", role = "region", `aria-label` = "R code",
          shiny::verbatimTextOutput("code")),
        shiny::downloadButton("save_code", "Save as R file", class = "btn-sm")),
      tab("Save", flume_downloads())
    )
  )
}

flume_plan_editor <- function() {
  tags <- shiny::tags
  tags$div(
    tags$label(`for` = "plan_text", "The plan of the gear on screen, to change and settle"),
    tags$textarea(id = "plan_text", class = "form-control plan-text", rows = "24",
      spellcheck = "false", wrap = "off", `aria-describedby` = "plan_text_error"),
    tags$p(id = "plan_text_error", class = "field-error", role = "alert", hidden = NA),
    tags$button(type = "button", id = "plan_text_settle", class = "btn btn-primary btn-sm",
      "Settle this plan")
  )
}

flume_downloads <- function() {
  tags <- shiny::tags
  save <- function(id, text, about) {
    tags$li(shiny::downloadButton(id, text, class = "btn-sm"), tags$span(class = "note", about))
  }
  tags$ul(
    class = "downloads",
    save("save_report", "Report (HTML)", "one page with everything, to send on or to print"),
    save("save_plan", "Plan (YAML)", "opens here again, and in codend on any machine"),
    save("save_measures", "Measures (CSV)", "with the pinned design's and the change"),
    save("save_drag", "Drag (CSV)", "by rope, panel and piece"),
    lapply(formats_of("state"), function(format) {
      package <- format$package
      if (!is.null(package) && !requireNamespace(package, quietly = TRUE)) return(NULL)
      save(paste0("save_", format$name), sprintf("%s (%s)", format$title, format$extension),
        paste("for", format$opens))
    })
  )
}

# The controls of a gear, with the values that it has.
controls_html <- function(controls) {
  if (!length(controls)) {
    return(shiny::tags$p("This gear has none of the usual fields; mark one of its own below."))
  }
  shiny::tagList(lapply(unname(controls), function(control) {
    switch(control$kind,
      number = number_html(control), choice = choice_html(control), truth = truth_html(control)
    )
  }))
}

control_frame <- function(control, ...) {
  tags <- shiny::tags
  id <- control$id
  tags$div(
    class = "control", `data-control` = id, `data-kind` = control$kind,
    `data-paths` = paste(control$paths, collapse = " "),
    ...,
    tags$p(id = paste0(id, "_error"), class = "field-error", hidden = NA)
  )
}

number_html <- function(control) {
  tags <- shiny::tags
  id <- control$id
  number <- paste0(id, "_number")
  shown <- shortest_decimal(control$value)
  units <- if (length(control$units)) {
    tags$select(
      class = "form-select form-select-sm unit", `aria-label` = paste("Unit of", control$label),
      Map(function(unit, factor) {
        tags$option(value = unit, `data-factor` = format(factor, digits = 15),
          selected = if (unit == control$unit) NA, unit)
      }, names(control$units), control$units)
    )
  }
  control_frame(
    control,
    tags$label(`for` = number, title = control$help, control$label),
    tags$div(
      class = "control-row",
      tags$input(
        type = "range", class = "form-range", min = shortest_decimal(control$low),
        max = shortest_decimal(control$high), step = shortest_decimal(control$step), value = shown,
        `aria-label` = control$label, `aria-valuetext` = trimws(paste(shown, control$unit))
      ),
      tags$input(
        type = "number", id = number, class = "form-control form-control-sm",
        step = if (control$whole) "1" else "any", value = shown, inputmode = "decimal",
        `aria-describedby` = paste0(id, "_error")
      ),
      units
    )
  )
}

choice_html <- function(control) {
  tags <- shiny::tags
  id <- paste0(control$id, "_choice")
  control_frame(
    control, tags$label(`for` = id, title = control$help, control$label),
    tags$select(
      id = id, class = "form-select form-select-sm choice",
      `aria-describedby` = paste0(control$id, "_error"),
      lapply(control$choices, function(choice) {
        tags$option(value = choice, selected = if (choice == control$value) NA,
          gsub("_", " ", choice))
      })
    )
  )
}

truth_html <- function(control) {
  tags <- shiny::tags
  id <- paste0(control$id, "_truth")
  control_frame(
    control,
    tags$div(
      class = "form-check",
      tags$input(type = "checkbox", id = id, class = "form-check-input truth",
        checked = if (control$value) NA, `aria-describedby` = paste0(control$id, "_error")),
      tags$label(`for` = id, class = "form-check-label", title = control$help, control$label)
    )
  )
}

# A field of the plan to choose, of those that have no control yet.
markable_html <- function(plan, controls) {
  tags <- shiny::tags
  shown <- unlist(lapply(controls, `[[`, "paths"))
  paths <- setdiff(markable_fields(plan), shown)
  shiny::tagList(
    tags$label(`for` = "mark_path", "Path of the field"),
    tags$div(
      class = "control-row",
      tags$input(id = "mark_path", class = "form-control form-control-sm", list = "mark_paths",
        autocomplete = "off", spellcheck = "false", `aria-describedby` = "mark_error"),
      tags$datalist(id = "mark_paths", lapply(paths, function(path) tags$option(value = path))),
      tags$button(type = "button", id = "mark", class = "btn btn-outline-secondary btn-sm",
        "Add control")
    ),
    tags$p(id = "mark_error", class = "field-error", hidden = NA)
  )
}
