skip_if_not_installed("xml2")

report_text <- function(state) {
  file <- tempfile(fileext = ".html")
  on.exit(unlink(file))
  expect_identical(withVisible(report(state, file)), list(value = file, visible = FALSE))
  paste(readLines(file, warn = FALSE, encoding = "UTF-8"), collapse = "\n")
}

# The body of a page without scripts, parsed as strict XML: an error if a tag is not closed or
# wrongly nested, or if text is not escaped.
report_body <- function(html) {
  body <- sub("^.*<body>", "<body>", sub("</body>.*$", "</body>", html))
  body <- gsub("<script[^>]*>.*?</script>", "", body, perl = TRUE)
  xml2::read_xml(body)
}

# A table of the page, found by a string in its caption, as a matrix of strings.
report_rows <- function(body, caption) {
  table <- xml2::xml_find_first(body, sprintf("//table[contains(caption, '%s')]", caption))
  rows <- xml2::xml_find_all(table, ".//tbody/tr")
  do.call(rbind, lapply(rows, function(row) xml2::xml_text(xml2::xml_find_all(row, "th|td"))))
}

as_number <- function(text) as.double(gsub(",", "", text, fixed = TRUE))

test_that("report is well formed and accessible without sight", {
  state <- settled("panel_in_current")
  body <- report_body(report_text(state))
  expect_length(xml2::xml_find_all(body, "//h1"), 1)
  expect_gt(length(xml2::xml_find_all(body, "//h2")), 6)
  ids <- xml2::xml_attr(xml2::xml_find_all(body, "//*[@id]"), "id")
  expect_false(anyDuplicated(ids) > 0)
  expect_true(all(nzchar(xml2::xml_attr(xml2::xml_find_all(body, "//img"), "alt"))))
  heads <- xml2::xml_find_all(body, "//th")
  expect_true(all(xml2::xml_attr(heads, "scope") %in% c("row", "col")))
  for (table in xml2::xml_find_all(body, "//table")) {
    columns <- length(xml2::xml_find_all(table, ".//thead//th"))
    for (row in xml2::xml_find_all(table, ".//tbody/tr")) {
      expect_length(xml2::xml_find_all(row, "th|td"), columns)
    }
  }
})

test_that("report has the numbers of the state", {
  state <- settled("midwater_trawl", nodes = 500)
  body <- report_body(report_text(state))
  said <- report_rows(body, "Measures of the gear")
  found <- measures(state)
  expect_identical(said[, 1], measure_labels(found)$words)
  # four digits and at most four decimals: half a unit of the fourth digit, or of the fourth decimal
  found <- plain_measures(found)
  off <- abs(as_number(said[, 2]) - found)
  expect_true(all(off <= pmax(5e-4 * abs(found), 5e-5) * (1 + 1e-9)))
  kilonewtons <- said[, 3] == "kN"
  expect_equal(as_number(said[kilonewtons, ncol(said)]), unname(found[kilonewtons]) / 9.80665,
    tolerance = 6e-4)
  ropes <- report_rows(body, "Ropes by tension")
  tensions <- summary(state)$tensions
  warp <- tensions[tensions$part %in% "warp_port", ]
  expect_equal(as_number(ropes[1, 3]), warp$max_kN, tolerance = 1e-3)
  # steel wire of 32 mm: 630 MPa of its diameter squared
  expect_equal(as_number(ropes[1, 6]), 630e6 * 0.032^2 / 1000, tolerance = 1e-3)
  expect_equal(as_number(ropes[1, 8]), 645.1 / warp$max_kN, tolerance = 0.05)
  drag <- report_rows(body, "Forces by group")
  expect_equal(as_number(drag[nrow(drag), 2]), found[["total_drag_kN"]], tolerance = 1e-3)
})

test_that("report contains the exact plan and escapes text", {
  sheets <- unsettled(sheets_plan)
  expect_false(sheets$report$converged)
  sheets$report[c("iterations", "residual", "cpu_seconds")] <- list(0L, 1, 0)
  html <- report_text(sheets)
  body <- report_body(html)
  plan <- xml2::xml_text(xml2::xml_find_first(body, "//pre"))
  expect_identical(trimws(plan), trimws(format(sheets$gear)))
  expect_identical(xml2::xml_text(xml2::xml_find_first(body, "//h1")), sheets_plan$name)
  expect_match(html, "did not settle", fixed = TRUE)
})

test_that("report needs no network and is reproducible", {
  state <- settled("crossing_cables")
  html <- report_text(state)
  asking <- "(src|href|url)\\s*[=(]\\s*[\"']?(https?:)?//[^\"' )>]*"
  expect_equal(regmatches(html, gregexpr(asking, html))[[1]], character())
  expect_false(grepl("(src|href)=[\"'](?!data:)", html, perl = TRUE))
  expect_identical(report_text(state), html)
})

test_that("report of a tow has measures over time", {
  trajectory <- tow("towed_cable", until = 20, every = 5,
    schedule = tow_schedule(speed = data.frame(time = c(0, 10), value = c("4 knot", "5 knot"))))
  body <- report_body(report_text(trajectory))
  said <- report_rows(body, "start and the end")
  of <- summary(trajectory)
  expect_identical(said[, 1], label_of(of$measure, of$unit))
  expect_equal(as_number(said[, 4]), of$end, tolerance = 1e-3)
})

test_that("report renders in a browser without errors", {
  browser <- Sys.which(c("chromium", "chromium-browser", "google-chrome"))
  browser <- browser[nzchar(browser)]
  skip_if_not(length(browser) > 0, "no Chromium is installed")
  folder <- test_folder()
  file <- file.path(folder, "report.html")
  report(settled("midwater_trawl", nodes = 500), file)
  said <- file.path(folder, "said")
  page <- system2(browser[1], c(
    "--headless=new", "--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader", "--no-first-run", "--disable-background-networking",
    "--disable-component-update", "--disable-sync", "--enable-logging=stderr",
    paste0("--user-data-dir=", shQuote(file.path(folder, "browser"))),
    "--virtual-time-budget=10000", "--window-size=1200,900", "--dump-dom",
    shQuote(paste0("file://", file))
  ), stdout = TRUE, stderr = said, timeout = 120)
  skip_if(!length(page), "Chromium does not run here")
  page <- paste(page, collapse = "\n")
  expect_length(grep("CONSOLE", readLines(said, warn = FALSE), value = TRUE), 0)
  still <- regmatches(page, regexpr("class=\"view-still\"[^>]*", page))
  # An empty scene of this size packs into about 4 kB.
  expect_gt(nchar(still), 2e4)
})

test_that("report lists the effect of more of a field with sensitivities", {
  state <- settle("towed_cable")
  slopes <- sensitivities(state, of = c("body_depth_m", "total_drag_kN"), secants = FALSE)
  columns <- sensitivity_columns(slopes)
  expect_identical(columns$` field`, c("towing.speed", "ropes.cable.length", "pieces.sphere.mass"))
  expect_identical(columns$` more`, c("+0.4000 knot", "+100.0 m", "+113.5 kg"))
  drag <- slopes$derivative[slopes$measure == "total_drag_kN"] * c(0.4, 100, 113.5)
  expect_identical(columns$`total drag kN`, figures(drag))
  file <- file.path(test_folder(), "made.html")
  report(state, file, slopes)
  # expect_match() takes a minute to format a whole page, even if it matches
  expect_true(any(grepl("Sensitivities", readLines(file, warn = FALSE), fixed = TRUE)))
  expect_wrong(report(state, file, sensitivities = 1))
})
