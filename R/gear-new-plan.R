# New plans by kind, from `inst/new_plans.yaml`, which documents its fields. Returns for each kind:
# `requests`: default strings of the required values, by name.
# `tested`: smallest and largest tested value of the first argument.
# `usual`: function of the headline length (m).
# `numbers`, `scale`: expressions, by name.
# `plan`: text of the plan.
# `like`: shipped plan to start from. A kind without an entry uses the shipped plan of its name.
new_plan_kinds <- remembered(read_new_plans)

read_new_plans <- function() {
  said <- yaml::read_yaml(system.file("new_plans.yaml", package = "codend"))
  kinds <- setdiff(plan_kinds, "assembly")
  own <- lapply(setNames(nm = setdiff(kinds, names(said))), function(kind) list(like = kind))
  lapply(c(said[names(said) != "shared"], own), function(kind) {
    usual <- kind$usual
    kind$requests <- vapply(as.list(kind$requests), identity, "")
    kind$numbers <- unlist(kind$numbers)
    kind$usual <- if (!is.null(usual)) function(h) {
      vapply(usual, function(text) eval(str2lang(text), list(h = h)), "")
    }
    kind
  })
}

#' Start a new plan
#'
#' Returns a complete, commented plan of about forty lines from a few numbers. The plan settles
#' without changes; adapt it line by line.
#'
#' All fields follow from the numbers. Lengths, areas, twines, ropes, boards, weights and floats
#' scale with the size of the gear. Mouth, spread, drag and rope loads are then within the ranges
#' published for gear of this kind and size ([findings()]).
#'
#' | kind | arguments |
#' |---|---|
#' | `bottom_trawl` | `headline`, `mesh_size`, `codend_mesh_size`, `speed`, `depth` |
#' | `midwater_trawl` | the same; `mesh_size` is the front mesh |
#' | `pair_trawl` | as `bottom_trawl` |
#' | `twin_trawl`, `triple_rig`, `quad_rig` | as `bottom_trawl`; `headline` of each net |
#' | `demersal_seine` | the same and `rope`, the length of each of the two ropes |
#' | `beam_trawl` | `beam`, `mesh_size`, `codend_mesh_size`, `speed`, `depth` |
#' | `gillnet` | `length`, `height` (hung), `mesh_size`, `depth`, `current` |
#' | `longline` | `baskets`, `branch_lines` per basket, lengths `main_line`, `branch_line` |
#' | `purse_seine` | `length`, `depth` (stretched), `mesh_size` |
#' | `stow_net` | `width`, `height`, `mesh_size`, `codend_mesh_size`, `current` |
#' | `cage` | `diameter`, `depth`, `mesh_size`, `current` |
#' | `dip_net` | any field of the plan by its path |
#'
#' Tested values of the first argument: `r tested_ranges()`; meshes of midwater trawls to 64 m.
#'
#' The last six kinds are scaled copies of a shipped plan. They also accept any other field by its
#' path, such as `wall.twine.diameter`. A trawl without mesh sizes gets typical mesh sizes for its
#' headline.
#'
#' @param kind Character: kind of gear.
#' @param ... Named values of the plan as strings with a unit (`headline = "32 m"`). Omitted values
#'   have typical defaults.
#' @param file Character: path of the plan file to write. Default `NULL`: write no file.
#' @param ask Logical: prompt for each value at the console, with the default in brackets? A number
#'   without a unit gets the unit of the default. Default `FALSE`.
#' @return The checked gear, of class `codend_gear`; invisibly if a file is written. `format(gear,
#'   remarks = TRUE)` returns its text.
#' @seealso [read_gear()] to read the file after changes, [settle()] for its shape.
#' @export
#' @examples
#' trawl <- new_plan("bottom_trawl", headline = "32 m", depth = "80 m")
#' cat(format(trawl, remarks = TRUE))
new_plan <- function(kind, ..., file = NULL, ask = FALSE) {
  check_given("kind")
  kinds <- new_plan_kinds()
  if (!is_text(kind) || !kind %in% names(kinds)) {
    abort_unknown_word("kind", if (missing(kind)) NULL else kind, names(kinds), "one of")
  }
  given <- list(...)
  if (length(given) && (is.null(names(given)) || any(!nzchar(names(given))))) {
    abort_argument("Every value needs a name, such as {.code headline = \"32 m\"}.")
  }
  if (!is.null(file)) check_file_path(file)
  given <- Map(given_value, given, names(given))
  about <- kinds[[kind]]
  check_truth(ask, "ask")
  if (ask) given <- prompt_for_values(about$requests, given, usual = about$usual)
  new <- if (is.null(about$plan)) new_from_shipped else new_from_numbers
  gear <- tryCatch(new(about, given), codend_error_plan = function(e) {
    abort_new_plan(e, given, kind)
  })
  if (is.null(file)) return(gear)
  write_gear(gear, file)
  gear["file"] <- list(file)
  invisible(gear)
}

# Returns the tested sizes of a kind as a string.
tested_range <- function(kind) paste(new_plan_kinds()[[kind]]$tested, collapse = " to ")

# Returns the tested sizes of all kinds as help text.
tested_ranges <- function() {
  kinds <- names(Filter(function(kind) length(kind$tested), new_plan_kinds()))
  paste0("`", kinds, "` ", vapply(kinds, tested_range, ""), collapse = ", ")
}

# Rethrows an error about a generated plan. The user has not seen this plan: the message names the
# given value and has no position in a file.
abort_new_plan <- function(e, given, kind) {
  said <- sub(" \\(line [0-9]+, column [0-9]+\\)$", "", first_of(e$said, conditionMessage(e)))
  tested <- new_plan_kinds()[[kind]]$tested
  name <- names(new_plan_kinds()[[kind]]$requests)[1L]
  size <- if (length(tested)) given[[name]]
  if (is.null(size)) abort_plan(said, e$path, e$value)
  si <- quantity_si(size, "length")
  ends <- vapply(tested, quantity_si, 0, "length")
  if (is.na(si) || (si >= ends[1L] && si <= ends[2L])) abort_plan(said, e$path, e$value)
  abort_plan(sprintf("`%s` is %s, outside the tested sizes from %s. %s", name, show_value(size),
    tested_range(kind), said), name, size)
}

# Prompts at the console for each missing value. An empty answer takes the default, a bare number
# takes the unit of the default, and an invalid quantity is requested again. `from`: connection to
# read if R is not interactive; `usual`: as in `new_plan_kinds()`.
prompt_for_values <- function(requests, given, from = NULL, usual = NULL) {
  if (is.null(from) && !interactive()) {
    from <- base::file("stdin", "r")
    on.exit(close(from))
  }
  asked <- setdiff(names(requests), names(given))
  if (length(asked)) cat("Press Enter for the value in brackets.\n", file = stderr())
  for (name in asked) {
    words <- gsub("[._]", " ", name)
    requests <- default_requests(requests, given, usual)
    repeat {
      typed <- typed_answer(sprintf("%s [%s]: ", words, requests[[name]]), from)
      if (!length(typed) || !nzchar(typed)) break
      given[[name]] <- answer_with_unit(typed, requests[[name]])
      dimension <- quantity_dimension(requests[[name]])
      number <- quantity_si(given[[name]], dimension)
      if (!is.na(number) && number >= 0) break
      cat(sprintf("\"%s\" is not a %s; enter one such as %s.\n", typed, dimension,
        requests[[name]]), file = stderr())
    }
  }
  given
}

# Returns one line from the console or a connection; character() at the end of the connection.
typed_answer <- function(prompt, from) {
  if (is.null(from)) return(trimws(readline(prompt)))
  cat(prompt, file = stderr())
  trimws(readLines(from, 1L))
}

# Returns the default strings, adapted to the given headline.
default_requests <- function(requests, given, usual) {
  headline <- if (!is.null(given$headline)) quantity_si(given$headline, "length")
  if (is.null(usual) || !isTRUE(headline > 0)) return(requests)
  found <- usual(headline)
  replace(requests, names(found), found)
}

# Returns `typed` with the unit of the default if it has none: "32" becomes "32 m".
answer_with_unit <- function(typed, usual) {
  found <- split_quantity(typed)
  if (is.null(found) || nzchar(found[2])) return(typed)
  paste(typed, split_quantity(usual)[2])
}

new_from_numbers <- function(about, given) {
  check_requested(about, given)
  si <- requested_numbers(about, given)
  if (!is.null(si$headline) && si$mesh_size > si$headline / 3.9) {
    abort_argument(paste(
      "{.arg mesh_size} is {.val {si$shown$mesh_size}}; it must be at most a quarter of",
      "{.arg headline}, {.val {si$shown$headline}}."
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
  text <- paste(vapply(about$plan, function(part) {
    if (is.list(part)) gsub("(?m)^(?=.)", "    ", part$indented, perl = TRUE) else part
  }, ""), collapse = "")
  text <- with_plain_numbers(filled_text(text, known_numbers(about, si)))
  gear_of_bytes(charToRaw(enc2utf8(text)), "new plan")
}

# Returns an environment with the requested numbers (SI) and the numbers computed from them.
known_numbers <- function(about, si) {
  known <- list2env(si, parent = topenv())
  for (name in names(about$numbers)) {
    assign(name, eval(str2lang(about$numbers[[name]]), known), known)
  }
  known
}

# Replaces expressions between backticks by their values and aligns the remarks in a column.
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

check_requested <- function(about, given) {
  unknown <- setdiff(names(given), names(about$requests))
  if (!length(unknown)) return(invisible())
  near <- nearest(unknown[1], names(about$requests))
  hint <- if (length(near)) " Did you mean {.arg {near}}?"
  abort_argument(paste0(
    "{.arg {unknown[1]}} is not a value of this kind; use {.arg {names(about$requests)}}.", hint
  ))
}

# Returns the requested numbers in SI by name, and in `shown` as strings.
requested_numbers <- function(about, given) {
  shown <- as.list(default_requests(about$requests, given, about$usual))
  shown[names(given)] <- given
  si <- lapply(stats::setNames(nm = names(shown)), function(name) {
    dimension <- quantity_dimension(about$requests[[name]])
    if (!is.na(dimension)) {
      return(quantity_number(shown[[name]], dimension, name, positive = TRUE))
    }
    # A count has no unit.
    number <- quantity_number(shown[[name]], "number", name, positive = TRUE)
    check_count(name, number)
    number
  })
  si$shown <- Map(function(value, usual) {
    if (!is.numeric(value)) return(value)
    dimension <- quantity_dimension(usual)
    unit <- if (!is.na(dimension)) names(plan_units[[dimension]])[1]
    paste(c(shortest_decimal(value), unit), collapse = " ")
  }, shown, about$requests[names(shown)])
  si
}

# Returns the shipped plan of a kind without its notes, sources and tow, scaled by the requested
# numbers. Other fields are set by their path.
new_from_shipped <- function(about, given) {
  gear <- read_gear(about$like)
  plan <- gear$plan
  plan[c("notes", "sources", "tow")] <- NULL
  numbers <- given[names(given) %in% names(about$requests)]
  if (length(numbers)) {
    si <- requested_numbers(about, numbers)
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
      "`; marks such as [usual] refer to the values of the shipped plan.\n", text)
  }
  gear_of_bytes(charToRaw(enc2utf8(text)), "new plan")
}

# ---- strings of computed numbers -----------------------------------------------------------------

# Returns the ratio of a speed (m/s) to the typical speed for a headline of h metres.
speed_over_usual <- function(speed, h) speed / from_unit(3, "knot") / (h / 25)^0.15

thick_rope <- function(diameter, material = "steel_wire") {
  sprintf("diameter: %s, material: %s", millimetres(diameter), material)
}

metres <- function(x, step = 0.5) {
  paste(shortest_decimal(sign(x) * max(step, round(abs(x) / step) * step)), "m")
}

millimetres <- function(x) paste(shortest_decimal(2 * round(x / 2)), "mm")

with_figures <- function(x, unit, figures = 2) paste(shortest_decimal(signif(x, figures)), unit)

# Rounds a mesh size (m) to commercial sizes, for example 2 m or 400 mm.
round_mesh <- function(x) if (x >= 1) round(x, 1) else round(x, 2)

displayed_mesh_size <- function(x) {
  if (x >= 1) paste(shortest_decimal(x), "m") else paste(shortest_decimal(x * 1000), "mm")
}

twine_field <- function(diameter, material, double = FALSE) {
  sprintf("twine: {diameter: %s mm, material: %s%s}", shortest_decimal(round(diameter, 1)),
    material, if (double) ", double: yes" else "")
}

# Polyethylene twine (mm): at most one fifth of a bar, and at least the thinnest twine on sale.
pe_twine <- function(diameter, mesh, double = FALSE) {
  twine_field(max(1.2, min(diameter, 100 * mesh)), "PE", double)
}

# Floats of commercial sizes that lift `lift` kgf (305 mm: 10.2 kgf, Poly Nor'Eastern trawl).
float_fields <- function(lift) {
  sizes <- data.frame(diameter = c(100, 150, 200, 305), lift = c(0.35, 1.2, 2.7, 10.2))
  # At most about two floats per metre of the headline length that fits this lift.
  fits <- which(lift / sizes$lift <= 2.1 * sqrt(lift / 0.22))
  size <- sizes[if (length(fits)) fits[1L] else nrow(sizes), ]
  sprintf("number: %d, buoyancy: %s kgf, diameter: %s mm", max(2, round(lift / size$lift)),
    shortest_decimal(size$lift), shortest_decimal(size$diameter))
}

# Sections of a midwater trawl panel: meshes halve from the front to the codend (sizes in m).
# `front`: stretched width at the front, m; `narrow`: width at the codend as a fraction of `front`;
# `size`: headline over 50 m.
midwater_sections <- function(mesh_size, codend, size, front, narrow) {
  sizes <- mesh_size
  while (utils::tail(sizes, 1L) / 2.2 > codend) {
    sizes <- c(sizes, round_mesh(utils::tail(sizes, 1L) / 2))
  }
  # Large nets are short compared with their mouth, as the shipped one is. Sections of large meshes
  # are longer, as in the depths of the shipped plan.
  deep <- sizes^0.2 / sum(sizes^0.2)
  wide <- front * (1 - (1 - narrow) * c(0, cumsum(deep)))
  rows <- pmax(2, round(1.2 * front * size^-0.25 * deep / sizes))
  # Largest meshes: HMPE rope. The shipped 2048 m trawl has 14 mm at a mesh size of 32 m.
  twine <- vapply(sizes, function(mesh) {
    if (mesh >= 12) return(twine_field(14 * sqrt(mesh / 32), "hmpe"))
    twine_field(max(1.4, 7 * sqrt(mesh / 4) * size^0.15), "PA")
  }, "")
  n <- length(sizes)
  sections <- sprintf(
    "  section_%d: {mesh_size: %s, meshes: {upper: %d, lower: %d, deep: %d}, %s%s}", seq_len(n),
    vapply(sizes, displayed_mesh_size, ""), pmax(2, round(wide[-n - 1L] / sizes)),
    pmax(2, round(wide[-1L] / sizes)), rows, twine, ifelse(sizes > 0.8, ", knotted: no", "")
  )
  paste(sections, collapse = "\n")
}
