# How a solve shows its progress, and what is said where it fails.

# CPU seconds of this process.
cpu_clock <- function() sum(proc.time()[c("user.self", "sys.self")])

# A function(iteration, residual) that shows a bar once a solve has run for two seconds.
settle_progress <- function() {
  # to load cli takes longer than a small gear to settle
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
          "{cli::pb_spin} Settling: step {cli::pb_current}, largest net force",
          "{cli::pb_status} of the largest tension [{cli::pb_elapsed}]"
        )
      )
    }
    cli::cli_progress_update(
      set = iteration, status = format(signif(residual, 2)), id = bar, .envir = frame
    )
  }
}

# advice: sentences that say what to try, or NULL.
abort_unsettled <- function(report, lattice, position, advice = NULL) {
  where <- describe_node(lattice, report$worst_node)
  at <- round(matrix(position, 3L)[, report$worst_node], 1)
  if (report$wake_change > 1e-5) {
    abort_not_converged(
      "The gear did not settle: shape and wake still changed each other after {report$wake_renewals}
      rounds, the speed of the flow at a point by {signif(100 * report$wake_change, 2)} % of the
      free flow's.",
      report = report
    )
  }
  if (report$part_rounding > report$greatest_rounding) {
    abort_not_converged(
      c("The gear did not settle: rounding of places alone leaves net forces of
        {signif(report$part_rounding, 2)} of the largest force in {.val {report$rounding_part}}.",
        "i" = "It is too stiff for a place so far from the origin to compute its tension: lower
        its {.field axial_stiffness}."),
      report = report
    )
  }
  if (report$residual <= settle_tolerance && report$part_residual > report$part_tolerance) {
    abort_not_converged(
      "The gear did not settle: after {report$iterations} steps the largest net force on
      {.val {report$worst_part}} is {signif(report$part_residual, 2)} of the largest force in it,
      where {report$part_tolerance} is needed.",
      report = report
    )
  }
  abort_not_converged(
    c(
      "The gear did not settle: after {report$iterations} steps the largest net force is
      {signif(report$residual, 2)} of the largest tension, where {settle_tolerance} is needed.",
      "x" = "Worst at {where}, near x = {at[1]} m, y = {at[2]} m, z = {at[3]} m:
      {signif(in_unit(report$worst_force, 'kN'), 3)} kN.",
      stats::setNames(sprintf("{advice[%d]}", seq_along(advice)), rep("i", length(advice)))
    ),
    report = report
  )
}

# The parts that meet at a node, by number.
parts_at <- function(lattice, node) {
  e <- lattice$mesh
  touching <- function(nodes, width, part) unique(part[(which(nodes == node) - 1L) %/% width + 1L])
  unique(c(
    touching(e$bars$node, 2L, lattice$bar_part),
    touching(e$cells$node, 4L, lattice$cell_part)
  ))
}

# The same in words.
describe_node <- function(lattice, node) {
  part <- parts_at(lattice, node)
  if (!length(part)) return("a point outside ropes and netting")
  paste0(lattice$parts$kind[part], " `", lattice$parts$name[part], "`", collapse = ", ")
}
