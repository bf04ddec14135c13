# Fails if the index of the site (_pkgdown.yml) or a page is incomplete:
#
# - a help page lacks an example, a see-also or a group in the index
# - a guide lacks a group, or the index names a missing page or guide
# - a guide defines a function with the name of an exported one: R CMD build computes all guides in
# one
#   session, where a later guide would call that function

pages <- list.files("man", "[.]Rd$", full.names = TRUE)
text <- lapply(pages, readLines, warn = FALSE)
has <- function(pattern) vapply(text, function(page) any(grepl(pattern, page)), NA)
name <- sub("[.]Rd$", "", basename(pages))

grouped <- function(part) {
  unlist(lapply(yaml::read_yaml("_pkgdown.yml")[[part]], `[[`, "contents"))
}
topics <- grouped("reference")
guides <- grouped("articles")
vignettes <- sub("[.]Rmd$", "", list.files("vignettes", "[.]Rmd$", recursive = TRUE))
exported <- grep("^export[(]", readLines("NAMESPACE"), value = TRUE)
exported <- sub("^export[(](.*)[)]$", "\\1", exported)
masked <- function(vignette) {
  lines <- readLines(file.path("vignettes", paste0(vignette, ".Rmd")), warn = FALSE)
  made <- "^([A-Za-z_.]+) <- function[(].*"
  intersect(sub(made, "\\1", grep(made, lines, value = TRUE)), exported)
}
masks <- unlist(lapply(vignettes, function(vignette) {
  sprintf("vignettes/%s.Rmd defines %s(), which codend exports", vignette, masked(vignette))
}))
wrong <- c(
  masks,
  sprintf("man/%s.Rd has no example", name[!has("^.examples")]),
  sprintf("man/%s.Rd has no see-also", name[!has("^.seealso")]),
  sprintf("man/%s.Rd is in no group of _pkgdown.yml", setdiff(name[!has("internal")], topics)),
  sprintf("_pkgdown.yml lists the page %s, which does not exist", setdiff(topics, name)),
  sprintf("vignettes/%s.Rmd is in no group of _pkgdown.yml", setdiff(vignettes, guides)),
  sprintf("_pkgdown.yml lists the vignette %s, which does not exist", setdiff(guides, vignettes))
)
if (length(wrong)) {
  cat(wrong, sep = "\n")
  quit(status = 1)
}
