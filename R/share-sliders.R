# The sliders of a shared page: fields of a plan that a page may change within a range.

# Default ranges, as fractions of the value to both sides. A slider has the largest range that the
# plan allows and a series covers.
slider_shares <- c(0.25, 0.15, 0.1, 0.05, 0.02)

# Adds to free_fields() `fixed` (TRUE if the user gave the range) and `asked` (TRUE if the user gave
# the sliders). `sliders`: as in sensitivities(), or NULL for the fields that users change first.
# `ranges`: by path, or NULL.
slider_fields <- function(gear, sliders, ranges) {
  if (!is.null(ranges) && !(is.list(ranges) && length(ranges) && !is.null(names(ranges)))) {
    abort_argument("{.arg ranges} must be a list of ranges by the paths of fields, such as
      {.code list(warps.length = c(\"300 m\", \"600 m\"))}.")
  }
  found <- sensitivity_fields(gear, slider_paths(sliders))
  name <- vapply(found, `[[`, "", "name")
  given <- vapply(names(ranges), function(path) paste(paths_of(path), collapse = " + "), "",
    USE.NAMES = FALSE)
  lost <- setdiff(given, name)
  if (length(lost)) {
    abort_argument("{.arg ranges} has {.field {lost[1]}}, which is not a slider; the sliders are
      {.field {name}}.")
  }
  fields <- lapply(found, function(field) {
    at <- match(field$name, given)
    fixed <- !is.na(at)
    range <- if (fixed) {
      free_fields(gear, setNames(list(ranges[[at]]), field$name), "ranges")[[1L]]
    } else {
      usual_range(gear, field, slider_shares[1L])
    }
    if (is.null(range)) {
      if (is.null(sliders)) return(NULL)
      abort_argument("{.arg sliders} has {.field {field$name}}, which has no valid default range in
        this plan: give it a range in {.arg ranges}.")
    }
    c(range, list(fixed = fixed, asked = !is.null(sliders)))
  })
  Filter(Negate(is.null), fields)
}

slider_paths <- function(sliders) {
  if (is.null(sliders)) return(NULL)
  if (!length(sliders) || !all(vapply(as.list(sliders), is.character, NA))) {
    abort_argument("{.arg sliders} must be paths of plan fields, such as {.val towing.speed}.")
  }
  unname(lapply(as.list(sliders), function(one) unlist(lapply(one, paths_of))))
}

# Returns the field with a rounded range, at most the fraction `most` of its value to both sides.
# Returns NULL if the plan allows no range.
usual_range <- function(gear, field, most) {
  for (share in slider_shares[slider_shares <= most]) {
    ends <- field$value + c(-1, 1) * share * abs(field$value)
    ends <- if (field$whole) {
      c(max(floor(ends[1L]), if (field$value > 0) 1 else -Inf), ceiling(ends[2L]))
    } else {
      # the value stays inside
      size <- 10^floor(log10(share * abs(field$value)))
      c(floor(ends[1L] / size * 2), ceiling(ends[2L] / size * 2)) * size / 2
    }
    range <- lapply(ends, field_text, field = field)
    found <- tryCatch(
      free_fields(gear, setNames(list(range), field$name), "ranges")[[1L]],
      codend_error = function(e) NULL
    )
    if (!is.null(found)) return(found)
  }
  NULL
}

# Returns the tank's form with only the fields that the page can change, in their ranges.
shared_form <- function(gear, fields) {
  ranged <- function(controls) {
    found <- lapply(controls, function(control) {
      field <- Find(function(field) setequal(field$paths, control$paths), fields)
      if (is.null(field)) return(NULL)
      ends <- vapply(field[c("lower", "upper")], shortest_decimal, "")
      control[c("low", "high", "step", "required", "must")] <- list(field$lower, field$upper,
        if (field$whole) 1 else round_step((field$upper - field$lower) / 200), TRUE,
        trimws(paste("from", ends[1L], "to", ends[2L], control$unit)))
      control
    })
    Filter(Negate(is.null), found)
  }
  form <- form_message(gear$plan, lapply(fields, `[[`, "paths"), 1)
  form$groups <- lapply(form$groups, function(group) {
    parts <- lapply(group$parts, function(part) {
      list(path = part$path, help = part$help, fields = ranged(part$fields), required = TRUE)
    })
    list(title = group$title, parts = Filter(function(part) length(part$fields), parts),
      open = FALSE, absent = I(character()))
  })
  form$quick <- ranged(form$quick)
  form
}
