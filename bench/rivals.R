# Compares settle() with other methods for the same steady state, at equal error on one small net.
#
# The net is square netting of 16 x 16 knots, 240 free (plan square_net). All methods start at rest
# from settle()'s crude layout. The reference is settle() with a tolerance of 1e-12. The error of a
# state is the largest distance of a knot from the reference. Time integrations end at the same
# simulated time: the first whole second with an error of symplectic Euler of at most `asked_error`.
#
# All use the engine's forces and masses. Methods in R call engine_evaluate(), which costs mostly R
# time. So every row also lists the cost of its evaluations inside the engine.

asked_error <- 0.01  # m
rival_limit <- 120   # CPU seconds; beyond this limit the cost is extrapolated from the time reached

# Returns the net as a system of equations, a list.
#
#   mesh, start (3n), answer (3n), free: indices of the free coordinates
#   error: function(3n)
#   evaluations: function() -> calls of rate and force since reset()
#   force: function(free coordinates) -> net forces there
#   rate: function(t, (free coordinates, their velocities)) -> their time derivatives
rival_problem <- function() {
  mesh <- codend:::build_mesh(codend:::gear_si(square_net(16)))
  mesh <- mesh$model
  start <- as.double(mesh$start)
  free <- which(rep(!mesh$held, each = 3L))
  known <- codend:::engine_settle(
    mesh, start, "crude", numeric(), integer(), 1e-12, 3200L, function(iteration, residual) NULL
  )
  stopifnot(known$converged)
  evaluations <- 0
  reached <- 0
  evaluate <- function(x, v) {
    evaluations <<- evaluations + 1
    position <- start
    velocity <- numeric(length(start))
    position[free] <- x
    velocity[free] <- v
    codend:::engine_evaluate(mesh, position, velocity)
  }
  half <- seq_along(free)
  list(
    mesh = mesh, start = start, answer = known$position, free = free,
    error = function(position) {
      max(sqrt(colSums(matrix(position - known$position, 3L)^2)))
    },
    evaluations = function() evaluations,
    reached = function() reached,
    reset = function() evaluations <<- reached <<- 0,
    force = function(x) evaluate(x, 0 * x)$force[free],
    rate = function(t, y, parameters = NULL) {
      reached <<- t + 0  # a copy: deSolve overwrites its t
      v <- y[-half]
      found <- evaluate(y[half], v)
      list(c(v, accelerations(found, free)))
    }
  )
}

# M^-1 F of the free nodes, by Cramer's rule on all blocks together.
accelerations <- function(found, free) {
  nodes <- (free[seq(1L, length(free), 3L)] + 2L) / 3L
  m <- matrix(found$mass, 9L)[, nodes]
  f <- matrix(found$force, 3L)[, nodes]
  cross <- function(a, b) {
    rbind(a[2, ] * b[3, ] - a[3, ] * b[2, ], a[3, ] * b[1, ] - a[1, ] * b[3, ],
      a[1, ] * b[2, ] - a[2, ] * b[1, ])
  }
  one <- m[1:3, ]
  two <- m[4:6, ]
  three <- m[7:9, ]  # symmetric: rows are columns
  determinant <- colSums(one * cross(two, three))
  as.vector(rbind(
    colSums(f * cross(two, three)), colSums(one * cross(f, three)), colSums(one * cross(two, f))
  ) / rep(determinant, each = 3L))
}

# Rows of the comparison, settle() first.
compare_rivals <- function() {
  problem <- rival_problem()
  euler <- march_symplectic_euler(problem)
  seconds <- euler$simulated
  paper <- march_paper(problem, seconds)
  inside <- paper$cpu / paper$evaluations
  rows <- list(
    settle_row(problem), euler, paper,
    solve_by_desolve(problem, seconds, "lsodes, implicit (backward differentiation)", "lsodes"),
    solve_by_desolve(problem, seconds, "ode45, explicit (Dormand and Prince)", "ode45"),
    solve_by_nleqslv(problem, "Newton"), solve_by_nleqslv(problem, "Broyden")
  )
  found <- bind_rows(rows)
  found$ratio <- found$cpu / found$cpu[1]
  found$cpu_inside <- found$evaluations * inside
  found
}

settle_row <- function(problem) {
  gear <- square_net(16)
  state <- settle(gear)
  list(
    method = "settle()", cpu = stats::median(replicate(9, cpu(settle(gear)))),
    error = problem$error(as.vector(state$position)), note = "the whole call, mesh included"
  )
}

# 0.5 ms is two thirds of 2 / omega of the net's stiffest motion: knots against each other along
# bars of 12 kN / 0.5 m with 7 g at either end. Bars are damped by the water alone here.
explicit_step <- 5e-4

march_symplectic_euler <- function(problem) {
  problem$reset()
  y <- c(problem$start[problem$free], numeric(length(problem$free)))
  x <- seq_along(problem$free)
  position <- problem$start
  simulated <- 0
  seconds <- cpu({
    while (problem$error(position) > asked_error && simulated < 100) {
      for (k in seq_len(round(1 / explicit_step))) {
        y[-x] <- y[-x] + explicit_step * problem$rate(0, y)[[1L]][-x]
        y[x] <- y[x] + explicit_step * y[-x]
      }
      simulated <- simulated + 1
      position[problem$free] <- y[x]
    }
  })
  list(
    method = "symplectic Euler", cpu = seconds, error = problem$error(position),
    simulated = simulated, evaluations = problem$evaluations(),
    note = sprintf("step %.3g ms, in R", 1000 * explicit_step)
  )
}

# The paper's scheme in the engine. Its step is halved in series; the cheapest over the first second
# counts.
march_paper <- function(problem, simulated) {
  march <- function(step, seconds) {
    steps <- as.integer(ceiling(seconds / step))
    codend:::engine_integrate(problem$mesh, problem$start, numeric(length(problem$start)),
      seconds / steps, steps, 1e-5, 200L)
  }
  steps <- 1.6e-3 / 2^(0:4)
  cost <- vapply(steps, function(step) {
    found <- march(step, 1)
    if (found$converged) found$substitutions else Inf
  }, 0)
  step <- steps[which.min(cost)]
  seconds <- cpu(found <- march(step, simulated))
  list(
    method = "the paper's scheme", cpu = seconds, error = problem$error(found$position),
    simulated = simulated, evaluations = found$substitutions,
    note = sprintf("step %.3g ms, in the engine%s", 1000 * step,
      if (found$converged) "" else "; stopped on its way")
  )
}

solve_by_desolve <- function(problem, simulated, name, method) {
  problem$reset()
  y <- c(problem$start[problem$free], numeric(length(problem$free)))
  position <- problem$start
  # tolerances are a tenth of the allowed error, in m and m/s
  tolerances <- list(rtol = asked_error / 10, atol = asked_error / 10)
  integrate <- function() {
    setTimeLimit(cpu = rival_limit, transient = TRUE)
    on.exit(setTimeLimit())
    do.call(deSolve::ode, c(
      list(y = y, times = c(0, simulated), func = problem$rate, parms = NULL, method = method,
        maxsteps = 1e7), tolerances
    ))
  }
  seconds <- cpu(found <- tryCatch(suppressWarnings(integrate()), error = identity))
  row <- list(method = paste0("deSolve ", name), cpu = seconds, simulated = simulated,
    evaluations = problem$evaluations(), note = "in R")
  if (inherits(found, "error") && grepl("CPU time limit", conditionMessage(found))) {
    share <- problem$reached() / simulated
    row$cpu <- row$cpu / share
    row$evaluations <- row$evaluations / share
    row$note <- sprintf("extrapolated from the first %.1f s of %g", problem$reached(), simulated)
  } else if (inherits(found, "error")) {
    row$note <- conditionMessage(found)
  } else {
    position[problem$free] <- found[nrow(found), 1L + seq_along(problem$free)]
    row$error <- problem$error(position)
  }
  row
}

solve_by_nleqslv <- function(problem, method) {
  problem$reset()
  position <- problem$start
  solve <- function() {
    setTimeLimit(cpu = rival_limit, transient = TRUE)
    on.exit(setTimeLimit())
    nleqslv::nleqslv(position[problem$free], problem$force, method = method,
      control = list(maxit = 1000, allowSingular = TRUE, ftol = 1e-7))
  }
  seconds <- cpu(found <- tryCatch(solve(), error = identity))
  row <- list(method = paste("nleqslv", method), cpu = seconds,
    evaluations = problem$evaluations())
  if (inherits(found, "error")) {
    row$note <- if (grepl("CPU time limit", conditionMessage(found))) {
      "not within the limit"
    } else {
      conditionMessage(found)
    }
    return(row)
  }
  position[problem$free] <- found$x
  row$error <- problem$error(position)
  row$note <- found$message
  row
}

# Lines of the page.
rival_lines <- function(rivals) {
  table <- data.frame(
    method = rivals$method, `CPU s` = rivals$cpu, `times settle()` = rivals$ratio,
    `error, m` = rivals$error, `simulated s` = rivals$simulated,
    evaluations = rivals$evaluations, `CPU s inside the engine` = rivals$cpu_inside,
    remark = rivals$note, check.names = FALSE
  )
  c("## Other ways to the same steady state", "",
    sprintf("Square netting of 16 x 16 knots, to an error of %g m; see the README.", asked_error),
    "", markdown_table(table))
}
