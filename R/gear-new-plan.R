# Plans to begin with.

# What each kind is asked for, as it is taken where nobody says: a text with a unit. make: of its
# text from SI numbers; or like: the shipped plan that it begins with, and scale: the fields that
# these numbers change in it (without it they are asked for by path). usual: what is usual for the
# numbers that are given, where that is not always the same.
new_plan_kinds <- function() {
  trawl <- c(head_line = "25 m", mesh_size = "100 mm", codend_mesh_size = "80 mm",
    speed = "3 knot", depth = "100 m")
  list(
    bottom_trawl = list(asks = trawl, make = new_bottom_trawl, usual = usual_bottom_meshes),
    midwater_trawl = list(
      asks = c(head_line = "50 m", mesh_size = "4 m", codend_mesh_size = "40 mm",
        speed = "4 knot", depth = "150 m"),
      make = new_midwater_trawl, usual = usual_midwater_meshes
    ),
    beam_trawl = list(
      asks = c(beam = "4 m", mesh_size = "100 mm", codend_mesh_size = "80 mm", speed = "4 knot",
        depth = "30 m"),
      make = new_beam_trawl
    ),
    pair_trawl = list(
      asks = replace(trawl, "depth", "60 m"), make = new_pair_trawl, usual = usual_bottom_meshes
    ),
    demersal_seine = list(
      asks = c(head_line = "36 m", mesh_size = "120 mm", codend_mesh_size = "100 mm",
        rope = "1760 m", speed = "2 knot", depth = "80 m"),
      make = new_demersal_seine, usual = usual_seine_meshes
    ),
    cage = list(
      asks = c(diameter = "40 m", depth = "15 m", mesh_size = "50 mm", current = "0.5 m/s"),
      like = "cage", scale = scaled_cage
    ),
    gillnet = list(
      asks = c(length = "50 m", height = "3.2 m", mesh_size = "150 mm", depth = "40 m",
        current = "0.15 m/s"),
      like = "gillnet", scale = scaled_gillnet
    ),
    longline = list(
      asks = c(baskets = "3", branch_lines = "15", main_line = "800 m", branch_line = "15 m"),
      like = "longline", scale = scaled_longline
    ),
    purse_seine = list(
      asks = c(length = "300 m", depth = "50 m", mesh_size = "25.4 mm"),
      like = "purse_seine", scale = scaled_purse_seine
    ),
    stow_net = list(
      asks = c(width = "8 m", height = "5 m", mesh_size = "200 mm", codend_mesh_size = "30 mm",
        current = "0.8 m/s"),
      like = "stow_net", scale = scaled_stow_net
    ),
    dip_net = list(asks = character(), like = "dip_net")
  )
}

#' A plan to begin with
#'
#' Writes a commented plan of some forty lines that settles as it is, to be changed line by line.
#' All of it follows from a few numbers: lengths, areas, twines, ropes, boards, weights and floats
#' grow with the size, so that mouth, spread, drag and the loads of ropes lie in the bands that are
#' published for gear of that kind and size (see [findings()]).
#'
#' | kind | what it needs | sizes that are tested |
#' |---|---|---|
#' | `bottom_trawl` | `head_line`, `mesh_size`, `codend_mesh_size`, `speed`, `depth` | 8 to 80 m |
#' | `midwater_trawl` | the same; `mesh_size` is that of the front | 15 to 250 m, meshes to 64 m |
#' | `pair_trawl` | as `bottom_trawl` | 10 to 60 m |
#' | `demersal_seine` | the same and `rope`, the length of each of its two ropes | 20 to 60 m |
#' | `beam_trawl` | `beam`, `mesh_size`, `codend_mesh_size`, `speed`, `depth` | 2 to 12 m |
#' | `gillnet` | `length`, `height` (hung), `mesh_size`, `depth`, `current` | |
#' | `longline` | `baskets`, `branch_lines` in one, lengths `main_line` and `branch_line` | |
#' | `purse_seine` | `length`, `depth` (stretched), `mesh_size` | |
#' | `stow_net` | `width`, `height`, `mesh_size`, `codend_mesh_size`, `current` | |
#' | `cage` | `diameter`, `depth`, `mesh_size`, `current` | |
#' | `dip_net` | any field of the plan by its path | |
#'
#' Of the last six kinds it is the shipped plan of that kind, scaled; there any other field may be
#' given by its path too, such as `wall.twine.diameter`. Meshes of trawls that are left out are
#' those usual for the head line.
#'
#' @param kind Kind of gear.
#' @param ... What the plan is made of, by name, as text with a unit (`head_line = "32 m"`); what
#'   is left out is as usual.
#' @param file `NULL`, or the path of the plan file to write.
#' @param ask Whether to ask at the console for each value, with the usual one in brackets; a number
#'   that is typed without a unit has that one's.
#' @return The gear, checked; invisibly where a file is written. Its text is `format(gear, remarks =
#'   TRUE)`.
#' @seealso [read_gear()] to read it after changes, [settle()] for its shape.
#' @export
#' @examples
#' trawl <- new_plan("bottom_trawl", head_line = "32 m", depth = "80 m")
#' cat(format(trawl, remarks = TRUE))
new_plan <- function(kind, ..., file = NULL, ask = FALSE) {
  check_given("kind")
  kinds <- new_plan_kinds()
  if (!is_text(kind) || !kind %in% names(kinds)) {
    abort_unknown_word("kind", if (missing(kind)) NULL else kind, names(kinds), "one of")
  }
  given <- list(...)
  if (length(given) && (is.null(names(given)) || any(!nzchar(names(given))))) {
    abort_argument("Every value must be named, such as {.code head_line = \"32 m\"}.")
  }
  if (!is.null(file)) check_file_path(file)
  about <- kinds[[kind]]
  if (ask) given <- asked_values(about$asks, given, usual = about$usual)
  new <- if (is.null(about$make)) new_from_shipped else new_from_numbers
  gear <- new(about, given)
  if (is.null(file)) return(gear)
  write_gear(gear, file)
  gear["file"] <- list(file)
  invisible(gear)
}

# Values typed at the console for what is not given; an empty answer takes the usual one, a bare
# number its unit, and what is no such quantity is asked for again.
# from: a connection that is read instead of the console where R is not interactive; usual: as in
# new_plan_kinds().
asked_values <- function(asks, given, from = NULL, usual = NULL) {
  if (is.null(from) && !interactive()) {
    from <- base::file("stdin", "r")
    on.exit(close(from))
  }
  asked <- setdiff(names(asks), names(given))
  if (length(asked)) cat("An empty answer takes the value in brackets.\n", file = stderr())
  for (name in asked) {
    words <- gsub("[._]", " ", name)
    asks <- usual_asks(asks, given, usual)
    repeat {
      typed <- typed_answer(sprintf("%s [%s]: ", words, asks[[name]]), from)
      if (!length(typed) || !nzchar(typed)) break
      given[[name]] <- answer_with_unit(typed, asks[[name]])
      dimension <- quantity_dimension(asks[[name]])
      number <- quantity_si(given[[name]], dimension)
      if (!is.na(number) && number >= 0) break
      cat(sprintf("\"%s\" is no %s; it must be one such as %s.\n", typed, dimension, asks[[name]]),
        file = stderr())
    }
  }
  given
}

# One line from the console or a connection, or nothing where that has ended.
typed_answer <- function(prompt, from) {
  if (is.null(from)) return(trimws(readline(prompt)))
  cat(prompt, file = stderr())
  trimws(readLines(from, 1L))
}

# What is asked for with what is usual for the head line that is given.
usual_asks <- function(asks, given, usual) {
  head_line <- if (!is.null(given$head_line)) quantity_si(given$head_line, "length")
  if (is.null(usual) || !isTRUE(head_line > 0)) return(asks)
  found <- usual(head_line)
  replace(asks, names(found), found)
}

# "32" as "32 m" where "25 m" is usual.
answer_with_unit <- function(typed, usual) {
  found <- split_quantity(typed)
  if (is.null(found) || nzchar(found[2])) return(typed)
  paste(typed, split_quantity(usual)[2])
}

# about: of new_plan_kinds(), with a maker.
new_from_numbers <- function(about, given) {
  check_asked(about, given)
  si <- asked_numbers(about, given)
  if (!is.null(si$head_line) && si$mesh_size > si$head_line / 3.9) {
    abort_argument(paste(
      "{.arg mesh_size} is {.val {si$shown$mesh_size}}; it must be at most a quarter of the head",
      "line."
    ))
  }
  if (si$codend_mesh_size > si$mesh_size) {
    abort_argument(paste(
      "{.arg codend_mesh_size} is {.val {si$shown$codend_mesh_size}}; it must be at most",
      "{.arg mesh_size}, {.val {si$shown$mesh_size}}."
    ))
  }
  gear_of_bytes(charToRaw(enc2utf8(with_plain_numbers(about$make(si)))), "new plan")
}

check_asked <- function(about, given) {
  unknown <- setdiff(names(given), names(about$asks))
  if (!length(unknown)) return(invisible())
  near <- nearest(unknown[1], names(about$asks))
  hint <- if (length(near)) " Did you mean {.arg {near}}?"
  abort_argument(paste0(
    "{.arg {unknown[1]}} is not known here; known are {.arg {names(about$asks)}}.", hint
  ))
}

# What is asked for as SI numbers by name, and in `shown` as it is written.
asked_numbers <- function(about, given) {
  shown <- as.list(usual_asks(about$asks, given, about$usual))
  shown[names(given)] <- given
  si <- lapply(stats::setNames(nm = names(shown)), function(name) {
    # a count has no unit
    dimension <- quantity_dimension(about$asks[[name]])
    if (is.na(dimension)) dimension <- "number"
    value <- shown[[name]]
    good <- is_text(value) || (is.numeric(value) && length(value) == 1L)
    number <- if (good) quantity_si(value, dimension) else NA
    if (is.na(number) || number <= 0) {
      abort_argument("{.arg {name}} is {.val {value}}; it must be a {dimension} greater than 0.")
    }
    number
  })
  si$shown <- Map(function(value, usual) {
    if (!is.numeric(value)) return(value)
    dimension <- quantity_dimension(usual)
    unit <- if (!is.na(dimension)) names(plan_units[[dimension]])[1]
    paste(c(shortest_decimal(value), unit), collapse = " ")
  }, shown, about$asks[names(shown)])
  si
}

# The shipped plan of a kind, without what is of that one gear alone, scaled by the numbers that it
# is asked for; other fields by their path.
new_from_shipped <- function(about, given) {
  gear <- read_gear(about$like)
  plan <- gear$plan
  plan[c("notes", "sources", "tow")] <- NULL
  numbers <- given[names(given) %in% names(about$asks)]
  if (length(numbers)) {
    si <- asked_numbers(about, numbers)
    scaled <- about$scale(si, plan)
    for (path in names(scaled)) plan <- set_plan_field(plan, path, scaled[[path]])
  }
  for (path in setdiff(names(given), names(numbers))) {
    plan <- set_plan_field(plan, path, given[[path]])
  }
  text <- edited_text(gear$source, plan)
  if (length(given)) {
    text <- paste0("# Scaled from the shipped plan `", about$like,
      "`; marks such as [usual] are of that plan's values.\n", text)
  }
  gear_of_bytes(charToRaw(enc2utf8(text)), "new plan")
}
