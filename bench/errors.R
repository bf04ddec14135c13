# Entry point of `make errors`: checks the reported errors of measures against true errors.
#
# Gears: shipped gears, random gears at random speeds, shipped gears at another speed, and tows.
# Each is computed with several node counts and with a much finer mesh. The difference counts as the
# true error. It omits the error of the finest mesh itself. If errors are proportional to the
# element length, 12,000 nodes reveal two thirds of the error at 1,500.
#
# Named arguments: gears=20 (random gears), seed=1001 (of the first), nodes=300,500,1500,
# finest=12000, speeds=0.7 (factor on a shipped gear's speed), tows=1 (0: none). Writes to
# bench/results/: errors.csv (a row per measure) and errors.md.
library(codend)
for (script in c("sizes", "results", "random-gears")) {
  source(file.path("bench", paste0(script, ".R")))
}

asked <- given_numbers(list(gears = 20, seed = 1001, nodes = c(300, 500, 1500), finest = 12000,
  speeds = 0.7, tows = 1))
limit <- 60  # CPU seconds of one settle()
commit <- system2("git", c("rev-parse", "--short", "HEAD"), stdout = TRUE)

settled <- function(gear, nodes) {
  setTimeLimit(cpu = limit, transient = TRUE)
  on.exit(setTimeLimit())
  tryCatch(suppressWarnings(settle(gear, nodes)), error = function(e) NULL)
}

# Measures of a state or of all time steps of a tow: measure, value, unit, error, kind.
measured <- function(found) {
  table <- as.data.frame(found, what = "measures")
  of <- if (inherits(found, "codend_state")) found else state_at(found, found$time[1L])
  kinds <- attr(measures(of), "kind")
  table$kind <- unname(kinds[table$measure])
  if (!is.null(table$time_s)) {
    table$measure <- paste(table$measure, "at", table$time_s, "s")
    table$time_s <- NULL
  }
  cbind(nodes = found$mesh$nodes, table)
}

# Returns the rows of one gear, or NULL if the fine mesh fails to settle. `of` is a function(nodes)
# that returns a state, a tow or NULL. `finest` lists node counts; the first that settles is the
# reference.
compared <- function(name, class, of, nodes = asked$nodes, finest = asked$finest / c(1, 2)) {
  fine <- NULL
  for (most in finest) if (is.null(fine)) fine <- of(most)
  if (is.null(fine)) {
    cat(name, "did not settle\n")
    return(NULL)
  }
  fine <- measured(fine)
  rows <- do.call(rbind, lapply(nodes, function(one) {
    coarse <- of(one)
    if (is.null(coarse)) return(NULL)
    found <- measured(coarse)
    at <- match(found$measure, fine$measure)
    cbind(gear = name, class = class, asked = one, found, fine = fine$value[at],
      fine_nodes = fine$nodes[1L])
  }))
  # a gear that defines its own mesh has no finer one
  rows <- rows[rows$fine_nodes > 1.5 * rows$nodes, ]
  rows$true <- abs(rows$value - rows$fine)
  # a value that finer meshes do not change is exact, so it does not test the estimate
  rows$exact <- rows$true <= 1e-7 * pmax(abs(rows$value), abs(rows$fine))
  rows$within <- rows$true <= 2 * rows$error | rows$exact
  cat(name, sum(rows$within, na.rm = TRUE), "of", nrow(rows), "\n")
  rows
}

of_gear <- function(name, class, gear) compared(name, class, function(nodes) settled(gear, nodes))

# The gear at another speed of the tow or the current; NULL if it has neither.
at_speed <- function(gear, factor) {
  field <- intersect(c("towing.speed", "water.current.speed"), names(plan_leaves(gear$plan)))[1L]
  if (is.na(field)) return(NULL)
  change <- stats::setNames(list(scaled_value(plan_leaves(gear$plan)[[field]], factor)), field)
  do.call(update, c(list(gear), change))
}

# Tows of one or two minutes: a trawl that pays out its warps, a trawl that slows down, and gears
# that are shot. Time steps are the same on all meshes, so their own error is not measured here.
slowed <- data.frame(time = c(0, 40), value = c("3 knot", "2.5 knot"))
tows <- list(
  midwater_trawl = list(until = 180, every = 60),
  poly_noreastern_trawl = list(until = 80, every = 40,
    schedule = tow_schedule(speed = slowed)),
  purse_seine = list(until = 120, every = 60), demersal_seine = list(until = 120, every = 60)
)
of_tow <- function(name) {
  compared(paste("tow of", name), "tow", function(nodes) {
    tryCatch(suppressWarnings(do.call(tow, c(list(name), tows[[name]], nodes = nodes))),
      codend_error = function(e) NULL)
  }, nodes = c(300, 700), finest = c(2800, 1800))
}

shipped <- sub("[.]yaml$", "", list.files(system.file("gears", package = "codend"), "yaml$"))
rows <- lapply(shipped, function(name) of_gear(name, "shipped", read_gear(name)))
for (factor in asked$speeds) {
  rows <- c(rows, lapply(shipped, function(name) {
    gear <- at_speed(read_gear(name), factor)
    if (!is.null(gear)) of_gear(paste(name, "at", factor), "shipped, other speed", gear)
  }))
}
for (number in asked$seed - 1 + seq_len(asked$gears)) {
  gear <- random_gear(number)
  rows <- c(rows, list(of_gear(paste("drawn", number), paste("drawn", gear$plan$kind), gear)))
}
if (asked$tows > 0) rows <- c(rows, lapply(names(tows), of_tow))
rows <- do.call(rbind, rows)
kept <- rows[c("gear", "class", "asked", "nodes", "measure", "value", "error", "unit", "fine",
  "fine_nodes")]
kept[] <- lapply(kept, function(column) if (is.double(column)) signif(column, 5) else column)
save_table(kept, "errors")

summed <- function(rows) {
  moving <- which(!rows$exact & is.finite(rows$error))
  list(
    measures = nrow(rows), `without an error` = sum(is.na(rows$error) & is.finite(rows$value)),
    `within twice the estimate, %` = 100 * mean(rows$within, na.rm = TRUE),
    `estimate over truth, median` = stats::median((rows$error / rows$true)[moving]),
    `truth over 5 estimates` = sum((rows$true > 5 * rows$error)[moving]),
    `true error, median %` = stats::median((100 * rows$true / abs(rows$fine))[moving])
  )
}
by <- function(rows, of) {
  table <- bind_rows(lapply(split(rows, rows[[of]]), function(some) {
    c(stats::setNames(list(as.character(some[[of]][1L])), of), summed(some))
  }))
  # `data.frame()` would change the names
  names(table) <- c(of, names(summed(rows)))
  table
}
missed <- rows[which(rows$true > 5 * rows$error & !rows$exact), ]
settles <- rows[rows$class != "tow", ]
save_page(c(
  "# Whether the errors of measures hold", "",
  sprintf(
    paste("Written by `make errors` on commit %s: %d gears (those drawn from seed %d), with %s",
      "nodes against %s, and tows with 300 and 700 against 2800. %s"),
    commit, length(unique(settles$gear)), asked$seed, paste(asked$nodes, collapse = ", "),
    asked$finest, measured_with()), "",
  "All:", "", markdown_table(by(cbind(rows, all = "all"), "all")), "", "Settled, by nodes:", "",
  markdown_table(by(settles, "asked")), "", "By class of gear:", "",
  markdown_table(by(rows, "class")), "", "By gear:", "",
  markdown_table(by(rows, "gear")), "", "By kind of measure:", "",
  markdown_table(by(rows, "kind")), "", "Truths of more than five estimates:", "",
  markdown_table(missed[c("gear", "nodes", "measure", "value", "error", "fine")])
), "errors")
cat(readLines(file.path(results_folder, "errors.md")), sep = "\n")
