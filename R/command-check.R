command_check <- function() {
  list(
    takes = "PLAN", does = "Check a plan and say what gear it holds.",
    options = list(), run = function(plan, options) print(read_gear(plan))
  )
}
