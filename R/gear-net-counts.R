# Counts and edges of the pieces of the field `net`.

# Panels of the field `net` by number of panels around the net.
net_panels <- list(
  `2` = c("upper", "lower"), `4` = c("upper", "lower", "side"),
  `6` = c("upper", "lower", "upper_side", "lower_side")
)

# Completes the field `net`: pieces take omitted fields from the upper panel, and counts and lost
# meshes of edges follow from the cutting.
#
# Returns list(fields, plan, derived) like `complete_counts()`. Each piece has `lost`: meshes lost
# along its left and right edge, or along the inner and outer edge of a wing.
complete_net <- function(fields, plan) {
  fields$net <- inherited_pieces(fields$net)
  plan$net <- inherited_pieces(plan$net)
  fields$panels <- net_size(fields, plan)
  derived <- numeric()
  for (panel in names(fields$net)) {
    for (row in names(fields$net[[panel]])) {
      path <- paste("net", panel, row, sep = ".")
      found <- piece_counts(fields$net[[panel]][[row]], path)
      for (name in setdiff(names(found$meshes), names(fields$net[[panel]][[row]]$meshes))) {
        derived[[paste0(path, ".meshes.", name)]] <- found$meshes[[name]]
      }
      fields$net[[panel]][[row]][c("meshes", "lost")] <- found
      plan$net[[panel]][[row]]$meshes <- found$meshes
    }
  }
  list(fields = fields, plan = plan, derived = derived)
}

# Returns the number of panels around a net; throws an error if its panels do not fit together.
net_size <- function(fields, plan) {
  size <- Find(function(size) setequal(net_panels[[size]], names(fields$net)), names(net_panels))
  if (is.null(size)) {
    abort_field("net", names(fields$net), paste("the panels upper and lower, with side in a net of",
      "4 panels or with upper_side and lower_side in a net of 6"), is = "has other panels")
  }
  if (!is.null(plan$panels) && fields$panels != as.integer(size)) {
    abort_field("panels", fields$panels, paste("omitted, or", size, "as in `net`"))
  }
  as.integer(size)
}

# Returns the pieces of a net with the fields that they omit and the piece of the same name in the
# upper panel has, except its window. Counts and cutting are taken together.
inherited_pieces <- function(net) {
  for (panel in setdiff(names(net), "upper")) {
    for (row in intersect(names(net[[panel]]), names(net$upper))) {
      own <- net[[panel]][[row]]
      base <- net$upper[[row]][names(net$upper[[row]]) != "window"]
      if (any(c("meshes", "cutting") %in% names(own))) {
        base[c("meshes", "cutting", "joined")] <- NULL
      }
      base$twine[names(own$twine)] <- own$twine
      base[setdiff(names(own), "twine")] <- own[setdiff(names(own), "twine")]
      net[[panel]][[row]] <- base
    }
  }
  net
}

# Returns list(meshes = list(front, rear, deep), lost): the counts of a piece and the meshes that it
# loses along each edge. Throws an error if its counts and its cutting contradict each other.
piece_counts <- function(piece, path) {
  for (field in setdiff(c("mesh_size", "twine", "meshes"), names(piece))) {
    abort_field(paste(path, field, sep = "."), NULL, "given", "is missing")
  }
  edges <- if (isTRUE(piece$pair)) c("inner", "outer") else c("left", "right")
  slopes <- piece_slopes(piece, edges, path)
  meshes <- piece$meshes[c("front", "rear", "deep")]
  meshes <- meshes[!vapply(meshes, is.null, NA)]
  missing <- setdiff(c("front", "rear", "deep"), names(meshes))
  # Usual direction first: a wing gets wider along its inner edge. Other edges lose meshes.
  usual <- c(inner = -1, outer = 1, left = 1, right = 1)[edges]
  ways <- list(usual, c(-1, -1), c(1, 1), c(1, -1), c(-1, 1))
  # Both edges of a whole piece with one rate lead inwards, or both outwards.
  directions <- ways[seq_len(if (is_text(piece$cutting) && !isTRUE(piece$pair)) 3L else 5L)]
  if (!length(missing)) {
    return(list(meshes = meshes, lost = edge_losses_given(meshes, slopes, directions, path, piece)))
  }
  if (length(missing) > 1L || all(is.na(slopes))) {
    abort_field(paste0(path, ".meshes.", missing[1L]), NULL,
      "given; without it, two counts and a `cutting` rate are needed", "is missing")
  }
  slopes[is.na(slopes)] <- 0
  if (missing == "deep") {
    loss <- meshes$front - meshes$rear
    total <- vapply(directions, function(direction) sum(direction * slopes), 0)
    use <- which(loss * total > 0)[1L]
    if (is.na(use)) {
      abort_field(paste0(path, ".meshes.deep"), NULL, sprintf(
        "given, because %s does not lead from %s meshes in front to %s at the rear",
        show_cutting(piece$cutting), displayed_count(meshes$front), displayed_count(meshes$rear)
      ), "is missing")
    }
    meshes$deep <- loss / total[use]
    return(list(meshes = meshes, lost = directions[[use]] * slopes * meshes$deep))
  }
  lost <- usual * slopes * meshes$deep
  meshes[[missing]] <- if (missing == "rear") meshes$front - sum(lost) else meshes$rear + sum(lost)
  if (meshes[[missing]] < -1e-9) {
    abort_field(paste0(path, ".cutting"), show_cutting(piece$cutting), sprintf(
      "a rate that leaves meshes at the %s: over %s deep it takes %s meshes from %s", missing,
      displayed_count(meshes$deep), displayed_count(abs(sum(lost))),
      displayed_count(meshes[[setdiff(c("front", "rear"), missing)]])
    ))
  }
  meshes[[missing]] <- max(0, meshes[[missing]])
  list(meshes = meshes, lost = lost)
}

# Returns the meshes across that each edge loses per mesh of depth, NA for edges without a rate.
piece_slopes <- function(piece, edges, path) {
  path <- paste0(path, ".cutting")
  given <- edge_rates(piece$cutting, edges)
  wrong <- setdiff(names(given), edges)
  if (length(wrong)) {
    abort_field(paste(path, wrong[1L], sep = "."), given[[wrong[1L]]], sprintf(
      "replaced by `%s` or `%s` in %s", edges[1L], edges[2L],
      if (edges[1L] == "inner") "a pair of wings" else "a whole piece"
    ))
  }
  vapply(stats::setNames(nm = edges), function(edge) {
    if (is.null(given[[edge]])) return(NA_real_)
    cutting_slope(given[[edge]], path, given_orientation(piece))
  }, 0)
}

# Returns the meshes that each edge loses if all counts are given. An edge without a rate takes the
# rest; rounding to whole meshes is divided between the cut edges.
edge_losses_given <- function(meshes, slopes, directions, path, piece) {
  loss <- meshes$front - meshes$rear
  free <- is.na(slopes)
  if (all(free)) {
    shares <- if ("inner" %in% names(slopes)) c(1, 0) else c(0.5, 0.5)
    return(stats::setNames(loss * shares, names(slopes)))
  }
  lost <- lapply(directions, function(direction) direction * slopes * meshes$deep)
  if (any(free)) {
    lost <- lost[[1L]]
    lost[free] <- loss - sum(lost[!free])
    return(lost)
  }
  off <- vapply(lost, sum, 0) - loss
  cut <- slopes > 0
  fits <- which(abs(off) <= rounded_meshes * sum(cut) + 1e-9)[1L]
  if (is.na(fits)) {
    abort_plan(sprintf(
      paste(
        "Plan field `%s.meshes`: %s meshes in front, cut %s over %s meshes deep, give %s at the",
        "rear; the plan has %s. Change a count or the cutting. The tolerance is one mesh",
        "at each cut edge."
      ),
      path, displayed_count(meshes$front), show_cutting(piece$cutting),
      displayed_count(meshes$deep), displayed_count(max(0, meshes$front - sum(lost[[1L]]))),
      displayed_count(meshes$rear)
    ), paste0(path, ".meshes"), meshes)
  }
  lost <- lost[[fits]]
  lost[cut] <- lost[cut] - off[fits] / sum(cut)
  lost
}
