# Returns a trawl with the field `net` instead of `wings`, `square` and `sections`.
net_form <- function(gear) {
  plan <- unclass(gear$plan)
  if (!is.null(plan$net)) return(gear)
  if (!"net" %in% names(kind_node(first_of(plan$kind, "assembly"))$properties)) {
    abort_argument("{.arg gear} is of a kind without the field {.field net}.")
  }
  checked <- gear_checked(gear)
  net <- net_of_short_form(checked$counted$fields, checked$counted$plan)
  short <- c("panels", "wings", "square", "sections")
  place <- match("sections", names(plan))
  plan <- append(plan, list(net = net), place)
  names(plan$uncertain) <- net_form_path(names(plan$uncertain))
  as_gear(plan[setdiff(names(plan), short)])
}

# Returns the field `net` of the fields of a short form.
net_of_short_form <- function(fields, plan) {
  grids <- panels_around(fields)
  net <- list()
  for (name in names(grid_panels)[vapply(grid_panels, function(of) of[1L] %in% grids, NA)]) {
    panel <- grid_panels[[name]][1L]
    rows <- lapply(plan$sections, function(section) {
      covers <- covers_of(section, panel, "cover")
      names(covers) <- sub("^cover_", "", names(covers))
      c(as_piece(section_panel(section, panel)), if (length(covers)) list(covers = covers))
    })
    if (name != "upper") rows <- Map(own_fields, rows, net$upper[names(rows)])
    net[[name]] <- c(pieces_ahead(name, fields, plan), rows)
  }
  net
}

# Returns a piece without the fields that it takes from the piece of the upper panel.
own_fields <- function(piece, upper) {
  same <- vapply(names(piece), function(name) identical(piece[[name]], upper[[name]]), NA)
  cut <- c("meshes", "cutting")
  if (!identical(piece[cut], upper[cut])) same[intersect(cut, names(piece))] <- FALSE
  if (all(same)) nothing else piece[!same]
}

# Returns a path of a short form as a path of the field `net`.
net_form_path <- function(path) {
  rules <- c(
    "^wings\\.(upper|lower|side)\\." = "net.\\1.\\1_wing.", "^wings\\." = "net.upper.wings.",
    "^square\\." = "net.upper.square.", "^sections\\.([^.]*)\\.back\\." = "net.upper.\\1.",
    "^sections\\.([^.]*)\\.belly\\." = "net.lower.\\1.",
    "^sections\\.([^.]*)\\.side\\." = "net.side.\\1.", "^sections\\." = "net.upper.",
    "^(net\\..*\\.meshes)\\.(tip|upper)$" = "\\1.front",
    "^(net\\..*\\.meshes)\\.(base|lower)$" = "\\1.rear"
  )
  for (k in seq_along(rules)) path <- sub(names(rules)[k], rules[[k]], path)
  path
}

# Returns the pieces of a panel ahead of the first section.
pieces_ahead <- function(name, fields, plan) {
  wings <- plan$wings
  if (!is.null(wings$mesh_size)) return(list(wings = as_wings(wings, gathered = TRUE)))
  ahead <- list()
  if (!is.null(wings[[name]])) {
    tier <- if (name == "side") as_piece(wings$side) else as_wings(wings[[name]])
    ahead[[paste0(name, "_wing")]] <- tier
  }
  if (name == "side" && !is.null(fields$wings$jib)) {
    deep <- fields$wings$jib$deep
    depth <- front_depth(fields)
    free <- deep - max(depth[["upper"]] - depth[["side"]], 0) / fields$wings$side$mesh_size
    jib <- as_piece(wings$side)
    jib$meshes <- list(front = 0, rear = jib$meshes$front, deep = deep)
    jib$cutting <- list(left = "AN")
    ahead <- c(list(jib = c(jib, list(flying = list(left = free, right = deep)))), ahead)
  }
  if (name == "upper" && !is.null(plan$square)) ahead$square <- as_piece(plan$square)
  ahead
}

as_piece <- function(given) {
  given$meshes <- list(front = given$meshes$upper, rear = given$meshes$lower,
    deep = given$meshes$deep)
  given
}

as_wings <- function(given, gathered = FALSE) {
  given$meshes <- list(front = given$meshes$tip, rear = given$meshes$base,
    deep = given$meshes$deep)
  if (isTRUE(given$flying == 0)) given$flying <- NULL
  c(list(pair = TRUE), if (gathered) list(gathered = TRUE), given)
}
