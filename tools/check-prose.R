# Fails if the prose of a class of text or of a file exceeds the limits. Also fails if a public
# name, a function or a file has a private word in its name.
#   Rscript tools/check-prose.R               prints a row per class and every failure
#   Rscript tools/check-prose.R --list FILE   prints the sentences of a file that count
# `index` is the number of private expressions per 1,000 words:
#
# - clauses used as nouns
# - chains of pronouns
# - a genitive at the start of a sentence
# - verbs of speech for things
#
# Five well-known R packages have an index of 0 to 6. `over30` is the percentage of sentences with
# more than 30 words. A file may have one match and one long sentence, because the expressions also
# match some good sentences.
limits <- c(index = 6, over30 = 10)

private <- c(
  "(?<!\\w)(?:[Ww]hat|[Ww]hatever|[Ww]ho|[Ww]hoever)\\b(?![^.;:]*\\?)",
  paste0("\\b(?:that|those|one|ones|these|none) of\\b|",
    "\\bof (?:which|what|whose|it|them|these|those|that)\\b(?! (?:is|are) )"),
  "^(?:Of|Those|That of|Anew|From what|As what|By what|With what)\\b",
  paste0("\\b(?:told|tells?|telling|says?|said|asks?|asked|stands?|stood|taken? for|",
    "goes? by|went by|goes? on|going on|went on|held (?:to|against)|holds? to|",
    "looked (?:for|through|at)|",
    "come(?:s)? (?:to lie|near|of)|lets? go|let go|is of|are of|was of)\\b")
)

count_matches <- function(pattern, text) {
  lengths(regmatches(text, gregexpr(pattern, text, perl = TRUE)))
}

replace_all <- function(text, patterns) {
  for (k in seq_along(patterns)) text <- gsub(names(patterns)[k], patterns[[k]], text, perl = TRUE)
  text
}

# Removes markup; names in code become the word NAME.
plain <- function(text) {
  trimws(replace_all(text, c(
    "!?\\[([^\\]]*)\\]\\([^)]*\\)" = "\\1", "`r [^`]*`" = "7", "`[^`]*`" = "NAME",
    "\\\\(?:code|verb)\\{(?:\\\\link(?:\\[[^\\]]*\\])?\\{[^}]*\\}|[^}]*)\\}" = "NAME",
    "\\\\(?:link|emph|strong|pkg|url|href|dQuote|eqn)(?:\\[[^\\]]*\\])?\\{([^}]*)\\}" = "\\1",
    "\\[[\\w.]+\\(\\)\\]" = "NAME", "<https?:[^>]*>|https?:\\S+" = "URL",
    "<!--.*?-->" = "", "\\*\\*|[*_](?=\\w)|(?<=\\w)[*_](?!\\w)|</?\\w+[^>]*>" = "", "\\s+" = " "
  )))
}

# Sentences of at least three words.
sentences <- function(paragraphs) {
  marked <- gsub("(?<=[.!?])(?<!e\\.g\\.|i\\.e\\.|al\\.|cf\\.|vs\\.)\\s+(?=[A-Z(`\"])", "\n",
    plain(paragraphs), perl = TRUE)
  all <- trimws(unlist(strsplit(marked, "\n", fixed = TRUE)))
  all[count_matches("[A-Za-z]{2,}", all) >= 3L]
}

read_text <- function(file) readLines(file, warn = FALSE, encoding = "UTF-8")

# Joins neighbouring lines of text into paragraphs; NA separates them.
paragraphs <- function(lines) {
  group <- cumsum(is.na(lines))
  as.character(tapply(lines[!is.na(lines)], group[!is.na(lines)], paste, collapse = " "))
}

markdown <- function(file) {
  lines <- read_text(file)
  if (lines[1L] == "---") lines <- lines[-seq_len(which(lines == "---")[2L])]
  fence <- grepl("^\\s*(```|~~~)", lines)
  skipped <- fence | cumsum(fence) %% 2L == 1L |
    grepl("^    \\S|^\t|^\\||^#|^<!--|^!\\[|^\\[!\\[|^<img|^<p|^<a|^</|^\\s*$", lines)
  item <- grepl("^\\s*([-*+]|\\d+\\.)\\s", lines)
  text <- ifelse(skipped, NA, trimws(sub("^\\s*([-*+]|\\d+\\.)\\s+", "", lines)))
  paragraphs(unlist(Map(function(line, starts) if (starts) c(NA, line) else line, text, item)))
}

help_text <- function(file) {
  lines <- c(read_text(file), "")
  help <- startsWith(lines, "#'")
  text <- trimws(sub("^#'", "", lines))
  tag <- ifelse(help, sub("^@(\\w+).*|.*", "\\1", text), "end")
  block <- cumsum(tag != "")
  of_prose <- c("param", "return", "details", "description", "title", "section", "note", "")
  prose <- c("", tag[tag != ""])[block + 1L] %in% of_prose
  text <- sub("^@param\\s+\\S+\\s*|^@section.*|^@\\w+\\s*", "", text)
  markup <- "^\\\\(itemize|describe|tabular|end|preformatted|if)|^[}|#]"
  breaks <- !help | !prose | tag != "" | !nzchar(text) |
    grepl("^([-*+]|\\d+\\.)\\s|^\\\\item", text) | grepl(markup, text)
  text <- sub("^([-*+]|\\d+\\.)\\s+|^\\\\item(\\{[^}]*\\}\\{)?", "", text)
  keep <- help & prose & nzchar(text) & !grepl(markup, text)
  line_of <- function(line, kept, new) c(if (new) NA, if (kept) line else NA)
  paragraphs(unlist(Map(line_of, text, keep, breaks)))
}

comments <- function(file, mark) {
  lines <- trimws(read_text(file))
  is_comment <- startsWith(lines, mark) & !startsWith(lines, "#'") & !startsWith(lines, "#!")
  text <- trimws(sub("^[#/!<]+", "", lines))
  found <- paragraphs(ifelse(is_comment & nzchar(text) & !grepl("^[-=*#_/]{3,}", text), text, NA))
  found[!grepl("<-|\\(\\)\\s*\\{|;$|NOLINT|nolint|SPDX|Copyright", found)]
}

# Strings of at least five words in code, without comments.
messages <- function(file) {
  lines <- read_text(file)
  text <- paste(lines[!startsWith(trimws(lines), "#")], collapse = "\n")
  found <- regmatches(text, gregexpr("\"(?:[^\"\\\\]|\\\\.)*\"", text, perl = TRUE))[[1L]]
  found <- substring(found, 2L, nchar(found) - 1L)
  found <- found[lengths(strsplit(found, "\\s+")) >= 5L]
  found <- found[!grepl("[<>{}]{2}|function|=>|\\\\\\\\|^\\s*[.#]|;\\s*\\w+:", found, perl = TRUE)]
  gsub("\\{[^}]*\\}", "NAME", found)
}

test_names <- function(file) {
  text <- paste(read_text(file), collapse = "\n")
  named <- "(test_that|TEST_CASE)\\(\\s*\"[^\"]*\""
  found <- regmatches(text, gregexpr(named, text, perl = TRUE))[[1L]]
  sub("^[^\"]*\"(.*)\"$", "\\1", found)
}

# ---- texts
# ------------------------------------------------------------------------------------------

tracked <- function(...) system2("git", c("ls-files", shQuote(c(...))), stdout = TRUE)
by_file <- function(read, ...) lapply(stats::setNames(nm = tracked(...)), read)
r_comments <- function(file) comments(file, "#")
line_comments <- function(file) comments(file, "//")
engine <- grep("cpp11", tracked("src/*.cpp", "src/*.hpp", "src/*.h"), value = TRUE, invert = TRUE)
subjects <- system2("git", c("log", "--no-merges", "-n", "100", "--format=%s"), stdout = TRUE)
texts <- list(
  readme = by_file(markdown, "README.md"),
  news = by_file(markdown, "NEWS.md"),
  contributing = by_file(markdown, "CONTRIBUTING.md", "ROADMAP.md", "RELEASING.md", "SUPPORT.md"),
  guides = by_file(markdown, "vignettes/*.Rmd"),
  help = by_file(help_text, "R/*.R"),
  messages = by_file(messages, "R/*.R"),
  r_comments = by_file(r_comments, "R/*.R"),
  cpp_comments = lapply(stats::setNames(nm = engine), line_comments),
  js_comments = by_file(line_comments, "web/*.ts", "web/*.js"),
  tests = by_file(test_names, "tests/testthat/*.R", "tests/engine/*.cpp"),
  test_comments = by_file(r_comments, "tests/*.R", "bench/*.R", "validation/*.R", "tools/*.R"),
  commits = list(`git log` = subjects)
)
found <- lapply(texts, lapply, sentences)

# A data frame with a row per element: sentences, index, over30, and if it fails. allowed: number of
# matches and of long sentences that never fail.
measured <- function(found, allowed) {
  rows <- lapply(found, function(text) {
    words <- count_matches("[A-Za-z0-9][\\w'./%-]*", text)
    matches <- sum(vapply(private, function(pattern) sum(count_matches(pattern, text)), 0))
    long <- sum(words > 30)
    index <- 1000 * matches / max(1, sum(words))
    over30 <- 100 * long / max(1, length(text))
    data.frame(
      sentences = length(text), index = round(index, 1), over30 = round(over30, 1),
      fails = index > limits[["index"]] && matches > allowed ||
        over30 > limits[["over30"]] && long > allowed
    )
  })
  data.frame(text = names(found), do.call(rbind, rows), row.names = NULL)
}

arguments <- commandArgs(TRUE)
if ("--list" %in% arguments) {
  file <- arguments[match("--list", arguments) + 1L]
  text <- unlist(lapply(found, `[[`, file))
  hits <- Reduce(`+`, lapply(private, count_matches, text))
  writeLines(text[hits > 0 | count_matches("[A-Za-z0-9][\\w'./%-]*", text) > 30])
  quit()
}
classes <- measured(lapply(found, unlist, use.names = FALSE), 0)
print(classes[1:4], row.names = FALSE)
files <- do.call(rbind, unname(lapply(found, measured, 1)))
failed <- rbind(classes, files)
failed <- failed[failed$fails, ]

# ---- names
# ------------------------------------------------------------------------------------------

words <- c("lattices?", "told", "tells?", "said", "says?", "asked", "asks", "rooms?", "beside",
  "anew", "alike", "aims?", "bows?", "march", "marched", "kept", "begun", "forge", "pushes",
    "texts",
  "narrow", "settles", "shown", "clerk")
has_private_word <- function(names) {
  grepl(paste0("(^|[-_.])(", paste(words, collapse = "|"), ")($|[-_.])"), names)
}
assigned <- function(file) {
  found <- lapply(as.list(parse(file, keep.source = FALSE)), function(e) {
    if (is.call(e) && identical(e[[1L]], quote(`<-`)) && is.name(e[[2L]])) as.character(e[[2L]])
  })
  unlist(found)
}
documented_arguments <- function(file) {
  sub(".item[{]([^}]*)[}].*", "\\1", grep("^.item[{][a-z_.]+[}]", readLines(file), value = TRUE))
}
fields <- function(node) {
  if (is.list(node)) c(names(node$properties), unlist(lapply(unname(node), fields)))
}
exported <- sub("^export[(](.*)[)]$", "\\1",
  grep("^export[(]", readLines("NAMESPACE"), value = TRUE))
definitions <- unlist(lapply(tracked("R/*.R"), assigned))
measure_table <- utils::read.csv("inst/schema/measures.csv")
names <- list(
  files = basename(tracked("R", "src", "tests", "bench", "vignettes", "tools")),
  `exported names` = exported,
  `fields of plans` = fields(jsonlite::read_json("inst/schema/plan.schema.json")),
  measures = c(measure_table$kind, names(measure_table)),
  `functions and constants` = definitions,
  arguments = unlist(lapply(tracked("man/*.Rd"), documented_arguments))
)
private_names <- unlist(lapply(names(names), function(kind) {
  bad <- unique(names[[kind]][has_private_word(names[[kind]])])
  if (length(bad)) sprintf("%s with private words: %s", kind, paste(bad, collapse = ", "))
}))
if (nrow(failed) || length(private_names)) {
  if (nrow(failed)) print(failed[1:4], row.names = FALSE)
  writeLines(as.character(private_names))
  quit(status = 1)
}
