# Designs that visitors of a tank share in a folder of the server: a file for each design and a file
# for the password of each author. File names are hexadecimal, so that no name leads out of the
# folder.

# Limits of a folder: authors, designs, bytes of a design and characters of a name. After
# `most_wrong_words` wrong passwords an author's designs are locked for `wrong_words_rest` s.
most_authors <- 300L
most_shared <- 1000L
most_shared_bytes <- 3e5
most_shared_name <- 30L
most_wrong_words <- 5L
wrong_words_rest <- 60

# Returns functions for a folder. list() returns list(author, name, changed) of each design, latest
# first. The functions put(author, word, name, words), take_out(author, word, name) and
# words(author, name) write, remove and read a design as from tank$words(). now: clock [s].
new_shared <- function(folder, now = function() proc.time()[["elapsed"]]) {
  wrong <- list()
  # Checks an author's password. A new author gets this password.
  check_word <- function(author, word) {
    if (!is_text(word) || !nchar(word) %in% 6:100) {
      abort_argument("The password must have 6 to 100 characters.")
    }
    file <- author_file(folder, author)
    if (!file.exists(file)) {
      authors <- list.files(folder, "[.]author$")
      if (length(authors) >= most_authors) {
        abort_argument("The folder of shared designs is full: it has the maximum number of
          authors.")
      }
      salt <- digest::digest(list(author, Sys.time(), tempfile(), Sys.getpid()), algo = "sha256")
      known <- list(salt = salt, check = word_check(word, salt))
      return(write_text(jsonlite::toJSON(known, auto_unbox = TRUE), file))
    }
    key <- basename(file)
    missed <- wrong[[key]]
    if (isTRUE(missed$count >= most_wrong_words) && now() - missed$since < wrong_words_rest) {
      abort_argument("Too many wrong passwords for this author; try again in a minute.")
    }
    known <- jsonlite::read_json(file)
    if (identical(word_check(word, known$salt), known$check)) {
      wrong[[key]] <<- NULL
      return(invisible())
    }
    wrong[[key]] <<- list(count = first_of(missed$count, 0L) %% most_wrong_words + 1L,
      since = now())
    abort_argument("The password of {.val {author}} is wrong. Only {.val {author}} can change these
      designs.")
  }
  list(
    list = function() shared_designs(folder),
    put = function(author, word, name, words) {
      file <- design_file(folder, author, name)
      text <- design_json(words)
      if (nchar(text, "bytes") > most_shared_bytes) {
        abort_argument("The designs are too large to be shared; remove some of the kept designs.")
      }
      if (!file.exists(file) && length(shared_designs(folder)) >= most_shared) {
        abort_argument("The folder of shared designs is full; remove a design first.")
      }
      check_word(author, word)
      write_text(c(text, ""), file)
    },
    take_out = function(author, word, name) {
      file <- there(design_file(folder, author, name))
      check_word(author, word)
      unlink(file)
    },
    words = function(author, name) {
      file <- there(design_file(folder, author, name))
      words <- if (file.size(file) <= 2 * most_shared_bytes) {
        tryCatch(jsonlite::read_json(file), error = function(e) NULL)
      }
      if (!is_map(words)) abort_argument("The file of this design is damaged.")
      words
    }
  )
}

# words: from tank$words().
design_json <- function(words) {
  as.character(jsonlite::toJSON(
    c(list(codend_designs = 1), words), auto_unbox = TRUE, digits = NA, null = "null"
  ))
}

shared_designs <- function(folder) {
  files <- list.files(folder, "^([0-9a-f]{2})+-([0-9a-f]{2})+[.]json$", full.names = TRUE)
  changed <- file.mtime(files)
  lapply(order(changed, decreasing = TRUE), function(k) {
    names <- strsplit(sub("[.]json$", "", basename(files[k])), "-", fixed = TRUE)[[1L]]
    list(
      author = name_of_hex(names[1L]), name = name_of_hex(names[2L]),
      changed = format(changed[k], "%Y-%m-%d %H:%M")
    )
  })
}

author_file <- function(folder, author) {
  file.path(folder, paste0(hex_of_name(author, "author"), ".author"))
}
design_file <- function(folder, author, name) {
  words <- c(hex_of_name(author, "author"), hex_of_name(name, "design"))
  file.path(folder, paste0(paste(words, collapse = "-"), ".json"))
}

# Returns the bytes of a trimmed name as hexadecimal digits, which every system accepts in file
# names.
hex_of_name <- function(name, of) {
  name <- if (is_text(name) && validUTF8(enc2utf8(name))) design_name(name, "") else ""
  bytes <- charToRaw(enc2utf8(name))
  if (!length(bytes) || nchar(name) > most_shared_name || length(bytes) > 2L * most_shared_name) {
    abort_argument("The name of the {of} must have 1 to {most_shared_name} characters.")
  }
  paste(bytes, collapse = "")
}
name_of_hex <- function(hex) {
  at <- seq(1L, nchar(hex), 2L)
  bytes <- as.raw(strtoi(substring(hex, at, at + 1L), 16L))
  name <- rawToChar(bytes[bytes != 0])
  Encoding(name) <- "UTF-8"
  if (validUTF8(name)) name else hex
}

# Returns a hash of a password that is slow to compute, so that many guesses take long.
word_check <- function(word, salt) {
  check <- enc2utf8(word)
  for (k in 1:2000) check <- digest::hmac(salt, check, "sha256")
  check
}

there <- function(file) {
  if (!file.exists(file)) abort_argument("This design is no longer in the folder.")
  file
}

# ---- on the page ---------------------------------------------------------------------------------

# Lists the folder, opens copies, and shares and removes designs. changed: counter of changes for
# all pages; open_words(words, number): opens the designs of an address.
flume_shares <- function(input, tank, shared, changed, said, trying, open_words) {
  shiny::observe({
    changed()
    said("flume_shared", designs = shared$list())
  })
  shiny::observeEvent(input$shared, {
    given <- as.list(input$shared)
    act <- if (is_text(given$act)) given$act else ""
    good <- trying("shared", switch(act,
      put = if (!is.null(tank$gear)) {
        shared$put(given$author, given$word, given$name, tank$words())
      },
      take_out = shared$take_out(given$author, given$word, given$name)
    ))
    if (good) {
      said("flume_shared_done")
      changed(shiny::isolate(changed()) + 1L)
    }
  })
  shiny::observeEvent(input$shared_open, {
    given <- as.list(input$shared_open)
    asked <- as.list(given$asked)
    number <- if (is.numeric(given$number)) given$number[1L] else 0
    words <- NULL
    if (trying("words", words <- shared$words(asked$author, asked$name), number)) {
      open_words(words, number)
    }
  })
}

shared_list <- function(say) {
  tags <- shiny::tags
  list(tags$h2(say("shared_heading")), tags$ul(class = "shared-list"))
}

# The list and a form to share designs.
shared_form <- function(say) {
  tags <- shiny::tags
  text <- function(id, label, type = "text") {
    tags$label(label, tags$input(type = type, id = id, class = "form-control form-control-sm",
      autocomplete = "off", maxlength = if (type == "text") most_shared_name else 100L))
  }
  tags$section(
    id = "shared", shared_list(say), tags$p(class = "note", say("shared_note")),
    tags$div(
      class = "shared-asks", text("shared_author", say("shared_author")),
      text("shared_word", say("shared_word"), "password"),
      text("shared_name", say("shared_name"))
    ),
    tags$button(type = "button", id = "shared_put", class = "btn btn-primary btn-sm",
      say("shared_put")),
    tags$p(id = "shared_error", class = "field-error", role = "alert", hidden = NA)
  )
}
