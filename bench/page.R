# Writes the page for readers, bench/results/results.md, from the tables.

label_of <- function(case) {
  vapply(case, function(name) known_cases[[name]]$label, "", USE.NAMES = FALSE)
}

write_page <- function(runs, ratios, medians, exponents, rivals) {
  save_page(c(
    "# What settling costs", "",
    paste("Written by `make bench`; [what is measured, against what and how](../README.md).",
      measured_with()), "",
    paste0("## Beside version ", last_release[["version"]]), "",
    "Both versions in turns, the same gear and water: `ratio` is CPU seconds per node over the",
    "release's, the median of neighbouring gears with the least and the most; `per knot` and",
    "`a factorisation` are the same per knot of bars and per factorisation. Of two figures the",
    "first is the release's.", "",
    markdown_table(ratio_table(ratios)), "",
    "## This tree", "",
    "Medians over the neighbours that settled; `settle` is CPU seconds of the whole call.", "",
    markdown_table(size_table(medians[medians$case %in% names(refined), ])), "",
    "Its parts over all levels, CPU seconds (`coarse`: everything before the finest level), and",
    "what comes before and after it:", "",
    markdown_table(part_table(medians[medians$case %in% names(refined), ])), "",
    "![CPU seconds against nodes](cost.svg)", "",
    "Exponents, from the fewest to the most nodes of each row:", "",
    markdown_table(exponent_table(exponents)), "",
    failure_lines(runs),
    "## Public cases", "",
    markdown_table(public_table(medians)), "",
    "The other programs' figures are in [published-figures.csv](../published-figures.csv), with",
    "what each stands for. No row but codend's was measured in this run.", "",
    rival_lines(rivals)
  ), "results")
}

ratio_table <- function(ratios) {
  pair <- function(name) {
    paste(plain_numbers(signif(ratios[[paste0(name, "_release")]], 3)),
      plain_numbers(signif(ratios[[name]], 3)), sep = " / ")
  }
  data.frame(
    gear = label_of(ratios$case), nodes = pair("nodes"), ratio = round(ratios$ratio, 2),
    `least, most` = sprintf("%.2f, %.2f", ratios$least, ratios$most),
    `per knot` = round(ratios$knot, 2), `a factorisation` = round(ratios$each, 2),
    `CPU s` = pair("settle"),
    `steps on the finest` = pair("steps"), factorisations = pair("factorisations"),
    check.names = FALSE
  )
}

size_table <- function(medians) {
  data.frame(
    gear = label_of(medians$case), nodes = medians$nodes,
    settled = sprintf("%d of %d", medians$settled, medians$runs), settle = medians$settle,
    from = medians$settle_least, to = medians$settle_most, levels = medians$levels,
    `steps on the finest` = medians$iterations, factorisations = medians$factorisations,
    residual = medians$residual,
    `memory, MB` = medians$rise, `peak, MB` = medians$peak, check.names = FALSE
  )[medians$settled > 0, ]
}

part_table <- function(medians) {
  data.frame(
    gear = label_of(medians$case), nodes = medians$nodes,
    medians[c("mesh", "analysis", "forces", "jacobian", "linear", "rest", "coarse")],
    `reading the plan` = medians$read, summary = medians$summary, picture = medians$picture,
    `first call` = medians$first, check.names = FALSE
  )[medians$settled > 0, ]
}

exponent_table <- function(exponents) {
  columns <- c(cost_columns, "iterations")
  data.frame(
    gear = label_of(exponents$case), from = exponents$from, to = exponents$to,
    lapply(exponents[columns], round, digits = 2), memory = round(exponents$rise, 2)
  )
}

failure_lines <- function(runs) {
  failed <- runs[runs$outcome != "settled", ]
  if (!nrow(failed)) return(NULL)
  c("Runs that did not settle:", "", sprintf(
    "- %s, %s, %s nodes, neighbour %d: %s", failed$version, label_of(failed$case),
    ifelse(failed$asked > 0, plain_numbers(failed$asked), "the plan's"), failed$neighbour,
    failed$outcome
  ), "")
}

public_table <- function(medians) {
  own <- medians[medians$case %in% names(public), ]
  error <- if (is.null(own$error)) NA_real_ else own$error
  others <- utils::read.csv(file.path("bench", "published-figures.csv"))
  table <- rbind(
    data.frame(case = own$case, program = "codend", settings = "settle()", seconds = own$settle,
      error = error),
    data.frame(case = others$case, program = paste(others$program, others$version),
      settings = others$settings, seconds = others$seconds, error = others$error)
  )
  table <- table[order(match(table$case, names(public))), ]
  data.frame(
    case = label_of(table$case), program = table$program, settings = table$settings,
    `until steady, s` = table$seconds,
    `times codend` = table$seconds / own$settle[match(table$case, own$case)],
    `error of the end, m` = table$error, check.names = FALSE
  )
}
