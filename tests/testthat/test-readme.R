# The README's blocks, in order: what a reader who copies them sees.

readme <- function(language) {
  lines <- readLines(test_path("..", "..", "README.md"), encoding = "UTF-8")
  opens <- which(lines == paste0("```", language))
  closes <- which(lines == "```")
  lapply(opens, function(from) lines[(from + 1L):(closes[closes > from][1L] - 1L)])
}

test_that("the blocks of R run in order", {
  skip_on_cran()
  skip_if_not(file.exists(test_path("..", "..", "README.md")), "the sources are not here")
  for (package in c("RNetCDF", "nloptr", "spacefillr")) skip_if_not_installed(package)
  code <- unlist(readme("r"))
  # these wait for a reader
  code <- code[!grepl("^flume\\(\\)", code)]
  expect_gt(length(code), 50)
  kept <- setwd(test_folder())
  on.exit(setwd(kept))
  quiet <- options(viewer = function(...) NULL, browser = function(...) NULL)
  on.exit(options(quiet), add = TRUE)
  reader <- new.env(parent = globalenv())
  for (expression in parse(text = code, keep.source = FALSE)) {
    if (identical(expression, quote(library(codend)))) next
    expect_no_error({
      utils::capture.output({
        found <- withVisible(suppressWarnings(eval(expression, reader)))
        if (found$visible && !inherits(found$value, "htmlwidget")) print(found$value)
      })
    })
  }
  made <- c("trawl.html", "turn.png", "turn.nc", "trawl.vtu", "trawl.glb", "trawl.nc")
  expect_setequal(intersect(made, list.files()), made)
})

test_that("its plan settles, and is in balance", {
  skip_if_not(file.exists(test_path("..", "..", "README.md")), "the sources are not here")
  file <- file.path(test_folder(), "plan.yaml")
  writeLines(readme("yaml")[[1L]], file)
  state <- settle(file, nodes = 300)
  expect_true(state$report$converged)
  expect_gt(measures(state)[["pull_kN"]], 0)
})

test_that("studies of the shell's block are run before they are plotted", {
  skip_if_not(file.exists(test_path("..", "..", "README.md")), "the sources are not here")
  lines <- grep("^    codend study ", readLines(test_path("..", "..", "README.md")), value = TRUE)
  words <- strsplit(trimws(lines), " +")
  what <- vapply(words, `[[`, "", 3L)
  study <- vapply(words, `[[`, "", 4L)
  for (plotted in which(what == "plot")) {
    expect_identical(what[study == study[plotted] & seq_along(what) < plotted], c("new", "run"))
  }
})
