# What sliders do to the numbers of a lattice, found by filling it at several of their values.
#
# Over the range of a slider, t from -1 to 1, every number that changes is a series of Chebyshev
# polynomials through lattices filled at their nodes; a few patterns over an array, each with a
# series, hold all of them (by singular values). Linear and quadratic changes are exact so, roots
# and the like to rounding. Where two sliders change one array together, what they do beyond their
# sum is such a series in both. Lattices filled at values between are what all of it is held to.

# Share of an array's largest number at which a series ends, and beyond which it is refused.
series_reached <- 1e-13
series_refused <- 1e-10
# How many nodes are tried, of one slider and of each of two.
series_nodes <- c(3L, 5L, 9L, 17L)
pair_nodes <- c(2L, 3L, 5L)

# A function(values) that fills the lattice of a state with sliders at values: arrays, or a text
# that says why it cannot.
lattice_filler <- function(state, fields, standard) {
  shape <- state_shape(state)
  asked <- state$lattice$counts$asked
  netting <- Find(function(netting) identical(panels_of_bars(state$si, netting), asked$bars),
    list(NULL, "bars", "cells"))
  own <- own_values(fields)
  known <- list2DF(engine_fields())
  real <- known$name[known$type == "number"]
  base <- NULL
  fill <- function(values = own) {
    moved <- which(values != own)
    lattice <- tryCatch({
      gear <- if (length(moved)) set_free(state$gear, fields[moved], values[moved]) else state$gear
      si <- gear_si(gear)
      build_lattice(si, asked$nodes, netting, shape)
    }, codend_error_plan = function(e) NULL)
    if (is.null(lattice)) return("is not allowed by the plan")
    if (!settled_alike(lattice, shape)) return("divides the gear otherwise")
    if (!is.null(si$catch)) lattice <- set_catch_front(lattice, shape$lattice$catch$blocked)
    arrays <- filled_arrays(si, lattice, standard)
    if (is.null(base)) base <<- arrays
    first_of(odd_array(arrays, base, real), arrays)
  }
  fill()
  fill
}

# The first array in which two fillings differ by more than numbers, in words, or NULL.
odd_array <- function(arrays, base, real) {
  if (!identical(names(arrays), names(base))) return("gives the gear other parts")
  if (!identical(lengths(arrays), lengths(base))) return("divides the gear otherwise")
  for (name in names(arrays)) {
    if (identical(arrays[[name]], base[[name]])) next
    number <- is.double(arrays[[name]]) &&
      (!startsWith(name, "model.") || sub(".*[.]", "", name) %in% real)
    if (!number) return(paste0("changes ", gsub("[._/]", " ", sub("^[a-z]+[./]", "", name))))
  }
  NULL
}

# The series of sliders: list(fields = those that fit, terms = list(of = numbers of one or two
# fields, array, index (from 0), pattern (numbers x patterns), series (a matrix patterns x
# coefficients)), base = arrays, left_out = words by field, misfit = the largest share left
# between). A slider whose range was asked for and does not fit is an error.
slider_series <- function(state, fields, standard) {
  gear <- state$gear
  fill <- lattice_filler(state, fields, standard)
  base <- fill()
  left_out <- character()
  singles <- list()
  for (k in seq_along(fields)) {
    found <- one_series(fill, base, fields, k)
    for (share in slider_shares[-1L]) {
      if (!is.character(found) || fields[[k]]$fixed) break
      range <- usual_range(gear, fields[[k]], share)
      if (is.null(range)) break
      narrower <- range$upper - range$lower < fields[[k]]$upper - fields[[k]]$lower
      if (!narrower) next
      fields[[k]][c("lower", "upper")] <- range[c("lower", "upper")]
      found <- one_series(fill, base, fields, k)
    }
    if (is.character(found)) {
      if (fields[[k]]$asked) {
        abort_argument("{.arg sliders} has {.field {fields[[k]]$name}}, which {found}: a shared page
          cannot change it.")
      }
      left_out[fields[[k]]$name] <- found
      found <- NULL
    }
    singles[[k]] <- list(terms = found)
  }
  kept <- which(!vapply(fields, `[[`, "", "name") %in% names(left_out))
  terms <- unlist(lapply(kept, function(k) singles[[k]]$terms), recursive = FALSE)
  for (f in kept) for (g in kept[kept > f]) {
    if (any(c(f, g) %in% dropped_of(fields, left_out))) next
    found <- pair_series(fill, base, fields, f, g, singles)
    if (!is.character(found)) {
      terms <- c(terms, found)
      next
    }
    name <- vapply(fields[c(f, g)], `[[`, "", "name")
    if (fields[[g]]$asked) {
      abort_argument("{.arg sliders} has {.field {name}}, which {found}: give one of them, or
        narrower ranges.")
    }
    left_out[name[2L]] <- paste("beside", name[1L], found)
  }
  kept <- setdiff(kept, dropped_of(fields, left_out))
  terms <- Filter(function(term) all(term$of %in% kept), terms)
  # what three and more do together no series has
  while ((off <- misfit_together(fill, base, fields, terms, kept)) > 10 * series_refused) {
    joint <- unlist(lapply(terms, function(term) if (length(term$of) > 1L) term$of))
    last <- max(joint, kept[1L])
    name <- vapply(fields, `[[`, "", "name")
    if (fields[[last]]$asked) {
      abort_argument("{.arg sliders} has {.field {name[sort(unique(joint))]}}, more than two of
        which change the same numbers together: give fewer.")
    }
    left_out[name[last]] <- "changes the same numbers as two others do together"
    kept <- setdiff(kept, last)
    terms <- Filter(function(term) all(term$of %in% kept), terms)
  }
  renumber <- match(seq_along(fields), kept)
  terms <- lapply(terms, function(term) {
    term$of <- renumber[term$of]
    term
  })
  fields <- fields[kept]
  list(fields = fields, terms = terms, base = base, left_out = left_out, misfit = off)
}

dropped_of <- function(fields, left_out) {
  which(vapply(fields, `[[`, "", "name") %in% names(left_out))
}

to_share <- function(field, value) {
  (2 * value - field$lower - field$upper) / (field$upper - field$lower)
}
of_share <- function(field, t) {
  value <- (field$lower + field$upper + t * (field$upper - field$lower)) / 2
  if (field$whole) round(value) else value
}

# Chebyshev polynomials 0 to n - 1 at t: a column each.
chebyshev <- function(t, n) {
  outer(t, seq_len(n) - 1L, function(t, k) cos(k * acos(pmin(pmax(t, -1), 1))))
}

lobatto <- function(n) -cos(pi * (seq_len(n) - 1L) / (n - 1L))

# Arrays minus base, as doubles.
array_change <- function(arrays, base, name) as.double(arrays[[name]]) - as.double(base[[name]])

array_scales <- function(base) {
  vapply(base, function(x) {
    if (is.numeric(x) && length(x) && !inherits(x, "groups")) max(abs(x), 1e-300) else 1
  }, 0)
}

# The terms of one slider, or why it has none.
one_series <- function(fill, base, fields, k) {
  field <- fields[[k]]
  own <- own_values(fields)
  known <- list()
  at <- function(value) {
    key <- format(value, digits = 17)
    if (is.null(known[[key]])) known[[key]] <<- fill(replace(own, k, value))
    known[[key]]
  }
  for (n in series_nodes) {
    value <- unique(of_share(field, lobatto(n)))
    t <- to_share(field, value)
    middle <- (t[-1L] + t[-length(t)]) / 2 + 0.01 * (n < 9)
    between <- setdiff(unique(of_share(field, middle)), value)
    if (length(between) > 3L) between <- between[round(seq(1, length(between), length.out = 3L))]
    all <- lapply(value, at)
    odd <- Filter(is.character, all)
    if (length(odd)) return(odd[[1L]])
    checks <- lapply(between, at)
    odd <- Filter(is.character, checks)
    if (length(odd)) return(odd[[1L]])
    found <- series_of(all, t, base, k, to_share(field, field$value))
    off <- max(0, mapply(function(value, arrays) {
      misfit(arrays, base, found, replace(own, k, value), fields)
    }, between, checks))
    if (off <= series_reached || length(value) < n) break
  }
  if (off > series_refused) {
    return(sprintf("changes numbers in a way that no series holds (%.0e of them left)", off))
  }
  found
}

# Terms through arrays at t, from base.
series_of <- function(all, t, base, k, own) {
  n <- length(t)
  scale <- array_scales(base)
  solved <- solve(chebyshev(t, n))
  terms <- lapply(names(base), function(name) {
    if (all(vapply(all, function(one) identical(one[[name]], base[[name]]), NA))) return(NULL)
    y <- matrix(vapply(all, array_change, numeric(length(base[[name]])), base, name), ncol = n)
    changed <- which(do.call(pmax, as.data.frame(abs(y))) > 1e-15 * scale[[name]])
    if (!length(changed)) return(NULL)
    of <- low_rank(y[changed, , drop = FALSE] %*% t(solved), scale[[name]])
    # nothing at the gear's own value
    of$series[, 1L] <- of$series[, 1L] - drop(of$series %*% t(chebyshev(own, n)))
    list(of = k, array = name, index = changed - 1L, pattern = of$pattern, series = of$series)
  })
  Filter(Negate(is.null), terms)
}

# A matrix as pattern %*% series with as few patterns as rounding of numbers of this size allows.
low_rank <- function(y, size) {
  parts <- svd(y)
  kept <- which(parts$d > max(1e-15 * parts$d[1L], 1e-15 * size))
  list(
    pattern = parts$u[, kept, drop = FALSE],
    series = parts$d[kept] * t(parts$v[, kept, drop = FALSE])
  )
}

# What terms make of an array's base: their sum over numbers, at values of all sliders.
series_change <- function(terms, base, name, values, fields) {
  change <- numeric(length(base[[name]]))
  for (term in terms) {
    if (term$array != name) next
    t <- mapply(to_share, fields[term$of], values[term$of])
    share <- term_shares(term, t)
    change[term$index + 1L] <- change[term$index + 1L] + drop(term$pattern %*% share)
  }
  change
}

# The sums of a term's series at t.
term_shares <- function(term, t) {
  if (length(term$of) == 1L) return(drop(term$series %*% t(chebyshev(t, ncol(term$series)))))
  n <- sqrt(ncol(term$series))
  first <- chebyshev(t[1L], n)
  second <- chebyshev(t[2L], n)
  drop(term$series %*% as.vector(t(first) %*% second))
}

# The largest misfit of terms to arrays, as a share of the array's largest number.
misfit <- function(arrays, base, terms, values, fields) {
  scale <- array_scales(base)
  touched <- union(unique(vapply(terms, `[[`, "", "array")),
    names(base)[!mapply(identical, arrays, base)])
  max(0, vapply(touched, function(name) {
    off <- array_change(arrays, base, name) - series_change(terms, base, name, values, fields)
    max(abs(off)) / max(scale[[name]], abs(as.double(arrays[[name]])))
  }, 0))
}

# The terms of two sliders beyond their sum; list() where there are none, or why not.
pair_series <- function(fill, base, fields, f, g, singles) {
  one <- singles[[f]]$terms
  two <- singles[[g]]$terms
  arrays_of <- function(terms) vapply(terms, `[[`, "", "array")
  both <- intersect(arrays_of(one), arrays_of(two))
  meets <- function(name) {
    places <- function(terms) unlist(lapply(terms[arrays_of(terms) == name], `[[`, "index"))
    length(intersect(places(one), places(two))) > 0L
  }
  # what two change of itself alone lies apart
  if (!length(both) || !any(vapply(both, meets, NA))) return(list())
  own <- own_values(fields)
  pair <- c(f, g)
  values_at <- function(t) replace(own, pair, mapply(of_share, fields[pair], t))
  fill_at <- function(t) fill(values_at(t))
  tests <- list(c(0.83, -0.71), c(-0.57, 0.64))
  checks <- lapply(tests, fill_at)
  if (any(vapply(checks, is.character, NA))) return("cannot both change freely")
  off_of <- function(terms) {
    max(mapply(function(t, arrays) {
      misfit(arrays, base, terms, values_at(t), fields)
    }, tests, checks))
  }
  sum <- c(one, two)
  if (off_of(sum) <= 10 * series_reached) return(list())
  for (n in pair_nodes) {
    values <- lapply(pair, function(k) unique(of_share(fields[[k]], lobatto(n))))
    if (any(lengths(values) < n)) break
    t <- Map(to_share, fields[pair], values)
    grid <- expand.grid(t[[1L]], t[[2L]])
    all <- lapply(seq_len(nrow(grid)), function(r) fill_at(as.double(grid[r, ])))
    if (any(vapply(all, is.character, NA))) return("cannot both change freely")
    found <- tensor_series(all, grid, t, base, fields, f, g, sum)
    off <- off_of(c(sum, found))
    if (off <= 10 * series_reached) break
  }
  if (off > series_refused) {
    return(sprintf("change numbers together in a way that no series holds (%.0e left)", off))
  }
  found
}

tensor_series <- function(all, grid, t, base, fields, f, g, sum) {
  n <- length(t[[1L]])
  own <- own_values(fields)
  solved <- kronecker(solve(chebyshev(t[[2L]], n)), solve(chebyshev(t[[1L]], n)))
  scale <- array_scales(base)
  terms <- lapply(names(base), function(name) {
    if (all(vapply(all, function(one) identical(one[[name]], base[[name]]), NA))) return(NULL)
    y <- vapply(seq_along(all), function(r) {
      values <- replace(own, c(f, g), mapply(of_share, fields[c(f, g)], as.double(grid[r, ])))
      array_change(all[[r]], base, name) - series_change(sum, base, name, values, fields)
    }, numeric(length(base[[name]])))
    y <- matrix(y, ncol = n * n)
    changed <- which(do.call(pmax, as.data.frame(abs(y))) > 1e-14 * scale[[name]])
    if (!length(changed)) return(NULL)
    of <- low_rank(y[changed, , drop = FALSE] %*% t(solved), scale[[name]])
    list(of = c(f, g), array = name, index = changed - 1L, pattern = of$pattern,
      series = of$series)
  })
  Filter(Negate(is.null), terms)
}

# The misfit with these sliders at once, at a few places that the plan allows.
misfit_together <- function(fill, base, fields, terms, kept) {
  if (length(kept) < 2L) return(0)
  max(vapply(1:3, function(k) {
    t <- cos(pi * ((kept * 0.618034 * k + 0.1 * k) %% 1))
    values <- replace(own_values(fields), kept, mapply(of_share, fields[kept], t))
    arrays <- fill(values)
    if (is.character(arrays)) return(0)
    misfit(arrays, base, terms, values, fields)
  }, 0))
}
