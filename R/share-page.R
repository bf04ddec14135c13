# The page that share() writes: the page of the flume tank, with the engine as its server.

# A tow has fewer stored times than given if the page would exceed this size [bytes].
shared_bytes <- 1e6

packed_text <- function(text) deflated(charToRaw(enc2utf8(text)))

scene_json <- function(scene) {
  escape_json(as.character(jsonlite::toJSON(scene, auto_unbox = TRUE, digits = NA, null = "null")))
}

# Returns the data that the page unpacks, each from deflated().
shared_parts <- function(state, model, tow) {
  wasm <- system.file("share", "engine.wasm.gz", package = "codend", mustWork = TRUE)
  scene <- state_scene(state)
  parts <- list(
    viewer = packed_text(view_file("viewer.js")), tank = packed_text(view_file("tank.js", "app")),
    worker = packed_text(paste(view_file("engine.js", "share"), view_file("worker.js", "share"),
      sep = "\n;\n")),
    wasm = jsonlite::base64_enc(readBin(wasm, "raw", file.size(wasm))),
    scene = packed_text(scene_json(scene)),
    model = packed_text(scene_json(model[setdiff(names(model), "body")])), arrays = model$body,
    page = packed_text(scene_json(shared_page(state, model, scene))),
    drawing = packed_text(drawing_svg(state$gear, "A3"))
  )
  if (is.null(tow)) return(parts)
  left <- shared_bytes - 3e4 - sum(nchar(parts))
  c(parts, list(tow = packed_text(scene_json(motion_scene(tow, bytes = max(left, 1e5))))))
}

write_shared_page <- function(file, state, parts) {
  # the page loads nothing from a server, even if the plan contains HTML
  policy <- paste0("<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; ",
    "script-src 'unsafe-inline' 'wasm-unsafe-eval' 'unsafe-eval' blob:; worker-src blob:; ",
    "style-src 'unsafe-inline'; img-src data: blob:\"/>")
  packed <- paste0("<script type=\"application/json\" id=\"packed\">",
    jsonlite::toJSON(parts, auto_unbox = TRUE), "</script>")
  write_html(
    file, state$gear$plan$name,
    inline_style(view_file("tank.css", "app")),
    c("<noscript>This page needs scripts to settle the gear.</noscript>", packed,
      inline_script(view_file("page.js", "share"))), policy
  )
}

# Returns the data of the page's first messages and answers (web/src/share/page.ts).
shared_page <- function(state, model, scene) {
  gear <- state$gear
  found <- measures(state)
  checks <- sorted_checks()
  checks <- checks[names(checks) != "flutter"]
  parts <- unique(c(scene$parts$name, scene$marks$part))
  words <- page_strings(make_translator("en"))
  # the page shows measures by their English labels
  words$words <- words$words[!startsWith(names(words$words), "measure.")]
  about <- sprintf("Made by codend %s, %s. The engine settles a model of %s nodes in this page.
    The page works without a network and sends no data.", utils::packageVersion("codend"),
    format(Sys.Date()), big_number(state$mesh$nodes))
  list(
    begin = c(words, list(language = "en", units = offered_units(), preferred = preferred_units,
      about = about)),
    form = shared_form(gear, model$fields), measures = measures_about(found),
    numbers = measures_numbers(found), notes = I(finding_sentences(findings_by(state, checks))),
    parts = lapply(stats::setNames(nm = parts), clicked_field, gear = gear), plan = format(gear)
  )
}
