# Measures the prose of this repository by class of text. Classes above the limits may not get
# worse.
#   Rscript tests/ratchets/prose.R               compares with prose.csv
#   Rscript tests/ratchets/prose.R --accept      stores the values
#   Rscript tests/ratchets/prose.R --list CLASS  prints the sentences of a class that count
# `index` is the number of private expressions per 1,000 words: clauses used as nouns, chains of
# pronouns, sentences that open with "Of", and verbs of speech for things. `over30` is the
# percentage of sentences with more than 30 words. Five well-known R packages have an index of 0
# to 6.
source("tools/ratchet.R")
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

# Removes markup; names of code become the word NAME.
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

# Strings of at least five words in code that is no comment.
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

of_files <- function(read, ...) unlist(lapply(Sys.glob(c(...)), read))
engine <- system2("git", c("ls-files", "'src/*.cpp'", "'src/*.hpp'"), stdout = TRUE)
texts <- list(
  readme = of_files(markdown, "README.md"),
  news = of_files(markdown, "NEWS.md"),
  contributing = of_files(markdown, "CONTRIBUTING.md", "ROADMAP.md", "RELEASING.md"),
  guides = of_files(markdown, "vignettes/*.Rmd"),
  help = of_files(help_text, "R/*.R"),
  messages = of_files(messages, "R/*.R"),
  r_comments = of_files(function(file) comments(file, "#"), "R/*.R"),
  cpp_comments = unlist(lapply(grep("cpp11", engine, value = TRUE, invert = TRUE), comments, "//")),
  tests = of_files(test_names, "tests/testthat/*.R", "tests/engine/*.cpp"),
  commits = system2("git", c("log", "--no-merges", "-n", "100", "--format=%s"), stdout = TRUE)
)
found <- lapply(texts, sentences)
words <- lapply(found, function(text) count_matches("[A-Za-z0-9][\\w'./%-]*", text))
counts <- lapply(found, function(text) Reduce(`+`, lapply(private, count_matches, text)))
table <- data.frame(
  class = names(found), sentences = lengths(found),
  index = round(1000 * vapply(counts, sum, 0) / vapply(words, sum, 0), 1),
  over30 = round(100 * vapply(words, function(count) mean(count > 30), 0), 1)
)


arguments <- commandArgs(TRUE)
if ("--list" %in% arguments) {
  class <- arguments[match("--list", arguments) + 1L]
  writeLines(found[[class]][counts[[class]] > 0 | words[[class]] > 30])
  quit()
}
print(table, row.names = FALSE)
# Below its limit a class may vary. The allowance covers one long sentence in a short class.
ratchet(table, "tests/ratchets/prose.csv", "class",
  columns = list(index = lower(absolute = 0.5), over30 = lower(absolute = 1.5)),
  summarise = function(table) {
    table[names(limits)] <- Map(pmax, table[names(limits)], limits)
    table
  })
