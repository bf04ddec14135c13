# The derivative of the drawn positions by a field. While a slider moves, the page predicts the
# shape linearly and draws it until the settled shape arrives (web/src/tank/predict.ts).

# Relative change of the field. The second equilibrium has the mesh of the first one and starts from
# it, so that their difference has four correct digits.
prediction_share <- 1e-3

# Arrays of positions (m), in the order of prediction_message().
predicted_arrays <- c("points", "places", "boards")

# Returns a message with the derivative for `said`, paths that change together; NULL if the field
# has none or changes the mesh. The state in `memory` is the state of the shape that the page has.
prediction_message <- function(said, memory) {
  state <- memory$state
  asked <- requested_field(state$gear$plan, said)
  field <- sensitivity_field(state$gear, asked$paths)
  if (!is.list(field)) return(NULL)
  shape <- flume_shape(state)
  memory$fixed <- scene_fixed(shape)
  memory$paths <- given_paths(state$gear$plan)
  share <- if (field$whole) 1 / abs(field$value) else prediction_share
  near <- settled_near(state, field, share)
  if (is.null(near)) return(NULL)
  value <- quantity_si(asked$field$value, asked$field$node[["x-dimension"]])
  arrays <- Map(function(to, from) as.double(to - from) / (share * value),
    flume_shape(near)[predicted_arrays], shape[predicted_arrays])
  header <- list(predicts = I(asked$paths), value = value, counts = lapply(arrays, length))
  with_header(header, single_bytes(arrays))
}

# Returns the state with a field changed by a fraction on the same mesh, or NULL.
settled_near <- function(state, field, share) {
  gear <- scaled_gear(state$gear, field, share)
  found <- if (!is.null(gear)) {
    settle_on_mesh(state, gear, state$mesh$counts$asked$nodes, requested_netting(state))
  }
  if (isTRUE(found$usable)) new_state(gear, found$si, found$mesh, found$position, found$report)
}

# Returns the handler of requests for the derivative by the field that the user is about to move.
# `serial()`: number of the last shape that the page received.
flume_predicts <- function(page, worker, serial) {
  tank <- page$tank
  list(prediction_wanted = function(given) {
    paths <- as.list(given)$paths
    at <- NULL
    worker$ask("prediction", function() {
      at <<- list(serial(), tank$serial)
      tank$request("prediction", paths, worker$holds)
    }, function(answer) {
      # a newer shape has another derivative
      if (page$closed() || is.null(answer) || !identical(at, list(serial(), tank$serial))) return()
      worker$holds <- tank$serial
      if (!is.null(answer$found)) page$send_bytes(answer$found)
    })
  })
}
