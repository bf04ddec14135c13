# Inputs that could explain the errors of net heights in flume tests and in hauls.
#
#   Rscript validation/heights.R    after `make condition`, whose derivatives it uses
#
# Writes validation/heights.md.
#
# A change x of an input (as a fraction) changes the logarithm of a height by its exact relative
# derivative times x. The derivatives are those of uncertainty() at the middle of each series.

source("validation/condition.R")

# Inputs: label, name of the source in uncertainty() (a regular expression), admissible range as
# fractions, and its origin.
input <- function(label, source, low, high, origin) {
  data.frame(label = label, source = source, low = low, high = high, origin = origin)
}
inputs <- rbind(
  input("upper bridles, length", "bridles? upper length$", -0.0055, 0.0055,
    "0.15 to 0.3 m of 55 m (drawings of AFSC nets)"),
  input("floats, buoyancy", "floats buoyancy$", -0.1, 0.025,
    "2.5 % from fresh to sea water; 10 % loss by pressure and wear (assumed)"),
  input("ground gear, weight in water", "^weight of ground gear", -0.2, 0.2,
    "twice the 10 % of `uncertainty.csv` (wear and fouling)"),
  input("hanging ratios", "hanging ratio", -0.04, 0.04, "twice the 2 % of `uncertainty.csv`"),
  input("twine diameter, wet", "^twine diameters$", -0.1, 0.25,
    "makers' tolerance of -10 % to +25 % (`uncertainty.csv`)"),
  input("mesh size", "^mesh sizes$", -0.03, 0.03, "2 to 3 % by shrinkage and wear (ISO 16663-1)"),
  input("drag of knots", "^drag of knots$", -1, 0.33,
    "from knotless netting to a third more (Suisan 45)"),
  input("drag of netting as a screen", "^drag of netting as a screen$", -0.25, 0.25,
    "spread of published screen models, 15 to 25 %"),
  input("lift of netting as a screen", "^lift of netting as a screen$", -0.25, 0.25,
    "as for the drag"),
  input("friction along netting", "^drag of netting along", -0.37, 4,
    "0.0126 (smooth plate) to 0.1 (twine models), 0.02 in codend"),
  input("wake of headline and floats", "^drag of (floats|ropes across)", -0.25, 0,
    "a drag reduction of the parts in a wake (assumed: at most 25 %)"),
  input("heel of boards", "otter boards? mass$", -0.3, 0.3,
    "10 deg tilt a lift of 1.7 times the weight in water (assumed), as a change of mass")
)

rows <- readRDS(slopes_file)
data <- stacked(rows)

# Returns the relative derivatives of all values by the inputs: a matrix, values x inputs.
input_slopes <- function(rows) {
  do.call(rbind, lapply(rows, function(one) {
    vapply(inputs$source, function(pattern) {
      at <- which(grepl(pattern, one$source) & one$share > 0)
      drop(one$slopes[, at, drop = FALSE] %*% (1 / one$share[at]))
    }, numeric(nrow(one$values)))
  }))
}

slopes <- input_slopes(rows)
slopes[!is.finite(slopes)] <- 0
values <- data$values
used <- !values$tuned
sets <- list(
  flume = used & values$quantity == "opening" & grepl("^flume", values$group),
  hauls = used & values$quantity == "opening" & grepl("^hauls", values$group),
  tension = used & values$kind == "force"
)

# Returns the mean absolute error of a set (fraction) after changes of the inputs.
mean_error <- function(set, x) {
  mean(abs(exp(drop(slopes[set, , drop = FALSE] %*% x) - values$y[set]) - 1))
}
none <- numeric(nrow(inputs))
errors_now <- vapply(sets, mean_error, 0, x = none)

# Returns the changes of the inputs `free` within their ranges that minimise the error of a set. If
# `others` is TRUE, the errors of the other sets stay at most as large. The cost is a smooth and
# convex function of the changes: mean absolute errors of logarithms, rounded below 1 %.
best_changes <- function(set, free, others = TRUE) {
  at <- function(x) replace(none, free, x)
  smooth_error <- function(set, x) {
    mean(sqrt((drop(slopes[set, , drop = FALSE] %*% x) - values$y[set])^2 + 0.01^2))
  }
  now <- vapply(sets, smooth_error, 0, x = none)
  cost <- function(x) {
    errors <- vapply(sets, smooth_error, 0, x = at(x))
    worse <- pmax(0, (errors - now)[setdiff(names(sets), set)])
    errors[[set]] + if (others) 1000 * sum(worse^2) else 0
  }
  low <- inputs$low[free]
  range <- inputs$high[free] - low
  found <- stats::nlminb(-low / range, function(part) cost(low + part * range), lower = 0,
    upper = 1)
  at(low + found$par * range)
}

# Returns the largest likelihood ratio of a change of one input within its range, for the mean
# height of every rig. The covariance contains all other sources and the model error.
likelihood_ratio <- function(k) {
  opening <- some_of(data, sets$flume | sets$hauls)
  means <- quantity_means(opening)
  key <- paste(opening$values$group, opening$values$quantity)
  slope <- tapply(slopes[sets$flume | sets$hauls, k], factor(key, unique(key)), mean)
  residuals <- utils::read.csv("inst/extdata/uncertainty_residuals.csv", comment.char = "#")
  model <- residuals[residuals$kind == "height", ]
  v <- means$values
  root <- chol(known_variance(means) +
    diag(v$mesh^2 + v$scatter^2 + model$net^2 + model$rig^2 + model$quantity^2 +
      model$value^2 / (v$freedom + 1)))
  log_likelihood <- function(x) -sum(backsolve(root, v$y - slope * x, transpose = TRUE)^2) / 2
  best <- stats::optimise(log_likelihood, c(inputs$low[k], inputs$high[k]), maximum = TRUE)
  exp(max(0, best$objective - log_likelihood(0)))
}

signed <- function(x) formatC(x, format = "f", digits = 1, flag = "+")
shift <- function(set, k) {
  ends <- mean(slopes[sets[[set]], k]) * c(inputs$low[k], inputs$high[k])
  paste(signed(100 * sort(ends)), collapse = " to ")
}
explained <- function(set, x) percent(1 - mean_error(sets[[set]], x) / errors_now[[set]])

free <- seq_len(nrow(inputs))
heights <- c(flume = "flume", hauls = "hauls")
single <- lapply(heights, function(set) lapply(free, best_changes, set = set, others = FALSE))
all <- lapply(heights, best_changes, free = free)
# A single input is a special case of all inputs together.
halves <- names(all)[vapply(heights, function(set) {
  mean_error(sets[[set]], all[[set]]) <= errors_now[[set]] / 2
}, NA)]

together <- lapply(names(all), function(set) {
  errors <- vapply(sets, mean_error, 0, x = all[[set]])
  used <- abs(all[[set]]) > 0.005
  sprintf("- All inputs together, %s set: the mean error falls from %s to %s %% (%s).", set,
    percent(errors_now[[set]], 1), percent(errors[[set]], 1),
    toString(paste(inputs$label, paste(signed(100 * all[[set]]), "%"))[used]))
})

writeLines(c(
  "# Inputs that could explain the errors of heights", "",
  paste("`make condition` writes this page ([heights.R](heights.R)). The flume set has",
    sum(sets$flume), "tests of two nets, the haul set", sum(sets$hauls), "means of hauls of three",
    "nets. Values that were used to choose an input do not count."), "",
  sprintf("The mean absolute errors are %s %% (flume), %s %% (hauls) and %s %% (tensions).",
    percent(errors_now[[1]], 1), percent(errors_now[[2]], 1), percent(errors_now[[3]], 1)), "",
  "- Sensitivity: change of the height (%) for 1 % of the input, mean of the set.",
  "- Shift: change of the mean height (%) at both ends of the admissible range.",
  paste("- Explained: fraction of the mean absolute error (%) that disappears with the best change",
    "in the range for this set alone."),
  paste("- Likelihood ratio: of the best change for all heights to no change. Values below 3 are",
    "no evidence."), "",
  md_table(list(input = inputs$label, `range, %` = paste(signed(100 * inputs$low), "to",
    signed(100 * inputs$high)), origin = inputs$origin,
    `sensitivity, flume` = formatC(colMeans(slopes[sets$flume, ]), format = "f", digits = 2),
    `sensitivity, hauls` = formatC(colMeans(slopes[sets$hauls, ]), format = "f", digits = 2),
    `shift, flume` = vapply(free, shift, "", set = "flume"),
    `shift, hauls` = vapply(free, shift, "", set = "hauls"),
    `explained, flume` = mapply(explained, "flume", single$flume),
    `explained, hauls` = mapply(explained, "hauls", single$hauls),
    `likelihood ratio` = formatC(vapply(free, likelihood_ratio, 0), format = "f", digits = 1))), "",
  "With all inputs together, the errors of the other set and of the tensions must not grow:", "",
  unlist(together), "",
  if (length(halves)) {
    paste("Admissible changes halve the error of this set without worsening the other or the",
      "tensions:", toString(halves))
  } else {
    paste("No admissible change, of one input or of all inputs together, halves the error of a set",
      "without worsening the other or the tensions.")
  }
), "validation/heights.md")
