# The first message to a page of the flume tank.

# Returns the message: strings, and lists that the page offers. opens: TRUE if the
# tank starts with a gear; shares: TRUE if there is a folder of shared designs.
begin_message <- function(say, opens, shares) {
  c(fixed_lists(attr(say, "language")), list(
    opens = opens, shares = shares, can_share = can_share(), guide = has_measures_guide()
  ))
}

fixed_lists <- remembered(function(language) {
  table <- word_table()
  lapply(c(page_strings(make_translator(language)), list(
    language = language,
    languages = lapply(word_languages(), function(one) {
      list(name = one, words = make_translator(one)("language.name"))
    }),
    checked = nzchar(table[[language]][table$key == "language.checked_by"]),
    catalogue = catalogue_lists(), units = offered_units(), preferred = preferred_units,
    gears = gallery_gears(), kinds = new_gear_kinds(),
    formats = lapply(unname(Filter(has_package, formats_of("state"))), function(format) {
      format[c("name", "title", "extension", "opens")]
    }),
    tow_saves = I(names(Filter(has_package, tow_saves)))
  )), function(x) structure(to_json(x, NA), class = "json"))
})

# TRUE if the package that a format needs is installed.
has_package <- function(format) {
  is.null(format$package) || requireNamespace(format$package, quietly = TRUE)
}
