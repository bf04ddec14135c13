# Named arrays as one text for a shared page, and a lattice as such arrays.

# All arrays of an engine list by path, as the engine's reader has them: a list of groups as their
# count, of class "groups".
flat_arrays <- function(x, prefix = "") {
  out <- list()
  for (name in names(x)) {
    value <- x[[name]]
    path <- paste0(prefix, name)
    if (is.null(value)) next
    if (!is.list(value)) {
      out[[path]] <- as.vector(value)
    } else if (is.null(names(value))) {
      out[[path]] <- structure(length(value), class = "groups")
      for (k in seq_along(value)) out <- c(out, flat_arrays(value[[k]], paste0(path, ".", k, ".")))
    } else {
      out <- c(out, flat_arrays(value, paste0(path, ".")))
    }
  }
  out
}

# Arrays as list(head = of every array its type (d: double, f: single, i: whole, w: words, g:
# groups), count and first byte, body = base64 of their bytes, deflated). Bytes of like weight stand
# together: so they take half as much.
packed_arrays <- function(arrays) {
  head <- bodies <- list()
  at <- 0
  for (name in names(arrays)) {
    x <- arrays[[name]]
    if (inherits(x, "groups")) {
      head[[name]] <- list("g", as.integer(unclass(x)))
    } else if (is.character(x)) {
      levels <- unique(x)
      codes <- match(x, levels) - 1L
      body <- shuffled(codes, 4L)
      head[[name]] <- list("w", length(x), at, I(levels))
      bodies[[name]] <- body
      at <- at + length(body)
    } else {
      single <- inherits(x, "single_floats")
      type <- if (single) "f" else if (is.double(x)) "d" else "i"
      numbers <- if (type == "i") as.integer(x) else as.double(x)
      body <- shuffled(numbers, c(d = 8L, f = 4L, i = 4L)[[type]])
      head[[name]] <- list(type, length(x), at)
      bodies[[name]] <- body
      at <- at + length(body)
    }
  }
  list(head = head, body = deflated(do.call(c, c(list(raw()), unname(bodies)))))
}

# What needs no more than single floats.
single_floats <- function(x) structure(as.double(x), class = "single_floats")

shuffled <- function(x, size) {
  raw <- writeBin(x, raw(), size = size, endian = "little")
  as.vector(t(matrix(raw, size)))
}

deflated <- function(raw) {
  gsub("[\r\n]", "", jsonlite::base64_enc(memCompress(raw, "gzip")))
}

# What of a gear's lattice a page fills anew where a slider moves, by name: the engine's arrays,
# with `page/` those that measures and pictures take. A catch's pressure follows its front.
filled_arrays <- function(si, lattice) {
  engine <- lattice$engine
  # they act at a surface alone, and one that joins others changes their number
  if (!si$water$free_surface) engine$volumes <- lapply(engine$volumes, `[`, 0L)
  engine <- flat_arrays(engine)
  engine <- engine[!names(engine) %in% c("wake", "pressure.weight")]
  c(engine, page_arrays(si, lattice))
}

page_arrays <- function(si, lattice) {
  n <- length(si$ropes)
  parts <- nrow(lattice$parts)
  strength <- rep(0, parts)
  strength[seq_len(n)] <- vapply(si$ropes, function(rope) as.double(first_of(rope$strength, 0)), 0)
  strength[is.na(strength)] <- 0
  held <- which(lattice$engine$held[seq_len(lattice$nodes)])
  boards <- unlist(lapply(unname(si$otter_boards), function(board) {
    c(board$attachment, board$chord, board$span)
  }))
  vessel <- si$vessel
  of <- list(
    rope_mass = vapply(si$ropes, `[[`, 0, "mass_per_length", USE.NAMES = FALSE),
    rope_volume = vapply(si$ropes, `[[`, 0, "volume_per_length", USE.NAMES = FALSE),
    speed = si$towing$speed, held = as.vector(lattice$start[, held]),
    size = part_sizes(si, lattice), strength = strength, boards = as.double(boards),
    vessel.speed = vessel$pull$speed, vessel.pull = vessel$pull$pull, vessel.power = vessel$power,
    vessel.load = vessel[["fuel"]]$load, vessel.consumption = vessel[["fuel"]]$consumption,
    vessel.density = if (!is.null(vessel[["fuel"]])) vessel$fuel_density,
    vessel.catch = vessel$catch_per_hour,
    width = vapply(si$panels, twine_width, 0, USE.NAMES = FALSE),
    stall = vapply(si$otter_boards, stall_angle, 0, USE.NAMES = FALSE),
    shares = unlist(lapply(si$measures, function(measure) {
      if (measure$kind == "volume_share") measure$of
    }), use.names = FALSE)
  )
  if (!is.null(si$catch)) {
    of <- c(of, list(
      catch.volume = as.double(si$catch$volume), catch.blocked = as.double(si$catch$blocked),
      catch.deep = as.double(si$catch$deep), catch.depth = as.vector(lattice$catch$depth),
      catch.across = as.vector(lattice$catch$across), catch.real = lattice$catch$real,
      catch.weight = lattice$catch$weight
    ))
    # a volume or a front
    of <- Filter(function(x) !anyNA(x), of)
  }
  of <- Filter(Negate(is.null), of)
  setNames(of, paste0("page/", names(of)))
}
