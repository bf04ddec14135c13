# Layout of flat netting. Lengths are in metres, x to the right, y down from the front.
#
# The layout follows the FAO Catalogue of Fishing Gear Designs: stretched depth and half the
# stretched width (hanging ratio 0.5). Exceptions: netting between two ropes of known hanging ratio
# has the hung width, square netting has its own width, and a window has the size of its hole.

# Returns a data frame, one row per panel: name, upper and lower (widths), depth, shift (x of the
# lower left corner minus x of the upper left corner).
flat_panels <- function(si, joints) {
  hung <- hung_widths(si, joints)
  rows <- lapply(names(si$panels), function(name) {
    panel <- si$panels[[name]]
    width <- hung[, name]
    if (anyNA(width)) {
      width <- vapply(c("upper", "lower"), edge_length, 0, panel = panel)
      if (panel$orientation != "square") width <- width / 2
    }
    data.frame(
      name = name, upper = width[[1L]], lower = width[[2L]],
      # An edge without taper is as long as the panel is deep.
      depth = edge_length(utils::modifyList(panel, list(lost_left = 0)), "left"),
      shift = panel$lost_left * if (panel$upper == panel$lower) {
        width[[1L]] / panel$upper
      } else {
        (width[[1L]] - width[[2L]]) / (panel$upper - panel$lower)
      }
    )
  })
  fill_holes(do.call(rbind, rows), joints)
}

# Draws a window in the size of its hole: a panel between two others, if all three are joined to the
# same panel ahead and to the same panel behind. `hole`: TRUE for these three.
fill_holes <- function(flat, joints) {
  flat$hole <- FALSE
  whole <- joints$to - joints$from == 1 & joints$other_to - joints$other_from == 1
  met <- function(name, edge, other_edge, sides = FALSE) {
    found <- joints$panel == name & joints$edge == edge & joints$other_edge == other_edge
    which(found & (whole | !sides))
  }
  ends <- function(names, edge, other_edge) {
    found <- lapply(names, met, edge, other_edge)
    if (all(lengths(found) == 1L) && length(unique(joints$other[unlist(found)])) == 1L) {
      joints[found[[1L]], ]
    }
  }
  for (k in seq_len(nrow(flat))) {
    beside <- c(met(flat$name[k], "left", "right", TRUE), met(flat$name[k], "right", "left", TRUE))
    if (length(beside) != 2L) next
    names <- c(flat$name[k], joints$other[beside])
    ahead <- ends(names, "upper", "lower")
    behind <- ends(names, "lower", "upper")
    if (is.null(ahead) || is.null(behind)) next
    flat$hole[flat$name %in% names] <- TRUE
    left <- flat[match(names[2L], flat$name), ]
    flat$upper[k] <- flat$lower[match(ahead$other, flat$name)] *
      abs(ahead$other_to - ahead$other_from)
    flat$lower[k] <- flat$upper[match(behind$other, flat$name)] *
      abs(behind$other_to - behind$other_from)
    flat$depth[k] <- left$depth
    flat$shift[k] <- left$shift + left$lower - left$upper
  }
  flat
}

# Returns the widths of upper and lower edges (2 x panels, m) of netting that hangs between two
# ropes, otherwise NA. A tapered panel takes each width from the rope on that edge. Panels without
# taper that follow each other all take the width at the upper rope.
hung_widths <- function(si, joints) {
  ratio <- hanging_ratios(si)
  width <- ratio * NA
  below <- joints[joints$edge == "lower" & joints$other_edge == "upper" &
    abs(joints$to - joints$from) == 1 & abs(joints$other_to - joints$other_from) == 1, ]
  straight <- vapply(si$panels, function(panel) panel$upper == panel$lower, NA)
  hung <- function(edge, name) ratio[edge, name] * edge_length(si$panels[[name]], edge)
  for (name in names(si$panels)[!is.na(ratio["upper", ])]) {
    if (!straight[[name]]) {
      width[, name] <- c(hung("upper", name), hung("lower", name))
      next
    }
    hanging <- name
    last <- name
    while (is.na(ratio["lower", last])) {
      last <- below$other[match(last, below$panel)]
      if (is.na(last) || !straight[[last]] || last %in% hanging) break
      hanging <- c(hanging, last)
    }
    if (!is.na(last) && !is.na(ratio["lower", last])) width[, hanging] <- hung("upper", name)
  }
  width
}

# Returns the hanging ratios of upper and lower edges (2 x panels), NA unless a rope runs along the
# whole edge.
hanging_ratios <- function(si) {
  found <- matrix(NA_real_, 2L, length(si$panels),
    dimnames = list(c("upper", "lower"), names(si$panels)))
  for (rope in si$ropes) {
    for (edge in rope$along) {
      whole <- edge$edge %in% rownames(found) && edge$to - edge$from == 1
      if (whole) found[edge$edge, edge$panel] <- rope_hanging_ratio(rope, si$panels)
    }
  }
  found
}

rope_hanging_ratio <- function(rope, panels) rope$length / chain_length(rope$along, panels)

edge_point <- function(panel, edge, fraction) {
  switch(edge,
    upper = c(panel$x + fraction * panel$upper, panel$y),
    lower = c(panel$x + panel$shift + fraction * panel$lower, panel$y + panel$depth),
    left = c(panel$x + fraction * panel$shift, panel$y + fraction * panel$depth),
    right = c(
      panel$x + panel$upper + fraction * (panel$shift + panel$lower - panel$upper),
      panel$y + fraction * panel$depth
    )
  )
}

# TRUE if two flat panels overlap, checked by their spans at five depths.
panels_overlap <- function(a, b) {
  top <- max(a$y, b$y)
  bottom <- min(a$y + a$depth, b$y + b$depth)
  room <- 1e-6 * max(a$depth, b$depth, a$upper, b$upper)
  if (bottom - top <= room) return(FALSE)
  any(vapply(top + (bottom - top) * c(0.1, 0.3, 0.5, 0.7, 0.9), function(y) {
    span <- function(p) {
      f <- (y - p$y) / p$depth
      c(edge_point(p, "left", f)[1], edge_point(p, "right", f)[1])
    }
    sa <- span(a)
    sb <- span(b)
    min(sa[2], sb[2]) - max(sa[1], sb[1]) > room
  }, NA))
}

# Lays out the panels in columns. Panels that follow each other share a column. Columns that fit
# side by side (walls of straight panels) are joined.
#
# Returns list(panels (`flat_panels()` with x, y and column), columns (data frame: heading, alike,
# count, symmetric), laced (`laced_edges()`), joints (`seam_joints()`)).
flat_layout <- function(si) {
  joints <- seam_joints(si)
  panels <- flat_panels(si, joints)
  panels$x <- panels$y <- 0
  laced <- laced_edges(si, joints)
  panels$column <- 0L
  column <- 0L
  while (any(panels$column == 0L)) {
    column <- column + 1L
    panels <- lay_column(panels, joints, column)
  }
  order_columns(panels, joints, si, laced)
}

# Starts a column with the first panel that has none and adds all panels that connect to it along
# upper and lower edges.
lay_column <- function(panels, joints, column) {
  waiting <- which(panels$column == 0L)[1L]
  panels$column[waiting] <- column
  while (length(waiting)) {
    here <- panels[waiting[1L], ]
    waiting <- waiting[-1L]
    across <- joints[joints$panel == here$name, , drop = FALSE]
    for (k in seq_len(nrow(across))) {
      joint <- across[k, ]
      if (!setequal(c(joint$edge, joint$other_edge), c("upper", "lower"))) next
      other <- match(joint$other, panels$name)
      if (panels$column[other] != 0L) next
      put <- panels[other, ]
      away <- edge_point(here, joint$edge, (joint$from + joint$to) / 2) -
        edge_point(put, joint$other_edge, (joint$other_from + joint$other_to) / 2)
      put$x <- put$x + away[1]
      put$y <- put$y + away[2]
      mine <- which(panels$column == column)
      if (any(vapply(mine, function(m) panels_overlap(panels[m, ], put), NA))) next
      panels[other, c("x", "y")] <- put[c("x", "y")]
      panels$column[other] <- column
      waiting <- c(waiting, other)
    }
  }
  panels
}

# Returns the joints of a right edge with a left edge of another column.
side_joints <- function(panels, joints) {
  joints <- joints[joints$edge == "right" & joints$other_edge == "left", , drop = FALSE]
  column <- panels$column[match(joints$panel, panels$name)]
  other <- panels$column[match(joints$other, panels$name)]
  joints[column != other, , drop = FALSE]
}

# Orders columns by their side seams, levels them along these seams and joins them if they fit.
# Identical columns are drawn once.
order_columns <- function(panels, joints, si, laced) {
  beside <- side_joints(panels, joints)
  beside$column <- panels$column[match(beside$panel, panels$name)]
  beside$other_column <- panels$column[match(beside$other, panels$name)]
  order <- integer()
  for (column in unique(panels$column)) {
    while (!is.na(column) && !column %in% order) {
      order <- c(order, column)
      onward <- beside[beside$column == column & !beside$other_column %in% order, , drop = FALSE]
      if (!nrow(onward)) break
      joint <- onward[1L, ]
      panels <- level_column(panels, joint)
      column <- joint$other_column
    }
  }
  panels$column <- match(panels$column, order)
  beside$column <- match(beside$column, order)
  beside$other_column <- match(beside$other_column, order)
  panels <- rest_on_top(level_covers(panels, joints))
  kind <- column_kinds(panels, si, laced)
  closed <- any(beside$column == max(panels$column) & beside$other_column == 1L)
  # A ring of equal columns is drawn as a single column, not unrolled.
  if (!(closed && all(kind == kind[1L]))) {
    panels <- join_columns(panels, beside)
    kind <- column_kinds(panels, si, laced)
  }
  columns <- lapply(unique(kind), function(k) {
    alike <- which(kind == k)
    list(
      column = alike[1L], count = length(alike),
      words = column_strings(lapply(alike, function(c) panels$name[panels$column == c]))
    )
  })
  first <- vapply(columns, `[[`, 0L, "column")
  panels <- panels[panels$column %in% first, ]
  panels$column <- match(panels$column, first)
  list(
    panels = panels, laced = laced, joints = joints,
    columns = data.frame(
      heading = vapply(columns, function(c) c$words[["heading"]], ""),
      alike = vapply(columns, function(c) c$words[["alike"]], ""),
      count = vapply(columns, `[[`, 0L, "count"),
      symmetric = vapply(seq_along(columns), function(c) {
        own <- panels[panels$column == c, ]
        identical(column_text(own, si, laced),
          column_text(mirrored(own), si, laced, mirror = TRUE))
      }, NA)
    )
  )
}

level_column <- function(panels, joint) {
  here <- panels[match(joint$panel, panels$name), ]
  other <- panels[match(joint$other, panels$name), ]
  away <- edge_point(here, joint$edge, (joint$from + joint$to) / 2)[2] -
    edge_point(other, joint$other_edge, (joint$other_from + joint$other_to) / 2)[2]
  mine <- panels$column == joint$other_column
  panels$y[mine] <- panels$y[mine] + away
  panels
}

# Moves a column that covers another one, such as a liner, to the depth at which its front edge is
# laced.
level_covers <- function(panels, joints) {
  for (column in unique(panels$column)) {
    mine <- panels$column == column
    # The front panel of such a column has an upper edge that meets a lower edge of another column.
    joint <- joints[joints$panel == panels$name[mine][which.min(panels$y[mine])] &
      joints$edge == "upper" & joints$other_edge == "lower" &
      !joints$other %in% panels$name[mine], ]
    if (!nrow(joint)) next
    here <- panels[match(joint$other[1L], panels$name), ]
    panels$y[mine] <- panels$y[mine] - min(panels$y[mine]) + here$y + here$depth
  }
  panels
}

# Columns without a side seam start at the top; x starts at 0 in each column.
rest_on_top <- function(panels) {
  panels$y <- panels$y - min(panels$y)
  for (column in unique(panels$column)) {
    mine <- panels$column == column
    panels$x[mine] <- panels$x[mine] - min(panels$x[mine], (panels$x + panels$shift)[mine])
  }
  panels
}

join_columns <- function(panels, beside) {
  repeat {
    column <- panels$column[match(beside$panel, panels$name)]
    other <- panels$column[match(beside$other, panels$name)]
    pairs <- unique(data.frame(column, other)[column != other, ])
    joined <- FALSE
    for (k in seq_len(nrow(pairs))) {
      mine <- which(column == pairs$column[k] & other == pairs$other[k])
      away <- fitting_shift(panels, beside[mine, ])
      if (is.na(away)) next
      moved <- panels[panels$column == pairs$other[k], ]
      moved$x <- moved$x + away
      still <- panels[panels$column == pairs$column[k], ]
      if (any_overlap(still, moved)) next
      panels[panels$column == pairs$other[k], c("x", "column")] <-
        list(moved$x, pairs$column[k])
      joined <- TRUE
      break
    }
    if (!joined) break
  }
  panels$column <- match(panels$column, sort(unique(panels$column)))
  rest_on_top(panels)
}

# Returns the shift in x (m) of the other column at which all these joints meet, NA if there is
# none.
fitting_shift <- function(panels, joints) {
  ends <- do.call(rbind, lapply(seq_len(nrow(joints)), function(k) {
    joint <- joints[k, ]
    here <- panels[match(joint$panel, panels$name), ]
    other <- panels[match(joint$other, panels$name), ]
    rbind(
      edge_point(here, "right", joint$from) - edge_point(other, "left", joint$other_from),
      edge_point(here, "right", joint$to) - edge_point(other, "left", joint$other_to)
    )
  }))
  room <- 1e-6 * max(panels$depth, panels$upper)
  if (max(abs(ends[, 2L])) > room || diff(range(ends[, 1L])) > room) NA else ends[1L, 1L]
}

any_overlap <- function(a, b) {
  any(vapply(seq_len(nrow(a)), function(i) {
    any(vapply(seq_len(nrow(b)), function(j) panels_overlap(a[i, ], b[j, ]), NA))
  }, NA))
}

# Returns one string per column that identifies its panels, their positions and the ropes along
# them. A column and its mirror image get the same string.
column_kinds <- function(panels, si, laced) {
  vapply(sort(unique(panels$column)), function(column) {
    mine <- panels[panels$column == column, ]
    min(column_text(mine, si, laced), column_text(mirrored(mine), si, laced, mirror = TRUE))
  }, "")
}

mirrored <- function(panels) {
  right <- max(panels$x + panels$upper, panels$x + panels$shift + panels$lower)
  panels$x <- right - (panels$x + panels$upper)
  panels$shift <- panels$upper - panels$lower - panels$shift
  panels
}

column_text <- function(panels, si, laced, mirror = FALSE) {
  rows <- vapply(seq_len(nrow(panels)), function(k) {
    flat <- panels[k, ]
    panel <- si$panels[[flat$name]]
    paste(
      c(
        format_places(c(flat$x, flat$y, flat$upper, flat$lower, flat$depth, flat$shift)),
        panel$upper, panel$lower, panel$deep, panel_netting(panel),
        ropes_along_panel(flat$name, laced, mirror)
      ),
      collapse = " "
    )
  }, "")
  paste(sort(rows), collapse = "\n")
}

ropes_along_panel <- function(name, laced, mirror) {
  mine <- laced[laced$panel == name, ]
  if (mirror) {
    across <- mine$edge %in% c("upper", "lower")
    mine[across, c("from", "to")] <- 1 - mine[across, c("to", "from")]
    side <- match(mine$edge, c("left", "right"))
    mine$edge[!is.na(side)] <- c("right", "left")[side[!is.na(side)]]
  }
  sort(paste(mine$kind, mine$edge, format_places(mine$from), format_places(mine$to)))
}

# Formats lengths (m) so that rounding errors do not change the string. Adding 0 turns -0 into 0.
# The small offset gives lengths at half a millimetre a definite rounding direction.
format_places <- function(x) sprintf("%.3f", round(x + 1.2345e-5, 3) + 0)

# Returns the edges that ropes run along, on both sides of seams: a data frame with rope, kind,
# panel, edge, from and to (from <= to).
laced_edges <- function(si, joints) {
  own <- do.call(rbind, lapply(names(si$ropes), function(rope) {
    along <- si$ropes[[rope]]$along
    if (is.null(along)) return(NULL)
    pick <- function(field, type) vapply(along, `[[`, type, field)
    data.frame(
      rope = rope, kind = rope_kind(rope, si), panel = pick("panel", ""), edge = pick("edge", ""),
      from = pick("from", 0), to = pick("to", 0)
    )
  }))
  if (is.null(own)) {
    return(data.frame(rope = character(), kind = character(), panel = character(),
      edge = character(), from = numeric(), to = numeric()))
  }
  opposite <- lapply(seq_len(nrow(own)), function(k) {
    row <- own[k, ]
    met <- joints[joints$panel == row$panel & joints$edge == row$edge, , drop = FALSE]
    if (!nrow(met)) return(NULL)
    low <- pmax(pmin(met$from, met$to), row$from)
    high <- pmin(pmax(met$from, met$to), row$to)
    across <- function(f) {
      met$other_from + (f - met$from) / (met$to - met$from) * (met$other_to - met$other_from)
    }
    data.frame(
      rope = row$rope, kind = row$kind, panel = met$other, edge = met$other_edge,
      from = pmin(across(low), across(high)), to = pmax(across(low), across(high))
    )[high - low > 1e-6, ]
  })
  merge_ranges(rbind(own, do.call(rbind, opposite)))
}

merge_ranges <- function(laced) {
  laced <- laced[order(laced$panel, laced$edge, laced$rope, laced$from), ]
  key <- paste(laced$panel, laced$edge, laced$rope)
  n <- nrow(laced)
  begins <- c(TRUE, key[-1L] != key[-n] | laced$from[-1L] > laced$to[-n] + 1e-6)
  run <- cumsum(begins)
  merged <- laced[begins, ]
  merged$to <- as.vector(tapply(laced$to, run, max))
  merged
}

# Returns c(heading, alike) for identical columns. `heading`: the words common to their panels'
# names, otherwise the panel names of the first column. `alike`: the number, and the words that
# differ between two ("2 off: starboard, port").
column_strings <- function(names) {
  n <- length(names)
  numbered <- if (n > 1L) paste(n, "off") else ""
  # Keeps the order of the first.
  shared <- function(lists) Reduce(function(a, b) a[a %in% b], lists)
  own <- lapply(names, function(each) {
    common <- unique(shared(strsplit(each, "_", fixed = TRUE)))
    grep("^[0-9]+$", common, invert = TRUE, value = TRUE)
  })
  common <- shared(own)
  if (!length(common)) {
    said <- unique(vapply(names[[1L]], general_name, ""))
    said <- if (length(said) > 3L) "netting" else paste(said, collapse = ", ")
    return(c(heading = said, alike = numbered))
  }
  apart <- vapply(own, function(words) paste(setdiff(words, common), collapse = " "), "")
  told <- n == 2L && all(nzchar(apart)) && apart[1L] != apart[2L]
  c(
    heading = paste(common, collapse = " "),
    alike = if (told) paste0(numbered, ": ", toString(apart)) else numbered
  )
}
