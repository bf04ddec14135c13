# Measures how often intervals of calibrate() contain the true values. Each of 200 repeats simulates
# a towed sphere at five speeds with two hauls each. Pull and depth have normal errors of 0.03 kN
# and 0.1 m. bench/coverage-trawls.R does the same for trawls whose hauls come from finer meshes.
#
#   Rscript bench/coverage.R [repeats]
#
# Prints the coverage of 90 % intervals from the covariance and, in every fifth repeat, from the
# profile likelihood. With 200 repeats the coverage is uncertain by +- 4.2 % (two standard
# deviations of a binomial fraction).
library(codend)

given <- commandArgs(TRUE)
repeats <- if (length(given)) as.integer(given[1L]) else 200L
truth <- c(drag_coefficient = 0.8, mass = 150)
speeds <- rep(paste(2:6, "knot"), 2L)

gear <- gear(
  name = "Towed sphere", towing = list(speed = "2 m/s"),
  points = list(ship = list(position = c(0, 0, 0), held = "moved"),
    end = setNames(list(), character())),
  ropes = list(line = rope(
    from = "ship", to = "end", length = "10 m", diameter = "1 mm", axial_stiffness = "1200 MN",
    mass_per_length = 0, volume_per_length = 0, segments = 1,
    coefficients = list(normal = 0, tangential = 0, skin = 0)
  )),
  pieces = list(sphere = list(at = "end", mass = "200 kg", diameter = "0.5 m",
    volume = "0.01 m3", drag_coefficient = 0.5)),
  measures = list(depth = list(depth = "end"), pull = list(tension = "line.start"))
)
true <- update(gear, pieces.sphere.drag_coefficient = 0.8, pieces.sphere.mass = 150)
settled <- vary(true, towing.speed = paste(2:6, "knot"))
k <- rep(1:5, 2L)

set.seed(20)
held <- t(vapply(seq_len(repeats), function(one) {
  runs <- data.frame(
    towing.speed = speeds,
    Pull = settled$pull_kN[k] + 0.03 * rnorm(10), Depth = settled$depth_m[k] + 0.1 * rnorm(10)
  )
  fit <- calibrate(gear, runs,
    change = list(
      pieces.sphere.drag_coefficient = c(0.2, 2), pieces.sphere.mass = c("50 kg", "400 kg")
    ),
    match = list(Pull ~ pull_kN, Depth ~ depth)
  )
  inside <- function(ends) truth >= ends[, 1L] & truth <= ends[, 2L]
  c(
    inside(confint(fit, level = 0.9, method = "normal")),
    if (one %% 5L == 0L) inside(confint(fit, level = 0.9)) else c(NA, NA)
  )
}, logical(4L)))
colnames(held) <- paste(rep(c("covariance", "profile"), each = 2L), names(truth))
print(data.frame(
  interval = colnames(held), repeats = colSums(!is.na(held)),
  held_percent = round(100 * colMeans(held, na.rm = TRUE), 1)
), row.names = FALSE)
