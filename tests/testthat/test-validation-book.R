# Tests the validation book's manifest, judgements and pictures. tests/ratchets/accuracy.R computes
# its cases. The book is part of the sources, not of the built package.

book <- local({
  root <- test_path("..", "..")
  skip <- !file.exists(file.path(root, "validation", "manifest.yaml"))
  room <- new.env(parent = asNamespace("codend"))
  if (!skip) {
    home <- setwd(root)
    on.exit(setwd(home))
    files <- c("validation/manifest.R", "validation/judge.R", "validation/page.R",
      list.files("validation/cases", "\\.R$", full.names = TRUE))
    for (file in files) sys.source(file, room)
  }
  # in the root of the sources, as the book runs
  function(code) {
    skip_if(skip, "the validation book is not with the installed package")
    home <- setwd(root)
    on.exit(setwd(home))
    code(room, room$read_manifest("validation/manifest.yaml"))
  }
})

test_that("manifest has at least 20 cases with a function each", {
  book(function(room, manifest) {
    expect_gte(length(manifest), 20)
    for (id in names(manifest)) {
      expect_true(is.function(room[[room$runner(id)]]), label = room$runner(id))
    }
    written <- grep("^case_", ls(room), value = TRUE)
    written <- written[vapply(written, function(name) is.function(room[[name]]) &&
      !length(formals(room[[name]])), NA)]
    expect_setequal(written, vapply(names(manifest), room$runner, ""))
  })
})

test_that("check_case() rejects wrong cases of a manifest", {
  book(function(room, manifest) {
    case <- manifest$elastic_catenary
    room$check_case(case)
    expect_error(room$check_case(utils::modifyList(case, list(plan = ""))), "plan")
    wrong <- case
    wrong$quantities$tension$status <- "missed"
    expect_error(room$check_case(wrong), "why")
    wrong$quantities$tension$status <- "tuned"
    expect_error(room$check_case(wrong), "tuned")
    wrong$quantities$tension <- list(unit = "N", band = 0, status = "held")
    expect_error(room$check_case(wrong), "band")
  })
})

test_that("judge() applies bands, tuned values and signs", {
  book(function(room, manifest) {
    case <- list(id = "made_up", group = "hauls",
      quantities = list(a = list(unit = "m", band = 5, status = "held"),
        b = list(unit = "m", band = 5, status = "held"),
        c = list(unit = "m", band = 5, status = "tuned")),
      trends = list(d = list(status = "missed", why = "so")))
    rows <- cbind(case = "made_up", rbind(
      room$compared("a", 1:2, c(10, 20), c(10.9, 20)), room$compared("b", 1:2, 10, c(10.6, 9.4)),
      room$compared("c", 1, 10, 20, TRUE), room$compared("a", 3, 10, 20, TRUE),
      room$trend("d", "x", c(1, 2, 4), c(1, 2, 4), c(4, 2, 1))
    ))
    judged <- room$judge(rows, list(made_up = case))
    expect_identical(judged$found, c("held", "missed", "tuned", "missed"))
    # the mean absolute misfit, not the absolute mean; tuned rows do not count
    expect_equal(judged$misfit[1:2], c(4.5, 6))
    expect_equal(judged$bias[1:2], c(4.5, 0))
    expect_equal(c(judged$measured[4], judged$computed[4]), c(1, -1))
    expect_equal(room$trawl_misfit(judged)[["mean"]], 5.25)
  })
})

test_that("draw_hauls() writes a single picture", {
  book(function(room, manifest) {
    rows <- utils::read.csv("validation/misfits.csv")
    folder <- tempfile()
    dir.create(folder)
    grDevices::png(file.path(folder, "hauls-%d.png"), 900, 800)
    room$draw_hauls(rows, manifest)
    grDevices::dev.off()
    expect_identical(list.files(folder), "hauls-1.png")
    # with a panel for each case that has values by warp
    hauls <- names(Filter(function(case) case$group == "hauls", manifest))
    by_warp <- rows$case[grepl(" m of (warp|wire)$", rows$at) & rows$kind == "quantity"]
    expect_true(all(hauls %in% by_warp))
  })
})
