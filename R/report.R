#' Write a report
#'
#' Writes one HTML page about a state or a tow, for a skipper or an appendix. The page needs no
#' network, and the browser prints it to paper or PDF.
#'
#' @section Contents:
#' The report of a state has
#'
#' - the plan drawing ([plot.codend_gear()]), the conditions, the measures and warnings
#'   ([findings()]);
#' - the gear from above, from the side and from astern, and in three dimensions;
#' - tensions of ropes with the margin to the breaking load, drag by component, and slack netting;
#' - the force balance and the convergence of the solver;
#' - the versions of the programs, and the exact plan to copy.
#'
#' The report of a trajectory has measures against time and the motion in three dimensions instead
#' of shapes and forces.
#'
#' @section Format:
#' - Numbers have four digits. Forces are also in tonnes-force (9.80665 kN).
#' - The plan drawing is printed on a separate landscape page.
#' - The same state gives the same file in every new session.
#'
#' @param state A state from [settle()], or a trajectory from [tow()].
#' @param file The HTML file to write. It is written atomically.
#' @param sensitivities `NULL` (default), or the result of [sensitivities()] for the state,
#'   for a table after the measures.
#' @param uncertainty `NULL` (default), or the uncertainty of the measures from [uncertainty()], for
#'   a table after the measures.
#' @return `file`, invisibly. See [codend-conditions] for errors.
#' @seealso [view_3d()] for the three-dimensional view alone, [summary()][summary.codend_state] for
#'   the numbers, [share()] for a page with sliders.
#' @examples
#' file <- tempfile(fileext = ".html")
#' report(settle("beam_trawl", nodes = 300), file)
#' @export
report <- function(state, file, sensitivities = NULL, uncertainty = NULL) {
  check_given("state", "file")
  moves <- inherits(state, "codend_trajectory")
  if (!moves) check_is_state(state)
  check_file_path(file, ".html")
  if (!is.null(sensitivities) && (moves || !inherits(sensitivities, "codend_sensitivities"))) {
    abort_argument("{.arg sensitivities} must be a result of {.fn sensitivities} for a state.")
  }
  if (!is.null(uncertainty) && moves) {
    abort_argument("{.arg uncertainty} needs a settled state, not a tow.")
  }
  check_is_uncertainty(uncertainty)
  body <- with_plain_numbers(if (moves) trajectory_report(state) else {
    state_report(state, sensitivities, uncertainty)
  })
  write_file(file, function(path) {
    write_single_page(path, paste("Report:", state$gear$plan$name), body,
      style = view_file("report.css"), script = view_file("report.js"))
  })
  invisible(file)
}

tag <- htmltools::tags

state_report <- function(state, sensitivities = NULL, uncertainty = NULL) {
  said <- summary(state)
  tag$main(
    report_header(state, paste0(said$conditions, ".")),
    if (!state$report$converged) {
      tag$p(class = "warning", "The solver did not settle this gear: the numbers belong to the last
        iteration and are not an equilibrium.")
    },
    report_section("Measures", report_table(measures_columns(said$measures),
      paste("Measures of the gear; forces also in tonnes-force. 'Computed to' is only the",
        "discretisation error.")), measure_terms(said$measures)),
    uncertainty_section(uncertainty),
    sensitivity_section(sensitivities),
    finding_section(said$findings),
    conditions_section(state),
    plan_section(state$gear),
    shape_section(state),
    tension_section(said),
    drag_section(said),
    board_section(said$boards),
    balance_section(said),
    version_section(),
    exact_plan_section(state$gear)
  )
}

trajectory_report <- function(trajectory) {
  start <- state_at(trajectory, trajectory$time[1L])
  last <- max(trajectory$time)
  words <- sprintf("Towed for %s, %d states saved%s.", time_text(last, last),
    length(trajectory$time),
    if (trajectory$end == "interrupted") "; interrupted by the user" else "")
  tag$main(
    report_header(trajectory, words),
    report_section("Measures against time",
      report_figure(picture_address(trajectory), paste(
        "Curves of the schedule and all measures against time. The table below gives the first and",
        "last values and the extremes."
      )),
      report_table(trajectory_columns(summary(trajectory)), paste(
        "Measures at the start and the end of the tow, and the extremes with their times."
      ))
    ),
    report_section("The gear in motion", report_scene(trajectory, paste(
      "The gear in three dimensions, as seen from the vessel; a button plays the tow and a slider",
      "steps through it."
    ))),
    finding_section(findings(trajectory)),
    conditions_section(start),
    plan_section(trajectory$gear),
    version_section(),
    exact_plan_section(trajectory$gear)
  )
}

# ---- parts of the page ---------------------------------------------------------------------------

report_header <- function(of, words) {
  notes <- unlist(of$gear$plan$notes)
  tag$header(
    tag$h1(of$gear$plan$name), tag$p(class = "conditions", words),
    lapply(notes, function(note) tag$p(class = "note", note))
  )
}

# Returns the definitions of the measures in a report, which the reader can open.
measure_terms <- function(measures) {
  kind <- attr(measures, "kind")
  first <- !duplicated(kind)
  kinds <- all_kinds()[kind]
  text <- measure_strings(kinds)
  sensor <- measure_strings(kinds, "sensor")
  terms <- lapply(which(first), function(k) {
    list(
      tag$dt(gsub("_", " ", kind[[k]])), tag$dd(text[k]),
      if (!is.na(sensor[k])) tag$dd(paste("Sensor:", sensor[k]))
    )
  })
  tag$details(tag$summary("Definitions of these measures"), tag$dl(terms),
    tag$p("In pictures: ", tag$code("vignette(\"measures\", \"codend\")"), "."))
}

report_section <- function(title, ..., class = NULL) {
  id <- gsub("[^a-z]+", "-", tolower(title))
  tag$section(class = class, `aria-labelledby` = id, tag$h2(id = id, title), ...)
}

# columns: a named list of strings. A name that begins with a space marks text, any other numbers.
report_table <- function(columns, caption) {
  if (!length(columns[[1L]])) return(NULL)
  caption <- gsub("\\s+", " ", caption)
  heads <- names(columns)
  words <- startsWith(heads, " ")
  heads <- trimws(heads)
  rows <- lapply(seq_along(columns[[1L]]), function(k) {
    cells <- lapply(seq_along(columns), function(c) {
      text <- trimws(columns[[c]][k])
      class <- if (!words[c]) "number"
      if (c == 1L) tag$th(scope = "row", class = class, text) else tag$td(class = class, text)
    })
    do.call(tag$tr, cells)
  })
  head <- lapply(seq_along(heads), function(c) {
    tag$th(scope = "col", class = if (!words[c]) "number", heads[c])
  })
  # a wide table scrolls sideways, also by keyboard
  tag$div(class = "table", tabindex = "0", role = "region", `aria-label` = caption,
    tag$table(tag$caption(caption), tag$thead(do.call(tag$tr, head)), do.call(tag$tbody, rows)))
}

# address: URL of a picture; words: its description.
report_figure <- function(address, words) {
  tag$figure(tag$div(class = "picture", tag$img(src = address, alt = words)))
}

# of: a state or a trajectory.
report_scene <- function(of, words) {
  widget <- viewer_widget(viewed_scene(of), "gear", title = FALSE)
  widget$width <- "100%"
  widget$height <- "100%"
  tag$figure(
    class = "scene", tag$div(class = "canvas", htmltools::as.tags(widget)),
    tag$figcaption(paste(words,
      "Turn it with the left mouse button or one finger; click it first to zoom with the wheel."
    ))
  )
}

# For a tow, `found` has the findings at its start.
finding_section <- function(found) {
  if (!nrow(found)) return(NULL)
  columns <- list(` where` = found$location, ` what` = found$message, ` to try` = found$advice)
  report_section("Warnings",
    report_table(columns, "Properties outside usual or tested ranges, and possible changes."))
}

sensitivity_section <- function(sensitivities) {
  if (is.null(sensitivities)) return(NULL)
  report_section("Sensitivities", report_table(sensitivity_columns(sensitivities), "Linear
    estimate of the change of each measure if a field increases by 10 % (counts: by 10). Values in
    brackets are not smooth: netting goes slack or ropes touch the sea bed."))
}

uncertainty_section <- function(uncertainty) {
  if (is.null(uncertainty)) return(NULL)
  report_section("Uncertainty of the results",
    report_table(uncertainty_columns(uncertainty), sprintf("The interval contains the true value
      with a probability of %g %%. The standard uncertainty is one standard deviation.",
      100 * uncertainty$level)),
    report_table(budget_columns(uncertainty), "Sources of the uncertainty in percent of the
      variance: force coefficients, numbers of the plan, conditions, discretisation, and other
      errors of the model."))
}

plan_section <- function(gear) {
  report_section("Plan of the gear", class = "plan", report_figure(
    picture_address(gear),
    paste(
      "Plan drawing: flat netting with meshes, mesh size, twine and cutting rates, the rigging,",
      "and lists of ropes and pieces. The exact plan below has the same data as text."
    )
  ))
}

shape_section <- function(state) {
  report_section("Shape",
    report_figure(picture_address(state), paste(
      "The gear from above, from the port side and from astern, to scale, coloured by tension.",
      "The measures include the main dimensions."
    )),
    report_scene(state, "The gear in three dimensions, coloured by tension.")
  )
}

# Returns the plot of a gear, a state or a trajectory as a data URL.
picture_address <- function(x) {
  file <- tempfile(fileext = ".png")
  on.exit(unlink(file))
  plot(x, file = file)
  paste0("data:image/png;base64,",
    gsub("[\r\n]", "", jsonlite::base64_enc(readBin(file, "raw", file.size(file)))))
}

tension_section <- function(said) {
  ropes <- said$tensions[said$tensions$kind == "rope", ]
  netting <- said$tensions[said$tensions$kind == "netting", ]
  if (!nrow(said$tensions)) return(NULL)
  report_section("Tensions",
    if (nrow(ropes)) report_table(rope_columns(ropes), "Ropes by tension: largest
      tension (also in tonnes-force), mean tension, breaking load of the
      material or plan, and breaking load over largest tension."),
    if (nrow(netting)) report_table(netting_columns(netting, said$slack), "Netting by part: mean
      tension of one twine (of both twines if double), its mean over the most loaded tenth of the
      length, and the percentage of slack twine.")
  )
}

drag_section <- function(said) {
  tangential <- said$tangential
  report_section("Drag",
    report_table(drag_columns(said$drag_totals, said$drag_totals$group), paste(
      "Forces by group: drag along the flow with its percentage of the total drag, side force to",
      "starboard, lift upwards, and weight in water. The sea bed adds friction and support."
    )),
    report_table(drag_part_columns(said$drag, said$drag_totals, reported_parts),
      "The parts with the largest drag."),
    if (!is.null(tangential)) tag$p(sprintf(
      "With all tangential coefficients halved, the total drag at this shape would be %s kN; with
      all doubled, %s kN. These coefficients are the least certain.",
      figures(tangential$halved), figures(tangential$doubled)
    ))
  )
}

board_section <- function(boards) {
  if (!nrow(boards)) return(NULL)
  report_section("Otter boards and kites", report_table(board_columns(boards), paste(
    "Free otter boards and kites: angle of attack, angle of largest lift, heel (positive outward;",
    "for kites: positive if the starboard end is high) and trim."
  )))
}

balance_section <- function(said) {
  report <- said$report
  report_section("Solution and force balance",
    tag$p(sprintf(
      "%s nodes, %s bars and %s netting cells. %s in %d iterations; the largest residual force on a
      node is %s of the largest tension.",
      big_number(report$nodes), big_number(report$bars), big_number(report$cells),
      if (report$converged) "Settled" else "Not settled", report$iterations,
      format(report$residual, digits = 2)
    )),
    report_table(balance_columns(said$balance), "Sums of all forces on the gear; the remainder is
      the residual of the solver."),
    report_table(axis_columns(said$reactions, "point", " support"),
      "Force of every support on the gear.")
  )
}

version_section <- function() {
  version <- function(package) paste(package, utils::packageVersion(package))
  report_section("Versions", tag$p(paste0(paste(c(
    version("codend"), paste("R", getRversion()), version("htmlwidgets")
  ), collapse = ", "), ".")))
}

exact_plan_section <- function(gear) {
  report_section("Exact plan", class = "exact",
    tag$p("All results above follow from this plan. Save it as a .yaml file to use it with
      read_gear() or codend settle."),
    tag$button(type = "button", class = "copy", `data-copies` = "plan-text", "Copy the plan"),
    tag$span(class = "copied", role = "status", `aria-live` = "polite"),
    tag$pre(id = "plan-text", tabindex = "0", `aria-label` = "The plan as YAML", format(gear))
  )
}
