# Share of absurd plans that are refused or get a finding, and share of sane plans with a finding.
#
#   Rscript bench/absurd-plans.R COUNT SEED
#
# An absurd plan is a shipped plan with one field multiplied by a factor of 10 to 1,000, up or down.
# It counts as detected if it is refused, does not settle, or has a finding that the shipped plan
# does not have. A sane plan has three fields other than mesh counts changed by up to 2 %.
#
# The fields are all numbers except angles, conditions that may be arbitrarily small (speeds,
# depths), and numbers of operations, models and materials.

suppressPackageStartupMessages(library(codend))
arguments <- as.integer(commandArgs(TRUE))
count <- if (length(arguments)) arguments[1] else 300L
set.seed(if (length(arguments) > 1) arguments[2] else 1L)

plans <- setdiff(gears()$name, c("crossing_cables", "flat_panel"))
other <- paste0("^(tow|hauling|pursing|shooting|multipliers|vessel|uncertain)[.]|toward|bearing|",
  "angle|stiffness|strength|position|segments|columns|current.*(speed|depth)|opening|friction")

settled_findings <- function(gear) {
  found <- findings(suppressWarnings(settle(gear, nodes = 600)))
  paste(found$check, found$location)
}
shipped <- lapply(setNames(nm = plans), function(plan) {
  gear <- read_gear(plan)
  paths <- grep(other, codend:::given_paths(gear$plan), value = TRUE, invert = TRUE)
  numbers <- lapply(setNames(nm = paths), function(path) codend:::field_number(gear$plan, path))
  numbers <- Filter(function(one) is.list(one) && !one$whole && one$value != 0, numbers)
  list(gear = gear, numbers = numbers, findings = settled_findings(gear))
})

# Returns the result for a plan with fields changed by factors.
outcome <- function(one, factors) {
  fields <- Map(function(number, factor) {
    value <- number$value * factor
    text <- format(value, digits = 8, scientific = FALSE)
    if (nzchar(number$unit)) paste(text, number$unit) else value
  }, one$numbers[names(factors)], factors)
  tryCatch(
    {
      found <- settled_findings(do.call(update, c(list(one$gear), fields)))
      found <- setdiff(found, one$findings)
      if (length(found)) paste("finding:", found[1]) else "none"
    },
    codend_error_plan = function(e) "refused",
    codend_error_not_converged = function(e) "not converged"
  )
}

rows <- do.call(rbind, lapply(seq_len(count), function(k) {
  plan <- sample(plans, 1)
  one <- shipped[[plan]]
  path <- sample(names(one$numbers), 1)
  factor <- 10^(sample(c(-1, 1), 1) * runif(1, 1, 3))
  measured <- grep("meshes", names(one$numbers), value = TRUE, invert = TRUE)
  sane <- sample(measured, min(3, length(measured)))
  data.frame(plan = plan, field = path, factor = signif(factor, 3),
    absurd = outcome(one, setNames(factor, path)),
    sane = outcome(one, setNames(runif(length(sane), 0.98, 1.02), sane)))
}))
print(rows[rows$absurd == "none", c("plan", "field", "factor")], row.names = FALSE)
print(rows[rows$sane != "none", c("plan", "sane")], row.names = FALSE)
cat(sprintf("absurd plans: %d of %d detected (%.1f %%)\n", sum(rows$absurd != "none"), count,
  100 * mean(rows$absurd != "none")))
cat(sprintf("sane plans: %d of %d with a false finding or failure (%.1f %%)\n",
  sum(rows$sane != "none"), count, 100 * mean(rows$sane != "none")))
