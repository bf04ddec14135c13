# Front and mass of a catch in netting during a tow.

# Interval between updates of the front (s).
catch_step <- 2

# Smallest distance of the front from the codline (meshes), for a nearly empty codend.
least_front <- 1e-3

# TRUE if the front moves: the catch is given by volume, or its schedule changes.
moves_catch <- function(what) {
  catch <- what$si$catch
  changes <- length(unique(unlist(what$curves$catch[c("begin", "end")]))) > 1L
  !is.null(catch) && (!is.na(catch$volume) || changes)
}

# Returns the catch for a fraction of the plan's catch.
si_catch_share <- function(catch, share) {
  catch$volume <- share * catch$volume
  catch$blocked <- share * catch$blocked
  catch
}

# Returns the front of the catch [meshes from the lower edges]: the netting behind it encloses the
# given fraction of the plan's catch. `position`: 3 x nodes [m].
found_catch_front <- function(si, mesh, share, position) {
  asked <- si_catch_share(si$catch, share)
  if (is.na(asked$volume)) return(max(asked$blocked, least_front))
  over <- function(front) catch_volume(mesh, position, front) - asked$volume
  if (over(least_front) >= 0) return(least_front)
  full <- over(si$catch$deep)
  if (full < 0) abort_catch_volume(replace(si, "catch", list(asked)), full + asked$volume)
  stats::uniroot(over, c(least_front, si$catch$deep), tol = 1e-9 * si$catch$deep)$root
}

# Returns the front of the catch: number of meshes behind it, and their volume [m3].
catch_front <- function(mesh, position) {
  if (is.null(mesh$catch)) return(numeric())
  c(mesh$catch$blocked, max(catch_volume(mesh, position), 0))
}

# Returns the mass of the nodes with a catch of this volume [m3], kg. The catch is as heavy as
# water: it has inertia but no weight in water.
catch_masses <- function(si, mesh, volume) {
  mass <- mesh$model$mass
  pressure <- mesh$model$pressure
  weight <- rowsum(abs(pressure$weight), pressure$node)
  node <- as.integer(rownames(weight))
  all <- si$water$density * volume
  if (sum(weight) > 0) mass[node] <- mass[node] + all * weight[, 1] / sum(weight)
  mass
}

# Returns a function(frame) that moves the front. Its result for the engine: list(weight of the
# pressure, node, mass [kg] of the points around the catch, front as in catch_front()).
catch_mover <- function(what) {
  share <- what$curves$catch
  nodes <- sort(unique(what$mesh$model$pressure$node))
  function(frame) {
    position <- matrix(frame$now$position, 3L)
    mesh <- set_catch_front(what$mesh, found_catch_front(
      what$si, what$mesh, curve_at(share, frame$now$time, after = TRUE), position
    ))
    front <- catch_front(mesh, position)
    list(
      weight = mesh$model$pressure$weight, node = nodes,
      mass = catch_masses(what$si, mesh, front[2])[nodes], front = front
    )
  }
}
