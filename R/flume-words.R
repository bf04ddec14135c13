# The words of the flume tank's page, in every language that it speaks: inst/app/words.csv, a row
# for each key and a column for each language. What a language lacks is told in English.
#
# Keys with a point belong to a family: language, room (of the form), field (of a plan, by its
# name), usual (of those that people change first), also (what else the trade calls a field),
# measure (by its kind, its number as #), kind (of gear), unit, busy (of what is waited for),
# tow_saves; view (of inst/view) and finding (R/finding-*.R), whose keys are the English texts: they
# are said without a tank too.

word_table <- remembered(function(version = 1) {
  table <- utils::read.csv(
    system.file("app", "words.csv", package = "codend", mustWork = TRUE), encoding = "UTF-8",
    na.strings = character(), check.names = FALSE, colClasses = "character"
  )
  by_text <- grepl("^(view|finding)[.]", table$key)
  table$en[by_text] <- sub("^[a-z]+[.]", "", table$key[by_text])
  table
})

word_languages <- function() setdiff(names(word_table()), c("key", "note"))

# All words of a language by their keys, the others' places taken by the English ones.
words_in <- function(language) {
  table <- word_table()
  table <- table[!startsWith(table$key, "also."), ]
  words <- table[[language]]
  stats::setNames(ifelse(nzchar(words), words, table$en), table$key)
}

# A function that says words in a language: say(key, ...) is the text of a key with the values of
# its places such as {n}; `otherwise` is said where the table has no such key, which is an error
# without it.
new_say <- remembered(function(language = "en") {
  words <- words_in(language)
  structure(
    function(key, ..., otherwise = NULL) {
      text <- if (key %in% names(words)) words[[key]] else otherwise
      if (is.null(text)) stop("codend's tank has no words for ", key)
      fill_places(text, list(...))
    },
    language = language
  )
})

# The language of a page: what its address says (?lang=fr), else what its browser likes best of
# those that there are, else English. query, accept: as a browser sends them, or NULL.
page_language <- function(query, accept) {
  asked <- tryCatch(shiny::parseQueryString(first_of(query, ""))$lang, error = function(e) NULL)
  liked <- strsplit(substr(first_of(accept, ""), 1L, 200L), ",", fixed = TRUE)[[1L]]
  share <- suppressWarnings(as.double(sub(".*;q=", "", liked)))
  share[is.na(share)] <- 1
  wanted <- c(if (is_text(asked)) asked, sub(";.*", "", trimws(liked))[order(-share)])
  wanted <- tolower(sub("[-_].*", "", wanted[grepl("^[-_A-Za-z]+$", wanted, useBytes = TRUE)]))
  wanted <- sub("^n[bn]$", "no", wanted)
  found <- intersect(wanted, word_languages())
  if (length(found)) found[1L] else "en"
}

# ---- words of the trade --------------------------------------------------------------------------

# A field's path, such as "otter_boards.lift_coefficient", in words: "Otter boards: lift
# coefficient".
said_path <- function(say, path) {
  usual <- say(paste0("usual.", path), otherwise = "")
  if (nzchar(usual)) return(usual)
  words <- vapply(strsplit(path, ".", fixed = TRUE)[[1]], function(step) said_field(say, step), "")
  last <- length(words)
  capital(if (last == 1L) words else {
    paste0(paste(words[-last], collapse = " "), ": ", words[last])
  })
}

said_field <- function(say, name) {
  say(paste0("field.", name), otherwise = gsub("_", " ", name, fixed = TRUE))
}

# The label of a field, which is in English.
said_label <- function(say, label, path) {
  if (attr(say, "language") == "en") label else said_path(say, path)
}

# Measures by their words in English, such as "door spread" or "hook 3 depth".
said_measure <- function(say, words) {
  vapply(words, function(word) {
    number <- regmatches(word, regexpr("[0-9]+", word))
    said <- say(paste0("measure.", gsub(" ", "_", sub("[0-9]+", "#", word))), otherwise = word)
    if (length(number)) sub("#", number, said, fixed = TRUE) else said
  }, "", USE.NAMES = FALSE)
}

said_unit <- function(say, unit) {
  vapply(unit, function(one) say(paste0("unit.", one), otherwise = one), "", USE.NAMES = FALSE)
}

# Translates a text of a finding, as told_in() takes it.
said_finding <- function(say) function(text) say(paste0("finding.", text), otherwise = text)

# "door spread (m)"
said_measure_unit <- function(say, words, unit) {
  paste0(said_measure(say, words), " (", said_unit(say, unit), ")")
}

# ---- what the page is given ----------------------------------------------------------------------

# As JSON: the words of its language by key, and of every field of a plan what it is called in all
# languages, for who looks for it.
words_json <- function(say) {
  table <- word_table()
  family <- sub("[.].*", "", table$key)
  of_field <- family %in% c("field", "also")
  every <- do.call(paste, table[of_field, word_languages()])
  field <- sub("^[a-z]*[.]", "", table$key[of_field])
  sought <- vapply(split(every, field), paste, "", collapse = " ")
  words <- words_in(attr(say, "language"))
  words <- words[!startsWith(names(words), "finding.")]
  escape_json(as.character(jsonlite::toJSON(
    list(words = as.list(words), sought = as.list(sought)),
    auto_unbox = TRUE
  )))
}
