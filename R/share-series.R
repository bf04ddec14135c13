# The effect of sliders on the numbers of a gear, from its plan at several values of the sliders.
#
# Over the range of a slider, each number that changes is the polynomial through its values at the
# nodes of the slider: the gear's own value, where the change is 0, and Chebyshev-Lobatto nodes.
# Linear and quadratic changes are exact, others such as roots accurate to rounding. If two sliders
# change the same number, a polynomial in both adds their interaction. All polynomials are checked
# against the plan at other values.
#
# A term is list(of = one or two sliders, nodes = values of each slider, index = numbers that
# change, change = changes [numbers x nodes of both sliders], the first slider fastest).

# Target and limit of the misfit, as a fraction of the largest number in an array.
series_reached <- 1e-13
series_refused <- 1e-10
# Numbers of nodes to try, for one slider and for each of two sliders.
series_nodes <- list(c(3L, 5L, 9L, 17L), c(2L, 3L, 5L))
# Fractions of the range, -1 to 1, at which terms are checked against the plan.
series_checks <- cbind(c(0.83, -0.57, 0.31, -0.14), c(-0.71, 0.64, -0.26, 0.93))

# Numbers for the initial layout and the meshing. A page needs neither, as it starts from a shape.
layout_numbers <- "^numbers[.]gear[.].*[.](near|upright|room|segments)$"

# Returns list(base = arrays of the gear, names = of its arrays of numbers, array = array of each
# number, fill). `fill(values)` returns all numbers at values of the sliders, or a string with the
# reason why the plan allows none.
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
  known <- list()
  fill <- function(values = own) {
    key <- paste(format(values, digits = 17), collapse = " ")
    if (!is.null(known[[key]])) return(known[[key]])
    arrays <- tryCatch(arrays_at(values),
      codend_error_plan = function(e) "is not allowed by the plan")
    found <- arrays
    if (is.list(arrays)) {
      arrays[layout] <- base[layout]
      found <- odd_array(arrays, base)
      if (is.null(found)) found <- as.double(unlist(arrays[numbers], use.names = FALSE))
    }
    known[[key]] <<- found
    found
  }
  list(
    base = base, names = numbers, fill = fill,
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

# Returns list(fields = sliders with a series, terms, filler, left_out = reasons by field, misfit).
# If the user requested a slider that has no series, it throws an error.
slider_series <- function(state, fields, standard) {
  filler <- gear_filler(state, fields, standard)
  name <- vapply(fields, `[[`, "", "name")
  left_out <- character()
  leave <- function(k, found, instead = "a shared page cannot change it") {
    if (fields[[k]]$asked) {
      abort_argument("{.arg sliders} has {.field {name[k]}}, which {found}: {instead}.")
    }
    left_out[name[k]] <<- found
  }
  kept <- function() which(!name %in% names(left_out))
  terms <- list()
  for (k in seq_along(fields)) {
    found <- fitted_term(filler, fields, k)
    for (share in slider_shares[-1L]) {
      if (!is.character(found) || fields[[k]]$fixed) break
      range <- usual_range(state$gear, fields[[k]], share)
      if (is.null(range)) break
      narrower <- range$upper - range$lower < fields[[k]]$upper - fields[[k]]$lower
      if (!narrower) next
      fields[[k]][c("lower", "upper")] <- range[c("lower", "upper")]
      found <- fitted_term(filler, fields, k)
    }
    if (is.character(found)) leave(k, found) else terms[[k]] <- found
  }
  for (f in kept()) for (g in kept()[kept() > f]) {
    if (!all(c(f, g) %in% kept())) next
    # sliders without common numbers do not interact
    if (!length(intersect(terms[[f]]$index, terms[[g]]$index))) next
    found <- fitted_term(filler, fields, c(f, g), terms[c(f, g)])
    if (is.character(found)) {
      leave(g, paste("together with", name[f], found), "use only one slider, or narrower ranges")
    } else if (length(found$index)) {
      terms <- c(terms, list(found))
    }
  }
  of_kept <- function() {
    Filter(function(term) length(term$index) && all(term$of %in% kept()), terms)
  }
  # series do not cover interactions of three or more sliders
  while ((off <- misfit_together(filler, fields, of_kept(), kept())) > 10 * series_refused) {
    joint <- unlist(lapply(of_kept(), function(term) if (length(term$of) > 1L) term$of))
    leave(max(joint, kept()[1L]), "changes the same numbers as two other sliders",
      "use fewer sliders")
  }
  terms <- lapply(of_kept(), function(term) {
    term$of <- match(term$of, kept())
    term
  })
  list(fields = fields[kept()], terms = terms, filler = filler, left_out = left_out, misfit = off)
}

# Returns the value of a slider at a fraction of its range, -1 to 1.
of_share <- function(field, t) {
  value <- (field$lower + field$upper + t * (field$upper - field$lower)) / 2
  if (field$whole) round(value) else value
}

# Returns the nodes of a slider: the gear's own value, and those of `n` nodes that differ from it.
slider_nodes <- function(field, n) {
  nodes <- unique(of_share(field, -cos(pi * (seq_len(n) - 1L) / (n - 1L))))
  c(field$value, nodes[abs(nodes - field$value) > 1e-3 * (field$upper - field$lower)])
}

# Returns the weights of the changes at all nodes of a term's sliders: Lagrange's polynomials.
node_weights <- function(nodes, values) {
  each <- Map(function(nodes, value) {
    vapply(seq_along(nodes), function(k) prod((value - nodes[-k]) / (nodes[k] - nodes[-k])), 0)
  }, nodes, values)
  as.vector(Reduce(outer, each))
}

# Returns the change of all numbers by terms at values of all sliders.
series_change <- function(terms, filler, values) {
  change <- numeric(length(filler$array))
  for (term in terms) {
    change[term$index] <- change[term$index] +
      drop(term$change %*% node_weights(term$nodes, values[term$of]))
  }
  change
}

# Returns the largest number in the array of each number, but at least 1e-6.
array_sizes <- function(filler, x) {
  pmax(as.vector(tapply(abs(x), filler$array, max))[filler$array], 1e-6)
}

# Returns the largest error of terms as a fraction of the largest number in its array, or a string
# with the reason why the plan allows no such gear.
misfit <- function(terms, filler, values) {
  base <- filler$fill()
  x <- filler$fill(values)
  if (is.character(x)) return(x)
  off <- x - base - series_change(terms, filler, values)
  max(0, abs(off) / array_sizes(filler, pmax(abs(x), abs(base))))
}

# Returns the term of one slider, or of two in addition to `terms`, or a string with a reason.
fitted_term <- function(filler, fields, of, terms = list()) {
  own <- own_values(fields)
  base <- filler$fill()
  values_at <- function(t) replace(own, of, mapply(of_share, fields[of], t))
  checks <- lapply(seq_len(nrow(series_checks)), function(k) {
    values_at(series_checks[k, seq_along(of)])
  })
  # Returns the largest misfit, or a string with a reason.
  held_to <- function(terms) {
    off <- lapply(checks, function(values) misfit(terms, filler, values))
    odd <- Filter(is.character, off)
    if (length(odd)) odd[[1L]] else max(unlist(off))
  }
  nothing <- list(of = of, nodes = list(), index = integer(), change = matrix(0, 0L, 0L))
  if (length(terms)) {
    off <- held_to(terms)
    if (is.character(off)) return(off)
    if (off <= 10 * series_reached) return(nothing)
  }
  for (n in series_nodes[[length(of)]]) {
    nodes <- lapply(fields[of], slider_nodes, n)
    values <- apply(expand.grid(nodes), 1L, function(at) replace(own, of, at), simplify = FALSE)
    all <- lapply(values, filler$fill)
    odd <- Filter(is.character, all)
    if (length(odd)) return(odd[[1L]])
    y <- mapply(function(x, values) x - base - series_change(terms, filler, values), all, values)
    y <- matrix(y, ncol = length(all))
    index <- which(do.call(pmax, as.data.frame(abs(y))) > 1e-15 * array_sizes(filler, base))
    found <- list(of = of, nodes = nodes, index = index, change = y[index, , drop = FALSE])
    off <- held_to(c(terms, list(found)))
    if (is.character(off)) return(off)
    if (off <= 10 * series_reached || any(lengths(nodes) < n)) break
  }
  if (off > series_refused) {
    return(sprintf("changes the model too irregularly for a series (relative residual %.0e)", off))
  }
  found
}

# Returns the misfit with all sliders moved at once, at a few values that the plan allows.
misfit_together <- function(filler, fields, terms, kept) {
  if (length(kept) < 2L) return(0)
  off <- lapply(1:3, function(k) {
    t <- cos(pi * ((kept * 0.618034 * k + 0.1 * k) %% 1))
    values <- replace(own_values(fields), kept, mapply(of_share, fields[kept], t))
    misfit(terms, filler, values)
  })
  max(0, unlist(Filter(is.numeric, off)))
}
