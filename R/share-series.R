# The effect of sliders on the numbers of a gear, from its plan at several values of the sliders.
#
# Over the range of a slider, the change of each number is a polynomial in the distance from the
# gear's own value. If several sliders change the same number, it is the sum or the product of their
# effects; without one of these rules, a slider is left out. Sliders without common numbers move
# together, so that one evaluation of the plan serves many sliders.
#
# A term is list(of = slider, index = numbers that change, change = coefficients [numbers x
# powers]).

# Residual of a sufficient degree, its limit, and the limit of the error with all sliders moved, as
# fractions of the largest number in an array.
series_reached <- 1e-12
series_limit <- 1e-10
series_refused <- 1e-9
# Degrees to try with a number of values. The residual is a check, as there are more values.
series_degrees <- list(`5` = 1:2, `24` = c(4L, 8L, 16L))

# Numbers for the initial layout and the meshing. A page needs neither, as it starts from a shape.
layout_numbers <- "^numbers[.]gear[.].*[.](near|upright|room|segments)$"

# Returns list(base = arrays of the gear, names = of its arrays of numbers, array = array of each
# number, own = numbers of the gear, fill). `fill(values)` returns all numbers at values of the
# sliders, or a string with the reason why the plan allows none.
gear_filler <- function(state, fields, standard) {
  asked <- state$mesh$counts$asked
  netting <- requested_netting(state)
  own <- own_values(fields)
  arrays_at <- function(values) {
    moved <- which(values != own)
    gear <- if (length(moved)) set_free(state$gear, fields[moved], values[moved]) else state$gear
    si <- gear_si(gear)
    # the page uses the mesh of the state
    if (!identical(requested_mesh_size(si, asked$nodes, netting), asked)) {
      return("changes the mesh of the model")
    }
    shared_arrays(si, netting, standard)
  }
  base <- arrays_at(own)
  layout <- grep(layout_numbers, names(base), value = TRUE)
  is_number <- vapply(base, function(x) is.numeric(x) && !inherits(x, "groups"), NA)
  numbers <- setdiff(names(base)[is_number], layout)
  fill <- function(values = own) {
    arrays <- tryCatch(arrays_at(values),
      codend_error_plan = function(e) "is not allowed by the plan")
    if (is.character(arrays)) return(arrays)
    arrays[layout] <- base[layout]
    first_of(odd_array(arrays, base), as.double(unlist(arrays[numbers], use.names = FALSE)))
  }
  list(
    base = base, names = numbers, fill = fill, own = fill(),
    array = factor(rep(seq_along(numbers), lengths(base[numbers])), seq_along(numbers))
  )
}

# Returns how two gears differ in anything but numbers, or NULL.
odd_array <- function(arrays, base) {
  if (!identical(names(arrays), names(base)) || !identical(lengths(arrays), lengths(base))) {
    return("changes the parts of the gear")
  }
  changed <- !mapply(identical, arrays, base) & !vapply(arrays, is.double, NA)
  if (!any(changed)) return(NULL)
  name <- names(arrays)[changed][1L]
  paste0("changes ", gsub("[._/]", " ", sub("^[a-z]+[./]", "", name)))
}

# Returns list(fields = sliders with a series, terms, filler, product = TRUE for numbers that are
# products, left_out = reasons by field, misfit).
# If the user requested a slider that has no series, it throws an error.
slider_series <- function(state, fields, standard) {
  filler <- gear_filler(state, fields, standard)
  name <- vapply(fields, `[[`, "", "name")
  own <- own_values(fields)
  every <- seq_along(fields)
  base <- filler$own
  size <- array_sizes(filler, base)
  left_out <- character()
  kept <- function() which(!name %in% names(left_out))
  leave <- function(k, found, instead = "a shared page cannot change it") {
    if (fields[[k]]$asked) {
      abort_argument("{.arg sliders} has {.field {name[k]}}, which {found}: {instead}.")
    }
    left_out[name[k]] <<- found
  }
  # Returns the values of all sliders with `of` at fractions `t` of their ranges.
  values_at <- function(of, t) replace(own, of, mapply(of_share, fields[of], t[of]))

  # Reduces the range of a slider. Returns FALSE if this is not possible.
  narrow <- function(k, share) {
    range <- if (!fields[[k]]$fixed) usual_range(state$gear, fields[[k]], share)
    if (!is.null(range)) fields[[k]][c("lower", "upper")] <<- range[c("lower", "upper")]
    !is.null(range)
  }
  shares <- c(slider_shares[-1L], 0)
  # numbers that each slider changes
  numbers <- lapply(every, function(k) {
    for (share in shares) {
      ends <- lapply(c(-1, 1), function(t) filler$fill(values_at(k, rep(t, k))))
      found <- first_of(Find(is.character, ends), ends[[2L]])
      if (is.numeric(found)) return(which(abs(found - base) > 1e-15 * size))
      if (!narrow(k, share)) break
    }
    leave(k, found)
    integer()
  })
  meet <- crossprod(vapply(numbers, function(index) 1 * (seq_along(base) %in% index), base)) > 0
  group <- integer(length(every))
  for (k in kept()) group[k] <- setdiff(every, group[meet[k, ]])[1L]

  # Returns all numbers with sliders moved. If the plan does not allow them together, halves move;
  # a single slider that it does not allow has no effect, which no series fits.
  moved <- function(of, t) {
    found <- filler$fill(values_at(of, t))
    if (is.numeric(found)) return(found)
    if (length(of) == 1L) return(base)
    half <- seq_along(of) <= length(of) / 2
    index <- unlist(numbers[of[!half]])
    replace(moved(of[half], t), index, moved(of[!half], t)[index])
  }
  terms <- list()
  # Adds terms of sliders from a number of values. Returns the sliders that need more values.
  add_terms <- function(of, values) {
    if (!length(of)) return(of)
    t <- cos(pi * seq(0, 1, length.out = as.integer(values)))
    change <- vapply(t, function(t) moved(of, rep(t, length(every))) - base, base)
    found <- lapply(of, function(k) {
      x <- slider_position(fields[[k]], vapply(t, of_share, 0, field = fields[[k]]))
      fitted_term(k, numbers[[k]], t(change[numbers[[k]], , drop = FALSE]), x,
        size[numbers[[k]]], series_degrees[[values]])
    })
    good <- vapply(found, function(term) term$off <= series_limit, NA)
    terms <<- c(terms, found[good])
    of[!good]
  }
  pending <- kept()
  for (share in shares) {
    pending <- as.integer(unlist(lapply(split(pending, group[pending]), function(of) {
      add_terms(add_terms(of, "5"), "24")
    })))
    for (k in Filter(function(k) !narrow(k, share), pending)) {
      leave(k, "changes the model too irregularly for a series")
    }
    pending <- intersect(pending, kept())
  }
  # Returns the largest errors at three places that the plan allows, NULL if it allows none.
  misfits <- function(product) {
    t <- lapply(1:12, function(k) cos(pi * (((every * 0.618034 + 0.1) * k) %% 1)) / (1 + k %/% 4))
    found <- list()
    for (t in t) if (length(found) < 3L) {
      off <- misfit(terms, filler, fields, values_at(kept(), t), product)
      if (is.numeric(off)) found <- c(found, list(off))
    }
    if (length(found)) do.call(pmax, found)
  }
  product <- base != 0 & first_of(misfits(base != 0), Inf) <= series_limit
  while (max(0, off <- misfits(product)) > series_refused) {
    wrong <- which(off > series_refused)
    # the slider that changes few other numbers is left out
    share <- vapply(numbers, function(index) mean(c(index %in% wrong, FALSE)), 0)
    share <- share * (every %in% kept())
    leave(max(which(share == max(share))),
      "changes the same numbers as other sliders, but neither as sum nor as product",
      "use fewer sliders")
  }
  terms <- Filter(function(term) term$of %in% kept(), terms)
  terms <- lapply(terms, function(term) replace(term, "of", match(term$of, kept())))
  list(fields = fields[kept()], terms = terms, filler = filler, product = product,
    left_out = left_out, misfit = max(0, off))
}

# Returns the value of a slider at a fraction of its range, -1 to 1.
of_share <- function(field, t) {
  value <- (field$lower + field$upper + t * (field$upper - field$lower)) / 2
  if (field$whole) round(value) else value
}

# Returns the distance of values from the gear's own value, as a fraction of half the range.
slider_position <- function(field, values) {
  2 * (values - field$value) / (field$upper - field$lower)
}

# Returns all numbers at values of all sliders.
series_numbers <- function(terms, fields, values, base, product) {
  x <- base
  for (term in terms) {
    k <- term$index
    position <- slider_position(fields[[term$of]], values[term$of])
    change <- drop(term$change %*% position^seq_len(ncol(term$change)))
    x[k] <- x[k] + change * ifelse(product[k], x[k] / base[k], 1)
  }
  x
}

# Returns the largest number in the array of each number, but at least 1e-6.
array_sizes <- function(filler, x) {
  pmax(as.vector(tapply(abs(x), filler$array, max))[filler$array], 1e-6)
}

# Returns the errors of terms as fractions of the largest number in each array, or a string with
# the reason why the plan allows no such gear.
misfit <- function(terms, filler, fields, values, product) {
  x <- filler$fill(values)
  if (is.character(x)) return(x)
  off <- x - series_numbers(terms, fields, values, filler$own, product)
  abs(off) / array_sizes(filler, filler$own)
}

# Returns the term of a slider with its largest residual `off`. change: of the numbers `index`
# [positions x numbers].
fitted_term <- function(of, index, change, positions, size, degrees) {
  for (degree in degrees) {
    powers <- qr(outer(positions, seq_len(degree), `^`))
    found <- qr.coef(powers, change)
    off <- max(0, abs(t(qr.resid(powers, change))) / size)
    if (off <= series_reached) break
  }
  # a whole number has fewer values than powers
  found[is.na(found)] <- 0
  list(of = of, index = index, change = t(found), off = off)
}
