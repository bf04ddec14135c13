# Measures in SI, as the engine computes them (src/engine/measure) for states, pages and programs.

# asked: a list of list(kind, what asks_*() gives), as a plan's measures are; of what every gear
# has, the engine's name as `kind` alone. Returns a number each, NaN of what the gear does not have.
measure_values <- function(state, asked) {
  engine_measures(
    state$lattice$mesh, questions_of(state$si, state$lattice, asked), shape_of(state)
  )
}

measure_value <- function(state, kind) measure_values(state, list(list(kind = kind)))

# What is asked of a gear, as the engine reads it: see `Questions` in src/engine/measure.
questions_of <- function(si, lattice, asked) {
  places <- place_names(si)
  mouth <- si$measures$mouth_area
  wings <- si$measures$wing_end_spread
  place_of <- function(texts) match(as.character(unlist(texts)), places)
  list(
    place_count = length(places), rope_count = length(si$ropes), panel_count = length(si$panels),
    part_count = nrow(lattice$parts), plate_count = length(si$otter_boards),
    speed = si$towing$speed,
    mouth = if (identical(mouth$kind, "area")) match(mouth$ropes, names(si$ropes)) else integer(),
    wings = if (identical(wings$kind, "spread")) place_of(wings$pairs) else integer(),
    propulsion = if (!is.null(si$vessel)) vessel_propulsion(si$vessel),
    measures = lapply(unname(asked), function(one) {
      of_rope <- !is.null(one$rope)
      list(
        kind = one$kind, places = place_of(c(one$pairs, if (!of_rope) one$place)),
        ropes = match(c(one$ropes, one$rope), names(si$ropes)),
        panels = match(one$panels, names(si$panels)),
        parts = which(lattice$parts$name %in% one$parts),
        plates = match(one$board, names(si$otter_boards)),
        at = if (of_rope) first_of(one$place, "none") else "none",
        angle = first_of(one$angle, "none"), of = first_of(one$of, 1)
      )
    })
  )
}

vessel_propulsion <- function(vessel) {
  fuel <- vessel[["fuel"]]
  known <- first_of(vessel$catch_per_hour, NA_real_)
  list(
    speed = vessel$pull$speed, pull = vessel$pull$pull, power = vessel$power,
    load = first_of(fuel$load, numeric()), consumption = first_of(fuel$consumption, numeric()),
    fuel_density = first_of(vessel$fuel_density, 1), yield = if (is.na(known)) 0 else known / 3600
  )
}
