finish_calibration <- function(refined) {
  task <- refined$task
  fit <- refined$fit
  scaled <- fit$scaled
  fields <- task$points$fields
  at <- range_ends(scaled)
  model <- model_at(task, scaled, slopes = TRUE)
  begun <- model_of(task, task$begun)
  used <- lapply(task$match, function(one) which(!is.na(one$measured)))
  task$freedom <- max(1, sum(lengths(used)) - sum(at == ""))
  # Estimated errors must account for the degrees of freedom that the fields use.
  grown <- sqrt(sum(lengths(used)) / task$freedom)
  error <- vapply(seq_along(task$match), function(k) {
    one <- task$match[[k]]
    off <- model[[k]]$fitted[used[[k]]] - one$measured[used[[k]]]
    error_of(one, off) * if (is.na(one$error)) grown else 1
  }, 0)
  matched <- do.call(rbind, lapply(seq_along(task$match), function(k) {
    one <- task$match[[k]]
    rows <- used[[k]]
    residual <- one$measured[rows] - model[[k]]$fitted[rows]
    data.frame(
      row = rows, match = one$text, measured = one$measured[rows],
      begun = begun[[k]]$fitted[rows], fitted = model[[k]]$fitted[rows], residual = residual,
      standardised = residual / error[k]
    )
  }))
  by <- lapply(task$match, function(one) matched[matched$match == one$text, ])
  rms <- function(x) sqrt(mean(x^2))
  found <- fields_covariance(task, model, used, error, at)
  covariance <- found$covariance
  values <- points_values(task$points, scaled)
  prior <- t(vapply(fields, function(field) first_of(field$prior, c(NA_real_, NA_real_)), c(0, 0)))
  task$steps <- NULL
  task$points$shared$record <- NULL
  structure(
    list(
      gear = set_free(task$points$gear, fields, values),
      fields = data.frame(
        field = field_names(fields), unit = vapply(fields, `[[`, "", "unit"),
        begun = own_values(fields), value = values, error = sqrt(diag(covariance)),
        mesh = found$mesh,
        lower = lower_ends(fields), upper = upper_ends(fields), at = at,
        prior_mean = prior[, 1L], prior_sd = prior[, 2L], row.names = NULL
      ),
      covariance = covariance, matched = matched,
      match = data.frame(
        text = vapply(task$match, `[[`, "", "text"), hauls = vapply(by, nrow, 0L), error = error,
        estimated = vapply(task$match, function(one) is.na(one$error), NA),
        bias = vapply(by, function(rows) mean(rows$residual), 0),
        rms_begun = vapply(by, function(rows) rms(rows$measured - rows$begun), 0),
        rms = vapply(by, function(rows) rms(rows$residual), 0)
      ),
      left_out = task$left_out,
      conditions = task$conditions, converged = fit$converged, misfit = fit$value,
      n_solves = task$points$count$n_solves, slopes = task$points$count$slopes,
      nodes = refined$nodes, accuracy = refined$accuracy, task = task, scaled = scaled
    ),
    class = "codend_calibration"
  )
}

# Returns list(covariance, mesh (standard errors due to the mesh)) in field units; NA at range
# ends.
fields_covariance <- function(task, model, used, error, at) {
  n <- length(task$points$fields)
  information <- matrix(0, n, n)
  for (k in seq_along(task$match)) {
    information <- information +
      crossprod(model[[k]]$slopes[used[[k]], , drop = FALSE]) / error[k]^2
  }
  for (k in which(has_prior(task$points$fields))) {
    information[k, k] <- information[k, k] + 1 / scaled_prior(task$points, k)[2L]^2
  }
  names <- field_names(task$points$fields)
  covariance <- matrix(NA_real_, n, n, dimnames = list(names, names))
  mesh <- rep(NA_real_, n)
  free <- which(at == "")
  inverse <- tryCatch(solve(information[free, free, drop = FALSE]), error = function(e) NULL)
  width <- task$points$width[free]
  if (is.null(inverse)) {
    # A singular matrix means that the data do not determine the fields.
    covariance[free, free] <- diag(Inf, length(free)) * outer(width, width)
  } else {
    model <- lapply(model, function(one) list(slopes = one$slopes[, free, drop = FALSE]))
    left <- mesh_covariance(task, model, used, error, inverse)
    covariance[free, free] <- (inverse + left) * outer(width, width)
    mesh[free] <- sqrt(diag(left)) * width
  }
  list(covariance = covariance, mesh = mesh)
}
