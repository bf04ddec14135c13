# Runs the cases at every size next to the last release and fits growth exponents to the medians.

# Requested node counts; CPU limit of one settle() (s), about twenty times the expected cost; number
# of neighbours per size.
sizes <- data.frame(
  nodes = c(1500, 1e4, 1e5, 1e6), limit = c(20, 60, 600, 3600), runs = c(5, 5, 2, 1)
)

# Exponents are fitted over these sizes, both included.
fitted_nodes <- c(1000, 150000)

cost_columns <- c("settle", "mesh", "analysis", "forces", "jacobian", "linear", "rest", "coarse")

# Runs one case in every version, neighbour after neighbour. Returns a data frame: a row per run. A
# failed run with a limit of a minute or more ends the case, so that a broken version still
# finishes.
run_case <- function(name, nodes, limit, count = length(neighbours)) {
  rows <- list()
  case <- known_cases[[name]]
  ended <- NULL
  for (neighbour in seq_len(count)) for (version in setdiff(names(case$netting), ended)) {
    asked <- format(nodes, scientific = FALSE)
    found <- in_own_process("measure-settle.R", version, name, asked, neighbour, limit)
    rows <- c(rows, list(c(
      list(case = name, version = version, asked = nodes, neighbour = neighbour),
      found[!vapply(found, is.null, NA)]
    )))
    cat(sprintf(
      "%-30s %-7s %8s nodes, %d: %s, %s CPU s\n", case$label, version,
      if (nodes > 0) format(nodes, big.mark = ",", scientific = FALSE) else "plan's", neighbour,
      substr(found$outcome, 1, 60), format(signif(c(found$settle, NA)[1], 3))
    ))
    if (found$outcome != "settled" && limit > 60) ended <- c(ended, version)
  }
  bind_rows(rows)
}

# Runs the public cases and the refined ones up to `most` nodes, in the order of sizes. Returns a
# row per run. A case that fails at one size is skipped at the next. keep: called with the rows so
# far after each case, since the last cases take hours.
run_all <- function(most, keep) {
  rows <- NULL
  add <- function(found) {
    rows <<- c(rows, split(found, seq_len(nrow(found))))
    keep(bind_rows(rows))
    any(found$outcome == "settled" & found$version == "now")
  }
  for (name in names(public)) add(run_case(name, 0, 60))
  works <- names(refined)
  for (k in which(sizes$nodes <= most)) {
    works <- Filter(function(name) {
      add(run_case(name, sizes$nodes[k], sizes$limit[k], sizes$runs[k]))
    }, works)
  }
  bind_rows(rows)
}

# Stops if the node count differs from the requested size by more than 20 %.
check_sizes <- function(runs) {
  off <- runs[runs$version == "now" & runs$asked > 0 & !is.na(runs$nodes) &
    abs(runs$nodes / runs$asked - 1) > 0.2, ]
  if (nrow(off)) {
    stop("node counts differ from the requested sizes: ", paste(sprintf("%s %s for %s", off$case,
      plain_numbers(off$nodes), plain_numbers(off$asked)), collapse = ", "))
  }
}

# Compares this tree with the last release: a row per case and size. The ratio of CPU seconds per
# node has its median, minimum and maximum over the neighbours that both versions settled.
compare_versions <- function(runs) {
  key <- paste(runs$case, runs$asked, runs$neighbour)
  settled <- runs$outcome == "settled"
  now <- runs[settled & runs$version == "now", ]
  release <- runs[settled & runs$version == "release", ]
  release <- release[match(key[settled & runs$version == "now"],
    key[settled & runs$version == "release"]), ]
  now$ratio <- (now$settle / now$nodes) / (release$settle / release$nodes)
  now$knot <- (now$settle / now$knots) / (release$settle / release$knots)
  now$each <- (now$settle / now$factorisations) / (release$settle / release$factorisations)
  both <- now[!is.na(now$ratio), ]
  groups <- split(seq_len(nrow(both)), list(factor(both$case, unique(both$case)), both$asked),
    drop = TRUE)
  was <- release[!is.na(now$ratio), ]
  bind_rows(lapply(groups, function(at) {
    middle <- function(x) stats::median(x[at])
    list(
      case = both$case[at[1]], asked = both$asked[at[1]], ratio = middle(both$ratio),
      least = min(both$ratio[at]), most = max(both$ratio[at]),
      knot = middle(both$knot), each = middle(both$each),
      nodes_release = middle(was$nodes), nodes = middle(both$nodes),
      settle_release = middle(was$settle), settle = middle(both$settle),
      steps_release = middle(was$iterations), steps = middle(both$iterations),
      factorisations_release = middle(was$factorisations),
      factorisations = middle(both$factorisations)
    )
  }))
}

# Returns a row per case and size of this tree: number of settled runs, and their medians.
summarise_runs <- function(runs) {
  runs <- runs[runs$version == "now", ]
  groups <- split(runs, list(factor(runs$case, unique(runs$case)), runs$asked), drop = TRUE)
  rows <- lapply(groups, function(group) {
    settled <- group[group$outcome == "settled", ]
    numbers <- setdiff(names(group)[vapply(group, is.numeric, NA)], c("asked", "neighbour"))
    c(
      list(case = group$case[1], asked = group$asked[1], runs = nrow(group),
        settled = nrow(settled)),
      lapply(settled[numbers], stats::median),
      list(settle_least = least(settled$settle), settle_most = -least(-settled$settle))
    )
  })
  found <- bind_rows(rows)
  found[order(match(found$case, names(known_cases)), found$asked), ]
}

least <- function(x) if (length(x)) min(x) else NA_real_

# Exponents of medians against nodes, a row per case; NA if fewer than two sizes settled.
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
