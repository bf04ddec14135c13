# Returns a text such as "Towed at 4.5 knot in water of 1025 kg/m3, current 0.5 m/s". plan: gives
# the units of speeds.
conditions_text <- function(si, plan = NULL) {
  short <- function(x) with_plain_numbers(format(signif(x, 4)))
  water <- if (si$water$density == 0) {
    "without water"
  } else {
    paste("in water of", short(si$water$density), "kg/m3")
  }
  motion <- if (si$towing$speed > 0) {
    paste("Towed at", quantity_text(si$towing$speed, "speed", plan$towing$speed))
  } else {
    "Held"
  }
  current <- max(current_speeds(si))
  layers <- if (nrow(si$water$current) > 1) "up to " else ""
  given <- unlist(plan$water$current)
  given <- given[grepl("speed$", names(given))]
  paste0(motion, " ", water, if (current > 0) {
    paste0(", current ", layers, quantity_text(current, "speed", first_of(given, 0)[[1L]]))
  })
}

size_text <- function(state) {
  e <- state$mesh$model
  sprintf("%d nodes, %d bars, %d netting cells", e$nodes, length(e$bars$rest),
    length(e$cells$rest))
}

# Returns the estimated error of the main measures with advice if it is large, NULL if it is
# unknown. report: from a summary.
accuracy_line <- function(measures, report) {
  error <- main_error(measures)
  if (!is.finite(error)) return(NULL)
  aimed <- report$accuracy_aimed_at
  advice <- accuracy_advice(error, report$nodes)
  said <- paste0(
    "Discretisation error of drag, spreads, heights, areas and volumes about ",
    percent_text(error), if (!is.null(aimed)) sprintf(" (target %s)", percent_text(aimed)),
    if (!is.null(advice)) paste0("; ", advice), few_nodes_text(measures, report$nodes)
  )
  strwrap(said, width = 98, indent = 2, exdent = 4)
}

# Number of nodes of a gear with netting below which estimated errors may be far too small. With 300
# and 500 nodes, 95 of 5,530 estimates were more than five times too small. With 1,500 nodes it was
# 1 of 2,783 (bench/results/errors.md).
sure_nodes <- 1000

few_nodes_text <- function(measures, nodes) {
  if (nodes >= sure_nodes || !"slack_netting_percent" %in% names(measures)) return("")
  paste0(". With so few nodes, 1 of 60 error estimates is over five times too small: use ",
    "settle(nodes = 1500)")
}

within_text <- function(measures, aimed = NULL) {
  error <- main_error(measures)
  if (!is.finite(error)) return(NULL)
  reached <- percent_text(error)
  if (is.null(aimed)) return(sprintf("; main measures within about %s", reached))
  sprintf("; main measures: target %s, reached %s", percent_text(aimed), reached)
}

# Returns advice with the node count that reaches the usual accuracy, NULL if the state reaches it.
accuracy_advice <- function(error, nodes) {
  if (!is.finite(error) || error <= usual_accuracy) return(NULL)
  aim <- percent_text(usual_accuracy)
  wanted <- nodes_for(nodes, error, usual_accuracy)
  enough <- if (wanted <= most_accurate_nodes) {
    number <- format(signif(wanted, 1), big.mark = ",", decimal.mark = ".", scientific = FALSE)
    paste("about", number, "nodes")
  } else {
    "more nodes than the limit"
  }
  sprintf("for %s: settle(accuracy = \"%s\"), %s", aim, aim, enough)
}

#' @export
print.codend_state <- function(x, ...) {
  found <- measures(x)
  advice <- accuracy_advice(main_error(found), x$mesh$nodes)
  with_plain_numbers(cat(
    if (is.null(x$time)) {
      paste0("Settled gear \"", x$si$name, "\"")
    } else {
      sprintf("Gear \"%s\" at %s s of a tow", x$si$name, format(signif(x$time, 6)))
    },
    paste0("  ", conditions_text(x$si, x$gear$plan)),
    paste0("  ", size_text(x), within_text(found, x$report$accuracy_aimed_at)),
    measure_lines(found[printed_measures(found)]),
    paste0("  More: measures(), summary(), as.data.frame(), plot(), view_3d()"),
    if (!is.null(advice)) paste0("  ", capital(advice)),
    sep = "\n"
  ))
  invisible(x)
}
