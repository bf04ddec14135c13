# Returns the TypeScript sources of pages in a folder or file below web/src. Skips the test if the
# package is tested without its repository.
web_source <- function(path) {
  place <- test_path("..", "..", "web", "src", path)
  skip_if_not(file.exists(place), "the sources of pages are not here")
  files <- if (dir.exists(place)) list.files(place, "[.]tsx?$", full.names = TRUE) else place
  paste(unlist(lapply(files, readLines, encoding = "UTF-8")), collapse = "\n")
}
