# The gears that a page opens: files it has read, plans typed on it, shipped and new ones. A message
# of a browser may be anything.

# The gear of a file that the page has read: list(name, text). The page sends what is in it and
# never a path, which could be any file of this computer's. It is nowhere that R code could read it
# from.
read_opened <- function(given) {
  given <- as.list(given)
  name <- if (is_text(given$name)) substr(given$name, 1L, 100L) else "on this page"
  read_sent(given$text, name)
}

# The gear of a plan typed on the page; file: of the gear whose plan it was.
read_typed <- function(text, file) {
  gear <- read_sent(text, "on this page")
  gear["file"] <- list(file)
  gear
}

# A gear that codend ships, by its name.
read_shipped <- function(name) {
  if (!is_text(name) || !name %in% names(shipped_plans())) {
    abort_argument("There is no shipped gear of that name.")
  }
  read_gear(name)
}

# A new gear: list(kind, values), texts by what new_plan() asks for.
read_new <- function(said) {
  said <- as.list(said)
  asks <- new_plan_kinds()[[if (is_text(said$kind)) said$kind else ""]]$asks
  values <- as.list(said$values)
  values <- values[names(values) %in% names(asks)]
  good <- vapply(values, function(value) is_text(value) && nchar(value) <= most_characters, NA)
  if (!all(good)) abort_argument("A new gear is asked for by texts such as 25 m.")
  # an empty field is as usual
  values <- values[vapply(values, function(value) nzchar(trimws(value)), NA)]
  values <- Map(typed_quantity, values, asks[names(values)])
  do.call(new_plan, c(list(said$kind), values))
}

read_sent <- function(text, name) {
  if (!is_text(text)) abort_plan("A plan is text.", NULL)
  gear_of_bytes(charToRaw(enc2utf8(text)), name)
}
