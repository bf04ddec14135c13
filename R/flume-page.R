# The page of the flume tank.

# opens: TRUE if the page starts with a gear instead of the gallery. `say`: translator from
# make_translator(), here and below. shares: TRUE if there is a folder of shared designs.
flume_page <- function(opens = TRUE, say = make_translator(), shares = FALSE) {
  tags <- shiny::tags
  asset <- function(name) paste0("codend-app/", name)
  of_viewer <- function(name) paste0("codend-view/", name)
  bslib::page_fluid(
    theme = bslib::bs_theme(version = 5), title = say("page_title"),
    lang = attr(say, "language"),
    tags$head(
      tags$meta(name = "viewport", content = "width=device-width, initial-scale=1"),
      tags$link(rel = "icon", href = "data:,"),
      tags$link(rel = "stylesheet", href = of_viewer("viewer.css")),
      tags$link(rel = "stylesheet", href = asset("flume.css")),
      tags$script(src = of_viewer("viewer.js")), tags$script(src = asset("tank.js"))
    ),
    tags$a(class = "skip-link", href = "#controls", say("skip")),
    tags$div(
      id = "flume", class = if (opens) "opens",
      flume_header(say), flume_waiting(say), flume_gallery(say, shares),
      tags$main(
        id = "design", class = "flume-grid", hidden = if (!opens) NA,
        flume_tank(say), flume_controls(say), flume_measures(say), flume_tabs(say, shares)
      ),
      tags$div(id = "said", class = "visually-hidden", role = "status", `aria-live` = "polite"),
      tags$script(type = "application/json", id = "catalogue",
        shiny::HTML(catalogue_json())),
      tags$script(type = "application/json", id = "words", shiny::HTML(strings_json(say)))
    )
  )
}

flume_header <- function(say) {
  tags <- shiny::tags
  button <- function(id, words, about) {
    tags$button(type = "button", id = id, class = "btn btn-outline-secondary btn-sm",
      title = about, words)
  }
  units <- function(dimension, label) {
    tags$select(
      class = "form-select form-select-sm preferred", `data-dimension` = dimension,
      `aria-label` = label, lapply(preferred_units[[dimension]], function(unit) {
        tags$option(value = unit, label_of_unit(say, unit))
      })
    )
  }
  tags$header(
    tags$div(tags$h1(id = "gear_name", say("tank_name")), tags$p(id = "gear_conditions",
      class = "note", lang = "en")),
    tags$div(
      class = "header-tools", role = "group", `aria-label` = say("design"),
      button("gears", say("gears"), say("gears_tip")),
      button("undo", say("undo"), say("undo_tip")),
      button("redo", say("redo"), say("redo_tip")),
      tags$span(class = "preferred-units", units("length", say("lengths_in")),
        units("force", say("forces_in")), units("speed", say("speeds_in"))),
      flume_languages(say)
    )
  )
}

# The languages by their native names. A note marks translations that nobody has checked.
flume_languages <- function(say) {
  tags <- shiny::tags
  language <- attr(say, "language")
  table <- word_table()
  tags$span(
    class = "languages",
    tags$select(
      id = "language", class = "form-select form-select-sm preferred-language",
      `aria-label` = say("language"), lapply(word_languages(), function(one) {
        tags$option(value = one, lang = one, selected = if (one == language) NA,
          make_translator(one)("language.name"))
      })
    ),
    if (!nzchar(table[[language]][table$key == "language.checked_by"])) {
      tags$span(id = "machine_made", class = "note", title = say("machine_made"),
        say("machine_short"))
    }
  )
}

# The progress of a request, with a button that cancels it.
flume_waiting <- function(say) {
  tags <- shiny::tags
  tags$div(
    id = "working", class = "working", role = "status", hidden = NA,
    tags$span(id = "working_words", say("settling")), tags$span(id = "working_time"),
    tags$button(type = "button", id = "cancel", class = "btn btn-sm btn-outline-secondary",
      say("cancel"))
  )
}

flume_tank <- function(say) {
  tags <- shiny::tags
  tags$section(
    class = "tank", `aria-label` = say("tank_region"),
    tags$div(
      class = "see", role = "group", `aria-label` = say("seen_region"),
      tags$button(type = "button", id = "see_tank", class = "btn btn-outline-secondary btn-sm",
        `aria-pressed` = "true", say("in_tank")),
      tags$button(type = "button", id = "see_drawing", class = "btn btn-outline-secondary btn-sm",
        `aria-pressed` = "false", say("drawing")),
      tags$span(
        class = "drawing-tools",
        tags$button(type = "button", id = "drawing_in", class = "btn btn-outline-secondary btn-sm",
          `aria-label` = say("zoom_in"), "+"),
        tags$button(type = "button", id = "drawing_out", class = "btn btn-outline-secondary btn-sm",
          `aria-label` = say("zoom_out"), "\u2212"),
        tags$button(type = "button", id = "drawing_all", class = "btn btn-outline-secondary btn-sm",
          say("whole_sheet")),
        tags$span(id = "drawing_said", class = "note", role = "status",
          say("drawing_hint"))
      )
    ),
    tags$div(id = "tank"),
    tags$div(id = "drawing", role = "group", `aria-label` = say("net_drawing"), tabindex = "0")
  )
}

# web/src/tank/form.ts adds the controls, from the data of form_message().
flume_controls <- function(say) {
  tags <- shiny::tags
  tags$section(
    id = "controls", class = "panel controls", `aria-labelledby` = "controls_heading",
    tags$h2(id = "controls_heading", say("design")),
    tags$div(id = "refused", class = "alert alert-danger", role = "alert", hidden = NA),
    tags$div(
      id = "unfinished", class = "alert alert-danger", role = "status", hidden = NA,
      tags$strong(say("unfinished")),
      tags$ul(id = "draft_problems")
    ),
    tags$div(id = "quick"),
    tags$div(
      class = "button-row",
      tags$button(type = "button", id = "keep", class = "btn btn-primary btn-sm",
        say("keep")),
      tags$button(type = "button", id = "back", class = "btn btn-outline-secondary btn-sm",
        say("back"))
    ),
    tags$h2(say("every_field")),
    tags$div(
      class = "find-row",
      tags$input(id = "find_field", type = "search", class = "form-control form-control-sm",
        placeholder = say("find_hint"), `aria-label` = say("find_field"),
        autocomplete = "off")
    ),
    tags$div(id = "form")
  )
}

flume_measures <- function(say) {
  shiny::tags$section(
    class = "panel measures", `aria-label` = say("measures"),
    shiny::tags$div(
      id = "worth", hidden = NA, shiny::tags$h2(say("warnings")), shiny::tags$ul(id = "noted")
    ),
    shiny::tags$div(id = "measures"),
    flume_target_form(say),
    shiny::tags$details(
      id = "measures_more", shiny::tags$summary(say("all_other_measures")),
      shiny::tags$div(id = "other_measures")
    ),
    shiny::checkboxInput("with_intervals", say("how_sure")),
    shiny::tags$p(id = "uncertainty_error", class = "field-error", role = "alert", hidden = NA),
    measures_guide(say),
    flume_more_of(say)
  )
}

# The form for the required value of a measure, hidden until the user clicks a measure.
flume_target_form <- function(say) {
  tags <- shiny::tags
  button <- function(id, class, words) {
    tags$button(type = "button", id = id, class = paste("btn btn-sm", class), words)
  }
  tags$div(
    id = "target_asks", hidden = NA,
    tags$label(tags$span(id = "target_label"), tags$input(id = "target_value", type = "text",
      class = "form-control form-control-sm", autocomplete = "off")),
    tags$label(say("field"), tags$select(id = "target_field",
      class = "form-select form-select-sm")),
    tags$div(class = "button-row",
      button("target_start", "btn-primary", say("target_start")),
      button("target_close", "btn-outline-secondary", say("target_close"))),
    tags$p(id = "target_error", class = "field-error", role = "alert", hidden = NA),
    tags$p(id = "target_said", class = "note", role = "status")
  )
}

# TRUE if codend was installed with its guides.
has_measures_guide <- function() nzchar(system.file("doc", "measures.html", package = "codend"))

measures_guide <- function(say) {
  tags <- shiny::tags
  tags$p(class = "note", if (has_measures_guide()) {
    tags$a(href = "codend-doc/measures.html", target = "_blank", say("what_measures_mean"))
  } else {
    tags$span(say("what_measures_mean"), tags$code("vignette(\"measures\", \"codend\")"))
  })
}

# The effect of a small increase of a field on the measures.
flume_more_of <- function(say) {
  tags <- shiny::tags
  tags$details(
    id = "more_of", tags$summary(say("little_more")),
    tags$div(
      class = "control-row",
      tags$input(id = "more_amount", type = "number", step = "any",
        class = "form-control form-control-sm", `aria-label` = say("how_much_more")),
      tags$span(id = "more_unit"), tags$span(say("more_of")),
      tags$select(id = "more_field", class = "form-select form-select-sm",
        `aria-label` = say("of_which_field"))
    ),
    tags$p(id = "slopes_error", class = "field-error", role = "alert", hidden = NA),
    tags$div(id = "more_does", `aria-live` = "polite"),
    tags$button(type = "button", id = "slopes_all", class = "btn btn-outline-secondary btn-sm",
      say("all_first_fields"))
  )
}

flume_tabs <- function(say, shares) {
  tags <- shiny::tags
  tab <- function(value, title, ...) shiny::tabPanel(title, value = value, ...)
  plane <- function(name, words) {
    tags$figure(
      tags$figcaption(words),
      tags$canvas(class = "plane", id = paste0("plane_", name), role = "img", `aria-label` = words)
    )
  }
  tags$section(
    class = "panel more", `aria-label` = say("more_region"),
    shiny::tabsetPanel(
      id = "shown",
      tab("Planes", say("tab_planes"), tags$div(class = "planes", plane("xy", say("from_above")),
        plane("xz", say("from_port")), plane("yz", say("from_astern")))),
      tab("Tensions", say("tab_tensions"), shiny::uiOutput("tensions")),
      tab("Drag", say("tab_drag"), shiny::uiOutput("drag")),
      tab("Slopes", say("tab_slopes"), sensitivities_tab(say)),
      tab("Vary", say("tab_vary"), flume_vary_tab(say)),
      tab("Tow", say("tab_tow"), flume_tow_tab(say)),
      tab("Designs", say("tab_designs"), tags$div(id = "kept_designs"), shiny::uiOutput("designs"),
        if (shares) shared_form(say)),
      tab("Changes", say("tab_changes"), shiny::uiOutput("differences")),
      tab("Plan", say("tab_plan"), flume_plan_editor(say)),
      tab("R code", say("tab_code"), shiny::tags$p(say("code_settles")),
        tags$div(tabindex = "0", role = "region", `aria-label` = say("tab_code"),
          shiny::verbatimTextOutput("code")),
        shiny::downloadButton("save_code", say("save_code"), class = "btn-sm")),
      tab("Save", say("tab_save"), flume_downloads(say))
    )
  )
}

sensitivities_tab <- function(say) {
  tags <- shiny::tags
  tags$div(
    tags$p(class = "note", say("slopes_note")),
    tags$button(type = "button", id = "slopes_table", class = "btn btn-primary btn-sm",
      say("find_slopes")),
    shiny::uiOutput("slopes")
  )
}

flume_vary_tab <- function(say) {
  tags <- shiny::tags
  text <- function(id, label, ...) {
    tags$label(label, tags$input(id = id, class = "form-control form-control-sm",
      autocomplete = "off", ...))
  }
  tags$div(
    tags$p(class = "note", say("vary_note")),
    tags$div(
      id = "vary_asks",
      tags$label(say("field"), tags$select(id = "vary_field",
        class = "form-select form-select-sm")),
      text("vary_from", say("from"), type = "text"), text("vary_to", say("to"), type = "text"),
      text("vary_number", say("values"), type = "number", value = 11, min = 2, max = most_varied)
    ),
    tags$div(
      class = "button-row",
      tags$button(type = "button", id = "vary_start", class = "btn btn-primary btn-sm",
        say("draw_graphs")),
      tags$button(type = "button", id = "vary_stop", class = "btn btn-outline-secondary btn-sm",
        hidden = NA, say("stop"))
    ),
    tags$p(id = "vary_error", class = "field-error", role = "alert", hidden = NA),
    tags$div(
      id = "varied", hidden = NA,
      tags$p(id = "vary_said", class = "note", role = "status"),
      tags$p(id = "vary_stale", class = "note", hidden = NA),
      tags$div(id = "vary_graphs", class = "graphs"),
      tags$label(say("another_graph"), tags$select(id = "vary_more",
        class = "form-select form-select-sm")),
      tags$ul(class = "downloads", save_line("save_vary", say("save_vary"),
        say("save_vary_about")))
    )
  )
}

flume_tow_tab <- function(say) {
  tags <- shiny::tags
  text <- function(id, label, value, about = NULL) {
    tags$label(label, tags$input(type = "text", id = id, class = "form-control form-control-sm",
      value = value, autocomplete = "off", placeholder = about))
  }
  change <- function(name, label, about, from, over) {
    tags$div(
      class = "tow-change", text(paste0("tow_", name), label, "", about),
      text(paste0("tow_", name, "_from"), say("change_from"), from),
      text(paste0("tow_", name, "_over"), say("change_over"), over)
    )
  }
  tags$div(
    tags$p(class = "note", say("tow_note")),
    tags$div(
      id = "tow_asks", text("tow_until", say("tow_for"), "60 s"),
      change("speed", say("speed_becomes"), say("such_as", example = "5 knot"), "10 s", "20 s"),
      change("course", say("turn_by"), say("such_as", example = "90 deg"), "10 s", "60 s"),
      change("warp_out", say("warp_paid"), say("such_as_two", example = "50 m", other = "-50 m"),
        "10 s", "60 s")
    ),
    tags$div(
      class = "button-row",
      tags$button(type = "button", id = "tow_start", class = "btn btn-primary btn-sm", say("tow")),
      tags$button(type = "button", id = "tow_planned", class = "btn btn-outline-secondary btn-sm",
        hidden = NA, say("tow_planned"))
    ),
    tags$p(id = "tow_error", class = "field-error", role = "alert", hidden = NA),
    tags$div(
      id = "towed", hidden = NA, tags$p(id = "tow_stale", class = "note", hidden = NA),
      tags$div(id = "tow_place"), tags$div(id = "tow_graphs", class = "graphs"),
      tags$label(say("another_graph"), tags$select(id = "tow_more",
        class = "form-select form-select-sm")),
      tags$ul(
        class = "downloads",
        lapply(names(tow_saves_here()), function(name) {
          key <- paste0("tow_saves.", name)
          save_line(paste0("save_tow_", name), say(key), say(paste0(key, ".about")))
        })
      )
    )
  )
}

save_line <- function(id, text, about) {
  shiny::tags$li(
    shiny::downloadButton(id, text, class = "btn-sm"), shiny::tags$span(class = "note", about)
  )
}

flume_plan_editor <- function(say) {
  tags <- shiny::tags
  tags$div(
    tags$label(`for` = "plan_area", say("plan_on_screen")),
    tags$textarea(id = "plan_area", class = "form-control plan-text", rows = "24",
      spellcheck = "false", wrap = "off", `aria-describedby` = "plan_text_error"),
    tags$p(id = "plan_text_error", class = "field-error", role = "alert", hidden = NA),
    tags$button(type = "button", id = "plan_text_settle", class = "btn btn-primary btn-sm",
      say("settle_plan"))
  )
}

flume_downloads <- function(say) {
  tags <- shiny::tags
  tags$ul(
    class = "downloads",
    save_line("save_report", say("save_report"), say("save_report_about")),
    if (can_share()) save_line("save_share", say("save_share"), say("save_share_about")),
    save_line("save_plan", say("save_plan"), say("save_plan_about")),
    tags$li(
      tags$button(type = "button", id = "save_picture", class = "btn btn-outline-secondary btn-sm",
        say("save_picture")),
      tags$span(class = "note", say("save_picture_about"))
    ),
    save_line("save_drawing_svg", say("save_drawing_svg"), say("save_drawing_svg_about")),
    save_line("save_drawing_pdf", say("save_drawing_pdf"), say("save_drawing_pdf_about")),
    save_line("save_drawing_dxf", say("save_drawing_dxf"), say("save_drawing_dxf_about")),
    save_line("save_slopes", say("save_slopes"), say("save_slopes_about")),
    save_line("save_all", say("save_all"), say("save_all_about")),
    save_line("save_designs", say("save_designs"), say("save_designs_about")),
    save_line("save_measures", say("save_measures"), say("save_measures_about")),
    save_line("save_drag", say("save_drag"), say("save_drag_about")),
    lapply(formats_of("state"), function(format) {
      package <- format$package
      if (!is.null(package) && !requireNamespace(package, quietly = TRUE)) return(NULL)
      save_line(paste0("save_", format$name), sprintf("%s (%s)", format$title, format$extension),
        say("for_program", program = format$opens))
    })
  )
}
