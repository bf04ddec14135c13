# Attacks on a shared tank: what one visitor, another page or another server must not achieve.

test_that("known_host() rejects names that do not belong to this computer", {
  of <- function(host, ...) known_host(list(HTTP_HOST = host, ...), "tank.example.org")
  for (host in c("localhost:3838", "127.0.0.1:3838", "192.168.1.7", "[::1]:3838",
    "Tank.example.org")) {
    expect_true(of(host))
  }
  for (host in c("evil.example:3838", "127.0.0.1.evil.example", "localhost.evil.example", "",
    "tank.example.org.evil.example", "a.tank.example.org")) {
    expect_false(of(host))
  }
  # a header of a visitor does not help
  expect_false(of("evil.example", HTTP_X_FORWARDED_FOR = "192.168.1.9"))
  expect_error(flume(hosts = 1), "hosts", class = "codend_error_argument")
})

test_that("same_origin() rejects pages of another origin", {
  of <- function(origin, host) same_origin(list(HTTP_ORIGIN = origin, HTTP_HOST = host))
  expect_true(of("http://127.0.0.1:3838", "127.0.0.1:3838"))
  expect_true(of("https://tank.example.org", "tank.example.org"))
  expect_true(of("https://Tank.example.org:443", "tank.example.org"))
  expect_true(of(NULL, "127.0.0.1:3838"))
  expect_false(of("http://evil.example", "127.0.0.1:3838"))
  expect_false(of("http://127.0.0.1:8080", "127.0.0.1:3838"))
  expect_false(of("http://127.0.0.1:3838.evil.example", "127.0.0.1:3838"))
  expect_false(of("null", "127.0.0.1:3838"))
  expect_false(of("file://", "127.0.0.1:3838"))
})

test_that("responses have headers that restrict other pages", {
  expect_identical(response_headers[["X-Content-Type-Options"]], "nosniff")
  policy <- strsplit(response_headers[["Content-Security-Policy"]], "; *")[[1]]
  expect_true(all(c("default-src 'none'", "script-src 'self'", "connect-src 'self'") %in% policy))
  expect_match(policy, "^frame-ancestors 'self'", all = FALSE)
})

test_that("visitor_of() trusts only the last proxy", {
  of <- function(given) visitor_of(list(HTTP_X_FORWARDED_FOR = given))
  expect_identical(of("10.0.0.1"), "10.0.0.1")
  expect_identical(of("1.2.3.4, 10.0.0.1"), "10.0.0.1")
  for (given in list(NULL, "", "1.2.3.4, ", 1, NA_character_)) expect_null(of(given))
})

test_that("one visitor cannot use up the pages and names of others", {
  clock <- 0
  visitors <- new_visitors(function() clock)
  one <- function() visitors("10.0.0.1")
  for (k in seq_len(most_pages)) expect_true(one()$enter())
  expect_false(one()$enter())
  expect_true(visitors("10.0.0.2")$enter())
  expect_lt(most_pages, flume_sessions)
  one()$leave()
  expect_true(one()$enter())
  # changes of all pages of the visitor count together
  for (k in seq_len(most_changes)) one()$change()
  expect_error(one()$change(), "in a minute", class = "codend_error_argument")
  expect_no_error(visitors("10.0.0.2")$change())
  clock <- change_time + 1
  expect_no_error(one()$change())
  for (k in seq_len(most_new_designs)) one()$add()
  expect_error(one()$add(), "in a day, which", class = "codend_error_argument")
  expect_lt(most_new_designs, most_shared / 10)
  # the count outlasts the visitor's pages
  for (k in seq_len(most_pages)) one()$leave()
  expect_error(one()$add(), "in a day, which")
  clock <- clock + day + 1
  expect_no_error(one()$add())
})

test_that("pages without a proxy are separate visitors", {
  visitors <- new_visitors()
  for (k in seq_len(2 * most_pages)) expect_true(visitors(NULL)$enter())
})

test_that("a page that floods the folder is refused and does not block the server", {
  folder <- tempfile("shared-")
  dir.create(folder)
  in_flume("towed_cable", folder = folder, function(session, sent, tank) {
    sent("flume_refused")
    for (k in 1:40) {
      session$hear(shared = list(number = k, act = "put", author = "Anna",
        key = strrep("a", 32), name = paste("Net", k)))
    }
    expect_length(sent("flume_refused"), 40 - most_changes)
    expect_length(list.files(folder), most_changes)
  })
})

test_that("two servers of one folder give a name to one of them", {
  folder <- tempfile("shared-")
  dir.create(folder)
  shared <- new_shared(folder)
  words <- list(now = list(base = "towed_cable"))
  # another server writes the same name between the check and the write
  other <- function() new_shared(folder)$put("Anna", strrep("b", 32), "Net", words)
  expect_error(shared$put("Anna", strrep("a", 32), "Net", words, add = other), "only that browser")
  expect_error(shared$take_out("Anna", strrep("a", 32), "Net"), "only that browser")
  expect_length(list.files(folder), 1L)
  # wrong keys do not lock the owner out
  for (k in 1:20) {
    expect_error(shared$put("Anna", sprintf("%032x", k), "Net", words), "only that browser")
  }
  expect_no_error(shared$put("Anna", strrep("b", 32), "Net", words))
})
