# Plans to begin with.

# What each kind is asked for, as it is taken where nobody says: a text with a unit. The kinds that
# have no maker begin with the shipped plan of `like`, whose fields these are.
new_plan_kinds <- function() {
  list(
    bottom_trawl = list(
      asks = c(head_line = "25 m", mesh_size = "100 mm", codend_mesh_size = "80 mm",
        speed = "3 knot", depth = "100 m"),
      make = new_bottom_trawl
    ),
    midwater_trawl = list(
      asks = c(head_line = "50 m", mesh_size = "4 m", codend_mesh_size = "40 mm",
        speed = "4 knot", depth = "150 m"),
      make = new_midwater_trawl
    ),
    beam_trawl = list(
      asks = c(towing.speed = "4 knot", seabed.depth = "30 m", warp.length = "90 m"),
      like = "beam_trawl"
    ),
    pair_trawl = list(
      asks = c(towing.speed = "3 knot", seabed.depth = "60 m"), like = "pair_trawl"
    ),
    cage = list(
      asks = c(diameter = "40 m", depth = "15 m", wall.mesh_size = "50 mm",
        water.current.speed = "0.5 m/s"),
      like = "cage"
    ),
    gillnet = list(
      asks = c(wall.mesh_size = "150 mm", seabed.depth = "40 m",
        water.current.speed = "0.15 m/s"),
      like = "gillnet"
    ),
    longline = list(asks = character(), like = "longline"),
    purse_seine = list(asks = character(), like = "purse_seine"),
    stow_net = list(asks = character(), like = "stow_net"),
    dip_net = list(asks = character(), like = "dip_net")
  )
}

#' A plan to begin with
#'
#' Writes a commented plan of some forty lines that settles as it is, to be changed line by line. Of
#' a bottom or a midwater trawl all of it follows from a few numbers; of other kinds it is the
#' shipped plan of that kind with the fields that are given.
#'
#' | kind | what it is asked for |
#' |---|---|
#' | `bottom_trawl` | `head_line`, `mesh_size`, `codend_mesh_size`, `speed`, `depth` |
#' | `midwater_trawl` | the same; `mesh_size` is that of the front |
#' | others | any field of the plan by its path, such as `towing.speed` |
#'
#' The others are `beam_trawl`, `pair_trawl`, `cage`, `gillnet`, `longline`, `purse_seine`,
#' `stow_net` and `dip_net`.
#'
#' @param kind Kind of gear.
#' @param ... What the plan is asked for, by name, as text with a unit (`head_line = "32 m"`); what
#'   is left out is as usual.
#' @param file `NULL`, or the path of the plan file to write.
#' @param ask Whether to ask for each value at the console, with the usual one in brackets; a number
#'   that is typed without a unit has that one's.
#' @return The gear, checked; invisibly where a file is written. Its text is `format(gear, remarks =
#'   TRUE)`.
#' @seealso [read_gear()] to read it after changes, [settle()] for its shape.
#' @export
#' @examples
#' trawl <- new_plan("bottom_trawl", head_line = "32 m", depth = "80 m")
#' cat(format(trawl, remarks = TRUE))
new_plan <- function(kind, ..., file = NULL, ask = FALSE) {
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
  if (ask) given <- asked_values(about$asks, given)
  new <- if (is.null(about$make)) new_from_shipped else new_from_numbers
  gear <- new(about, given)
  if (is.null(file)) return(gear)
  write_gear(gear, file)
  gear["file"] <- list(file)
  invisible(gear)
}

# Values typed at the console for what is not given; an empty answer takes the usual one, a bare
# number its unit, and what is no such quantity is asked for again.
# from: a connection that is read instead of the console where R is not interactive.
asked_values <- function(asks, given, from = NULL) {
  if (is.null(from) && !interactive()) {
    from <- base::file("stdin", "r")
    on.exit(close(from))
  }
  asked <- setdiff(names(asks), names(given))
  if (length(asked)) cat("An empty answer takes what stands in brackets.\n", file = stderr())
  for (name in asked) {
    words <- gsub("[._]", " ", name)
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

# "32" as "32 m" where "25 m" is usual.
answer_with_unit <- function(typed, usual) {
  found <- split_quantity(typed)
  if (is.null(found) || nzchar(found[2])) return(typed)
  paste(typed, split_quantity(usual)[2])
}

# about: of new_plan_kinds(), with a maker.
new_from_numbers <- function(about, given) {
  unknown <- setdiff(names(given), names(about$asks))
  if (length(unknown)) {
    near <- nearest(unknown[1], names(about$asks))
    hint <- if (length(near)) " Did you mean {.arg {near}}?"
    abort_argument(paste0(
      "{.arg {unknown[1]}} is not asked for; known are {.arg {names(about$asks)}}.", hint
    ))
  }
  shown <- as.list(about$asks)
  shown[names(given)] <- given
  si <- lapply(stats::setNames(nm = names(shown)), function(name) {
    dimension <- if (name == "speed") "speed" else "length"
    value <- shown[[name]]
    good <- is_text(value) || (is.numeric(value) && length(value) == 1L)
    number <- if (good) quantity_si(value, dimension) else NA
    if (is.na(number) || number <= 0) {
      abort_argument("{.arg {name}} is {.val {value}}; it must be a {dimension} greater than 0.")
    }
    number
  })
  si$shown <- lapply(shown, function(value) {
    if (is.numeric(value)) shortest_decimal(value) else value
  })
  if (si$mesh_size > si$head_line / 8) {
    abort_argument(
      "{.arg mesh_size} is {.val {shown$mesh_size}}; it must be at most an eighth of the head line."
    )
  }
  if (si$codend_mesh_size > si$mesh_size) {
    abort_argument(paste(
      "{.arg codend_mesh_size} is {.val {shown$codend_mesh_size}}; it must be at most",
      "{.arg mesh_size}, {.val {shown$mesh_size}}."
    ))
  }
  gear_of_bytes(charToRaw(enc2utf8(with_plain_numbers(about$make(si)))), "new plan")
}

# The shipped plan of a kind, without what is of that one gear alone.
new_from_shipped <- function(about, given) {
  gear <- read_gear(about$like)
  plan <- gear$plan
  plan[c("notes", "sources", "tow")] <- NULL
  for (path in names(given)) plan <- set_plan_field(plan, path, given[[path]])
  text <- edited_text(gear$source, plan)
  gear_of_bytes(charToRaw(enc2utf8(text)), "new plan")
}
