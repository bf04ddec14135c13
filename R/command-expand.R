command_expand <- function() {
  list(
    takes = "PLAN", does = "Print the assembly that a plan stands for, as a plan (YAML).",
    options = list(), run = function(plan, options) cat(format(assembly(read_gear(plan))))
  )
}
