command_check <- function() {
  list(
    takes = "PLAN", does = "Check a plan and say what gear it holds.",
    options = list(set_option()), run = run_check
  )
}

run_check <- function(plan, options) {
  gear <- read_changed(plan, options)
  print(gear)
  found <- findings(gear)
  if (nrow(found)) cat("", cli::style_bold("Warnings"), finding_lines(found), sep = "\n")
}
