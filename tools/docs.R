# Updates the results that README, guides and help quote from result files.
#   Rscript tools/docs.R           writes the documents
#   Rscript tools/docs.R --check   fails if a document differs from the result files, or if README
#                                  quotes a percentage or a time without a marker
#
# In Markdown a result is between markers: <!-- result: book-cases -->49<!-- end -->. In help it is
# an Rd macro such as \resultBookCases{} of man/macros/results.Rd, which this script writes.

number <- function(x, digits = 2) {
  stopifnot("a result is not one number in its file" = length(x) == 1L && is.finite(x))
  format(signif(x, digits), big.mark = ",", scientific = FALSE, trim = TRUE, drop0trailing = TRUE)
}
percent <- function(x, digits = 2) paste(number(x, digits), "%")
bench <- function(name) utils::read.csv(file.path("bench", "results", paste0(name, ".csv")))

book_results <- function() {
  book <- new.env()
  for (part in c("manifest", "judge")) sys.source(file.path("validation", paste0(part, ".R")), book)
  rows <- utils::read.csv("validation/misfits.csv")
  judged <- book$judge(rows, book$read_manifest("validation/manifest.yaml"))
  trawls <- book$trawl_misfit(judged)
  rows$misfit <- 100 * (rows$computed / rows$measured - 1)
  rows <- rows[rows$kind == "quantity" & !rows$tuned, ]
  flume <- rows[grepl("^flume_", rows$case) & !grepl("eastern", rows$case), ]
  hauls <- rows[rows$case == "poly_noreastern_hauls", ]
  size <- function(rows, quantity) mean(abs(rows$misfit[rows$quantity == quantity]))
  quantities <- judged[judged$kind == "quantity", ]
  list(
    `book-cases` = number(length(unique(judged$case)), 4),
    `book-quantities` = number(nrow(quantities), 4),
    `book-held` = number(sum(quantities$found == "held"), 4),
    `book-missed` = number(sum(quantities$found == "missed"), 4),
    `book-trawl-misfit` = percent(trawls[["mean"]]),
    `book-trawl-quantities` = number(trawls[["quantities"]], 4),
    `axicodend-largest` = percent(max(abs(rows$misfit[grepl("^axicodend_", rows$case)]))),
    `flume-tests` = number(sum(flume$quantity == "bridle_tension"), 4),
    `flume-tension` = percent(size(flume, "bridle_tension")),
    `flume-height` = percent(size(flume, "opening")),
    `hauls-height` = percent(size(hauls, "opening"))
  )
}

netting_results <- function() {
  found <- bench("netting")
  value <- function(case, netting, measure) {
    at <- found$case == case & found$netting == netting & found$measure == measure
    found$value[at & found$section == "nettings"]
  }
  # Returns the difference between bars and cells [% of cells].
  apart <- function(case, measure = "total_drag_kN") {
    percent(100 * abs(value(case, "bars", measure) / value(case, "cells", measure) - 1))
  }
  panels <- found[grepl("^panel, ", found$case) & found$measure == "width_m", ]
  exact <- panels[panels$netting == "mesh by mesh", ]
  cells <- panels[panels$netting == "cells" & panels$asked == 1000, ]
  list(
    `cells-panel-width` = percent(100 * max(abs(
      cells$value / exact$value[match(cells$case, exact$case)] - 1
    ))),
    `nettings-cage` = apart("cage"), `nettings-pair-trawl` = apart("pair_trawl"),
    `nettings-survey-trawl` = apart("poly_noreastern_trawl"),
    `nettings-midwater-trawl` = apart("midwater_trawl"),
    `nettings-midwater-straight` = apart("midwater_trawl, straight bars")
  )
}

cost_results <- function() {
  settles <- bench("medians")
  settles <- settles[settles$case == "own_trawl_bars", ]
  changes <- bench("loops")
  changes <- changes[changes$version == "now" & changes$gear == "midwater_trawl" &
    changes$asked == 1500 & changes$percent == 1, ]
  robust <- bench("robust")
  varied <- robust$settled[grepl("^variation ", robust$run)]
  seconds <- function(asked) paste(number(settles$settle[settles$asked == asked], 1), "s")
  list(
    `settle-seconds-coarse` = seconds(1500), `settle-seconds-fine` = seconds(10000),
    `settle-steps-anew` = number(settles$iterations[settles$asked == 1500]),
    `settle-steps-changed` = number(stats::median(changes$steps)),
    `variations` = number(length(varied), 4), `variations-settled` = number(sum(varied), 4)
  )
}

motion_results <- function() {
  found <- bench("motion")
  surest <- function(scheme) {
    paste(number(found$cpu_per_second[found$case == "trawl that is sped up, the first 0.5 s" &
      found$scheme == scheme & found$setting == "longest sure step" & found$nodes == 1467]), "s")
  }
  list(
    `motion-symplectic` = surest("symplectic_euler"),
    `motion-substitution` = surest("substitution")
  )
}

error_results <- function() {
  found <- bench("errors")
  true <- abs(found$value - found$fine)
  exact <- true <= 1e-7 * pmax(abs(found$value), abs(found$fine))
  is_missed <- true > 5 * found$error & !exact
  missed <- function(rows) percent(100 * mean(is_missed[rows], na.rm = TRUE), 1)
  settled <- found$class != "tow"
  list(
    `errors-within-two` = percent(100 * mean(true <= 2 * found$error | exact, na.rm = TRUE)),
    `errors-missed-coarse` = missed(settled & found$asked < 1000),
    `errors-missed-default` = missed(settled & found$asked == 1500)
  )
}

# Returns the lanes of continuous integration as a Markdown table.
lane_results <- function() {
  lanes <- utils::read.csv("tools/lanes.csv")
  command <- sprintf("`%s`", gsub("|", "\\|", lanes$command, fixed = TRUE))
  rows <- sprintf("| %s | %s | %s | %s |", lanes$lane, command, lanes$minutes, lanes$protects)
  head <- c("| lane | command | minutes | checks |", "|---|---|---:|---|")
  list(lanes = paste0(c("", head, rows, ""), collapse = "\n"))
}

results <- unlist(c(
  book_results(), netting_results(), cost_results(), motion_results(), error_results(),
  lane_results()
))

guides <- Sys.glob(c("vignettes/*.Rmd", "vignettes/articles/*.Rmd"))
documents <- c("README.md", "CONTRIBUTING.md", guides)
macros_file <- "man/macros/results.Rd"
marker <- "<!-- result: ([a-z-]+) -->((?s:.*?))<!-- end -->"

read_text <- function(file) {
  if (!file.exists(file)) return("")
  paste0(readLines(file, encoding = "UTF-8", warn = FALSE), "\n", collapse = "")
}

# Returns one group of a pattern for every match in a string.
matches <- function(pattern, text, group = 1L) {
  found <- gregmatches(pattern, text)
  vapply(found, `[[`, "", group + 1L)
}
gregmatches <- function(pattern, text) {
  whole <- regmatches(text, gregexpr(pattern, text, perl = TRUE))[[1L]]
  regmatches(whole, regexec(pattern, whole, perl = TRUE))
}

# Returns the text with updated values of its results.
with_results <- function(text) {
  places <- gregexpr(marker, text, perl = TRUE)
  names <- matches(marker, text)
  regmatches(text, places) <- list(
    sprintf("<!-- result: %s -->%s<!-- end -->", names, results[names])
  )
  text
}

was <- vapply(c(documents, macros_file), read_text, "")
quoted <- do.call(rbind, lapply(documents, function(file) {
  name <- matches(marker, was[[file]])
  data.frame(file = rep(file, length(name)), name, value = matches(marker, was[[file]], 2L))
}))

macros <- paste0("result", gsub("(^|-)([a-z])", "\\U\\2", names(results), perl = TRUE))
in_help <- unique(unlist(lapply(Sys.glob("R/*.R"), function(file) {
  matches("\\\\(result[A-Z][A-Za-z]*)", read_text(file))
})))
used <- macros %in% in_help
is <- was
is[documents] <- vapply(was[documents], with_results, "")
is[[macros_file]] <- paste0(
  c("% Written by tools/docs.R.", sprintf("\\newcommand{\\%s}{%s}", macros[used],
    gsub("%", "\\\\\\%", results[used], fixed = TRUE))), "\n", collapse = ""
)

# Prose of README, without code blocks and marked results.
prose <- gsub("(?ms)^```.*?^```", "", was[["README.md"]], perl = TRUE)
prose <- gsub(marker, "", prose, perl = TRUE)
prose <- gsub("(?m)^    .*", "", prose, perl = TRUE)
wrong <- c(
  sprintf("%s quotes an unknown result, %s", quoted$file, quoted$name)[
    !quoted$name %in% names(results)],
  sprintf("help quotes an unknown result, \\%s", setdiff(in_help, macros)),
  sprintf("no document quotes %s: remove it from tools/docs.R",
    setdiff(names(results)[!used], quoted$name)),
  sprintf("README.md has a measured value without a marker: %s",
    matches("([^\\n]*[0-9] ?(?:%|(?:s|ms|min|seconds|minutes|hours)\\b)[^\\n]*)", prose))
)
if (length(wrong)) {
  cat(wrong, sep = "\n")
  quit(status = 1)
}

stale <- names(was)[was != is]
if ("--check" %in% commandArgs(TRUE)) {
  differ <- quoted[quoted$value != results[quoted$name], ]
  cat(sprintf("%s: %s is %s, the result files give %s\n", differ$file, differ$name, differ$value,
    results[differ$name]), sep = "")
  if (length(stale)) cat("Run `make docs` to rewrite", stale, "\n")
  quit(status = length(stale) > 0L)
}
for (file in stale) {
  dir.create(dirname(file), FALSE, TRUE)
  writeLines(is[[file]], file, sep = "", useBytes = TRUE)
}
cat(if (length(stale)) c("Rewrote", stale) else "All documents quote the stored results.", "\n")
