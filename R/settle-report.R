# Progress of the solver and its error messages.

cpu_clock <- function() sum(proc.time()[c("user.self", "sys.self")])

# Returns a function(now) that reports steps to the package progressr; NULL if it is not loaded.
progressr_steps <- function(total, done, frame) {
  if (!isNamespaceLoaded("progressr")) return(NULL)
  step <- progressr::progressor(steps = total, envir = frame)
  if (done > 0L) step(amount = done)
  function(now) {
    if (now > done) step(amount = now - done)
    done <<- now
  }
}

# Returns a function(iteration, residual) that shows a progress bar after two seconds.
settle_progress <- function() {
  # loading cli takes longer than settling a small gear
  if (!interactive() && !isatty(stderr())) return(function(iteration, residual) NULL)
  if (!cli::is_dynamic_tty()) return(function(iteration, residual) NULL)
  begun <- proc.time()[["elapsed"]]
  bar <- NULL
  frame <- parent.frame()
  function(iteration, residual) {
    if (is.null(bar)) {
      if (proc.time()[["elapsed"]] - begun < 2) return(NULL)
      bar <<- cli::cli_progress_bar(
        total = NA, .envir = frame, format = paste(
          "{cli::pb_spin} Settling: iteration {cli::pb_current}, largest residual force",
          "{cli::pb_status} of the largest tension [{cli::pb_elapsed}]"
        )
      )
    }
    cli::cli_progress_update(
      set = iteration, status = format(signif(residual, 2)), id = bar, .envir = frame
    )
  }
}

# `advice`: sentences with remedies, or NULL.
abort_unsettled <- function(report, mesh, position, advice = NULL) {
  where <- describe_node(mesh, report$worst_node)
  at <- round(matrix(position, 3L)[, report$worst_node], 1)
  reason <- if (report$wake_change > 1e-5) {
    "shape and wake did not converge in {report$wake_renewals} iterations. The last one changed the
    speed of the flow at a point by {signif(100 * report$wake_change, 2)} % of the free flow."
  } else if (report$part_rounding > report$greatest_rounding) {
    advice <- "Reduce the `axial_stiffness` of this part: it is too stiff at this distance
      from the origin for an accurate tension."
    "rounding errors of positions cause residual forces of {signif(report$part_rounding, 2)} of the
    largest force in {.val {report$rounding_part}}."
  } else if (report$residual <= settle_tolerance && report$part_residual > report$part_tolerance) {
    "after {report$iterations} iterations the largest residual force on {.val {report$worst_part}}
    is {signif(report$part_residual, 2)} of its largest force; the limit is
    {report$part_tolerance}."
  } else {
    c("after {report$iterations} iterations the largest residual force is
      {signif(report$residual, 2)} of the largest tension; the limit is {settle_tolerance}.",
      "x" = "Worst at {where}, near x = {at[1]} m, y = {at[2]} m, z = {at[3]} m:
      {signif(in_unit(report$worst_force, 'kN'), 3)} kN.")
  }
  reason[1L] <- paste("The gear did not settle:", reason[1L])
  bullets <- stats::setNames(sprintf("{advice[%d]}", seq_along(advice)), rep("i", length(advice)))
  abort_not_converged(c(reason, bullets), report = report)
}

# Returns the numbers of the parts that meet at a node.
parts_at <- function(mesh, node) {
  e <- mesh$model
  touching <- function(nodes, width, part) unique(part[(which(nodes == node) - 1L) %/% width + 1L])
  unique(c(
    touching(e$bars$node, 2L, mesh$bar_part),
    touching(e$cells$node, 4L, mesh$cell_part)
  ))
}

# Returns kinds and names of the parts at a node as a string.
describe_node <- function(mesh, node) {
  part <- parts_at(mesh, node)
  if (!length(part)) return("a point outside ropes and netting")
  paste0(mesh$parts$kind[part], " `", mesh$parts$name[part], "`", collapse = ", ")
}
