# Returns a trawl with a random net of 2, 4 or 6 panels and 4 to 14 rows, and its rig.
random_net <- function(seed) {
  withr::local_seed(seed)
  pick <- function(...) sample(list(...), 1)[[1]]
  whole <- function(from, to) sample(seq(from, to), 1)
  panels <- pick(2, 4, 6)
  mesh <- pick(100, 120, 140, 160, 200)
  twine <- function(mesh) {
    list(diameter = sprintf("%.1f mm", max(1.2, mesh / 45)), material = pick("PE", "PA"))
  }
  piece <- function(mesh, front, deep, cutting, ...) {
    list(mesh_size = paste(mesh, "mm"), meshes = list(front = front, deep = deep),
      cutting = cutting, twine = twine(mesh), ...)
  }
  slopes <- c(AB = 1, AN = 0, `1N2B` = 0.5, `1N4B` = 2 / 3, `1N1B` = 1 / 3, `3N2B` = 0.25,
    `5N2B` = 1 / 6)
  # Wings of `count` pieces of a total stretched depth, in mm.
  wings <- function(name, count, total) {
    front <- whole(8, 25)
    out <- list()
    for (k in seq_len(count)) {
      inner <- pick("AB", "1N4B", "1N2B")
      outer <- pick("AN", "AN", "3N2B", "5N2B")
      deep <- max(4, round(total / count / mesh))
      out[[paste0(name, k)]] <- piece(mesh, front, deep, list(inner = inner, outer = outer),
        pair = TRUE)
      front <- round(front + (slopes[[inner]] - slopes[[outer]]) * deep)
    }
    list(pieces = out, base = front)
  }
  long <- whole(30, 90) * mesh
  square <- if (runif(1) < 0.6) whole(10, 30)
  count <- whole(1, 3)
  upper <- wings("upper_wing_", count, long)
  lower <- wings("lower_wing_", whole(1, 3), long + first_of(square, 0) * mesh)
  across <- round(max(upper$base, lower$base) * 2 * runif(1, 1.2, 1.6))
  rows <- list()
  front <- across
  size <- mesh
  total <- whole(4, 14) - max(length(lower$pieces), count + length(square))
  for (k in seq_len(max(2, total))) {
    deep <- whole(20, 60)
    cutting <- pick("AN", "1N2B", "1N1B", "5N2B", "3N2B")
    while (front - 2 * slopes[[cutting]] * deep < 25) {
      if (cutting == "AN") break
      cutting <- "AN"
    }
    rows[[paste0("row_", k)]] <- piece(size, front, deep, cutting)
    rear <- front - 2 * slopes[[cutting]] * deep
    now <- max(40, size - pick(0, 10, 20, 40))
    front <- max(20, round(rear * size / now * runif(1, 0.9, 1.1)))
    size <- now
  }
  net <- list(
    upper = c(upper$pieces,
      if (!is.null(square)) list(square = piece(mesh, across, square, "AN")), rows),
    lower = c(lower$pieces, rows)
  )
  if (panels > 2) {
    # Sides of half the width, and a wing as deep as the seam beside it.
    narrow <- lapply(rows, function(row) {
      rear <- row$meshes$front - 2 * slopes[[row$cutting]] * row$meshes$deep
      row$meshes <- list(front = row$meshes$front / 2, rear = rear / 2, deep = row$meshes$deep)
      row[names(row) != "cutting"]
    })
    deep <- round((long + first_of(square, 0) * mesh) / mesh)
    side <- c(list(side_wing = piece(mesh, narrow[[1]]$meshes$front, deep, "AN")), narrow)
    if (panels == 4) net$side <- side
    # Some sides end ahead of the last row, half of them pointed.
    last <- whole(1, length(rows))
    if (last < length(rows) && runif(1) < 0.5) {
      side <- side[seq_len(1L + last)]
      meshes <- side[[1L + last]]$meshes
      pointed <- runif(1) < 0.5 && meshes$front <= 2 * meshes$deep
      if (pointed) side[[1L + last]]$meshes$rear <- 0
    }
    if (panels == 4) net$side <- side
    if (panels == 6) net[c("upper_side", "lower_side")] <- list(side)
  }
  line <- list(hanging_ratio = runif(1, 0.75, 0.95), diameter = "18 mm", material = "PE")
  base <- new_plan(if (panels == 6) "midwater_trawl" else "bottom_trawl", headline = "25 m")$plan
  base[c("wings", "square", "sections", "panels", "belly_lines", "canvas")] <- NULL
  base[c("headline", "footrope", "side_lines")] <- list(line, line, line)
  base$ground_gear$length <- NULL
  if (panels < 6) base$ground_gear$hanging_ratio <- line$hanging_ratio
  base$net <- net
  if (panels < 6 && runif(1) < 0.3) {
    line <- line[names(line) != "hanging_ratio"]
    line$sections <- list(list(length = "2 m"), list(length = "3 m"))
    base$side_lines <- line
  }
  as_gear(unclass(base))
}

# Returns the covered fraction of each edge of netting by seams and lines of the mouth.
covered_edges <- function(gear) {
  si <- gear_si(gear)
  mouth <- Filter(function(rope) rope$role %in% c("headline", "footrope", "side_line"), si$ropes)
  chains <- c(lapply(si$seams, `[[`, "edges"), lapply(mouth, function(rope) list(rope$along)))
  edges <- unlist(unlist(unname(chains), recursive = FALSE), recursive = FALSE)
  table <- data.frame(
    edge = vapply(edges, function(edge) paste0(edge$panel, ".", edge$edge), ""),
    part = vapply(edges, function(edge) edge$to - edge$from, 0)
  )
  all <- outer(names(si$panels), c("upper", "lower", "left", "right"), paste, sep = ".")
  found <- tapply(table$part, factor(table$edge, all), sum)
  meshes <- vapply(si$panels, function(panel) {
    c(panel$upper, panel$lower, panel$deep, panel$deep)
  }, numeric(4))
  found[t(meshes) > 0]
}
