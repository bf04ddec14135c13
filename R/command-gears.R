command_gears <- function() {
  list(
    takes = "", does = "List the plans that ship with codend.", options = list(),
    run = function(plan, options) {
      plans <- gears()
      cat(paste0(format(c("PLAN", plans$name)), "  ", c("TITLE", plans$title), "\n"), sep = "")
    }
  )
}
