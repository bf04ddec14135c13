# Fails where what users read (README, NEWS, guides, help as written in R/) has a word of
# tools/words.csv: `not` is a regular expression, `but` what to write instead.

words <- utils::read.csv("tools/words.csv")

# Lines of prose, others empty.
prose <- function(file) {
  lines <- readLines(file, warn = FALSE, encoding = "UTF-8")
  if (grepl("[.]R$", file)) {
    lines[!startsWith(lines, "#'")] <- ""
    tag <- cummax(ifelse(grepl("^#' @", lines) | !nzchar(lines), seq_along(lines), 0L))
    lines[tag > 0L & grepl("^#' @examples", lines[pmax(tag, 1L)])] <- ""
    return(lines)
  }
  lines[cumsum(startsWith(lines, "```")) %% 2L == 1L | startsWith(lines, "    ")] <- ""
  lines
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
