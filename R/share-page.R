# The page that share() writes: its text as HTML, all other data deflated.

# A tow has fewer stored times than given if the page would exceed this size [bytes].
shared_bytes <- 1e6

packed_text <- function(text) deflated(charToRaw(enc2utf8(text)))

scene_json <- function(scene) {
  escape_json(as.character(jsonlite::toJSON(scene, auto_unbox = TRUE, digits = NA, null = "null")))
}

# Returns the data that the page unpacks, each from deflated().
shared_parts <- function(state, model, tow) {
  wasm <- gzfile(system.file("share", "engine.wasm.gz", package = "codend", mustWork = TRUE), "rb")
  on.exit(close(wasm))
  parts <- list(
    viewer = packed_text(view_file("viewer.js")),
    worker = packed_text(paste(view_file("engine.js", "share"), view_file("worker.js", "share"),
      sep = "\n;\n")),
    wasm = deflated(readBin(wasm, "raw", 1e8)),
    scene = packed_text(scene_json(state_scene(state))),
    model = packed_text(scene_json(model[setdiff(names(model), "body")])), arrays = model$body,
    drawing = packed_text(drawing_svg(state$gear, "A3"))
  )
  if (is.null(tow)) return(parts)
  left <- shared_bytes - 3e4 - sum(nchar(parts))
  c(parts, list(tow = packed_text(scene_json(motion_scene(tow, bytes = max(left, 1e5))))))
}

write_shared_page <- function(file, state, model, parts) {
  body <- with_plain_numbers(as.character(shared_body(state, model, !is.null(parts$tow))))
  # the page loads nothing from a server, even if the plan contains HTML
  policy <- paste0("<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; ",
    "script-src 'unsafe-inline' 'wasm-unsafe-eval' 'unsafe-eval' blob:; worker-src blob:; ",
    "style-src 'unsafe-inline'; img-src data: blob:\"/>")
  packed <- paste0("<script type=\"application/json\" id=\"packed\">",
    jsonlite::toJSON(parts, auto_unbox = TRUE), "</script>")
  write_html(
    file, state$gear$plan$name,
    c(inline_style(view_file("viewer.css")), inline_style(view_file("page.css", "share"))),
    c(body, packed, inline_script(view_file("page.js", "share"))), policy
  )
}

shared_body <- function(state, model, moves) {
  notes <- unlist(state$gear$plan$notes)
  sources <- state$gear$plan$sources
  found <- findings_by(state, {
    checks <- sorted_checks()
    checks[names(checks) != "flutter"]
  })
  htmltools::tagList(
    tag$a(class = "skip", href = "#sliders", "Skip to the sliders"),
    tag$header(
      tag$h1(state$gear$plan$name),
      tag$p(id = "conditions", state_conditions(state))
    ),
    tag$main(
      tag$section(class = "picture", `aria-label` = "The gear in three dimensions",
        tag$div(id = "tank"),
        if (moves) tag$button(type = "button", id = "tow", `aria-pressed` = "false",
          "Play the tow")),
      tag$section(class = "sliders", `aria-labelledby` = "sliders-heading",
        tag$h2(id = "sliders-heading", "Change the gear"),
        tag$div(id = "sliders"),
        tag$button(type = "button", id = "reset", disabled = NA, "Back to the gear as shared"),
        tag$p(id = "told", role = "status", `aria-live` = "polite", "The engine starts.")),
      tag$section(class = "measured", `aria-labelledby` = "measures-heading",
        tag$h2(id = "measures-heading", "Measures"),
        tag$ul(id = "warnings", `aria-live` = "polite", hidden = NA),
        tag$table(
          tag$thead(tag$tr(lapply(c("Measure", "Now", "Computed to", "Change"), tag$th,
            scope = "col"))),
          tag$tbody(id = "measures"))),
      tag$section(class = "more", `aria-label` = "More of the gear",
        if (nrow(found)) tag$details(open = NA,
          tag$summary("Warnings, for the gear as shared"),
          tag$ul(lapply(finding_sentences(found), tag$li))),
        tag$details(id = "drawing", tag$summary("Plan drawing"),
          tag$div(class = "drawing", tabindex = "0", role = "region",
            `aria-label` = "Plan drawing")),
        if (length(notes)) tag$details(tag$summary("Notes"), lapply(notes, tag$p)),
        if (length(sources)) tag$details(tag$summary("Sources"), tag$dl(
          lapply(names(sources), function(of) {
            list(tag$dt(of), lapply(unlist(sources[[of]]), tag$dd))
          }))),
        tag$details(tag$summary("Definitions of these measures"), tag$dl(
          lapply(unname(model$programs), function(one) {
            list(tag$dt(one$words), tag$dd(one$definition))
          }))),
        tag$details(tag$summary("This page"),
          tag$p(sprintf("Made by codend %s, %s. The engine settles a model of %s nodes in this
            page. The page works without a network and sends no data.",
            utils::packageVersion("codend"), format(Sys.Date()), big_number(model$nodes))),
          if (length(model$left_out)) tag$p("Fields without a slider: ",
            paste(names(model$left_out), collapse = ", "), "."),
          tag$pre(tabindex = "0", `aria-label` = "The plan", format(state$gear))))
    ),
    tag$noscript("This page needs scripts to settle the gear; this browser does not run them.")
  )
}
