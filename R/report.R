# A state or a trajectory as one page to read, print and pass on.

#' Write a report
#'
#' One HTML page for a skipper or an appendix: the plan of the gear drawn flat
#' ([plot.codend_gear()]), the conditions, the measures, warnings ([findings()]), the
#' gear from above, from the side and from astern and in three dimensions, the tensions by rope with
#' what is left to the breaking load, the drag by component, slack netting, how well the forces
#' balance and how the solver ended, the versions of the programs, and the exact plan to copy. That
#' of a trajectory has the measures against time and the motion in three dimensions in place of the
#' shapes and forces.
#'
#' The file holds all that it needs and uses no network. It prints to paper or PDF from
#' the browser, the plan drawing on a page of its own on its side. The same state gives the same
#' file in every new session. Numbers are rounded to four figures; forces are also given in
#' tonnes-force (9.80665 kN).
#'
#' @param state A state, from [settle()], or a trajectory, from [tow()].
#' @param file The HTML file to write. It is written whole or not at all.
#' @param slopes What more of each field would do: sensitivities of the state's measures, from
#'   [sensitivities()], as a table next to the measures; `NULL` for none.
#' @param uncertainty How far the measures may be from the truth, from [uncertainty()], as a table
#'   after the measures; `NULL` for none.
#' @return `file`, invisibly. See [codend-conditions] for errors.
#' @seealso [view_3d()] for the three dimensions alone, [summary()][summary.codend_state] for the
#'   numbers.
#' @examples
#' file <- tempfile(fileext = ".html")
#' report(settle("towed_cable"), file)
#' @export
report <- function(state, file, slopes = NULL, uncertainty = NULL) {
  check_given("state", "file")
  moves <- inherits(state, "codend_trajectory")
  if (!moves) check_is_state(state)
  check_file_path(file, ".html")
  if (!is.null(slopes) && (moves || !inherits(slopes, "codend_sensitivities"))) {
    abort_argument("{.arg slopes} must be what {.fn sensitivities} returns, of a settled state.")
  }
  if (!is.null(uncertainty) && moves) {
    abort_argument("{.arg uncertainty} is of a settled state, not of a tow.")
  }
  check_is_uncertainty(uncertainty)
  body <- with_plain_numbers(if (moves) trajectory_report(state) else {
    state_report(state, slopes, uncertainty)
  })
  write_file(file, function(path) {
    write_single_page(path, paste("Report:", state$gear$plan$name), body,
      style = view_file("report.css"), script = view_file("report.js"))
  })
  invisible(file)
}

tag <- htmltools::tags

state_report <- function(state, slopes = NULL, uncertainty = NULL) {
  said <- summary(state)
  tag$main(
    report_header(state, paste0(said$conditions, ".")),
    if (!state$report$converged) {
      tag$p(class = "warning", "The solver did not settle this gear: the numbers are those of its
        last step, not of an equilibrium.")
    },
    report_section("Measures", report_table(measures_columns(said$measures),
      paste("What was measured; forces also in tonnes-force. Computed to: the computer's own error",
        "(discretisation) alone.")), measure_terms(said$measures)),
    uncertainty_section(uncertainty),
    slope_section(slopes),
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
  words <- sprintf("Towed for %s, %d states kept%s.", time_words(last, last),
    length(trajectory$time),
    if (trajectory$end == "interrupted") "; interrupted by the user" else "")
  tag$main(
    report_header(trajectory, words),
    report_section("Measures against time",
      report_figure(picture_address(trajectory), paste(
        "Curves of the schedule and of every measure of the gear against time; the table below",
        "gives their ends and extremes."
      )),
      report_table(trajectory_columns(summary(trajectory)), paste(
        "Measures at the start and the end of the tow, and their extremes with the times of these."
      ))
    ),
    report_section("The gear in motion", report_scene(trajectory, paste(
      "The gear in three dimensions, as seen from the vessel; a button plays the tow and a slider",
      "steps through it."
    ))),
    finding_section(findings(start)),
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

# What the kinds of measures in a report are, to open and read.
measure_terms <- function(measures) {
  kind <- attr(measures, "kind")
  first <- !duplicated(kind)
  kinds <- all_kinds()[kind]
  text <- measure_texts(kinds)
  sensor <- measure_texts(kinds, "sensor")
  terms <- lapply(which(first), function(k) {
    list(
      tag$dt(gsub("_", " ", kind[[k]])), tag$dd(text[k]),
      if (!is.na(sensor[k])) tag$dd(paste("Sensor:", sensor[k]))
    )
  })
  tag$details(tag$summary("What these measures are"), tag$dl(terms),
    tag$p("In pictures: ", tag$code("vignette(\"measures\", \"codend\")"), "."))
}

report_section <- function(title, ..., class = NULL) {
  id <- gsub("[^a-z]+", "-", tolower(title))
  tag$section(class = class, `aria-labelledby` = id, tag$h2(id = id, title), ...)
}

# columns: a named list of texts; those whose names begin with a space hold words, the others
# numbers.
report_table <- function(columns, caption) {
  if (!length(columns[[1L]])) return(NULL)
  caption <- gsub("\\s+", " ", caption)
  heads <- names(columns)
  words <- startsWith(heads, " ")
  heads <- trimws(heads)
  rows <- lapply(seq_along(columns[[1L]]), function(k) {
    cells <- lapply(seq_along(columns), function(c) {
      text <- columns[[c]][k]
      class <- if (!words[c]) "number"
      if (c == 1L) tag$th(scope = "row", class = class, text) else tag$td(class = class, text)
    })
    do.call(tag$tr, cells)
  })
  head <- lapply(seq_along(heads), function(c) {
    tag$th(scope = "col", class = if (!words[c]) "number", heads[c])
  })
  # A wide table scrolls sideways, also by keyboard.
  tag$div(class = "table", tabindex = "0", role = "region", `aria-label` = caption,
    tag$table(tag$caption(caption), tag$thead(do.call(tag$tr, head)), do.call(tag$tbody, rows)))
}

# A picture (its address) with what it shows in words.
report_figure <- function(address, words) {
  tag$figure(tag$div(class = "picture", tag$img(src = address, alt = words)))
}

# The gear in three dimensions; of: a state or a trajectory.
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

# Of a tow, what is worth a look at its start.
finding_section <- function(found) {
  if (!nrow(found)) return(NULL)
  columns <- list(` where` = found$place, ` what` = found$words, ` to try` = found$advice)
  report_section("Warnings",
    report_table(columns, "What lies outside what practice and tests know, and what to try."))
}

slope_section <- function(slopes) {
  if (is.null(slopes)) return(NULL)
  report_section("What more would do", report_table(slope_columns(slopes), "Changes of measures by
    10 % more of a field, or ten more of what is counted, as far as the sensitivity at this state
    holds. In brackets where it is not smooth: netting goes slack, ropes touch the sea bed."))
}

uncertainty_section <- function(uncertainty) {
  if (is.null(uncertainty)) return(NULL)
  report_section("How sure these numbers are",
    report_table(uncertainty_columns(uncertainty), sprintf("The truth lies in the interval with a
      probability of %g %%. The standard uncertainty is one standard deviation.",
      100 * uncertainty$level)),
    report_table(budget_columns(uncertainty), "Where the uncertainty comes from, in percent of its
      variance: coefficients of force, numbers of the plan, conditions, discretisation (the
      computer's own error), and what no number of the plan covers (model)."))
}

plan_section <- function(gear) {
  report_section("Plan of the gear", class = "plan", report_figure(
    picture_address(gear),
    paste(
      "Plan drawing: the netting laid flat with meshes, mesh size, twine and cutting rates, the",
      "rigging, and lists of ropes and pieces. All of it is given as text in the exact plan below."
    )
  ))
}

shape_section <- function(state) {
  report_section("Shape",
    report_figure(picture_address(state), paste(
      "The gear from above, from the port side and from astern, to scale, coloured by tension.",
      "Its main dimensions are among the measures."
    )),
    report_scene(state, "The gear in three dimensions, coloured by tension.")
  )
}

# The picture of a gear, a state or a trajectory as the address of its own contents.
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
    if (nrow(ropes)) report_table(rope_columns(ropes), "Ropes, the highest tension first: largest
      tension (in kilonewtons and tonnes-force), mean tension, the breaking load of the material or
      plan, and how many times the largest tension goes into it."),
    if (nrow(netting)) report_table(netting_columns(netting, said$slack), "Netting by part: mean
      tension of one twine (of both where the twine is double), that which 1 % of the twine exceeds,
      and the share of the twine that hangs slack.")
  )
}

drag_section <- function(said) {
  tangential <- said$tangential
  report_section("Drag",
    report_table(drag_columns(said$drag_totals, said$drag_totals$group), paste(
      "Forces of the water by group: drag along the flow with its share, side force to starboard,",
      "lift upwards; and weight in water."
    )),
    report_table(
      drag_part_columns(said$drag, said$drag_totals), "The parts with the largest drag."
    ),
    if (!is.null(tangential)) tag$p(sprintf(
      "With all coefficients along twines and ropes halved the total drag would be %s kN at this
      shape, and doubled %s kN: they are known worst.",
      figures(tangential$halved), figures(tangential$doubled)
    ))
  )
}

board_section <- function(boards) {
  if (!nrow(boards)) return(NULL)
  report_section("Otter boards and kites", report_table(board_columns(boards), paste(
    "Free otter boards and kites in the flow: angle of attack and that of their largest lift, heel",
    "(positive outward; of a kite where its starboard end is high) and trim."
  )))
}

balance_section <- function(said) {
  report <- said$report
  report_section("Solution and force balance",
    tag$p(sprintf(
      "%s nodes, %s bars and %s netting cells. %s in %d steps; the largest net force left on a
      node is %s of the largest tension.",
      big_number(report$nodes), big_number(report$bars), big_number(report$cells),
      if (report$converged) "Settled" else "Not settled", report$iterations,
      format(report$residual, digits = 2)
    )),
    report_table(balance_columns(said$balance), "Sums of all forces on the gear; what remains is the
      solver's error."),
    report_table(reaction_columns(said$reactions), "Force of every support on the gear.")
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
    tag$p("Everything above follows from this plan. Save it as a file ending in .yaml, which
      read_gear() and codend settle read."),
    tag$button(type = "button", class = "copy", `data-copies` = "plan-text", "Copy the plan"),
    tag$span(class = "copied", role = "status", `aria-live` = "polite"),
    tag$pre(id = "plan-text", tabindex = "0", `aria-label` = "The plan as YAML", format(gear))
  )
}
