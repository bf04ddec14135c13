# Fails where a help page has no example, or stands in no group of the site's index of help
# (_pkgdown.yml), or a vignette in no group of its guides; or where these name what is not there; or
# where a vignette makes a function of a name that codend exports: R CMD build computes all of them
# in one R, so a later one would call it in codend's place.

pages <- list.files("man", "[.]Rd$", full.names = TRUE)
text <- lapply(pages, readLines, warn = FALSE)
has <- function(pattern) vapply(text, function(page) any(grepl(pattern, page)), NA)
name <- sub("[.]Rd$", "", basename(pages))

grouped <- function(part) {
  unlist(lapply(yaml::read_yaml("_pkgdown.yml")[[part]], `[[`, "contents"))
}
topics <- grouped("reference")
guides <- grouped("articles")
vignettes <- sub("[.]Rmd$", "", list.files("vignettes", "[.]Rmd$"))
exported <- grep("^export[(]", readLines("NAMESPACE"), value = TRUE)
exported <- sub("^export[(](.*)[)]$", "\\1", exported)
masked <- function(vignette) {
  lines <- readLines(file.path("vignettes", paste0(vignette, ".Rmd")), warn = FALSE)
  made <- "^([A-Za-z_.]+) <- function[(].*"
  intersect(sub(made, "\\1", grep(made, lines, value = TRUE)), exported)
}
masks <- unlist(lapply(vignettes, function(vignette) {
  sprintf("vignettes/%s.Rmd makes its own %s(), which codend has", vignette, masked(vignette))
}))
wrong <- c(
  masks,
  sprintf("man/%s.Rd has no example", name[!has("^.examples")]),
  sprintf("man/%s.Rd is in no group of _pkgdown.yml", setdiff(name[!has("internal")], topics)),
  sprintf("_pkgdown.yml names the page %s, which is not there", setdiff(topics, name)),
  sprintf("vignettes/%s.Rmd is in no group of _pkgdown.yml", setdiff(vignettes, guides)),
  sprintf("_pkgdown.yml names the vignette %s, which is not there", setdiff(guides, vignettes))
)
if (length(wrong)) {
  cat(wrong, sep = "\n")
  quit(status = 1)
}
