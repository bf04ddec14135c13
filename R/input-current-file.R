#' Read currents from a file of an ocean model
#'
#' Returns the current profile at one position and time from a NetCDF file that follows the CF
#' conventions, the format of ocean data services.
#'
#' - Variables are identified by `standard_name`: `eastward_sea_water_velocity` and
#'   `northward_sea_water_velocity`, `longitude`, `latitude`, `time` and `depth`. Without `depth`
#'   the current is the surface current.
#' - Velocities along the axes of a rotated grid (`sea_water_x_velocity`) are rejected, because they
#'   have no compass direction.
#' - The profile is interpolated linearly in time. In space it is taken from the nearest cell with
#'   water, because interpolation would include land.
#' - Calendars other than the common one (`noleap`, `360_day`, `julian` and others) need the package
#'   CFtime.
#'
#' @param file Character: path of a NetCDF file.
#' @param longitude,latitude Numbers: position in degrees east and north. Longitudes of the file may
#'   run to 180 or to 360.
#' @param time Time in UTC: a [POSIXct][base::DateTimeClasses], a [Date] or a string such as
#'   `"2026-05-03 14:00"`.
#' @param farthest Number: maximum distance of the nearest cell, m. Default 20 km.
#' @return A data frame for [current_profile()] with columns `depth` (m), `eastward` and `northward`
#'   (m/s). Its attribute `cell` is a list of `longitude`, `latitude` (deg) and `distance` (m). An
#'   error of class `codend_error_file` is thrown for a file without these variables, with unknown
#'   units or an unknown calendar, or without data at this position and time.
#' @references Eaton and others: NetCDF Climate and Forecast (CF) Metadata Conventions, version 1.11
#'   (2023), sections 4 and 3.3.
#' @seealso [current_profile()] to use the result in a plan.
#' @export
#' @examplesIf requireNamespace("RNetCDF", quietly = TRUE)
#' file <- system.file("extdata", "current_cf.nc", package = "codend")
#' read_currents(file, longitude = 5.1, latitude = 60.3, time = "2026-05-03 14:00")
read_currents <- function(file, longitude, latitude, time, farthest = 20e3) {
  check_given("file", "longitude", "latitude", "time")
  check_netcdf()
  check_package("callr", "Reading a NetCDF file of currents")
  check_between("longitude", longitude, -180, 360)
  check_between("latitude", latitude, -90, 90)
  check_between("farthest", farthest, 0, 2.1e7)
  time <- moment(time)
  check_file_exists(file)
  # A damaged file can crash or block the NetCDF library, so reading runs in a separate process.
  tryCatch(
    callr::r(read_cf_currents, list(file, longitude, latitude, time, farthest),
      package = "codend", timeout = most_reading_seconds),
    error = function(e) {
      if (inherits(e$parent, "codend_error")) stop(e$parent)
      abort_file(file, "is damaged: the NetCDF library failed or needed more than {most} s.",
        most = most_reading_seconds)
    }
  )
}

most_reading_seconds <- 60

read_cf_currents <- function(file, longitude, latitude, time, farthest) {
  nc <- tryCatch(RNetCDF::open.nc(file), error = function(e) {
    abort_file(file, "is not a NetCDF file: {why}", why = conditionMessage(e))
  })
  on.exit(RNetCDF::close.nc(nc))
  variables <- cf_variables(nc)
  names <- cf_names(variables, file)
  axes <- cf_axes(nc, names, variables, file)
  near <- axes$moments(time)
  cells <- cells_by_distance(axes$longitude, axes$latitude, longitude, latitude, farthest)
  if (!nrow(cells)) {
    abort_file(file, "has no cell within {reach} km of {east} deg east, {north} deg north.",
      reach = farthest / 1000, east = longitude, north = latitude)
  }
  for (k in seq_len(nrow(cells))) {
    part <- function(name) {
      at <- lapply(near$index, function(time) {
        cf_profile(nc, variables[[name]], names, cells[k, ], time, file)
      })
      drop(near$share %*% do.call(rbind, at))
    }
    profile <- data.frame(
      depth = axes$depth, eastward = part(names$eastward), northward = part(names$northward)
    )
    profile <- profile[is.finite(profile$eastward) & is.finite(profile$northward), ]
    if (nrow(profile)) break
  }
  if (!nrow(profile)) {
    abort_file(file, "has no water within {reach} km of {east} deg east, {north} deg north.",
      reach = farthest / 1000, east = longitude, north = latitude)
  }
  profile <- table_rows(profile, order(profile$depth))
  attr(profile, "cell") <- list(
    longitude = axes$longitude[cells$i[k]], latitude = axes$latitude[cells$j[k]],
    distance = cells$distance[k]
  )
  profile
}

# Returns name, dimensions and the required attributes of each variable.
cf_variables <- function(nc) {
  dimensions <- vapply(seq_len(RNetCDF::file.inq.nc(nc)$ndims) - 1L, function(k) {
    RNetCDF::dim.inq.nc(nc, k)$name
  }, "")
  count <- RNetCDF::file.inq.nc(nc)$nvars
  found <- lapply(seq_len(count) - 1L, function(k) {
    of <- RNetCDF::var.inq.nc(nc, k)
    own <- vapply(seq_len(of$natts) - 1L, function(a) RNetCDF::att.inq.nc(nc, k, a)$name, "")
    attribute <- function(name) {
      if (!name %in% own) return("")
      as.character(RNetCDF::att.get.nc(nc, k, name))[1L]
    }
    list(
      name = of$name, dimensions = dimensions[of$dimids + 1L],
      standard = attribute("standard_name"), units = attribute("units"),
      positive = attribute("positive"), calendar = attribute("calendar")
    )
  })
  stats::setNames(found, vapply(found, `[[`, "", "name"))
}

cf_names <- function(variables, file) {
  standard <- vapply(variables, `[[`, "", "standard")
  named <- function(name) names(variables)[standard == name]
  find <- function(name, needed = TRUE) {
    found <- named(name)
    if (length(found) == 1L || (!needed && !length(found))) return(found)
    turned <- if (length(named("sea_water_x_velocity"))) {
      " Its velocities follow the axes of a rotated grid."
    } else {
      ""
    }
    abort_file(file,
      "has {count} variables of standard_name \"{wanted}\"; it must have one.{turned}",
      count = length(found), wanted = name, turned = turned)
  }
  list(
    eastward = find("eastward_sea_water_velocity"),
    northward = find("northward_sea_water_velocity"),
    longitude = find("longitude"), latitude = find("latitude"), time = find("time"),
    depth = find("depth", needed = FALSE)
  )
}

# Returns longitudes and latitudes (deg), depths (m), and `moments(time)`, a function that returns
# one or two time indices with their weights.
cf_axes <- function(nc, names, variables, file) {
  values <- function(name) {
    if (length(variables[[name]]$dimensions) > 1L) {
      abort_file(file, "has \"{axis}\" with more than one dimension; codend reads only grids along
        meridians and parallels.", axis = name)
    }
    as.vector(RNetCDF::var.get.nc(nc, name, unpack = TRUE))
  }
  depth <- 0
  if (length(names$depth)) {
    of <- variables[[names$depth]]
    factor <- c(m = 1, meter = 1, meters = 1, metre = 1, metres = 1, km = 1000)[of$units]
    if (is.na(factor)) {
      abort_file(file, "has depths in \"{unit}\"; the unit must be metres.", unit = of$units)
    }
    depth <- values(names$depth) * factor[[1L]] * if (of$positive == "up") -1 else 1
  }
  list(
    longitude = values(names$longitude), latitude = values(names$latitude), depth = depth,
    moments = function(time) cf_moments(values(names$time), variables[[names$time]], time, file)
  )
}

# Returns one or two time indices with their weights for linear interpolation.
cf_moments <- function(values, variable, time, file) {
  clock <- cf_clock(values, variable, time, file)
  times <- clock$times
  if (clock$asked < min(times) || clock$asked > max(times)) {
    abort_file(file, "has times from {first} to {last} UTC, but not {wanted}.",
      first = clock$shown(which.min(times)), last = clock$shown(which.max(times)),
      wanted = format_moment(time))
  }
  before <- which.max(ifelse(times <= clock$asked, times, -Inf))
  after <- which.min(ifelse(times >= clock$asked, times, Inf))
  if (before == after) return(list(index = before, share = 1))
  later <- (clock$asked - times[before]) / (times[after] - times[before])
  list(index = c(before, after), share = c(1 - later, later))
}

# Returns the times of a file and the requested time in one unit: `times`, `asked`, and `shown`, a
# function of a time index. RNetCDF (UDUNITS) supports the common calendar, CFtime the others.
cf_clock <- function(values, variable, time, file) {
  unread <- function(e) {
    abort_file(file, "has the time unit \"{unit}\" and the calendar \"{calendar}\": {why}",
      unit = variable$units, why = conditionMessage(e),
      calendar = if (nzchar(variable$calendar)) variable$calendar else "standard")
  }
  if (tolower(variable$calendar) %in% c("", "standard", "gregorian", "proleptic_gregorian")) {
    times <- tryCatch(
      as.double(RNetCDF::utcal.nc(variable$units, values, type = "c")), error = unread
    )
    shown <- function(k) format_moment(as.POSIXct(times[k], origin = "1970-01-01", tz = "UTC"))
    return(list(times = times, asked = as.double(time), shown = shown))
  }
  check_package("CFtime", sprintf("The calendar \"%s\"", variable$calendar))
  own <- tryCatch(CFtime::CFtime(variable$units, variable$calendar, values), error = unread)
  # CFtime gives a warning and an error for a day that the calendar lacks.
  asked <- tryCatch(
    suppressWarnings(
      CFtime::parse_timestamps(own, format(time, "%Y-%m-%dT%H:%M:%S", tz = "UTC"))$offset
    ),
    error = function(e) NA
  )
  if (is.na(asked)) {
    abort_file(file, "has times of the calendar \"{calendar}\", in which {wanted} does not exist.",
      calendar = variable$calendar, wanted = format_moment(time))
  }
  shown <- function(k) {
    stamp <- CFtime::CFtime(variable$units, variable$calendar, values[k])
    sub("T", " ", substr(CFtime::as_timestamp(stamp, "timestamp"), 1L, 16L), fixed = TRUE)
  }
  list(times = values, asked = asked, shown = shown)
}

format_moment <- function(time) format(time, "%Y-%m-%d %H:%M", tz = "UTC")

# Returns the values (m/s) of one cell at one time, for all depths.
cf_profile <- function(nc, variable, names, cell, time, file) {
  where <- c(cell$i, cell$j, time, 1L)
  axes <- c(names$longitude, names$latitude, names$time, names$depth)
  along <- match(variable$dimensions, axes)
  if (anyNA(along)) {
    abort_file(file, "has \"{name}\" by {own}; it must be by {axes}.", name = variable$name,
      own = paste(variable$dimensions, collapse = ", "), axes = paste(axes, collapse = ", "))
  }
  start <- where[along]
  count <- ifelse(along == 4L, NA, 1L)
  values <- as.vector(
    RNetCDF::var.get.nc(nc, variable$name, start, count, unpack = TRUE, na.mode = 0)
  )
  unit <- gsub("[[:space:]]+", " ", variable$units)
  factor <- c(
    "m s-1" = 1, "m/s" = 1, "m s^-1" = 1, "meter second-1" = 1, "m.s-1" = 1, "cm s-1" = 0.01,
    "cm/s" = 0.01, "knot" = 1852 / 3600
  )[unit]
  if (is.na(factor)) {
    abort_file(file, "has \"{name}\" in \"{unit}\"; the unit must be \"m s-1\", \"cm s-1\" or
      \"knot\".", name = variable$name, unit = variable$units)
  }
  values * factor[[1L]]
}

# Returns the cells within reach in order of distance: data.frame(i, j, distance (m)).
cells_by_distance <- function(longitude, latitude, east, north, farthest) {
  # Limit a global file to the parallels within reach.
  within <- earth_radius * from_unit(abs(latitude - north), "deg") <= farthest
  cells <- expand.grid(i = seq_along(longitude), j = which(within))
  cells$distance <- great_circle(
    from_unit(c(longitude[cells$i] - east), "deg"), from_unit(latitude[cells$j], "deg"),
    from_unit(north, "deg")
  )
  cells <- cells[is.finite(cells$distance) & cells$distance <= farthest, ]
  cells[order(cells$distance), ]
}

# Returns the distance (m) on a sphere of the Earth's mean radius (haversine formula; rad).
great_circle <- function(east, north, north_of) {
  earth_radius * 2 *
    asin(sqrt(sin((north - north_of) / 2)^2 + cos(north) * cos(north_of) * sin(east / 2)^2))
}

# Mean radius R1 of IUGG (Moritz 1980), m.
earth_radius <- 6371008.8

moment <- function(time) {
  if (is_text(time)) {
    formats <- c("%Y-%m-%d %H:%M:%S", "%Y-%m-%d %H:%M", "%Y-%m-%dT%H:%M:%SZ", "%Y-%m-%dT%H:%M",
      "%Y-%m-%d")
    time <- as.POSIXct(time, tz = "UTC", tryFormats = formats, optional = TRUE)
  }
  if (inherits(time, "Date")) time <- as.POSIXct(format(time), tz = "UTC")
  if (!inherits(time, "POSIXct") || length(time) != 1L || is.na(time)) {
    abort_argument("{.arg time} must be one moment, such as {.val 2026-05-03 14:00} (UTC).")
  }
  time
}
