# Files that the flume tank's page saves. The slow worker writes files that take long.

# Files that are written at once: list(ending of the file name, write(tank, file)).
quick_files <- list(
  plan = list(".yaml", function(tank, file) write_gear(tank$gear, file)),
  vary = list("-varied.csv", function(tank, file) write_csv(varied_table(tank$varied), file)),
  drag = list("-drag.csv", function(tank, file) {
    write_csv(as.data.frame(tank$state, what = "drag"), file)
  })
)

# Returns a file that the page requests by name: list(ending, write(file)), or list(ending, kind,
# request), the request to the worker without the path of the file. NULL for an unknown name.
tank_file <- function(name, tank) {
  quick <- quick_files[[name]]
  if (!is.null(quick)) {
    return(list(ending = quick[[1L]], write = function(file) quick[[2L]](tank, file)))
  }
  if (name == "slopes" && !is.null(tank$slopes)) {
    return(list(ending = "-slopes.csv", write = function(file) {
      write_csv(as.data.frame(unclass(tank$slopes)), file)
    }))
  }
  tow <- sub("^tow_", "", name)
  if (tow != name) {
    if (is.null(tow_saves[[tow]])) return(NULL)
    return(list(
      ending = paste0("-tow-", tow, ".", tow_saves[[tow]]$extension), kind = "save_tow",
      request = list(name = tow, trajectory = tank$trajectory)
    ))
  }
  of_state <- function(ending, format) {
    list(ending = ending, kind = "save", request = list(format = format))
  }
  drawing <- sub("^drawing_", "", name)
  if (drawing %in% drawing_formats) return(of_state(paste0("-drawing.", drawing), "drawing"))
  endings <- c(slopes = "-slopes.csv", report = ".html", share = "-living.html")
  if (name %in% names(endings)) return(of_state(endings[[name]], name))
  format <- Find(function(format) format$name == name, formats_of("state"))
  if (!is.null(format)) of_state(paste0("-", name, format$extension), name)
}

drawing_formats <- c("svg", "pdf", "dxf")

# Sends the file of a name to the page.
flume_saves <- function(page) {
  tank <- page$tank
  list(save_wanted = function(given) {
    one <- if (is_text(given) && !is.null(tank$gear)) tank_file(given, tank)
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
