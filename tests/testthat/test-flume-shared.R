skip_if_not_installed("shiny")
skip_if_not_installed("digest")

# An empty folder.
new_folder <- function() {
  folder <- tempfile("shared-")
  dir.create(folder)
  folder
}

words_of_speed <- function(speed) {
  list(now = list(base = "towed_cable", edits = list(towing.speed = speed)))
}

test_that("shared design returns unchanged and only its author's password changes it", {
  folder <- new_folder()
  shared <- new_shared(folder)
  words <- words_of_speed("5 knot")
  shared$put("S\u00f8ren", "torsk og sei", "../../my net", words)
  expect_identical(shared$words("S\u00f8ren", "../../my net")$now, words$now)
  expect_identical(shared$list()[[1]][c("author", "name")],
    list(author = "S\u00f8ren", name = "../../my net"))
  expect_error(shared$put("S\u00f8ren", "another", "../../my net", words_of_speed("6 knot")),
    "password of .* is wrong", class = "codend_error_argument")
  expect_error(shared$put("S\u00f8ren", "another", "a second", words), "password of .* is wrong")
  expect_error(shared$take_out("S\u00f8ren", "another", "../../my net"), "password of .* is wrong")
  expect_identical(shared$words("S\u00f8ren", "../../my net")$now, words$now)
  shared$put("S\u00f8ren", "torsk og sei", "../../my net", words_of_speed("6 knot"))
  expect_identical(shared$words("S\u00f8ren", "../../my net")$now, words_of_speed("6 knot")$now)
  # another server of the folder accepts the password, which is not stored as text
  expect_error(new_shared(folder)$take_out("S\u00f8ren", "another", "../../my net"), "is wrong")
  texts <- unlist(lapply(list.files(folder, full.names = TRUE), readLines, warn = FALSE))
  expect_false(any(grepl("torsk og sei", texts, fixed = TRUE)))
  # no name refers outside the folder
  expect_true(all(grepl("^[0-9a-f-]+[.](json|author)$", list.files(folder, all.files = TRUE,
    no.. = TRUE))))
  expect_length(list.files(dirname(folder), "my net"), 0L)
  shared$take_out("S\u00f8ren", "torsk og sei", "../../my net")
  expect_length(shared$list(), 0L)
  expect_error(shared$words("S\u00f8ren", "../../my net"), "no longer in the folder")
})

test_that("new_shared() rejects wrong or large input and writes nothing", {
  folder <- new_folder()
  shared <- new_shared(folder)
  words <- words_of_speed("5 knot")
  for (name in list(NULL, 1, "", " \n", strrep("a", 31), NA_character_, c("a", "b"), list("a"))) {
    expect_error(shared$put(name, "long word", "net", words), "name of the author")
    expect_error(shared$put("Anna", "long word", name, words), "name of the design")
  }
  for (word in list(NULL, "short", strrep("a", 101), 123456, NA_character_)) {
    expect_error(shared$put("Anna", word, "net", words), "6 to 100 characters")
  }
  large <- list(now = list(plan = strrep("x", most_shared_bytes)))
  expect_error(shared$put("Anna", "long word", "net", large), "too large")
  expect_identical(list.files(folder, all.files = TRUE, no.. = TRUE), character())
  # files that are not designs
  writeLines("{", file.path(folder, "61-62.json"))
  writeLines("x", file.path(folder, "passwd"))
  expect_identical(shared$list()[[1]][c("author", "name")], list(author = "a", name = "b"))
  expect_error(shared$words("a", "b"), "damaged")
})

test_that("new_shared() blocks repeated wrong passwords", {
  clock <- 0
  shared <- new_shared(new_folder(), function() clock)
  words <- words_of_speed("5 knot")
  shared$put("Anna", "long word", "net", words)
  for (k in 1:5) {
    expect_error(shared$take_out("Anna", "wrong word", "net"), "password of .* is wrong")
  }
  expect_error(shared$take_out("Anna", "long word", "net"), "in a minute")
  # other authors are not blocked
  shared$put("Bo", "long word", "net", words)
  clock <- 61
  shared$take_out("Anna", "long word", "net")
  expect_length(shared$list(), 1L)
})

test_that("pages share designs as copies and receive changes", {
  folder <- new_folder()
  in_flume("towed_cable", folder = folder, function(session, sent, tank) {
    rows <- list(list(class = "rope", title = "Mine", values = list(diameter = "16,5")))
    session$setInputs(own = list(number = 1, rows = rows))
    ask(session, towing.speed = list(value = 5, unit = "knot"))
    session$setInputs(shared = list(act = "put", author = "Anna", word = "long word", name = "Net"))
    told <- sent("flume_shared")
    expect_identical(told[[length(told)]]$designs[[1]]$name, "Net")
  })
  in_flume(NULL, folder = folder, function(session, sent, tank) {
    expect_identical(sent("flume_shared")[[1]]$designs[[1]]$author, "Anna")
    session$setInputs(shared_open = list(number = 3, asked = list(author = "Anna", name = "Net")))
    expect_identical(tank$gear$plan$towing$speed, "5 knot")
    expect_identical(tank$own[[1]]$values, list(diameter = "16.5 mm"))
    sent("flume_refused")
    session$setInputs(shared_open = list(number = 4, asked = list(author = "..", name = "/etc")))
    told <- sent("flume_refused")[[1]]$message
    expect_match(told, "no longer in the folder")
    session$setInputs(shared = list(act = "take_out", author = "Anna", word = "wrong one",
      name = "Net"))
    told <- sent("flume_refused")[[1]]$message
    expect_match(told, "password of .* is wrong")
  })
  expect_error(flume(folder = file.path(folder, "none")), "folder", class = "codend_error_argument")
})
