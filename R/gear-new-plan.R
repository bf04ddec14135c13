# Plans to begin with.

# By kind, of inst/new_plans.yaml, which says what stands there: asks (texts by name), usual (a
# function of the head line, m), numbers and scale (expressions by name), plan (its text), like. A
# kind that is not there begins with the shipped plan of its name.
new_plan_kinds <- remembered(read_new_plans)

read_new_plans <- function() {
  said <- yaml::read_yaml(system.file("new_plans.yaml", package = "codend"))
  kinds <- setdiff(plan_kinds, "assembly")
  own <- lapply(setNames(nm = setdiff(kinds, names(said))), function(kind) list(like = kind))
  lapply(c(said[names(said) != "shared"], own), function(kind) {
    usual <- kind$usual
    kind$asks <- vapply(as.list(kind$asks), identity, "")
    kind$numbers <- unlist(kind$numbers)
    kind$usual <- if (!is.null(usual)) function(h) {
      vapply(usual, function(text) eval(str2lang(text), list(h = h)), "")
    }
    kind
  })
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
  given <- Map(given_value, given, names(given))
  about <- kinds[[kind]]
  if (ask) given <- asked_values(about$asks, given, usual = about$usual)
  new <- if (is.null(about$plan)) new_from_shipped else new_from_numbers
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

# about: of new_plan_kinds(), with a text.
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
  if (!is.null(si$rope) && si$rope < 6 * si$depth) {
    abort_argument(paste(
      "{.arg rope} is {.val {si$shown$rope}}; it must be at least six times the depth of the",
      "sea bed, {.val {si$shown$depth}}."
    ))
  }
  text <- paste(about$plan, collapse = "")
  text <- with_plain_numbers(filled_text(text, known_numbers(about, si)))
  gear_of_bytes(charToRaw(enc2utf8(text)), "new plan")
}

# What a kind's expressions are evaluated in: the numbers that it is asked for (SI), and what
# follows from these.
known_numbers <- function(about, si) {
  known <- list2env(si, parent = topenv())
  for (name in names(about$numbers)) {
    assign(name, eval(str2lang(about$numbers[[name]]), known), known)
  }
  known
}

# A text with the values of the expressions between its backticks, and its remarks in a column where
# there is room.
filled_text <- function(text, known) {
  lines <- strsplit(text, "\n", fixed = TRUE)[[1L]]
  values <- lapply(strsplit(lines, "`", fixed = TRUE), function(pieces) {
    of <- seq_along(pieces) %% 2L == 0L
    values <- lapply(pieces[of], function(text) eval(str2lang(text), known))
    if (any(lengths(values) == 0L)) return(NULL)
    pieces[of] <- vapply(values, function(value) {
      if (is.numeric(value)) shortest_decimal(value) else value
    }, "")
    paste(pieces, collapse = "")
  })
  lines <- unlist(strsplit(paste(unlist(values), collapse = "\n"), "\n", fixed = TRUE))
  remark <- regexpr("(?<=[^ ])  # ", lines, perl = TRUE)
  has <- remark > 0L
  field <- sprintf("%-40s", substr(lines, 1L, remark - 1L))
  lines[has] <- paste0(field, substring(lines, remark))[has]
  paste0(paste(lines, collapse = "\n"), "\n")
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
    number <- given_si(value, dimension, name)
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
    known <- known_numbers(about, si)
    for (path in names(about$scale)) {
      plan <- set_plan_field(plan, path, eval(str2lang(about$scale[[path]]), known))
    }
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

# ---- words of their numbers ----------------------------------------------------------------------

# A speed over what is usual for a head line (m).
speed_over_usual <- function(speed, h) speed / from_unit(3, "knot") / (h / 25)^0.15

thick_rope <- function(diameter, material = "steel_wire") {
  sprintf("diameter: %s, material: %s", millimetres(diameter), material)
}

metres <- function(x, step = 0.5) {
  paste(shortest_decimal(sign(x) * max(step, round(abs(x) / step) * step)), "m")
}

millimetres <- function(x) paste(shortest_decimal(2 * round(x / 2)), "mm")

with_figures <- function(x, unit, figures = 2) paste(shortest_decimal(signif(x, figures)), unit)

# A mesh size (m) as loose meshes are ordered: 2 m, 400 mm.
round_mesh <- function(x) if (x >= 1) round(x, 1) else round(x, 2)

shown_mesh_size <- function(x) {
  if (x >= 1) paste(shortest_decimal(x), "m") else paste(shortest_decimal(x * 1000), "mm")
}

twine_field <- function(diameter, material, double = FALSE) {
  sprintf("twine: {diameter: %s mm, material: %s%s}", shortest_decimal(round(diameter, 1)),
    material, if (double) ", double: yes" else "")
}

# Polyethylene no thicker than a fifth of its bars, nor thinner than twines that are sold.
pe_twine <- function(diameter, mesh, double = FALSE) {
  twine_field(max(1.2, min(diameter, 100 * mesh)), "PE", double)
}

# Floats that together lift some kgf, of the sizes that are sold (305 mm: 10.2 kgf, as on the Poly
# Nor'Eastern trawl).
float_fields <- function(lift) {
  sizes <- data.frame(diameter = c(100, 150, 200, 305), lift = c(0.35, 1.2, 2.7, 10.2))
  # no more than about two in a metre of what a head line of this lift is long
  fits <- which(lift / sizes$lift <= 2.1 * sqrt(lift / 0.22))
  size <- sizes[if (length(fits)) fits[1L] else nrow(sizes), ]
  sprintf("number: %d, buoyancy: %s kgf, diameter: %s mm", max(2, round(lift / size$lift)),
    shortest_decimal(size$lift), shortest_decimal(size$diameter))
}

# Sections of a midwater trawl's panel, whose meshes halve from the front's to the codend's (m).
# front: stretched width there, m; narrow: the codend's as a share of it; size: head line over 50 m.
midwater_sections <- function(mesh_size, codend, size, front, narrow) {
  sizes <- mesh_size
  while (utils::tail(sizes, 1L) / 2.2 > codend) {
    sizes <- c(sizes, round_mesh(utils::tail(sizes, 1L) / 2))
  }
  # large nets are short for their mouth, as the shipped one is, and sections of large meshes are
  # longer, by that one's depths
  deep <- sizes^0.2 / sum(sizes^0.2)
  wide <- front * (1 - (1 - narrow) * c(0, cumsum(deep)))
  rows <- pmax(2, round(1.2 * front * size^-0.25 * deep / sizes))
  # ropes of hmpe in the largest, which the shipped trawl of 2048 m has at 14 mm in meshes of 32 m
  twine <- vapply(sizes, function(mesh) {
    if (mesh >= 12) return(twine_field(14 * sqrt(mesh / 32), "hmpe"))
    twine_field(max(1.4, 7 * sqrt(mesh / 4) * size^0.15), "PA")
  }, "")
  n <- length(sizes)
  sections <- sprintf(
    "  section_%d: {mesh_size: %s, meshes: {upper: %d, lower: %d, deep: %d}, %s%s}", seq_len(n),
    vapply(sizes, shown_mesh_size, ""), pmax(2, round(wide[-n - 1L] / sizes)),
    pmax(2, round(wide[-1L] / sizes)), rows, twine, ifelse(sizes > 0.8, ", knotted: no", "")
  )
  paste(sections, collapse = "\n")
}
