# The refined cases at every size from five crude starts, and what their medians grow as.

# Nodes asked for, and the CPU seconds (of one settle()) after which a run counts as failed: some
# twenty times what each size should take.
sizes <- data.frame(nodes = c(1500, 1e4, 1e5, 1e6), limit = c(20, 60, 600, 3600))

# Fitted over these sizes, both included.
fitted_nodes <- c(1000, 150000)

cost_columns <- c("settle", "lattice", "analysis", "forces", "jacobian", "linear", "rest", "coarse")

# Runs one case from every start: a data frame, a row per run. A start that fails at a size of a
# minute and more ends its row of starts, so that a bench of what does not work yet ends.
run_case <- function(name, nodes, limit) {
  rows <- list()
  for (start in starts) {
    asked <- format(nodes, scientific = FALSE)
    found <- in_own_process("measure-settle.R", name, asked, start, limit)
    rows[[start]] <- c(
      list(case = name, asked = nodes, start = start), found[!vapply(found, is.null, NA)]
    )
    cat(sprintf(
      "%-28s %8s nodes, start %d: %s, %s CPU s\n", known_cases[[name]]$label,
      if (nodes > 0) format(nodes, big.mark = ",", scientific = FALSE) else "plan's", start,
      substr(found$outcome, 1, 60), format(signif(c(found$settle, NA)[1], 3))
    ))
    if (found$outcome != "settled" && limit > 60) break
  }
  bind_rows(rows)
}

# The public cases and the refined ones up to `most` nodes, a row per run, in the order of sizes. A
# case none of whose starts settled at one size is not tried at the next. keep: called with the rows
# so far after each case, since the last ones take hours.
run_all <- function(most, keep) {
  rows <- NULL
  add <- function(found) {
    rows <<- c(rows, split(found, seq_len(nrow(found))))
    keep(bind_rows(rows))
    any(found$outcome == "settled")
  }
  for (name in names(public)) add(run_case(name, 0, 60))
  works <- names(refined)
  for (k in which(sizes$nodes <= most)) {
    works <- Filter(function(name) add(run_case(name, sizes$nodes[k], sizes$limit[k])), works)
  }
  bind_rows(rows)
}

# A row per case and size: how many of the runs settled, and medians over those.
summarise_runs <- function(runs) {
  groups <- split(runs, list(factor(runs$case, unique(runs$case)), runs$asked), drop = TRUE)
  rows <- lapply(groups, function(group) {
    settled <- group[group$outcome == "settled", ]
    numbers <- setdiff(names(group)[vapply(group, is.numeric, NA)], c("asked", "start"))
    c(
      list(case = group$case[1], asked = group$asked[1], starts = nrow(group),
        settled = nrow(settled)),
      lapply(settled[numbers], stats::median),
      list(settle_least = least(settled$settle), settle_most = -least(-settled$settle))
    )
  })
  found <- bind_rows(rows)
  found[order(match(found$case, names(known_cases)), found$asked), ]
}

least <- function(x) if (length(x)) min(x) else NA_real_

# Exponents of medians against nodes, a row per case; NA where fewer than two sizes settled.
fit_exponents <- function(medians) {
  cases <- intersect(names(refined), medians$case)
  rows <- lapply(cases, function(case) {
    of <- medians[medians$case == case & medians$settled > 0 &
      medians$asked >= fitted_nodes[1] & medians$asked <= fitted_nodes[2], ]
    slope <- function(column) {
      use <- which(of[[column]] > 0)
      if (length(use) < 2L) return(NA_real_)
      stats::coef(stats::lm(log(of[[column]][use]) ~ log(of$nodes[use])))[[2]]
    }
    columns <- stats::setNames(nm = c(cost_columns, "iterations", "rise"))
    c(
      list(case = case, from = least(of$nodes), to = -least(-of$nodes)), lapply(columns, slope)
    )
  })
  bind_rows(rows)
}
