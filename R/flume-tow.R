# A tow of the design on screen. The slow worker computes it and the page plays it. The page offers
# a few changes of conditions; the section `tow` of a plan supports all options.

# Longest tow [s], and number of stored time steps. The page displays every stored step.
longest_tow <- 3600
tow_frames <- 100L

# `said`: list(until = "60 s", planned = TRUE or changes = list(speed, course, warp_out)), with each
# change list(to or by, from, over) as strings with units. Returns list(trajectory, scene).
requested_tow <- function(state, said) {
  said <- as.list(said)
  until <- format_time(said$until, "until", 1, longest_tow)
  given <- if (isTRUE(said$planned)) planned_tow(state) else describe_tow(state,
    as.list(said$changes))
  trajectory <- do.call(tow, c(
    list(state, until = until, every = until / tow_frames), given
  ))
  list(trajectory = serialize(trajectory, NULL), scene = viewed_scene(trajectory))
}

# Returns the arguments of tow() from the section `tow` of the plan.
planned_tow <- function(state) {
  section <- tow_section(state$gear)
  if (!length(section)) abort_argument("The plan on screen has no section `tow`.")
  c(
    list(schedule = with_planned(tow_schedule(), section)),
    section[intersect(c("scheme", "accuracy"), names(section))]
  )
}

describe_tow <- function(state, changes) {
  given <- list(
    speed = describe_change(changes$speed, state$si$towing$speed, "speed", "speed"),
    course = describe_change(changes$course, 0, "angle", "course")
  )
  if (!is.null(changes$warp_out)) {
    ropes <- Filter(function(rope) isTRUE(rope$role %in% c("warp", "purse_wire")), state$si$ropes)
    if (!length(ropes)) abort_argument("The gear on screen has no warp to pay out.")
    given$warp_out <- lapply(ropes, function(rope) {
      describe_change(changes$warp_out, rope$length, "length", "warp_out")
    })
  }
  list(schedule = do.call(tow_schedule, given))
}

# Returns a schedule that is constant until `from`, then linear over `over` seconds to the value
# `to` or by the difference `by`. Returns NULL if the page requests no change.
describe_change <- function(asked, now, dimension, name) {
  asked <- as.list(asked)
  if (!length(asked)) return(NULL)
  from <- format_time(asked$from, paste0(name, ", from"), 0, longest_tow)
  over <- format_time(asked$over, paste0(name, ", over"), 0, longest_tow)
  to <- if (is.null(asked$by)) format_number(asked$to, name, dimension) else {
    now + format_number(asked$by, name, dimension)
  }
  # a change at time 0 has no row before it, and a change within 0 s is a jump
  time <- c(0, if (from > 0) from, from + over)
  table <- data.frame(time = time, value = c(rep(now, length(time) - 1L), to))
  if (dimension == "angle") setNames(table, c("time", "value_rad")) else table
}

format_time <- function(said, name, low, high) {
  time <- format_number(said, name, "time")
  if (time < low || time > high) {
    abort_argument("{.arg {name}} is {.val {said}}; it must be from {low} to {high} s.")
  }
  time
}

tow_units <- c(time = "1 s", speed = "1 knot", angle = "1 deg", length = "1 m")

# Returns the SI value of a typed number.
format_number <- function(said, name, dimension) {
  typed_number(said, tow_units[[dimension]], name)$si
}

# Downloads of a tow: file extension, required package, and a function that writes a trajectory.
tow_saves <- list(
  measures = list(
    extension = "csv",
    write = function(x, file) write_csv(as.data.frame(x, what = "measures"), file)
  ),
  conditions = list(
    extension = "csv",
    write = function(x, file) write_csv(as.data.frame(x, what = "conditions"), file)
  ),
  tensions = list(
    extension = "csv",
    write = function(x, file) write_csv(as.data.frame(x, what = "tensions"), file)
  ),
  motion = list(
    extension = "html",
    write = function(x, file) view_3d(x, file)
  ),
  trajectory = list(
    extension = "nc",
    package = "RNetCDF", write = function(x, file) write_trajectory(x, file)
  ),
  grids = list(
    extension = "tar.gz",
    write = function(x, file) write_grids(x, file)
  )
)

# Writes the grids of a trajectory and their index as one file.
write_grids <- function(trajectory, file) {
  folder <- tempfile("grids")
  dir.create(folder)
  on.exit(unlink(folder, recursive = TRUE))
  write_vtk(trajectory, file.path(folder, "tow.pvd"))
  write_file(file, function(path) {
    back <- setwd(folder)
    on.exit(setwd(back))
    utils::tar(path, list.files(), compression = "gzip", tar = "internal")
  })
}
