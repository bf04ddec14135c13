# Priors of `calibrate()`, and sources of `uncertainty()` from a calibration.

# Returns normal priors for fields without a range.
known_priors <- function(gear, paths) {
  if (is.character(gear)) gear <- read_gear(gear)
  sources <- uncertainty_sources(gear)
  lapply(setNames(paths, paths), function(path) {
    source <- Find(function(source) path %in% source$paths, sources)
    if (is.null(source)) {
      abort_argument("{.arg change} has {.field {path}} without a range, and its uncertainty is not
        known. Give a range, or add an `uncertainty` to the plan.")
    }
    number <- field_number(gear$plan, path)
    own <- number$value
    mean <- own * (1 + source$off)
    sd <- whole_of(own) * source$share
    # A multiplier stays positive, so that the force keeps its direction.
    ends <- c(max(mean - normal_reach * sd, if (!is.null(source$multiplier)) 0.05 * own), mean +
      normal_reach * sd)
    ends <- range(ends, own + c(-0.01, 0.01) * abs(own))
    do.call(normal_value, numbers_in_units(c(mean, sd, ends), number))
  })
}

# Replaces paths without a range in `change` by priors.
change_with_priors <- function(gear, change) {
  if (is.character(change) && is.null(names(change))) return(known_priors(gear, change))
  if (!is.list(change)) return(change)
  alone <- if (is.null(names(change))) rep(TRUE, length(change)) else !nzchar(names(change))
  if (!any(alone) || !all(vapply(change[alone], is.character, NA))) return(change)
  c(known_priors(gear, unlist(change[alone])), change[!alone])
}

# Returns the sources of a calibrated gear: calibrated fields have the errors of the fit.
calibrated_sources <- function(sources, fit) {
  fields <- fit$fields
  paths <- lapply(fields$field, paths_of)
  taken <- unlist(paths)
  # A calibrated field no longer has the same error as others of its kind.
  sources <- lapply(sources, function(source) {
    source$paths <- setdiff(source$paths, taken)
    source
  })
  sources <- Filter(function(source) length(source$paths) > 0L, sources)
  found <- lapply(seq_along(paths), function(k) {
    path <- paths[[k]]
    multiplier <- sub("^multipliers[.]", "", path[1L])
    is_multiplier <- multiplier != path[1L]
    error <- fields$error[k]
    source <- list(
      name = if (is_multiplier) force_multipliers[[multiplier]] else path_labels(path),
      group = if (is_multiplier) "coefficients" else "plan", paths = path,
      share = if (is.finite(error)) error / whole_of(fields$value[k]) else 0, off = 0,
      calibrated = fields$field[k]
    )
    if (is_multiplier) source$multiplier <- multiplier
    source
  })
  c(found, sources)
}
