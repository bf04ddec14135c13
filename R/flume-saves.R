# Downloads of the flume tank. The slow worker writes files that take long.

flume_saves <- function(output, tank, clerk) {
  save <- function(name, extension, write) {
    shiny::downloadHandler(
      filename = function() paste0(file_strings(tank$gear$plan$name), name, ".", extension),
      content = write
    )
  }
  table <- function(make) function(file) write_csv(make(), file)
  of_state <- function(format) {
    function(file) {
      on_slow_worker(clerk, "save", file, function() {
        tank$request("save", list(format = format, file = file))
      })
    }
  }
  output$save_plan <- save("", "yaml", function(file) write_gear(tank$gear, file))
  output$save_all <- save("-designs", "json", function(file) {
    write_text(c(design_json(tank$words()), ""), file)
  })
  output$save_measures <- save("-measures", "csv", table(function() {
    measure_changes(tank$measures, tank$kept[[1L]]$measures)
  }))
  output$save_designs <- save("-designs", "csv", table(function() {
    designs_frame(c(tank$kept, list(list(name = "On screen", measures = tank$measures))))
  }))
  lapply(formats_of("state"), function(format) {
    output[[paste0("save_", format$name)]] <- save(
      paste0("-", format$name), sub(".", "", format$extension, fixed = TRUE),
      of_state(format$name)
    )
  })
  output$save_vary <- save("-varied", "csv", table(function() varied_table(tank$varied)))
  output$save_drag <- save("-drag", "csv", table(function() {
    as.data.frame(tank$state, what = "drag")
  }))
  output$save_code <- save("", "R", function(file) write_text(c(tank$code(), ""), file))
  for (extension in drawing_formats) {
    local({
      extension <- extension
      output[[paste0("save_drawing_", extension)]] <- save("-drawing", extension,
        of_state("drawing"))
    })
  }
  output$save_report <- save("", "html", of_state("report"))
  output$save_share <- save("-living", "html", of_state("share"))
  output$save_slopes <- save("-slopes", "csv", function(file) {
    write <- function(slopes) write_csv(as.data.frame(unclass(slopes)), file)
    if (!is.null(tank$slopes)) return(write(tank$slopes))
    found <- promised(clerk, "slopes", function() tank$request("slopes", NULL))
    promises::then(found, write)
  })
}

drawing_formats <- c("svg", "pdf", "dxf")

# Returns a promise of the worker's answer.
promised <- function(clerk, kind, make) {
  promises::promise(function(resolve, reject) {
    clerk$ask(kind, make, function(answer) {
      if (is.null(answer)) return(reject("A newer request has replaced this one."))
      if (is.null(answer$problem)) resolve(answer$found) else reject(answer$problem$message)
    })
  })
}

# Returns a promise of a file that the worker writes.
on_slow_worker <- function(clerk, kind, file, make) {
  promises::then(promised(clerk, kind, make), function(found) file)
}

# Converts a gear's name to a part of a file name.
file_strings <- function(name) {
  words <- gsub("[^a-z0-9]+", "-", tolower(iconv(name, to = "ASCII//TRANSLIT", sub = "")))
  words <- gsub("^-|-$", "", substr(words, 1, 60))
  if (is.na(words) || !nzchar(words)) "gear" else words
}
