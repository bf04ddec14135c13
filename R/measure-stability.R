# Warns where the balance of a state does not last, and of what it is that a push carries away.
warn_of_instability <- function(state) {
  if (!isTRUE(state$report$unstable)) return(invisible())
  of <- if (length(state$si$otter_boards)) {
    c("board", "the free boards and kites",
      "Look at {.fn tow} from this state, and where warps and backstrops are fastened.")
  } else if (any(vapply(state$si$ropes, `[[`, NA, "strut"))) {
    c("pole", "poles and pipes in compression",
      "Look at {.fn tow} from this state, and where ropes hold them.")
  } else {
    c("catch", "the netting around the catch, {.field catch.panels},",
      "The netting may have gone through itself. Look at the picture of this state, and settle with
      other {.arg nodes}.")
  }
  cli::cli_warn(
    c(paste("The balance that was found for", of[2L], "does not last: a small push carries it
      further away."), "i" = of[3L]),
    class = c(paste0("codend_warning_", of[1L], "_unstable"), "codend_warning"), call = NULL
  )
}
