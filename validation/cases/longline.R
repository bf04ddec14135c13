# Depths of the hooks of a longline without current.

use_tests("test-kind-longline")

# Depth (m) of hook j of n in a basket of main line of a length (m) by the catenary of T. Yoshihara
# (Bulletin of the Japanese Society of Scientific Fisheries 16:370, 1951, and 19:1012, 1954). The
# shortening ratio is k; lengths of the float line and branch line are in m.
yoshihara <- function(j, n, length, k, float_line, branch_line) {
  # k = cot(p) asinh(tan(p)), p the angle of the main line at the float line
  p <- uniroot(function(p) asinh(tan(p)) / tan(p) - k, c(1e-6, pi / 2 - 1e-6), tol = 1e-14)$root
  cot2 <- 1 / tan(p)^2
  float_line + branch_line + length / 2 * (sqrt(1 + cot2) - sqrt((1 - 2 * j / (n + 1))^2 + cot2))
}

# Depth (m) below its ends of an elastic line of n + 1 stretches of length s (m), weight w (N/m) and
# stiffness EA (N). A weight P (N) hangs between every two stretches, and the ends are `apart` (m).
# Elastic catenaries join end to end; V is the vertical force at the start of each.
hung_line <- function(n, s, w, ea, load, apart) {
  v <- ((n + 1) * s * w + n * load) / 2 - (0:n) * (s * w + load)
  step <- function(h) {
    h / w * (asinh(v / h) - asinh((v - w * s) / h)) + h * s / ea
  }
  h <- uniroot(function(h) sum(step(h)) - apart, c(0.01, 1e3), tol = 1e-13)$root
  drop <- (sqrt(h^2 + v^2) - sqrt(h^2 + (v - w * s)^2)) / w + (v^2 - (v - w * s)^2) / (2 * ea * w)
  cumsum(drop)[seq_len(n)]
}

# The same for the hooks (m below the surface) of a basket of a settled still_longline().
hung_longline <- function(state) {
  si <- state$si
  main <- si$ropes$main_line_2_1
  branch <- si$ropes$branch_line_2_1
  hook <- si$pieces$hook_2_1
  weight <- function(mass, volume) 9.81 * (mass - 1025 * volume)
  load <- weight(hook$mass, hook$volume) +
    15 * weight(branch$mass_per_length, branch$volume_per_length)
  joins <- state$position[, nodes_at(state, c("join_2", "join_3"))]
  hung <- hung_line(15, 50, weight(main$mass_per_length, main$volume_per_length),
    main$axial_stiffness, load, joins[1, 2] - joins[1, 1])
  hung - joins[3, 1] + 15
}

case_yoshihara <- function() {
  found <- measures(settle(still_longline()))[sprintf("hook_%d_depth_m", 1:8)]
  compared("depth", paste("hook", 1:8), yoshihara(1:8, 15, 800, 0.65, 25, 15), as.double(found))
}

case_loaded_line <- function() {
  state <- settle(still_longline())
  found <- as.double(measures(state)[sprintf("hook_%d_depth_m", 1:8)])
  compared("depth", paste("hook", 1:8), hung_longline(state)[1:8], found)
}
