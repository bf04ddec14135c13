# Settled gears that several tests use; each settles once, at `nodes`, because the default of
# settle() takes longer.
settled <- local({
  known <- list()
  function(name, ..., nodes = 1500) {
    key <- paste(name, ..., nodes)
    if (is.null(known[[key]])) known[[key]] <<- settle(settled_gear(name), ..., nodes = nodes)
    known[[key]]
  }
})

settled_gear <- function(name) {
  switch(name,
    hung_panel = as_gear(hung_panel_plan),
    panel_in_current = as_gear(panel_in_current_plan),
    read_gear(name)
  )
}

# Square netting in air, its upper edge gathered in one point: every lengthwise twine hangs straight
# down and carries the weight below it, and the crosswise twines are slack.
hung_panel_plan <- list(
  codend = 1, name = "Hung panel", water = list(density = 0),
  points = list(nail = list(position = c(0, 0, 0), held = "fixed")),
  panels = list(net = list(
    mesh_size = 0.1, meshes = list(upper = 40, lower = 40, deep = 60), orientation = "square",
    twine = list(diameter = 0.002, axial_stiffness = 1e6, mass_per_length = 0.01),
    columns = 4, rows = 8
  )),
  seams = list(top = list(edges = list("net.upper"), gathered_at = "nail"))
)

# A weighted sheet of netting between two points, in a current across its plane and along it.
panel_in_current_plan <- list(
  codend = 1, name = "Panel in a current",
  water = list(current = list(speed = 0.5, toward = "30 deg")),
  points = list(
    left = list(position = c(0, 0, 0), held = "fixed"),
    right = list(position = c(0, 2, 0), held = "fixed"),
    corner = list(at = "net.lower_left", load = c(5, 0, 0))
  ),
  ropes = list(
    headline = list(along = list("net.upper"), length = 2.2, diameter = "8 mm", material = "PP"),
    lead_line = list(along = list("net.lower"), hanging_ratio = 0.5, diameter = "10 mm",
      material = "PP", strength = "10 kN")
  ),
  pieces = list(
    weights = list(along = "lead_line", mass = 2, density = 7800, number = 4, diameter = 0.08,
      role = "weight")
  ),
  panels = list(net = list(
    mesh_size = 0.1, meshes = list(upper = 20, lower = 20, deep = 20),
    twine = list(diameter = "2 mm", material = "PA")
  )),
  seams = list(
    left = list(edges = list("net.upper[0:1]"), gathered_at = "left"),
    right = list(edges = list("net.upper[19:20]"), gathered_at = "right")
  )
)

shipped_states <- c("towed_cable", "crossing_cables", "midwater_trawl")
shipped_state <- function(name) {
  if (name == "midwater_trawl") settled(name, nodes = 500) else settled(name)
}

# Runs code with another value of an object of the package.
with_package_value <- function(name, value, code) {
  before <- getFromNamespace(name, "codend")
  on.exit(assignInNamespace(name, before, "codend"))
  assignInNamespace(name, value, "codend")
  code
}

# Runs code with a limit of iterations per mesh level.
with_settle_iterations <- function(iterations, code) {
  with_package_value("settle_iterations", iterations, code)
}
