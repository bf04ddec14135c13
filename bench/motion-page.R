# Writes the page for readers, bench/results/motion.md. whole_run: CPU s.

# Returns the CPU time of run `now` at root mean square error `error` (m): a power law through its
# three accuracies.
cost_at_error <- function(now, error) {
  settings <- c("loose", "usual", "tight")
  errors <- log(unlist(now[paste0(settings, ".error")]))
  costs <- log(unlist(now[paste0(settings, ".cost")]))
  power <- stats::lm.fit(cbind(1, errors), costs)$coefficients
  exp(power[[1L]] + power[[2L]] * log(error))
}

# Compares this tree with the last release: a row per case and size. Each value is a median; the
# ratio of CPU seconds per node also has its minimum and maximum over the rounds.
compare_marches <- function(runs) {
  groups <- unique(runs[c("case", "asked")])
  bind_rows(lapply(seq_len(nrow(groups)), function(k) {
    of <- runs[runs$case == groups$case[k] & runs$asked == groups$asked[k], ]
    now <- of[of$version == "now", ]
    was <- of[of$version == "release", ]
    ratio <- (now$usual.cost / now$nodes) / (was$usual.cost / was$nodes)
    equal <- vapply(seq_len(nrow(now)), function(k) cost_at_error(now[k, ], was$usual.error[k]), 0)
    list(
      case = compared_motions[[groups$case[k]]]$label, asked = groups$asked[k],
      ratio_at_equal_error = stats::median((equal / now$nodes) / (was$usual.cost / was$nodes)),
      error_release = was$usual.error[1], error = now$usual.error[1],
      ratio = stats::median(ratio), least = min(ratio), most = max(ratio),
      nodes_release = was$nodes[1], nodes = now$nodes[1],
      cpu_release = 1000 * stats::median(was$usual.cost),
      cpu = 1000 * stats::median(now$usual.cost),
      steps_release = was$steps[1], steps = now$steps[1],
      rejected_release = was$repeated[1] + was$not_found[1],
      rejected = now$repeated[1] + now$not_found[1],
      iterations_release = was$iterations[1], iterations = now$iterations[1],
      factorisations = now$factorisations[1]
    )
  }))
}

write_motion_page <- function(motion, ratios, whole_run) {
  cases <- unique(motion[c("case", "nodes")])
  public <- utils::read.csv(file.path("bench", "published-motion.csv"))
  lines <- unlist(lapply(seq_len(nrow(cases)), function(k) {
    of <- motion[motion$case == cases$case[k] & motion$nodes == cases$nodes[k], ]
    c(
      sprintf("## %s, %s nodes", cases$case[k], plain_number(cases$nodes[k])), "",
      markdown_table(case_table(of, public[public$case == cases$case[k], ])), ""
    )
  }))
  save_page(c(
    "# What motion costs", "",
    paste("Written by `make bench-tow`; [what is measured, against what and how](../README.md).",
      measured_with()), sprintf("The whole run took %.0f CPU s.", whole_run), "",
    "## Beside the last release", "",
    paste("CPU time per node relative to 0.1.0: `ratio` at equal accuracy, `ratio_at_equal_error`",
      "at the root mean square error (m) of 0.1.0. Release 0.1.0 does not count factorisations."),
    "",
    markdown_table(ratios), "", lines,
    "The energy imbalance is the energy gained or lost by the scheme over the energy exchanged.",
    "Rows of other programs come from [published-motion.csv](../published-motion.csv). They were",
    "measured once, not in this run. Their errors are those of the steady state."
  ), "motion")
}

case_table <- function(of, public) {
  own <- data.frame(
    program = "codend", scheme = gsub("_", " ", of$scheme), setting = of$setting,
    simulated = of$simulated, cpu = of$cpu_per_second, largest = of$largest_error,
    mean = of$mean_error, steps = of$steps, longest = of$longest_step,
    rejected = 100 * of$rejected, imbalance = 100 * of$imbalance,
    remark = if (is.null(of$remark)) NA_character_ else of$remark
  )
  unknown <- rep(NA_real_, nrow(public))
  others <- data.frame(
    program = paste(public$program, public$version), scheme = public$settings,
    setting = public$basis, simulated = unknown, cpu = public$cpu_per_second,
    largest = public$error, mean = unknown, steps = unknown, longest = unknown,
    rejected = unknown, imbalance = unknown, remark = rep(NA_character_, nrow(public))
  )
  table <- rbind(own, others[seq_len(nrow(public)), ])
  table$cpu <- 1000 * table$cpu
  table$longest <- 1000 * table$longest
  setNames(table, c(
    "program", "scheme", "setting", "simulated, s", "CPU ms per simulated s", "largest error, m",
    "root mean square error, m", "steps", "longest step, ms", "attempts rejected, %",
    "energy imbalance, % of put through", "remark"
  ))
}
