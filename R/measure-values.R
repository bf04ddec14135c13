# Measures in SI, computed by the engine (src/engine/measure).

# `asked`: list of list(kind, arguments as in `si$measures`); standard measures need only `kind`.
# Returns one number each; NaN if the gear has no such measure.
measure_values <- function(state, asked) {
  engine_measures(
    state$mesh$model, questions_of(state$si, state$mesh, asked), shape_of(state)
  )
}

measure_value <- function(state, kind) measure_values(state, list(list(kind = kind)))

# Returns a request in the engine's format: see `Questions` in src/engine/measure/measures.hpp.
questions_of <- function(si, mesh, asked) {
  places <- place_names(si)
  place_of <- function(texts) match(as.character(unlist(texts)), places)
  list(
    place_count = length(places), rope_count = length(si$ropes), panel_count = length(si$panels),
    part_count = nrow(mesh$parts), plate_count = length(si$otter_boards),
    speed = si$towing$speed,
    nets = lapply(unname(si$nets), function(net) {
      list(mouth = match(net$mouth, names(si$ropes)), wings = place_of(net$wing_ends))
    }),
    propulsion = if (!is.null(si$vessel)) vessel_propulsion(si$vessel),
    measures = lapply(unname(asked), function(one) {
      of_rope <- !is.null(one$rope)
      list(
        kind = one$kind, places = place_of(c(one$pairs, if (!of_rope) one$place)),
        ropes = match(c(one$ropes, one$rope), names(si$ropes)),
        panels = match(one$panels, names(si$panels)),
        parts = which(mesh$parts$name %in% one$parts),
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
