# Lists of a plan drawing: ropes, netting and pieces, with identical items merged.

material_text <- function(material) {
  short <- names(material_abbreviations)[match(material, material_abbreviations)]
  ifelse(is.na(short), gsub("_", " ", material), short)
}

short_number <- function(x, digits = 4) {
  vapply(x, function(one) format(signif(one, digits), trim = TRUE, drop0trailing = TRUE), "")
}

# Formats a number of meshes: quarters as fraction signs, other fractions to one decimal. A plan may
# divide a round net into fractional meshes.
mesh_number <- function(meshes) {
  whole <- floor(meshes + 1e-6)
  quarters <- round(4 * (meshes - whole))
  part <- c("", "\u00bc", "\u00bd", "\u00be")[quarters + 1]
  counted <- paste0(ifelse(whole == 0 & quarters > 0, "", short_number(whole, 7)), part)
  ifelse(abs(whole + quarters / 4 - meshes) < 1e-6, counted, short_number(round(meshes, 1), 7))
}

mesh_text <- function(panel) {
  words <- c(
    diamond = "", square = "square", turned = "T90", hexagonal = "hexagonal",
    hexagonal_turned = "hexagonal T90"
  )
  words <- c(words[[panel$orientation]], if (panel$knot_diameter == 0) "knotless")
  paste(words[nzchar(words)], collapse = ", ")
}

# Returns a string that is equal for panels with identical netting.
panel_netting <- function(panel) {
  size <- short_number(in_unit(unlist(panel[c("mesh_size", "twine_diameter")]), "mm"))
  paste(c(size, panel$twine_count, panel$material, mesh_text(panel)), collapse = " ")
}

general_name <- function(name) {
  words <- strsplit(name, "_", fixed = TRUE)[[1L]]
  kept <- words[!words %in% c("port", "starboard") & !grepl("^[0-9]+$", words)]
  paste(if (length(kept)) kept else words, collapse = " ")
}

# Returns the name of a part in its gear of a rig.
name_in_gear <- function(name, si) {
  own <- si$names_in_gears[name]
  if (is.null(own) || is.na(own)) name else own[[1L]]
}

# Returns a string that is equal for ropes in the same list item: same name and make.
rope_kind <- function(name, si) {
  rope <- si$ropes[[name]]
  own <- name_in_gear(name, si)
  words <- if (is.na(rope$role)) general_name(own) else {
    # The tier in their names distinguishes hand ropes.
    tier <- intersect(c("upper", "middle", "lower"), strsplit(own, "_", fixed = TRUE)[[1L]])
    tier <- setdiff(tier, strsplit(rope$role, "_", fixed = TRUE)[[1L]])
    paste(c(tier, gsub("_", " ", rope$role)), collapse = " ")
  }
  make <- sprintf("%.6g", c(rope$length, rope$diameter, rope$axial_stiffness, rope$mass_per_length))
  paste(c(words, make), collapse = "|")
}

# Returns a data frame, one row per item of the rope list. Columns: item (number), name, count,
# length (m), diameter (m), material, hanging (ratio, NA), strength (N, NA), laced (TRUE along
# netting), kind (`rope_kind()`), first (name of the first such rope in the assembly).
rope_items <- function(si) {
  kind <- vapply(names(si$ropes), rope_kind, "", si = si)
  first <- which(!duplicated(kind))
  # Ropes between points are listed before ropes along netting.
  laced <- !vapply(si$ropes[first], function(rope) is.null(rope$along), NA)
  first <- c(first[!laced], first[laced])
  do.call(rbind, lapply(seq_along(first), function(k) {
    name <- names(si$ropes)[first[k]]
    rope <- si$ropes[[name]]
    along <- !is.null(rope$along)
    data.frame(
      item = k, name = sub("[|].*", "", kind[[first[k]]]), count = sum(kind == kind[first[k]]),
      length = rope$length, diameter = rope$diameter,
      material = if (is.na(rope$material)) "" else material_text(rope$material),
      hanging = if (along) rope_hanging_ratio(rope, si$panels) else NA_real_,
      strength = rope$strength, laced = along, kind = kind[[first[k]]], first = name
    )
  }))
}

# Returns the columns of the rope list: name, length (m), diameter (mm) with material, hanging
# ratio.
rope_item_text <- function(item) {
  c(
    name = paste0(item$name, if (item$count > 1) paste0(", ", item$count, " off")),
    length = format(round(item$length, 2), nsmall = 2, trim = TRUE),
    make = trimws(paste(short_number(in_unit(item$diameter, "mm")), item$material)),
    hanging = if (is.na(item$hanging)) "" else sprintf("%.2f", item$hanging)
  )
}

# Returns a data frame, one row per item of the list of weights, floats, boards and other pieces.
# Columns: item (letter), name, count, words (description of one piece), role, parts (names), ref
# (path of the first piece in the assembly). `grids`: checked sorting grids, by name.
piece_items <- function(si, grids = NULL) {
  each <- c(
    lapply(names(si$pieces), function(name) {
      piece <- si$pieces[[name]]
      list(part = name, role = piece$role, count = piece$number, words = piece_text(piece, si),
        ref = paste0("pieces.", name))
    }),
    lapply(names(si$otter_boards), function(name) {
      board <- si$otter_boards[[name]]
      list(part = name, role = board$role, count = 1, ref = paste0("otter_boards.", name),
        words = paste0(short_number(board$area), " m2, ", short_number(board$mass), " kg"))
    }),
    lapply(names(grids), function(name) {
      list(part = name, role = "sorting_grid", count = 1, words = grid_text(grids[[name]]),
        ref = paste0("grids.", name))
    })
  )
  if (!length(each)) return(NULL)
  pick <- function(field, type) vapply(each, `[[`, type, field)
  role <- pick("role", "")
  part <- pick("part", "")
  own <- vapply(part, function(one) general_name(name_in_gear(one, si)), "")
  name <- ifelse(is.na(role), own, gsub("_", " ", role))
  kind <- paste(name, pick("words", ""), sep = "|")
  first <- which(!duplicated(kind))
  k <- seq_along(first) - 1L
  data.frame(
    item = paste0(LETTERS[k %% 26L + 1L], ifelse(k < 26L, "", k %/% 26L + 1L)), name = name[first],
    words = pick("words", "")[first],
    count = vapply(first, function(k) sum(as.double(pick("count", 0))[kind == kind[k]]), 0),
    role = ifelse(role[first] %in% view_symbols$role, role[first], "other"),
    parts = I(lapply(first, function(k) part[kind == kind[k]])), ref = pick("ref", "")[first]
  )
}

grid_text <- function(grid) {
  mm <- function(x) short_number(in_unit(x, "mm"))
  sprintf("%s m by %s m, %s deg, behind %s, bars \u00d8%s and %s mm apart, %s kg",
    short_number(grid$height), short_number(first_of(grid$width, grid$height)),
    short_number(in_unit(grid$angle, "deg")), gsub("_", " ", grid$behind), mm(grid$bars$diameter),
    mm(grid$bars$spacing), short_number(grid$mass))
}

piece_text <- function(piece, si) {
  float <- gear_gravity * (si$water$density * piece$volume - piece$mass)
  kilograms <- function(force) paste(short_number(abs(force) / 9.80665, 3), "kgf")
  said <- c(
    if (piece$mass > 0) paste(short_number(piece$mass), "kg"),
    if (float > 0.5) paste("buoyancy", kilograms(float)),
    if (float < -0.5) paste("in water", kilograms(float)),
    if (piece$lift_area > 0) paste("area", short_number(piece$area), "m2, lift area",
      short_number(piece$lift_area), "m2"),
    if (piece$lift_area == 0 && piece$mass == 0 && float == 0 && piece$drag_area > 0) {
      paste("drag area", short_number(piece$drag_area), "m2")
    }
  )
  paste(said, collapse = ", ")
}
