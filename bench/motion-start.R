# Initial trajectories (one time step) of the measured motions.

# Starts from a settled state, with the fields of tow_schedule().
from_state <- function(state, until, ...) {
  codend:::started_trajectory(state, tow_schedule(...), until)
}

# Starts at rest from node positions (3 x nodes, m).
from_rest <- function(gear, mesh, position, until) {
  what <- codend:::tow_start(gear, codend:::gear_si(gear), mesh, tow_schedule(), until)
  codend:::add_start(what, position, c(0, 0, 0))
}

# The shipped trawl, settled once per size.
settled_trawl <- local({
  known <- list()
  function(nodes) {
    key <- as.character(nodes)
    if (is.null(known[[key]])) {
      known[[key]] <<- settle("midwater_trawl", nodes = nodes, netting = "bars")
    }
    known[[key]]
  }
})

# The shipped trawl while its speed increases smoothly by 20 % in 4 s.
sped_up_trawl <- function(nodes) {
  state <- settled_trawl(nodes)
  speed <- state$si$towing$speed
  from_state(state, 4, speed = function(t) speed * (1.1 - 0.1 * cos(pi * min(t, 4) / 4)))
}

# The shipped trawl at the start of the turn of its plan.
turning_trawl <- function(nodes) {
  from_state(settled_trawl(nodes), 120,
    course = data.frame(time = c(0, 480), value = c("0 deg", "90 deg")))
}

# The shipped purse seine, bunched at the surface when shooting starts.
seine_from_vessel <- function(nodes, until) {
  gear <- read_gear("purse_seine")
  codend:::shot_trajectory(gear, codend:::gear_si(gear), tow_schedule(), until, nodes, NULL)
}

# The warp of the public case, straight down and unstretched.
warp_from_rest <- function() {
  gear <- test_plan("towed_warp")
  mesh <- codend:::build_mesh(codend:::gear_si(gear))
  position <- mesh$start
  node <- mesh$ropes$warp$node
  position[, node] <- rbind(0, 0, -20 - 5 * (seq_along(node) - 1))
  from_rest(gear, mesh, position, 2170)
}

# The square net of the public case, flat, upright and unstretched.
net_from_rest <- function(n) {
  gear <- square_net(n)
  mesh <- codend:::build_mesh(codend:::gear_si(gear))
  position <- mesh$start
  net <- mesh$panels[[1L]]
  position[, net$node] <- rbind(0, 0.5 * net$i - (n - 1) / 4, -10 - 0.5 * net$j)
  from_rest(gear, mesh, position, 400)
}

# Motions compared with the last release, by name: list(label, begin = function(nodes), until and
# every (s), sizes = requested node counts).
compared_motions <- list(
  sped_up = list(label = "trawl that is sped up", begin = sped_up_trawl, until = 2, every = 1,
    sizes = c(1500, 1e4)),
  turn = list(label = "trawl in a turn", begin = turning_trawl, until = 120, every = 20,
    sizes = c(1500, 1e4)),
  seine = list(label = "purse seine that is shot",
    begin = function(nodes) seine_from_vessel(nodes, 20), until = 20, every = 5, sizes = 1000)
)
