# Designs that visitors of a tank share in a folder of the server, one file each. File names are
# hexadecimal, so that no name leads out of the folder. A file contains the hash of its owner's key,
# which the owner's browser draws at random and keeps: only this browser can change the design.

# Limits: designs in a folder, bytes of a design, and characters of a name.
most_shared <- 1000L
most_shared_bytes <- 3e5
most_shared_name <- 30L

# Returns functions for a folder. list() returns list(author, name, changed) of each design, latest
# first. put(author, key, name, words, add) writes a design, and calls add() before it adds one to
# the folder. take_out(author, key, name) removes a design, and words(author, name) reads one as
# the page sent it. listen(act) calls act(designs) now and after each changed(), until ignore() of
# its result.
new_shared <- function(folder) {
  listening <- new.env(parent = emptyenv())
  list(
    listen = function(act) {
      id <- basename(tempfile(""))
      assign(id, act, listening)
      act(shared_designs(folder))
      id
    },
    ignore = function(id) remove(list = id, envir = listening),
    changed = function() {
      designs <- shared_designs(folder)
      for (act in as.list(listening)) act(designs)
    },
    list = function() shared_designs(folder),
    put = function(author, key, name, words, add = function() NULL) {
      file <- design_file(folder, author, name)
      text <- design_json(words, owner_of(key))
      if (nchar(text, "bytes") > most_shared_bytes) {
        abort_argument("The designs are too large to be shared; remove some of the kept designs.")
      }
      if (is_there(file)) {
        check_owner(file, key)
        return(write_text(c(text, ""), file))
      }
      if (length(shared_designs(folder)) >= most_shared) {
        abort_argument("The folder of shared designs is full; remove a design first.")
      }
      add()
      # A link to a complete file neither overwrites a file nor follows a symbolic link.
      complete <- tempfile(tmpdir = folder)
      on.exit(unlink(complete))
      write_text(c(text, ""), complete)
      if (!suppressWarnings(file.link(complete, file))) abort_other_owner(author)
    },
    take_out = function(author, key, name) {
      file <- there(design_file(folder, author, name))
      check_owner(file, key)
      unlink(file)
    },
    words = function(author, name) {
      words <- shared_words(there(design_file(folder, author, name)))
      words[names(words) != "owner"]
    }
  )
}

# Returns the hash of a key. Nobody can guess a random key of 128 bits, so a fast hash is enough.
owner_of <- function(key) {
  if (!is_text(key) || !grepl("^[0-9a-f]{32}$", key)) {
    abort_argument("This browser has no key for shared designs; reload the page.")
  }
  cli::hash_sha256(key)
}

check_owner <- function(file, key) {
  if (!identical(shared_words(file)$owner, owner_of(key))) {
    abort_other_owner(name_of_hex(sub("-.*", "", basename(file))))
  }
}

abort_other_owner <- function(author) {
  abort_argument(paste(
    "{.val {author}} shared this design from another browser, and only that browser can change it.",
    "Choose another name."
  ))
}

# Returns the content of the file of a design.
shared_words <- function(file) {
  words <- if (file.size(file) <= 2 * most_shared_bytes) {
    tryCatch(jsonlite::read_json(file), error = function(e) NULL)
  }
  if (!is_map(words)) abort_argument("The file of this design is damaged.")
  words
}

# words: designs as the page sends them; owner: from owner_of().
design_json <- function(words, owner) {
  words <- words[intersect(names(words), c("now", "kept", "draft", "own", "units"))]
  to_json(c(list(codend_designs = 1), words, list(owner = owner)), NA)
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

design_file <- function(folder, author, name) {
  words <- c(hex_of_name(author, "author"), hex_of_name(name, "design"))
  file.path(folder, paste0(paste(words, collapse = "-"), ".json"))
}

# Characters that names must not have: control characters, marks, blank letters, letters of two
# alphabets that look the same, and characters that NFKC replaces. NFKC replaces other spaces, forms
# of presentation, half and full width, letters in circles and squares, and mathematical letters.
unclear_characters <- paste0(
  "(*UTF)\\p{Latin}.*[\\p{Greek}\\p{Cyrillic}]|[\\p{Greek}\\p{Cyrillic}].*\\p{Latin}|[\\p{C}\\p{M}",
  "\\p{Lm}\\p{No}\\x{A0}\\x{115F}\\x{1160}\\x{1680}\\x{2000}-\\x{200A}\\x{2028}-\\x{202F}\\x{205F}",
  "\\x{2800}\\x{3000}\\x{3164}\\x{2100}-\\x{218F}\\x{2460}-\\x{24FF}\\x{3200}-\\x{33FF}",
  "\\x{F900}-\\x{FDFF}\\x{FE70}-\\x{FEFF}\\x{FF00}-\\x{FFEF}\\x{1D400}-\\x{1D7FF}",
  "\\x{1F100}-\\x{1F2FF}]"
)

# Returns the bytes of a trimmed name as hexadecimal digits, which every system accepts in file
# names.
hex_of_name <- function(name, of) {
  name <- if (is_text(name) && validUTF8(enc2utf8(name))) design_name(name, "") else ""
  bytes <- charToRaw(enc2utf8(name))
  if (!length(bytes) || nchar(name) > most_shared_name || length(bytes) > 2L * most_shared_name) {
    abort_argument("The name of the {of} must have 1 to {most_shared_name} characters.")
  }
  # Two names that look the same would otherwise be different. The page sends names in the form
  # NFKC.
  if (grepl(unclear_characters, name, perl = TRUE)) {
    abort_argument("The name of the {of} must not have invisible, combining or decorated
      characters.")
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

is_there <- function(file) file.exists(file) && identical(Sys.readlink(file), "")

there <- function(file) {
  if (!is_there(file)) abort_argument("This design is no longer in the folder.")
  file
}

# ---- on the page ---------------------------------------------------------------------------------

# Returns the handlers that share, remove and open designs. visitor: from new_visitors().
flume_shares <- function(page, shared, visitor) {
  list(
    shared = function(given) {
      given <- as.list(given)
      act <- if (is_text(given$act)) given$act else ""
      good <- page$trying("shared", {
        visitor$change()
        switch(act,
          put = if (!is.null(page$tank$gear)) {
            shared$put(given$author, given$key, given$name, as.list(given$words), visitor$add)
          },
          take_out = shared$take_out(given$author, given$key, given$name)
        )
      })
      if (!good) return()
      page$said("flume_shared_done")
      shared$changed()
    },
    shared_open = function(given) {
      asked <- as.list(as.list(given)$asked)
      number <- request_number(given)
      words <- NULL
      if (page$trying("words", words <- shared$words(asked$author, asked$name), number)) {
        page$said("flume_words", answers = number, words = words)
      }
    }
  )
}
