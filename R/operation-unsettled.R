# What to try where a gear does not settle, from what its last shape shows.

# Share of a netting's twines that are slack from which on this is named as the likely cause.
much_slack <- 0.5

# found: as settle_numbers() gives it. Returns sentences that name the fields to change, the most
# telling first; one at least.
unsettled_advice <- function(gear, si, found) {
  advice <- c(slack_advice(gear, si, found), odd_plan(gear))
  if (length(advice)) return(advice)
  paste("Settle it with fewer `nodes`, or `from` the state of a gear that is near;",
    "`vignette(\"when-it-does-not-settle\", \"codend\")` has more.")
}

# Of netting at the worst node: whether it is slack, which line along it may be too short, and its
# law.
slack_advice <- function(gear, si, found) {
  parts <- found$lattice$parts
  here <- parts_at(found$lattice, found$report$worst_node)
  netting <- here[parts$kind[here] == "netting"]
  if (!length(netting)) return(NULL)
  part <- line_part(found$lattice)
  share <- vapply(netting, function(one) mean(found$strain[part == one] < 0), 0)
  name <- parts$name[netting[which.max(share)]]
  law <- si$panels[[name]]$netting_drag
  c(
    if (max(share) > much_slack) {
      sprintf("%.0f %% of the twines of netting `%s` are slack there%s", 100 * max(share), name,
        short_line(gear, si, parts$name[here[parts$kind[here] == "rope"]]))
    },
    if (!identical(law, "twines")) {
      sprintf(paste("The drag law `%s` gives netting along the flow next to no pull: try",
        "`netting_drag: twines`, and see how much depends on it."), law)
    }
  )
}

# The end of a sentence on slack netting: the first of these ropes that is laced to netting.
short_line <- function(gear, si, ropes) {
  laced <- Filter(function(rope) !is.null(si$ropes[[rope]]$along), ropes)
  if (!length(laced)) return(".")
  field <- finding_field(gear$plan, paste("rope", laced[1L]), "hanging_ratio")
  sprintf("; the line `%s` along it may be too short: lengthen it (`%s`).", laced[1L],
    if (is.na(field)) "hanging_ratio" else field)
}

# What is unusual in the plan, the most important first.
odd_plan <- function(gear) {
  found <- findings_by(gear, sorted_checks())
  utils::head(finding_sentences(found[found$rank <= 2L, ]), 1L)
}
