# Returns the state of a shipped gear for the gallery. A purse seine is towed until its wire has
# closed the net; other gears are settled. nodes: as in settle().
gallery_state <- function(name, nodes = NULL) {
  if (name != "purse_seine") return(settle(name, nodes = nodes))
  state_at(tow(name, until = 420, every = 420, nodes = 120, accuracy = 1), 420)
}
