# Advice for a gear that does not settle, from its last shape.

# Fraction of slack twines above which slack netting is the likely cause.
much_slack <- 0.5

# `found`: result of settle_numbers(). Returns at least one sentence that names fields to change,
# most useful first.
unsettled_advice <- function(gear, si, found) {
  odd <- findings_by(gear, sorted_checks())
  advice <- c(
    # All 11 of 500 random gears that failed with bars converged with cells.
    if (any(found$mesh$counts$asked$bars)) {
      "Use `netting = \"cells\"`. This converges more often than bars."
    },
    slack_advice(gear, si, found),
    utils::head(finding_sentences(odd[odd$rank <= 2L, ]), 1L)
  )
  if (length(advice)) return(advice)
  paste("Settle it with fewer `nodes`, or `from` the state of a similar gear;",
    "see `vignette(\"when-it-does-not-settle\", \"codend\")`.")
}

# Returns advice on the netting at the worst node: slack twines, a short line, the drag model.
slack_advice <- function(gear, si, found) {
  parts <- found$mesh$parts
  here <- parts_at(found$mesh, found$report$worst_node)
  netting <- here[parts$kind[here] == "netting"]
  if (!length(netting)) return(NULL)
  part <- line_part(found$mesh)
  share <- vapply(netting, function(one) mean(found$strain[part == one] < 0), 0)
  name <- parts$name[netting[which.max(share)]]
  law <- si$panels[[name]]$netting_drag
  c(
    if (max(share) > much_slack) {
      sprintf("%.0f %% of the twines of netting `%s` are slack there%s", 100 * max(share), name,
        short_line(gear, si, parts$name[here[parts$kind[here] == "rope"]]))
    },
    if (!identical(law, "morison")) {
      sprintf(paste("The drag model `%s` gives netting along the flow almost no tension. Try",
        "`netting_drag: morison` and compare the results."), law)
    }
  )
}

# Returns the end of a sentence on slack netting. It names the first rope that is laced to netting.
short_line <- function(gear, si, ropes) {
  laced <- Filter(function(rope) !is.null(si$ropes[[rope]]$along), ropes)
  if (!length(laced)) return(".")
  field <- finding_field(gear$plan, paste("rope", laced[1L]), "hanging_ratio")
  sprintf("; the line `%s` along it may be too short: lengthen it (`%s`).", laced[1L],
    if (is.na(field)) "hanging_ratio" else field)
}
