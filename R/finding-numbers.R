# Numbers outside the range that is possible or usual. The table inst/extdata/ranges.csv lists their
# checks with limits, messages, advice and sources. Checks with rows in inst/extdata/bands.csv have
# limits by kind of gear instead; they apply to each net. A new check needs a row in the table and a
# function in finding-ranges.R or finding-proportions.R.

# Functions(si, state) by check. Each returns numbers in the unit of the check, named by location as
# in finding(). Numbers without names have the location of the table. An attribute `limits` has a
# row of limits for each number. `si`: the gear in SI, or one of its nets.
checked_numbers <- new.env(parent = emptyenv())

define_number <- function(check, values) checked_numbers[[check]] <- values

# Defines the number of each part, or NA. kind: "rope", "panel", "piece" or "seam".
define_part_number <- function(check, kind, of) {
  parts <- paste0(kind, "s")
  define_number(check, function(si, state) numbers_of_parts(si[[parts]], kind, of))
}

# Returns a number for each part of a list, named by location. `of(part)`: the number or NA.
numbers_of_parts <- function(parts, kind, of) {
  found <- vapply(parts, of, 0)
  setNames(found, paste(kind, names(parts), recycle0 = TRUE))
}

number_ranges <- package_table("ranges.csv")

# `usual_least` and `usual_greatest` are published values, which starters must meet.
number_bands <- package_table("bands.csv")

# si: SI numbers of one net (`si_by_net()`).
band_of <- function(quantity, si) {
  kind <- if (length(si$nets) == 1L) si$nets[[1L]]$kind else "assembly"
  # Pair trawls off the seabed have the proportions of midwater trawls.
  if (kind == "pair_trawl" && is.null(si$ground)) kind <- "midwater_trawl"
  row <- which(number_bands$quantity == quantity & number_bands$kind == kind)
  if (length(row)) number_bands[row, ]
}

for (k in seq_len(nrow(number_ranges))) local({
  limits <- number_ranges[k, ]
  define_finding(limits$check, function(gear, state) unusual_numbers(limits, gear, state),
    table = number_ranges)
})
rm(k)

# Returns findings. range: a row of the table of ranges.
unusual_numbers <- function(range, gear, state) {
  si <- if (range$of == "state") state$si else gear_si(gear)
  by_kind <- range$check %in% number_bands$quantity
  nets <- if (by_kind) si_by_net(si) else list(si)
  found <- Map(function(si, net) {
    limits <- if (by_kind) band_of(range$check, si) else range
    if (is.null(limits)) return(NULL)
    values <- checked_numbers[[range$check]](si, state)
    limits <- first_of(attr(values, "limits"), limits)
    below <- !is.na(limits$least) & values < limits$least
    lapply(which(is.finite(values) & (below | values > limits$greatest)), function(k) {
      location <- first_of(names(values)[k], range$location)
      own <- limits[if (nrow(limits) > 1L) k else 1L, ]
      unusual_number(range, values[[k]], own, location_in_net(location, net, gear$plan),
        below[[k]])
    })
  }, nets, first_of(names(nets), ""))
  unlist(unname(found), recursive = FALSE)
}

# Returns the finding of a number. limits: a row of a table. below: TRUE if the number is too small.
unusual_number <- function(range, value, limits, location, below) {
  with_unit <- trimws(paste("{n}", first_of(limits$unit, range$unit)))
  label <- template(with_unit, n = figures(value))
  least <- first_of(limits$usual_least, limits$least)
  greatest <- first_of(limits$usual_greatest, limits$greatest)
  field <- first_of(limits$field, range$field)
  list(location = location, value = value, label = label,
    message = template("{quantity} is {value}; usual is {band}.", quantity = range$quantity,
      value = label, band = template(with_unit, n = band_text(least, greatest))),
    advice = if (below || !nzchar(range$high)) range$low else range$high,
    field = if (nzchar(field)) field)
}

# An end of a range without limit is NA.
band_text <- function(least, greatest) {
  number <- function(x) format(x, trim = TRUE)
  if (is.na(least)) return(template("at most {n}", n = number(greatest)))
  if (is.na(greatest)) return(template("at least {n}", n = number(least)))
  template("{least} to {most}", least = number(least), most = number(greatest))
}

# Returns the location of a finding with the name of its net in a rig ("" for a single net).
location_in_net <- function(location, net, plan) {
  if (!nzchar(net)) return(location)
  if (grepl("^rope ", location)) return(sub("^rope ", paste0("rope ", net, "_"), location))
  of <- intersect(c(net, sub("_[0-9]+$", "", net)), names(plan$gears))
  own <- if (length(of)) gear_field_path(plan$gears, of[1L], location) else location
  if (is.null(plan_field(plan, own))) location else own
}
