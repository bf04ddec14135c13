# Keys of strings used directly, such as `say("keep")`, in the tank's R code and its scripts.
keys_of_r <- function() {
  said <- character()
  walk <- function(x) {
    if (is.call(x)) {
      if (identical(x[[1]], quote(say)) && length(x) > 1L && is.character(x[[2]])) {
        said <<- c(said, x[[2]])
      }
      lapply(as.list(x), walk)
    }
    NULL
  }
  ns <- asNamespace("codend")
  for (name in ls(ns)) if (is.function(ns[[name]])) walk(body(ns[[name]]))
  unique(said)
}

# Strings of the viewer: its own, headings of scales and marks, and roles of ropes.
viewer_words <- function() {
  roles <- unlist(lapply(gears()$name, function(name) {
    lapply(gear_si(read_gear(name))$ropes, `[[`, "role")
  }))
  # roles that are also plan fields use the field's string
  roles <- setdiff(roles, c(NA, sub("^field[.]", "", word_table()$key)))
  headings <- c(
    scale_heading(NULL, "rope"), scale_heading(NULL, "netting"), "Drag of ropes",
    "Drag over area of netting", "Mesh opening over mesh size", "Mesh angle"
  )
  labels <- setdiff(view_symbols$label, sub("_", " ", sub("^field[.]", "", word_table()$key)))
  own <- found_in(web_source("view"), "\\bsay\\(\\s*'([^']+)'")
  unique(c(own, headings, labels, gsub("_", " ", roles)))
}

# Strings of findings: templates, advice, and values of their placeholders.
finding_words <- function() {
  said <- character()
  walk <- function(x) {
    if (!is.call(x)) return()
    if (identical(x[[1]], quote(template)) && is.character(x[[2]])) said <<- c(said, x[[2]])
    for (inner in as.list(x)) if (!missing(inner)) walk(inner)
  }
  ns <- asNamespace("codend")
  for (name in ls(ns)) if (is.function(ns[[name]])) walk(body(ns[[name]]))
  for (check in as.list(finding_checks)) walk(body(check$test))
  said <- c(said, unlist(number_ranges[c("quantity", "low", "high")]),
    unlist(finding_strings[c("text", "advice")]))
  unique(c(one_line(said[nzchar(said)]), "rope", "panel", "seam", "piece", "stalled", "back-winded",
    "fallen over", "{n} knot"))
}

found_in <- function(text, pattern) {
  hits <- regmatches(text, gregexpr(pattern, text, perl = TRUE))[[1]]
  unique(sub(pattern, "\\1", hits, perl = TRUE))
}

# Names that keys with a dot must use, by family.
families <- function() {
  schema <- jsonlite::read_json(system.file("schema", "plan.schema.json", package = "codend"))
  fields <- character()
  walk <- function(node) {
    if (!is.list(node)) return()
    fields <<- c(fields, names(node$properties))
    lapply(node, walk)
  }
  walk(schema)
  asked <- unlist(lapply(new_plan_kinds(), function(kind) names(kind$requests)))
  gears <- c(
    lapply(gears()$name, read_gear), lapply(names(new_plan_kinds()), function(kind) new_plan(kind))
  )
  measures <- c(
    names(standard_measures), unlist(lapply(gears, function(gear) {
      # Measures of gears in a rig have the gear's name before them.
      of_rig <- paste(c("^none", names(gear_checked(gear)$gears)), collapse = "|^")
      sub(paste0("(", of_rig, ")_"), "", names(gear_si(gear)$measures))
    }))
  )
  list(
    language = c("name", "checked_by"), room = names(form_sections), field = unique(c(fields,
      asked)),
    also = unique(fields), usual = names(usual_fields), unit = c("knot", "fathom", "ft", "meshes"),
    measure = unique(sub("[0-9]+", "#", measures)),
    kind = c("assembly", names(new_plan_kinds()), gears()$kind),
    busy = c("uncertainty", "slopes", "drawing", "tow", "target", "save"),
    tow_saves = c(names(tow_saves), paste0(names(tow_saves), ".about")),
    view = viewer_words(), finding = finding_words()
  )
}

test_that("word table contains exactly the strings of the page", {
  named <- families()
  keys <- word_table()$key
  expect_identical(anyDuplicated(keys), 0L)
  code <- web_source("tank")
  said <- c(keys_of_r(), found_in(code, "\\bsay\\('([^']+)'"))
  expect_gt(length(said), 150L)
  of_family <- paste0(names(named), ".")
  expect_identical(setdiff(said, c(keys, of_family)), character())
  # keys with a family are named after existing items
  plain <- !grepl(".", keys, fixed = TRUE)
  quoted <- c(said, found_in(code, "'([a-z_]+)'"))
  # an explanation has the key of its button with _about
  quoted <- c(quoted, paste0(quoted, "_about"))
  expect_identical(setdiff(keys[plain], quoted), character())
  known <- unlist(Map(paste, names(named), named, sep = "."))
  expect_identical(setdiff(keys[!plain], known), character())
})

test_that("every language translates the most visible strings", {
  named <- families()
  keys <- word_table()$key
  of_all <- c("room", "kind", "measure", "usual", "field", "tow_saves", "busy", "view", "finding")
  for (family in of_all) {
    expect_identical(setdiff(paste0(family, ".", named[[family]]), keys), character(),
      label = family)
  }
  expect_identical(unlist(usual_fields), strings_of_language("en")[paste0("usual.",
    names(usual_fields))],
    ignore_attr = TRUE)
})

test_that("translations keep the placeholders of the English strings", {
  table <- word_table()
  places <- function(texts) lapply(texts, function(text) sort(found_in(text, "[{]([a-z]+)[}]")))
  english <- places(table$en)
  for (language in setdiff(word_languages(), "en")) {
    given <- nzchar(table[[language]])
    expect_gt(mean(given), 0.9)
    expect_identical(places(table[[language]][given]), english[given], label = language)
  }
})

test_that("missing translations fall back to English and placeholders are filled", {
  say <- make_translator("fr")
  expect_identical(say("must_be", must = "x"), "Must be x.")
  expect_identical(say("fields_many", n = 3), "3 champs")
  expect_identical(say("field.nothing", otherwise = "nothing"), "nothing")
  expect_error(say("nothing"), "no words")
})

test_that("findings appear in the language of the page", {
  fast <- update(read_gear("poly_noreastern_trawl"), towing.speed = "40 knot",
    sections.body.twine.diameter = "25 mm")
  found <- list_findings(fast, sorted_checks())
  english <- finding_rows(found)
  expect_identical(english, as.data.frame(findings(fast)))
  translate <- translated_finding(make_translator("fr"))
  french <- finding_rows(found, translate)
  for (column in c("check", "location", "value", "field", "rank", "n_similar")) {
    expect_identical(french[[column]], english[[column]])
  }
  expect_identical(french$label[french$check == "towing speed"], "40.00 n\u0153uds")
  said <- finding_sentences(french, translate)
  expect_match(said, "^pi\u00e8ce back_body.*: diam\u00e8tre du fil : 25.00 mm", all = FALSE)
  # the tank shows them among its warnings
  tank <- new_tank(NULL, character(), 200, make_translator("fr"))
  tank$notes <- "a warning"
  tank$worth <- found
  expect_identical(tank$warnings(), c("a warning", said))
})

test_that("page_language() prefers the address, then the browser, then English", {
  expect_identical(page_language("?lang=es", "fr-FR,fr;q=0.9"), "es")
  expect_identical(page_language("?lang=xx", "de;q=0.9, nb-NO;q=0.8, en;q=0.7"), "no")
  expect_identical(page_language("", "en;q=0.2,fr;q=0.8"), "fr")
  for (odd in list(NULL, "", "?lang", "?lang=%ff", "?lang=fr%00")) {
    expect_identical(page_language(odd, NULL), "en")
  }
})

test_that("page uses its language and mark machine translations", {
  begin <- function(language) {
    jsonlite::parse_json(message_json("begin", begin_message(make_translator(language), TRUE,
      TRUE)))$begin
  }
  norwegian <- begin("no")
  expect_identical(norwegian$words$keep, "Behold denne konstruksjonen")
  expect_identical(norwegian$language, "no")
  expect_false(norwegian$checked)
  expect_true(begin("en")$checked)
})

test_that("search finds fields by the words of the trade", {
  found <- page_strings(make_translator("en"))$sought
  fields <- c(breastline = "side_lines", gavel = "side_lines", lastridge = "belly_lines",
    backstrop = "backstrops", setback = "setback", taper = "cutting", chafer = "covers",
    "lisi\u00e8re" = "selvedges", hanefot = "backstrops", cometas = "kites")
  for (word in names(fields)) {
    expect_match(paste0(" ", found[[fields[[word]]]]), paste0(" ", word), fixed = TRUE)
  }
})
