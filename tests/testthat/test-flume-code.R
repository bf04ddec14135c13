run_code <- function(code) {
  # plot() and view_3d() write files and pages
  code <- sub("view_3d(state)", "", code, fixed = TRUE)
  env <- new.env(parent = globalenv())
  grDevices::pdf(NULL)
  on.exit(grDevices::dev.off())
  utils::capture.output(eval(parse(text = code), env))
  env
}

test_that("flume_code() of a changed shipped plan settles the same gear", {
  loaded <- read_gear("towed_cable")
  design <- update(loaded, towing.speed = "5 knot", ropes.cable.length = 800)
  code <- flume_code(loaded, loaded, design, 300)
  expect_match(code, "update(read_gear(\"towed_cable\"),", fixed = TRUE)
  ran <- run_code(code)
  expect_identical(ran$gear$plan, design$plan)
  expect_identical(ran$kept$plan, loaded$plan)
  expect_identical(measures(ran$state), measures(settle(design, nodes = 300)))
})

test_that("flume_code() contains an uploaded plan with any strings", {
  # strings that would end a string literal, run, or be lost in another locale
  tree <- read_gear("towed_cable")$plan
  tree$name <- "net \"); stop('ran'); (\" \\ %s \u00e9\u4e2d\U0001f41f"
  tree$notes <- c("'; stop('ran') #", "`quit()`", "\\u0041 \t.")
  own <- as_gear(tree)
  code <- flume_code(own, own, update(own, towing.speed = 3), 1500)
  expect_true(all(utf8ToInt(code) < 128))
  lines <- strsplit(code, "\n")[[1]]
  # without settling
  ran <- run_code(paste(lines[seq_len(grep("^state <-", lines)[1] - 1L)], collapse = "\n"))
  expect_identical(ran$gear$plan, update(own, towing.speed = 3)$plan)
})

test_that("flume_code() writes the whole plan when parts are added or removed", {
  loaded <- read_gear("towed_cable")
  without <- loaded$plan
  without$pieces <- NULL
  expect_null(update_arguments(loaded$plan, without))
  expect_identical(update_arguments(loaded$plan, loaded$plan), character())
})
