# Files that the flume tank's page saves.

drawing_page <- "A3"

# Returns the files by name: list(ending of the file name, of, write(x, file)). `x` is the data of
# the page (`of` is "tank"), or in the slow worker the state or the serialised trajectory.
tank_files <- function() {
  file <- function(of, ending, write) list(of = of, ending = ending, write = write)
  of_state <- function(ending, write) file("state", ending, write)
  of_page <- function(what) {
    file("tank", paste0("-", what, ".csv"), function(tank, file) {
      write_csv(as.data.frame(tank$state, what = what), file)
    })
  }
  formats <- lapply(formats_of("state"), function(format) {
    of_state(paste0("-", format$name, format$extension), format$write)
  })
  # drawings have the format of the file's extension
  drawings <- lapply(c(drawing_svg = "svg", drawing_pdf = "pdf", drawing_dxf = "dxf"),
    function(format) {
      of_state(paste0("-drawing.", format), function(state, file) {
        plot(state$gear, file = file, page = drawing_page)
      })
    })
  tows <- Map(function(name, one) {
    file("trajectory", paste0("-tow-", name, ".", one$extension), function(trajectory, file) {
      one$write(unserialize(trajectory), file)
    })
  }, names(tow_saves), tow_saves)
  c(list(
    plan = file("tank", ".yaml", function(tank, file) write_gear(tank$gear, file)),
    vary = file("tank", "-varied.csv", function(tank, file) {
      write_csv(varied_table(tank$varied), file)
    }),
    measures = of_page("measures"), drag = of_page("drag"),
    planes = of_state("-planes.svg", function(state, file) plot(state, file = file)),
    slopes = of_state("-slopes.csv", function(state, file) {
      write_csv(as.data.frame(unclass(sensitivities(state))), file)
    }),
    report = of_state(".html", report), share = of_state("-living.html", share)
  ), formats, drawings, stats::setNames(tows, paste0("tow_", names(tows))))
}

# Returns the handler that sends the file of a name to the page.
flume_saves <- function(page) {
  tank <- page$tank
  list(save_wanted = function(given) {
    one <- if (is_text(given)) tank_files()[[given]]
    if (is.null(one)) return()
    name <- paste0(file_strings(tank$gear$plan$name), one$ending)
    file <- tempfile(fileext = sub(".*([.][a-z0-9]+)$", "\\1", one$ending))
    hand_over <- function(...) {
      on.exit(unlink(file))
      page$send_bytes(with_header(list(file = name), readBin(file, "raw", file.size(file))))
    }
    if (one$of == "tank") {
      if (page$trying("save", one$write(tank, file))) hand_over()
    } else {
      page$request_slow_worker("save", list(name = given, file = file,
        trajectory = if (one$of == "trajectory") tank$trajectory), hand_over)
    }
  })
}

# Converts a gear's name to a part of a file name.
file_strings <- function(name) {
  words <- gsub("[^a-z0-9]+", "-", tolower(iconv(name, to = "ASCII//TRANSLIT", sub = "")))
  words <- gsub("^-|-$", "", substr(words, 1, 60))
  if (is.na(words) || !nzchar(words)) "gear" else words
}
