# Files that the flume tank's page saves. The slow worker writes files that take long.

# Returns the files by name: list(ending of the file name, write), or list(ending, request), the
# data for the worker without the path of the file. write(file) writes a file at once.
tank_files <- function(tank) {
  table <- function(make) function(file) write_csv(make(), file)
  at_once <- function(ending, write) list(ending = ending, write = write)
  of_state <- function(ending, format) {
    list(ending = ending, kind = "save", request = list(format = format))
  }
  formats <- lapply(formats_of("state"), function(format) {
    of_state(paste0("-", format$name, format$extension), format$name)
  })
  tows <- Map(function(name, one) list(
    ending = paste0("-tow-", name, ".", one$extension), kind = "save_tow",
    request = list(name = name, trajectory = tank$trajectory)
  ), names(tow_saves), tow_saves)
  drawings <- lapply(stats::setNames(nm = drawing_formats), function(extension) {
    of_state(paste0("-drawing.", extension), "drawing")
  })
  c(list(
    plan = at_once(".yaml", function(file) write_gear(tank$gear, file)),
    all = at_once("-designs.json", function(file) {
      write_text(c(design_json(tank$words()), ""), file)
    }),
    measures = at_once("-measures.csv", table(function() {
      measure_changes(tank$measures, tank$kept[[1L]]$measures)
    })),
    designs = at_once("-designs.csv", table(function() {
      designs_frame(c(tank$kept, list(list(name = "On screen", measures = tank$measures))))
    })),
    vary = at_once("-varied.csv", table(function() varied_table(tank$varied))),
    drag = at_once("-drag.csv", table(function() as.data.frame(tank$state, what = "drag"))),
    code = at_once(".R", function(file) write_text(c(tank$code(), ""), file)),
    slopes = if (is.null(tank$slopes)) {
      of_state("-slopes.csv", "slopes")
    } else {
      at_once("-slopes.csv", table(function() as.data.frame(unclass(tank$slopes))))
    },
    report = of_state(".html", "report"), share = of_state("-living.html", "share")
  ), stats::setNames(drawings, paste0("drawing_", drawing_formats)),
  stats::setNames(tows, paste0("tow_", names(tows))), formats)
}

drawing_formats <- c("svg", "pdf", "dxf")

# Sends the file of a name to the page.
flume_saves <- function(page) {
  tank <- page$tank
  list(save_wanted = function(given) {
    one <- if (is_text(given) && !is.null(tank$gear)) tank_files(tank)[[given]]
    if (is.null(one)) return()
    name <- paste0(file_strings(tank$gear$plan$name), one$ending)
    # drawings have the format of the file's extension
    file <- tempfile(fileext = sub(".*([.][a-z0-9]+)$", "\\1", one$ending))
    hand_over <- function(...) {
      on.exit(unlink(file))
      page$send_bytes(with_header(list(file = name), readBin(file, "raw", file.size(file))))
    }
    if (is.null(one$request)) {
      if (page$trying("save", one$write(file))) hand_over()
    } else {
      page$request_slow_worker(one$kind, c(one$request, list(file = file)), hand_over)
    }
  })
}

# Converts a gear's name to a part of a file name.
file_strings <- function(name) {
  words <- gsub("[^a-z0-9]+", "-", tolower(iconv(name, to = "ASCII//TRANSLIT", sub = "")))
  words <- gsub("^-|-$", "", substr(words, 1, 60))
  if (is.na(words) || !nzchar(words)) "gear" else words
}
