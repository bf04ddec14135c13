# Fails where what users read (README, NEWS, guides, help as written in R/, and R's texts of more
# than one word: messages, labels, definitions) has a word of tools/words.csv: `not` is a regular
# expression, `but` what to write instead. Code in texts (`such`, {.such x}, {such}) is left out.

words <- utils::read.csv("tools/words.csv")

# Lines of texts of more than one word, others empty.
texts <- function(file, lines) {
  parsed <- utils::getParseData(parse(file, keep.source = TRUE, encoding = "UTF-8"))
  parsed <- parsed[parsed$token == "STR_CONST" & grepl(" ", parsed$text), ]
  found <- character(length(lines))
  for (k in seq_len(nrow(parsed))) {
    at <- seq(parsed$line1[k], parsed$line2[k])
    text <- strsplit(utils::getParseText(parsed, parsed$id[k]), "\n", fixed = TRUE)[[1L]]
    text <- gsub("`[^`]*`|[{][.](code|fn|field|arg|val)[^}]*[}]+|[{][^. ][^}]*[}]", "", text)
    found[at] <- paste(found[at], text)
  }
  found
}

# Lines of prose, others empty.
prose <- function(file) {
  lines <- readLines(file, warn = FALSE, encoding = "UTF-8")
  if (grepl("[.]R$", file)) {
    help <- startsWith(lines, "#'")
    tag <- cummax(ifelse(grepl("^#' @", lines) | !help, seq_along(lines), 0L))
    examples <- tag > 0L & grepl("^#' @examples", lines[pmax(tag, 1L)])
    # the tank's page has words of its own
    text <- if (grepl("R/flume-", file)) "" else texts(file, lines)
    return(ifelse(help & !examples, gsub("`[^`]*`", "", lines), text))
  }
  lines[cumsum(startsWith(lines, "```")) %% 2L == 1L | startsWith(lines, "    ")] <- ""
  gsub("`[^`]*`", "", lines)
}

files <- c("README.md", "NEWS.md", Sys.glob(c("vignettes/*.Rmd", "R/*.R")))
found <- unlist(lapply(files, function(file) {
  lines <- prose(file)
  unlist(Map(function(not, but) {
    at <- grep(not, lines, perl = TRUE, ignore.case = TRUE)
    if (length(at)) sprintf("%s:%d: %s: rather %s", file, at, trimws(lines[at]), but)
  }, words$not, words$but), use.names = FALSE)
}))
cat(found, sep = "\n")
quit(status = length(found) > 0L)
