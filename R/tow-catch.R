# The catch in netting while a gear is towed: how far its front reaches, and its mass.

# The front is moved to where the netting behind it holds the catch this often, s.
catch_step <- 2

# The least meshes that a front may lie from the codline, where there is next to no catch.
least_front <- 1e-3

# Whether the front moves: a catch by volume follows the shape of the netting, any follows its
# schedule.
moves_catch <- function(what) {
  catch <- what$si$catch
  changes <- length(unique(unlist(what$curves$catch[c("begin", "end")]))) > 1L
  !is.null(catch) && (!is.na(catch$volume) || changes)
}

# A gear's catch in netting when a share of the plan's is there.
si_catch_share <- function(catch, share) {
  catch$volume <- share * catch$volume
  catch$blocked <- share * catch$blocked
  catch
}

# The front of a lattice's catch (meshes from the lower edges) where the netting behind it, at a
# place (3 x nodes, m), holds a share of the plan's catch.
found_catch_front <- function(si, lattice, share, position) {
  asked <- si_catch_share(si$catch, share)
  if (is.na(asked$volume)) return(max(asked$blocked, least_front))
  over <- function(front) catch_volume(lattice, position, front) - asked$volume
  if (over(least_front) >= 0) return(least_front)
  full <- over(si$catch$deep)
  if (full < 0) abort_catch_volume(si_with(si, "catch", asked), full + asked$volume)
  stats::uniroot(over, c(least_front, si$catch$deep), tol = 1e-9 * si$catch$deep)$root
}

si_with <- function(si, field, value) {
  si[[field]] <- value
  si
}

# The front of a lattice's catch: meshes behind it, and the volume (m3) there.
catch_front <- function(lattice, position) {
  if (is.null(lattice$catch)) return(numeric())
  c(lattice$catch$blocked, max(catch_volume(lattice, position), 0))
}

# Mass of the lattice's points with that of a catch of a volume (m3), kg: as heavy as the water that
# it displaces, so it weighs nothing, but has to be moved.
catch_masses <- function(si, lattice, volume) {
  mass <- lattice$mesh$mass
  pressure <- lattice$mesh$pressure
  weight <- rowsum(abs(pressure$weight), pressure$node)
  node <- as.integer(rownames(weight))
  all <- si$water$density * volume
  if (sum(weight) > 0) mass[node] <- mass[node] + all * weight[, 1] / sum(weight)
  mass
}

# A function(frame) that moves the front and answers with what the engine then reads: list(weight of
# the pressure, node and mass (kg) of the points around the catch, front = as catch_front()).
catch_mover <- function(what) {
  share <- what$curves$catch
  nodes <- sort(unique(what$lattice$mesh$pressure$node))
  function(frame) {
    position <- matrix(frame$now$position, 3L)
    lattice <- set_catch_front(what$lattice, found_catch_front(
      what$si, what$lattice, curve_at(share, frame$now$time, after = TRUE), position
    ))
    front <- catch_front(lattice, position)
    list(
      weight = lattice$mesh$pressure$weight, node = nodes,
      mass = catch_masses(what$si, lattice, front[2])[nodes], front = front
    )
  }
}
