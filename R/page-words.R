# Translations of the flume tank's page, from inst/app/words.csv: a row for each key and a column
# for each language. Missing translations are English.
#
# Keys with a point belong to a family: `language`, `room` (group of the form), `field` (of a plan),
# `usual` (fields that users change first), `kind` (of gear) and `unit`. The families `busy` and
# `tow_saves` have progress messages and downloads of a tow. The family `also` has other trade names
# of fields. Keys of `measure` are kinds of measures, with # for a number. Keys of the families
# `view` (web/src/view) and `finding` (R/finding-*.R) are English strings, because these are also
# used without the tank.

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

# Returns the strings of a language by key, in English if there is no translation.
strings_of_language <- function(language) {
  table <- word_table()
  table <- table[!startsWith(table$key, "also."), ]
  words <- table[[language]]
  stats::setNames(ifelse(nzchar(words), words, table$en), table$key)
}

# Returns a translator: `say(key, ...)` is the string of a key with values for placeholders such as
# {n}. An unknown key gives `otherwise`, or an error without it.
make_translator <- remembered(function(language = "en") {
  words <- strings_of_language(language)
  structure(
    function(key, ..., otherwise = NULL) {
      text <- if (key %in% names(words)) words[[key]] else otherwise
      if (is.null(text)) stop("codend's tank has no words for ", key)
      fill_places(text, list(...))
    },
    language = language
  )
})

# Returns the language in the address (?lang=fr), otherwise the available language that the browser
# prefers, otherwise English. query, accept: as a browser sends them, or NULL.
page_language <- function(query, accept) {
  asked <- regmatches(query, regexpr("(?<=[?&]lang=)[-_A-Za-z]+(?=&|$)", query, perl = TRUE))
  liked <- strsplit(substr(first_of(accept, ""), 1L, 200L), ",", fixed = TRUE)[[1L]]
  share <- suppressWarnings(as.double(sub(".*;q=", "", liked)))
  share[is.na(share)] <- 1
  wanted <- c(asked, sub(";.*", "", trimws(liked))[order(-share)])
  wanted <- tolower(sub("[-_].*", "", wanted[grepl("^[-_A-Za-z]+$", wanted, useBytes = TRUE)]))
  wanted <- sub("^n[bn]$", "no", wanted)
  found <- intersect(wanted, word_languages())
  if (length(found)) found[1L] else "en"
}

# Returns a translator of findings for fill_template().
translated_finding <- function(say) function(text) say(paste0("finding.", text), otherwise = text)

# Returns list(words, sought): the strings of the language by key, and all names of each field in
# all languages, for searches.
page_strings <- function(say) {
  table <- word_table()
  family <- sub("[.].*", "", table$key)
  of_field <- family %in% c("field", "also")
  every <- do.call(paste, table[of_field, word_languages()])
  field <- sub("^[a-z]*[.]", "", table$key[of_field])
  sought <- vapply(split(every, field), paste, "", collapse = " ")
  words <- strings_of_language(attr(say, "language"))
  list(words = as.list(words[!startsWith(names(words), "finding.")]), sought = as.list(sought))
}
