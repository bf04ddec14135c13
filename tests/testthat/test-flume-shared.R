# An empty folder.
new_folder <- function() {
  folder <- tempfile("shared-")
  dir.create(folder)
  folder
}

words_of_speed <- function(speed) {
  list(now = list(base = "towed_cable", edits = list(towing.speed = speed)))
}

key_of <- function(digit) strrep(digit, 32)

test_that("shared design returns unchanged and only its owner's key changes it", {
  folder <- new_folder()
  shared <- new_shared(folder)
  words <- words_of_speed("5 knot")
  other <- "only that browser can change it"
  shared$put("S\u00f8ren", key_of("a"), "../../my net", words)
  expect_identical(shared$words("S\u00f8ren", "../../my net")$now, words$now)
  expect_identical(shared$list()[[1]][c("author", "name")],
    list(author = "S\u00f8ren", name = "../../my net"))
  expect_error(shared$put("S\u00f8ren", key_of("b"), "../../my net", words_of_speed("6 knot")),
    other, class = "codend_error_argument")
  expect_error(shared$take_out("S\u00f8ren", key_of("b"), "../../my net"), other)
  expect_identical(shared$words("S\u00f8ren", "../../my net")$now, words$now)
  # another server of the folder accepts the key, which is not stored as text
  again <- new_shared(folder)
  again$put("S\u00f8ren", key_of("a"), "../../my net", words_of_speed("6 knot"))
  expect_identical(again$words("S\u00f8ren", "../../my net")$now, words_of_speed("6 knot")$now)
  expect_null(again$words("S\u00f8ren", "../../my net")$owner)
  texts <- unlist(lapply(list.files(folder, full.names = TRUE), readLines, warn = FALSE))
  expect_false(any(grepl(key_of("a"), texts, fixed = TRUE)))
  # no name refers outside the folder
  expect_true(all(grepl("^[0-9a-f-]+[.]json$", list.files(folder, all.files = TRUE, no.. = TRUE))))
  expect_length(list.files(dirname(folder), "my net"), 0L)
  shared$take_out("S\u00f8ren", key_of("a"), "../../my net")
  expect_length(shared$list(), 0L)
  expect_error(shared$words("S\u00f8ren", "../../my net"), "no longer in the folder")
})

test_that("new_shared() rejects wrong or large input and writes nothing", {
  folder <- new_folder()
  shared <- new_shared(folder)
  words <- words_of_speed("5 knot")
  for (name in list(NULL, 1, "", " \n", strrep("a", 31), NA_character_, c("a", "b"), list("a"))) {
    expect_error(shared$put(name, key_of("a"), "net", words), "name of the author")
    expect_error(shared$put("Anna", key_of("a"), name, words), "name of the design")
  }
  # a zero-width space, a direction mark, a combining accent, a ligature, letters of full width and
  # of mathematics, a letter in a circle, a wide space, blank letters, a Cyrillic letter
  for (name in c("An\u200bna", "\u202eAnna", "Ande\u0301", "\ufb01n", "\uff21nna", "\U1d400nna",
    "\u24b6nna", "Anna\u00a0x", "Anna\u3164", "Anna\u2800", "\u0410nna")) {
    expect_error(shared$put(name, key_of("a"), "net", words), "invisible, combining or decorated")
  }
  for (key in list(NULL, "short", strrep("g", 32), 123456, NA_character_)) {
    expect_error(shared$put("Anna", key, "net", words), "no key")
  }
  large <- list(now = list(plan = strrep("x", most_shared_bytes)))
  expect_error(shared$put("Anna", key_of("a"), "net", large), "too large")
  # letters with accents, of another alphabet, and punctuation
  for (name in c("\u00c8ve d\u2019Or", "\u0410\u043d\u043d\u0430", "A & B \u2013 2")) {
    expect_match(hex_of_name(name, "author"), "^[0-9a-f]+$")
  }
  expect_identical(list.files(folder, all.files = TRUE, no.. = TRUE), character())
  # files that are not designs
  writeLines("{", file.path(folder, "61-62.json"))
  writeLines("x", file.path(folder, "passwd"))
  expect_identical(shared$list()[[1]][c("author", "name")], list(author = "a", name = "b"))
  expect_error(shared$words("a", "b"), "damaged")
  expect_error(shared$put("a", key_of("a"), "b", words), "damaged")
})

test_that("new_shared() neither reads nor writes through a symbolic link", {
  skip_on_os("windows")
  folder <- new_folder()
  outside <- tempfile("outside-")
  writeLines("{}", outside)
  # the file of design "b" by author "a"
  file.symlink(outside, file.path(folder, "61-62.json"))
  shared <- new_shared(folder)
  words <- words_of_speed("5 knot")
  expect_error(shared$put("a", key_of("a"), "b", words), "only that browser")
  expect_error(shared$words("a", "b"), "no longer in the folder")
  expect_error(shared$take_out("a", key_of("a"), "b"), "no longer in the folder")
  expect_identical(readLines(outside), "{}")
})

test_that("pages share designs as copies and receive changes", {
  folder <- new_folder()
  in_flume("towed_cable", folder = folder, function(session, sent, tank) {
    edits <- list(towing.speed = list(value = 4.1, unit = "knot"))
    words <- list(now = list(base = "towed_cable", edits = list(edits)), owner = "me")
    session$hear(shared = list(act = "put", author = "Anna", key = key_of("a"), name = "Net",
      words = words))
    told <- sent("flume_shared")
    expect_identical(told[[length(told)]]$designs[[1]]$name, "Net")
  })
  in_flume(NULL, folder = folder, function(session, sent, tank) {
    expect_identical(sent("flume_shared")[[1]]$designs[[1]]$author, "Anna")
    session$hear(shared_open = list(number = 3, asked = list(author = "Anna", name = "Net")))
    told <- sent("flume_words")[[1]]
    expect_identical(told$answers, 3)
    expect_identical(sent_design(told$words$now)$plan$towing$speed, "4.1 knot")
    expect_null(told$words$owner)
    sent("flume_refused")
    session$hear(shared_open = list(number = 4, asked = list(author = "..", name = "/etc")))
    told <- sent("flume_refused")[[1]]$message
    expect_match(told, "no longer in the folder")
    session$hear(shared = list(act = "take_out", author = "Anna", key = key_of("b"),
      name = "Net"))
    told <- sent("flume_refused")[[1]]$message
    expect_match(told, "only that browser can change it")
  })
  expect_error(flume(folder = file.path(folder, "none")), "folder", class = "codend_error_argument")
})
