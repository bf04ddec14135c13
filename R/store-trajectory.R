# Trajectories as NetCDF (classic format, 64-bit offsets, CF conventions). Other programs can read
# the file while it grows.
#
# Each saved time is one record. It is valid once its flag `complete` is set, after its numbers have
# reached the disk. A killed run therefore loses only the record in progress. Data for a
# continuation alternate between two slots, so one slot is always complete.

write_trajectory <- function(trajectory, file) {
  check_netcdf()
  record <- record_trajectory(constants_of(trajectory), trajectory_frames(trajectory), file)
  record$close(trajectory$end)
  invisible(file)
}

# Reads a state or trajectory from a file.
read_netcdf <- function(file) {
  nc <- open_saved(file)
  if (attr(nc, "what") == "state") read_state(nc, file) else read_trajectory(nc, file)
}

# Reads the trajectory of an open file with all complete records.
read_trajectory <- function(nc, file) {
  read_saved(nc, file, function(get) {
    what <- read_saved_variables(get)
    # count complete records from the start
    n <- min(sum(cumprod(get("complete") == 1L)), attr(nc, "records"))
    # last record that allows a continuation
    resumed <- get("resume_record")
    n <- max(0L, resumed[resumed >= 1 & resumed <= n])
    if (n == 0L) abort_file(file, "has no complete record.")
    end <- file_ends[1L + get("end")]
    if (is.na(end)) stop("its end is unknown")
    if (end != "interrupted" && seal_of(file) == "none") stop("it ends without its checksum")
    what$mesh <- mesh_of_recipe(what$si, what$recipe)
    gather_trajectory(what[names(what) != "recipe"], read_frames(get, n), end)
  })
}

# Codes for the end of a tow, from 0. A running tow has the first code.
file_ends <- c("interrupted", "reached", "stuck", "unbalanced")

# Unit and description of node variables; frame_fields lists the others.
node_variables <- rbind(
  x_m = c("m", "position aft of the start, over the ground"),
  y_m = c("m", "position to starboard of the start, over the ground"),
  z_m = c("m", "height above the water surface"),
  x_velocity_m_per_s = c("m s-1", "velocity aft of the start, over the ground"),
  y_velocity_m_per_s = c("m s-1", "velocity to starboard of the start, over the ground"),
  z_velocity_m_per_s = c("m s-1", "upward velocity")
)

vessel_variables <- rbind(
  vessel_x_m = c("m", "position of the vessel aft of its start, over the ground"),
  vessel_y_m = c("m", "position of the vessel to starboard of its start, over the ground"),
  vessel_speed_m_per_s = c("m s-1", "speed of the vessel over the ground"),
  course_deg = c("degree", "course relative to the start, positive to starboard")
)

# Data for a continuation, in addition to the nodes. Controlled lengths and breaking ropes are
# vectors.
resume_numbers <- c("steps", "caution", "step")
resume_control <- c("length", "since", "speed", "target_speed", "near_limit")
report_numbers <- c(
  "steps", "repeated", "not_found", "unbalanced", "iterations", "shortest_step", "longest_step",
  "largest_error", "worst_node", "time", "factorisations", "force_evaluations", "factor_entries"
)
report_ends <- c("reached", "stopped", "stuck", "unbalanced")
resume_motions <- c("now", "before")
motion_vectors <- c("position", "velocity", "acceleration")

# Writes the snapshots of a trajectory atomically and leaves the file open for more. `what`:
# constants of the trajectory. Returns list(add = function(frame), close = function(end)).
record_trajectory <- function(what, frames, file) {
  count <- 0L
  first <- gather_trajectory(what, frames[1L], "interrupted")
  measured <- measure_numbers(state_at(first, first$time))
  add_to <- function(nc, frame) {
    count <<- count + 1L
    put_frame(nc, what, frame, count, names(measured))
  }
  write_netcdf(file, function(nc) {
    # the last snapshot includes the data for a continuation
    define_trajectory(nc, what, frames[[length(frames)]], measured)
    for (frame in frames) add_to(nc, frame)
  })
  nc <- RNetCDF::open.nc(file, write = TRUE)
  failed <- FALSE
  trying <- function(code) {
    tryCatch(code, error = function(e) {
      failed <<- TRUE
      abort_unwritten(file, conditionMessage(e))
    })
  }
  list(
    add = function(frame) trying(add_to(nc, frame)),
    close = function(end) {
      if (failed) return(invisible())
      trying({
        put(nc, "end", match(end, file_ends) - 1L)
        close_netcdf(nc)
        seal_file(file)
        check_written(file, file_sync(file))
      })
    }
  )
}

# ---- content of files ----------------------------------------------------------------------------

define_trajectory <- function(nc, what, frame, measured) {
  mesh <- what$mesh
  variables <- c(
    record_variables(), model_variables(mesh),
    resume_variables(), saved_variables(what),
    lapply(measured, function(of) file_variable(of$type, "time", of$words, of$unit))
  )
  sizes <- c(
    bar = length(frame$bar_tension), cell = length(frame$u_tension),
    point = length(frame$wake),
    catch = length(frame$catch_front), energy_part = length(engine_energy_parts()),
    growing_part = length(frame$done$length), rupture = length(frame$done$broken),
    anchor = length(frame$done$anchor), component = 3L * mesh$nodes, slot = 2L,
    report_number = length(report_numbers)
  )
  RNetCDF::dim.def.nc(nc, "time", unlim = TRUE)
  define_file(nc, variables, sizes, mesh, what$gear, paste("Tow of", what$gear$plan$name),
    "trajectory")
  put_attributes(nc, "time", c(axis = "T", standard_name = "time"))
  put_attributes(nc, "vessel_speed_m_per_s", c(standard_name = "platform_speed_wrt_ground"))
  put_attributes(nc, "energy_J", c(energy_parts = paste(engine_energy_parts(), collapse = " ")))
  put_attributes(nc, "end", c(flag_meanings = paste(file_ends, collapse = " ")))
  RNetCDF::att.put.nc(nc, "end", "flag_values", "NC_INT", seq_along(file_ends) - 1L)
  for (name in names(variables)) put(nc, name, variables[[name]]$value)
}

record_variables <- function() {
  of_table <- function(table, across = NULL) {
    lapply(setNames(nm = rownames(table)), function(name) {
      file_variable("NC_DOUBLE", c(across, "time"), table[[name, 2L]], table[[name, 1L]])
    })
  }
  frames <- lapply(seq_len(nrow(frame_fields)), function(k) {
    of <- frame_fields[k, ]
    type <- if (of$name == "broken") "NC_INT" else "NC_DOUBLE"
    file_variable(type, c(of$across, "time"), of$words, of$unit)
  })
  c(
    list(
      time = file_variable("NC_DOUBLE", "time", "time since the start of the tow", "s"),
      complete = file_variable("NC_INT", "time", "1 where all numbers of a time are written", "1"),
      end = file_variable("NC_INT", character(), "how the tow ended", value = 0L)
    ),
    of_table(node_variables, "node"), setNames(frames, frame_fields$variable),
    of_table(vessel_variables)
  )
}

resume_variables <- function() {
  of <- function(names, across = NULL, unit = NULL, type = "NC_DOUBLE", words = NULL) {
    variable <- file_variable(type, c(across, "slot"), words, unit)
    setNames(rep(list(variable), length(names)), paste0("resume_", names))
  }
  c(
    of("record", type = "NC_INT", words = "index of the time of a slot, from 1"),
    of(paste0(resume_motions, "_time"), unit = "s"),
    of(outer(resume_motions, motion_vectors, paste, sep = "_"), "component"),
    of(resume_numbers), of(paste0("control_", resume_control), "growing_part"),
    of("broken", "rupture", type = "NC_INT"), of("broken_at", "rupture", "s"),
    of("anchor", "anchor", "m"), of("report", "report_number"), of("report_end", type = "NC_INT")
  )
}

# ---- writing ------------------------------------------------------------------------------------

# `measured`: names of the measures in the file.
put_frame <- function(nc, what, frame, k, measured) {
  now <- gather_trajectory(what, list(frame), "interrupted")
  put_at <- function(name, value) put_numbers(nc, name, value, k)
  put_at("time", now$time)
  for (axis in 1:3) {
    put_at(rownames(node_variables)[axis], now$position[axis, , 1L])
    put_at(rownames(node_variables)[axis + 3L], now$velocity[axis, , 1L])
  }
  for (row in seq_len(nrow(frame_fields))) {
    put_at(frame_fields$variable[row], as.vector(now[[frame_fields$name[row]]]))
  }
  put_at("vessel_x_m", now$conditions$x)
  put_at("vessel_y_m", now$conditions$y)
  put_at("vessel_speed_m_per_s", now$conditions$speed)
  put_at("course_deg", in_unit(now$conditions$course, "deg"))
  found <- plain_measures(measures(state_at(now, now$time)))
  for (name in measured) put_at(name, unname(found[name]))
  if (!is.null(frame$step)) put_resume(nc, frame, k)
  RNetCDF::sync.nc(nc)
  put_at("complete", 1L)
  RNetCDF::sync.nc(nc)
}

put_resume <- function(nc, frame, k) {
  put_one <- function(name, value) {
    put_numbers(nc, paste0("resume_", name), as.double(value), 1L + k %% 2L)
  }
  for (motion in resume_motions) {
    for (name in c("time", motion_vectors)) {
      put_one(paste(motion, name, sep = "_"), frame[[motion]][[name]])
    }
  }
  for (name in resume_numbers) put_one(name, frame[[name]])
  for (name in resume_control) put_one(paste0("control_", name), frame$done[[name]])
  for (name in c("broken", "broken_at", "anchor")) put_one(name, frame$done[[name]])
  put_one("report", unlist(frame$report[report_numbers]))
  put_one("report_end", match(first_of(frame$report$end, ""), report_ends, 0L))
  put_one("record", k)
}

# Writes the values of a variable at one time or slot.
put_numbers <- function(nc, name, value, k) {
  if (!length(value)) return(invisible())
  n <- if (RNetCDF::var.inq.nc(nc, name)$ndims == 2L) length(value)
  put(nc, name, value, c(if (length(n)) 1, k), c(n, 1))
}

# ---- reading ------------------------------------------------------------------------------------

read_frames <- function(get, n) {
  records <- function(name) {
    value <- get(name)
    if (length(value)) value[, seq_len(n), drop = FALSE] else matrix(value, 0L, n)
  }
  of_nodes <- lapply(rownames(node_variables), records)
  other <- setNames(lapply(frame_fields$variable, records), frame_fields$name)
  time <- as.vector(get("time"))[seq_len(n)]
  bound <- function(axes, k) {
    as.vector(do.call(rbind, lapply(of_nodes[axes], function(x) x[, k])))
  }
  frames <- lapply(seq_len(n), function(k) {
    now <- list(time = time[k], position = bound(1:3, k), velocity = bound(4:6, k))
    c(list(now = now), frame_of_arrays(other, k))
  })
  frames[[n]][c(memory_fields, "report")] <- read_resume(get, n)
  frames
}

read_resume <- function(get, n) {
  slot <- match(n, get("resume_record"))
  one <- function(name) get(paste0("resume_", name), slot, 1)[1L]
  all <- function(name) as.vector(get(paste0("resume_", name), c(1, slot), c(NA, 1)))
  motion <- function(name) {
    vectors <- lapply(setNames(motion_vectors, motion_vectors), function(v) {
      all(paste(name, v, sep = "_"))
    })
    c(list(time = one(paste0(name, "_time"))), vectors)
  }
  done <- lapply(
    setNames(resume_control, resume_control), function(name) all(paste0("control_", name))
  )
  done$near_limit <- as.logical(done$near_limit)
  done$broken <- as.integer(all("broken"))
  done$broken_at <- all("broken_at")
  done$anchor <- as.double(all("anchor"))
  report <- NULL
  if (one("report_end") > 0L) {
    numbers <- all("report")  # earlier versions wrote fewer numbers
    report <- c(
      list(end = report_ends[one("report_end")]),
      as.list(setNames(numbers, report_numbers[seq_along(numbers)]))
    )
    report$worst_node <- as.integer(report$worst_node)
  }
  list(
    now = motion("now"), before = motion("before"), steps = as.integer(one("steps")),
    caution = as.integer(one("caution")), step = one("step"), done = done, report = report
  )
}
