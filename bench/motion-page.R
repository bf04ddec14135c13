# The page for people, bench/results/motion.md. whole_run: CPU s.

write_motion_page <- function(motion, whole_run) {
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
    lines,
    "The energy imbalance is what the run made or lost of energy over what was put through.",
    "Rows of other programs are those of [published-motion.csv](../published-motion.csv): measured",
    "once, not in this run; their errors are those of the steady state."
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
