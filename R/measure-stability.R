# Warns if the equilibrium of a state is unstable and names the parts that would move away.
warn_of_instability <- function(state) {
  if (!isTRUE(state$report$unstable)) return(invisible())
  of <- if (length(state$si$otter_boards)) {
    c("board", "the free boards and kites",
      "Simulate the motion with {.fn tow} from this state, and check where warps and backstrops are
      attached.")
  } else if (any(vapply(state$si$ropes, `[[`, NA, "strut"))) {
    c("pole", "poles and pipes in compression",
      "Simulate the motion with {.fn tow} from this state, and check the ropes that support them.")
  } else {
    c("catch", "the netting around the catch, {.field catch.panels},",
      "The netting may have passed through itself. Check the picture of this state, and settle with
      other {.arg nodes}.")
  }
  warn_as(paste0(of[1L], "_unstable"), c(
    paste("The equilibrium of", of[2L], "is unstable: small disturbances grow."), "i" = of[3L]
  ))
}
