# The flume tank's page.

# opens: whether a gear is on screen at once, not the gallery.
flume_page <- function(opens = TRUE) {
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
      lapply(viewer_scripts, function(name) tags$script(src = of_viewer(name))),
      lapply(flume_scripts, function(name) tags$script(src = asset(name)))
    ),
    tags$a(class = "skip-link", href = "#controls", "Skip to the controls"),
    tags$div(
      id = "flume", class = if (opens) "opens",
      flume_header(), flume_waiting(), flume_gallery(),
      tags$main(
        id = "design", class = "flume-grid", hidden = if (!opens) NA,
        flume_tank(), flume_controls(), flume_measures(), flume_tabs()
      ),
      tags$div(id = "said", class = "visually-hidden", role = "status", `aria-live` = "polite"),
      tags$script(type = "application/json", id = "catalogue",
        shiny::HTML(catalogue_json()))
    )
  )
}

# The page's scripts, in the order in which they are read: the viewer's, as
# inst/htmlwidgets/codend.yaml has them, then its own.
viewer_scripts <- c(
  "three.js", "element.js", "materials.js", "gear.js", "graph.js", "motion.js", "viewer.js"
)
flume_scripts <- c(
  "talk.js", "tank.js", "form.js", "files.js", "designs.js", "drawing.js", "gallery.js",
  "slopes.js", "graphs.js", "vary.js", "tow.js", "page.js"
)

flume_header <- function() {
  tags <- shiny::tags
  button <- function(id, words, about) {
    tags$button(type = "button", id = id, class = "btn btn-outline-secondary btn-sm",
      title = about, words)
  }
  units <- function(dimension, label) {
    tags$select(
      class = "form-select form-select-sm preferred", `data-dimension` = dimension,
      `aria-label` = label, lapply(preferred_units[[dimension]], function(unit) {
        tags$option(value = unit, unit)
      })
    )
  }
  tags$header(
    tags$div(tags$h1(id = "gear_name", "Flume tank"), tags$p(id = "gear_conditions",
      class = "note")),
    tags$div(
      class = "header-tools", role = "group", `aria-label` = "Design",
      button("gears", "Gears", "All gears, a new one, or a plan of your own"),
      button("undo", "Undo", "The design before (Ctrl+Z)"),
      button("redo", "Redo", "The design after (Ctrl+Y)"),
      tags$span(class = "preferred-units", units("length", "Lengths in"),
        units("force", "Forces in"), units("speed", "Speeds in"))
    )
  )
}

# What is waited for, with a way out.
flume_waiting <- function() {
  tags <- shiny::tags
  tags$div(
    id = "working", class = "working", role = "status", hidden = NA,
    tags$span(id = "working_words", "settling"), tags$span(id = "working_time"),
    tags$button(type = "button", id = "cancel", class = "btn btn-sm btn-outline-secondary",
      "Cancel")
  )
}

flume_tank <- function() {
  tags <- shiny::tags
  tags$section(
    class = "tank", `aria-label` = "The gear in three dimensions",
    tags$div(
      class = "see", role = "group", `aria-label` = "What is seen",
      tags$button(type = "button", id = "see_tank", class = "btn btn-outline-secondary btn-sm",
        `aria-pressed` = "true", "In the tank"),
      tags$button(type = "button", id = "see_drawing", class = "btn btn-outline-secondary btn-sm",
        `aria-pressed` = "false", "Drawing"),
      tags$span(
        class = "drawing-tools",
        tags$button(type = "button", id = "drawing_in", class = "btn btn-outline-secondary btn-sm",
          `aria-label` = "Zoom in", "+"),
        tags$button(type = "button", id = "drawing_out", class = "btn btn-outline-secondary btn-sm",
          `aria-label` = "Zoom out", "\u2212"),
        tags$button(type = "button", id = "drawing_all", class = "btn btn-outline-secondary btn-sm",
          "Whole sheet"),
        tags$span(id = "drawing_said", class = "note", role = "status",
          "Click a number and type. Tab goes to the next.")
      )
    ),
    tags$div(id = "tank"),
    tags$div(id = "drawing", role = "group", `aria-label` = "The net drawing", tabindex = "0")
  )
}

# The controls themselves are laid out by form.js, from what R/flume-form.R makes of the schema.
flume_controls <- function() {
  tags <- shiny::tags
  tags$section(
    id = "controls", class = "panel controls", `aria-labelledby` = "controls_heading",
    tags$h2(id = "controls_heading", "Design"),
    tags$div(id = "refused", class = "alert alert-danger", role = "alert", hidden = NA),
    tags$div(
      id = "unfinished", class = "alert alert-danger", role = "status", hidden = NA,
      tags$strong("This design does not fit yet. The tank shows the last one that did."),
      tags$ul(id = "draft_problems")
    ),
    tags$div(id = "quick"),
    tags$div(
      class = "button-row",
      tags$button(type = "button", id = "keep", class = "btn btn-primary btn-sm",
        "Keep this design"),
      tags$button(type = "button", id = "back", class = "btn btn-outline-secondary btn-sm",
        "Back to the kept one")
    ),
    tags$h2("Every field of the plan"),
    tags$div(
      class = "find-row",
      tags$input(id = "find_field", type = "search", class = "form-control form-control-sm",
        placeholder = "Find a field, such as twine", `aria-label` = "Find a field",
        autocomplete = "off")
    ),
    tags$div(id = "form")
  )
}

flume_measures <- function() {
  shiny::tags$section(
    class = "panel measures", `aria-label` = "Measures",
    shiny::tags$div(
      id = "worth", hidden = NA, shiny::tags$h2("Warnings"), shiny::tags$ul(id = "noted")
    ),
    shiny::uiOutput("measures"),
    shiny::tags$details(
      id = "measures_more", shiny::tags$summary("All other measures"),
      shiny::uiOutput("other_measures")
    ),
    shiny::checkboxInput("with_intervals", "How sure: intervals of 90 %"),
    shiny::tags$p(id = "uncertainty_error", class = "field-error", role = "alert", hidden = NA),
    measures_guide(),
    flume_more_of()
  )
}

# Whether codend was installed with its guides.
has_measures_guide <- function() nzchar(system.file("doc", "measures.html", package = "codend"))

measures_guide <- function() {
  tags <- shiny::tags
  tags$p(class = "note", if (has_measures_guide()) {
    tags$a(href = "codend-doc/measures.html", target = "_blank", "What the measures mean")
  } else {
    tags$span("What the measures mean: ", tags$code("vignette(\"measures\", \"codend\")"))
  })
}

# What a little more of a field would do, beside the measures.
flume_more_of <- function() {
  tags <- shiny::tags
  tags$details(
    id = "more_of", tags$summary("What a little more would do"),
    tags$div(
      class = "control-row",
      tags$input(id = "more_amount", type = "number", step = "any",
        class = "form-control form-control-sm", `aria-label` = "How much more"),
      tags$span(id = "more_unit"), tags$span("more of"),
      tags$select(id = "more_field", class = "form-select form-select-sm",
        `aria-label` = "Of which field")
    ),
    tags$p(id = "slopes_error", class = "field-error", role = "alert", hidden = NA),
    tags$div(id = "more_does", `aria-live` = "polite"),
    tags$button(type = "button", id = "slopes_all", class = "btn btn-outline-secondary btn-sm",
      "All fields that people change first")
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
      tab("Slopes", flume_slopes_tab()),
      tab("Vary", flume_vary_tab()),
      tab("Tow", flume_tow_tab()),
      tab("Designs", tags$div(id = "kept_designs"), shiny::uiOutput("designs")),
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

flume_slopes_tab <- function() {
  tags <- shiny::tags
  tags$div(
    tags$p(class = "note", "How every measure changes with the fields that people change first, and
      those that were asked for beside the measures, at the design on screen."),
    tags$button(type = "button", id = "slopes_table", class = "btn btn-primary btn-sm",
      "Find the slopes"),
    shiny::uiOutput("slopes")
  )
}

# Measures against a field, as graphs.
flume_vary_tab <- function() {
  tags <- shiny::tags
  text <- function(id, label, ...) {
    tags$label(label, tags$input(id = id, class = "form-control form-control-sm",
      autocomplete = "off", ...))
  }
  tags$div(
    tags$p(class = "note", "Settles the design on screen with other values of one field, in the
      background, and draws each measure against it."),
    tags$div(
      id = "vary_asks",
      tags$label("Field", tags$select(id = "vary_field", class = "form-select form-select-sm")),
      text("vary_from", "From", type = "text"), text("vary_to", "To", type = "text"),
      text("vary_number", "Values", type = "number", value = 11, min = 2, max = most_varied)
    ),
    tags$div(
      class = "button-row",
      tags$button(type = "button", id = "vary_start", class = "btn btn-primary btn-sm",
        "Draw the graphs"),
      tags$button(type = "button", id = "vary_stop", class = "btn btn-outline-secondary btn-sm",
        hidden = NA, "Stop")
    ),
    tags$p(id = "vary_error", class = "field-error", role = "alert", hidden = NA),
    tags$div(
      id = "varied", hidden = NA,
      tags$p(id = "vary_said", class = "note", role = "status"),
      tags$p(id = "vary_stale", class = "note", hidden = NA),
      tags$div(id = "vary_graphs", class = "graphs"),
      tags$label("Another graph", tags$select(id = "vary_more",
        class = "form-select form-select-sm")),
      tags$ul(class = "downloads", save_line("save_vary", "Graphs (CSV)",
        "all measures at every value, as vary() gives them"))
    )
  )
}

# A tow from the design on screen, its picture and its graphs.
flume_tow_tab <- function() {
  tags <- shiny::tags
  text <- function(id, label, value, about = NULL) {
    tags$label(label, tags$input(type = "text", id = id, class = "form-control form-control-sm",
      value = value, autocomplete = "off", placeholder = about))
  }
  change <- function(name, label, about, from, over) {
    tags$div(
      class = "tow-change", text(paste0("tow_", name), label, "", about),
      text(paste0("tow_", name, "_from"), "from", from),
      text(paste0("tow_", name, "_over"), "over", over)
    )
  }
  tags$div(
    tags$p(class = "note", "From the design on screen, at rest in its tow. What is left empty stays
      as it is."),
    tags$div(
      id = "tow_asks", text("tow_until", "Tow for", "60 s"),
      change("speed", "Speed becomes", "such as 5 knot", "10 s", "20 s"),
      change("course", "Turn to starboard by", "such as 90 deg", "10 s", "60 s"),
      change("warp_out", "Warp paid out", "such as 50 m, or -50 m", "10 s", "60 s")
    ),
    tags$div(
      class = "button-row",
      tags$button(type = "button", id = "tow_start", class = "btn btn-primary btn-sm", "Tow"),
      tags$button(type = "button", id = "tow_planned", class = "btn btn-outline-secondary btn-sm",
        hidden = NA, "Tow as the plan's section tow says")
    ),
    tags$p(id = "tow_error", class = "field-error", role = "alert", hidden = NA),
    tags$div(
      id = "towed", hidden = NA, tags$p(id = "tow_stale", class = "note", hidden = NA),
      tags$div(id = "tow_place"), tags$div(id = "tow_graphs", class = "graphs"),
      tags$label("Another graph", tags$select(id = "tow_more",
        class = "form-select form-select-sm")),
      tags$ul(
        class = "downloads",
        unname(Map(function(name, one) {
          save_line(paste0("save_tow_", name), sprintf("%s (.%s)", one$title, one$extension),
            one$about)
        }, names(tow_saves_here()), tow_saves_here()))
      )
    )
  )
}

# A thing that can be saved.
save_line <- function(id, text, about) {
  shiny::tags$li(
    shiny::downloadButton(id, text, class = "btn-sm"), shiny::tags$span(class = "note", about)
  )
}

flume_plan_editor <- function() {
  tags <- shiny::tags
  tags$div(
    tags$label(`for` = "plan_area", "The plan of the gear on screen, to change and settle"),
    tags$textarea(id = "plan_area", class = "form-control plan-text", rows = "24",
      spellcheck = "false", wrap = "off", `aria-describedby` = "plan_text_error"),
    tags$p(id = "plan_text_error", class = "field-error", role = "alert", hidden = NA),
    tags$button(type = "button", id = "plan_text_settle", class = "btn btn-primary btn-sm",
      "Settle this plan")
  )
}

flume_downloads <- function() {
  tags <- shiny::tags
  save <- save_line
  tags$ul(
    class = "downloads",
    save("save_report", "Report (HTML)", "one page with everything, to send on or to print"),
    if (can_share()) {
      save("save_share", "Living page (HTML)",
        "settles by itself as its sliders move, for anyone with a browser")
    },
    save("save_plan", "Plan (YAML)", "opens here again, and in codend on any machine"),
    tags$li(
      tags$button(type = "button", id = "save_picture", class = "btn btn-outline-secondary btn-sm",
        "Picture (PNG)"),
      tags$span(class = "note", "the gear in three dimensions, as it is looked at now")
    ),
    save("save_drawing_svg", "Drawing (SVG)", "the net drawing, to print or to send on"),
    save("save_drawing_pdf", "Drawing (PDF)", "to print"),
    save("save_drawing_dxf", "Drawing (DXF)", "for CAD and cutting"),
    save("save_slopes", "Slopes (CSV)", "what more of each field does to each measure"),
    save("save_all", "All designs (JSON)", "that on screen and those kept; opens here again"),
    save("save_designs", "Designs (CSV)", "measures of all designs beside each other"),
    save("save_measures", "Measures (CSV)", "with the kept design's and the change"),
    save("save_drag", "Drag (CSV)", "by rope, panel and piece"),
    lapply(formats_of("state"), function(format) {
      package <- format$package
      if (!is.null(package) && !requireNamespace(package, quietly = TRUE)) return(NULL)
      save(paste0("save_", format$name), sprintf("%s (%s)", format$title, format$extension),
        paste("for", format$opens))
    })
  )
}
