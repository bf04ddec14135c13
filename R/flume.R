#' The live flume tank
#'
#' A page in the browser where gear is made and tried: it begins at a gallery of the shipped gears,
#' with a new gear from a few numbers ([new_plan()]) or a plan of one's own, and shows the gear
#' settled, to change field by field. The net moves to its new shape as a slider does: every shape
#' is settled from the one before.
#'
#' @details
#' The page shows
#'
#' - the controls: first those that people change most, and those of `fields`; then a form with
#'   every field of the plan, made from the schema and grouped as a net drawing is, with what each
#'   means and may be. Fields are found by their words, added, and taken out. A wrong value is shown
#'   next to its field;
#' - the gear in three dimensions: drag or the arrow keys turn it, the wheel, two fingers or `+` and
#'   `-` zoom, and buttons look at the net or the whole gear, from above, from the side and from
#'   astern. A click on a part opens its fields. Ropes and netting are coloured by tension as in
#'   [plot.codend_state()];
#' - the measures, each with its change from a kept design, and warnings ([findings()]):
#'   they follow when a slider pauses, and twice a second while it moves. The gear is kept as it was
#'   opened; *Keep this design* keeps others, and a table has all next to each other. Each can be
#'   put on screen again. Any number of them is drawn under the present one, each in its colour, or
#'   side by side, aligned at the bosom (level, where there is a bed) or at the towing point;
#' - each measure against any field as a graph, settled in the background at values of the field as
#'   [vary()] would, to save as pictures and as a table;
#' - what a little more of any field would do to the measures ([sensitivities()]), kinks marked;
#' - a tow from the design on screen ([tow()]): a change of speed, a turn, warps that are paid out,
#'   or what the plan's section `tow` says, to play with its graphs;
#' - the net drawing ([plot.codend_gear()]), which is an editor: a click on a number is followed by
#'   typing, a click on a panel or a rope opens its fields in the form, the lower edge of a chosen
#'   panel can be dragged; the wheel, two fingers, `+`, `-` and the arrow keys zoom and move it;
#' - the three planes, the tensions ranked by part with their margin to the breaking load, the drag
#'   by part, what differs from the kept design, the plan and the R code of what is on screen.
#'
#' Every step can be undone and done again. The address of the page carries the design on screen and
#' those kept, so that a reload loses neither and a link shows them to others. Lengths, forces and
#' speeds are shown in the units that the user likes.
#'
#' The page is in English, French, Spanish or Norwegian: as its browser likes best, as `?lang=` in
#' its address says, or as chosen at its top. Names of gears, what a field means and may be, and
#' refusals are in English. Fields are found by the words of any of these languages. A
#' language whose words a machine made is marked as unchecked.
#'
#' A design may be unfinished: every change is kept, in any order. What does not fit is marked in
#' the form and the drawing, with a sentence, and the tank shows the last design that fits. A number
#' alone has the unit shown at its field; `20,5`, `20.5 m` and `11 fm` are read too.
#'
#' A plan file dropped on the page, or chosen there, takes the gear's place. A wrong one is answered
#' as [read_gear()] answers; a design that does not settle leaves the last shape on screen and says
#' where the imbalance is. Nothing that is typed or loaded is run as code.
#'
#' A settle that takes long says so and can be cancelled. What is on screen can be saved: a report
#' ([report()]), the plan with its remarks ([write_gear()]), all designs as a file that opens here
#' again, the drawing, the picture, the tow, the tables as CSV, and R code that settles both designs
#' again. `codend flume PLAN --port
#' 3838` opens the same page from a shell.
#'
#' The page asks nothing of the network but the R process that serves it. Each browser has a gear of
#' its own, which a process of its own settles; it waits for its last answer before it asks again,
#' with the latest values. That process ends when the browser leaves.
#'
#' Rows of one's own can be added to what the catalogue ([catalogue()]) offers; they go with the
#' page's address and with designs that are saved or shared. With a `folder`, the page lists the
#' designs in it. Everybody may open a copy of each; to put one there takes an author's name and a
#' word, without which nobody changes or removes that author's designs.
#'
#' @section As a server for others: There is no password, and `codend flume` answers this computer
#'   alone. `vignette("serve-the-tank")` says how to let others in, and what bounds each of them:
#'   sizes of plans, designs and messages, times, memory, and how many come in at a time.
#'
#' @param gear `NULL` for the gallery, or a gear, from [read_gear()] or the constructors, or the
#'   name or file of a plan.
#' @param fields Further fields of the plan to have a control each: paths as in
#'   [update.codend_gear()], such as `"otter_boards.lift_coefficient"`. In a list, an item of
#'   several paths is one control that changes them together; names are labels. A field is a number,
#'   one of several words, or yes and no.
#' @param nodes About how many nodes the model should have; see [settle()].
#' @param folder A folder in which all who see the page share designs, or `NULL` for none.
#' @return A Shiny app, which runs when printed. A wrong argument is an error of class
#'   `codend_error_argument`, a wrong plan one of class `codend_error_plan`, a gear that does not
#'   settle one of class `codend_error_not_converged`, and a missing package one of class
#'   `codend_error_package`.
#' @examplesIf interactive()
#' flume()
#' flume("towed_cable", fields = c("ropes.cable.length", "pieces.sphere.mass"))
#' flume("midwater_trawl", fields = list(
#'   "Hand ropes" = c("hand_ropes.upper.length", "hand_ropes.lower.length")
#' ))
#' @export
flume <- function(gear = NULL, fields = NULL, nodes = 1500, folder = NULL) {
  check_flume_packages()
  if (!is.null(folder)) {
    if (!is_text(folder) || !dir.exists(folder) || file.access(folder, 2L) != 0L) {
      abort_argument("{.arg folder} must be the name of a folder that can be written to, or NULL.")
    }
    check_package("digest", "A folder of shared designs")
  }
  start <- NULL
  if (is.null(gear)) {
    check_settle_arguments(read_gear("towed_cable"), nodes, NULL)
    if (!is.null(fields)) abort_argument("{.arg fields} are those of a gear: give {.arg gear} too.")
    marked <- list()
  } else {
    if (is.character(gear)) gear <- read_gear(gear)
    check_settle_arguments(gear, nodes, NULL)
    marked <- check_marked(first_of(fields, character()), gear$plan)
    start <- settled_start(gear, nodes)
  }
  for (of in c("app", "view")) {
    shiny::addResourcePath(
      paste0("codend-", of), system.file(of, package = "codend", mustWork = TRUE)
    )
  }
  if (has_measures_guide()) {
    shiny::addResourcePath("codend-doc", system.file("doc", package = "codend"))
  }
  shiny::shinyApp(
    ui = function(request) {
      language <- page_language(request$QUERY_STRING, request$HTTP_ACCEPT_LANGUAGE)
      flume_page(!is.null(start), new_say(language), !is.null(folder))
    },
    server = flume_server(start, marked, nodes, folder = folder),
    onStart = function() {
      kept <- options(shiny.maxRequestSize = plan_bytes_limit)
      shiny::onStop(function() options(kept))
    }
  )
}

check_flume_packages <- function() {
  needed <- c("shiny", "bslib", "callr", "later", "promises")
  absent <- needed[!vapply(needed, requireNamespace, NA, quietly = TRUE)]
  if (!length(absent)) return(invisible())
  abort_package(
    c(
      "The flume tank takes the R package{?s} {.pkg {absent}}, which {?is/are} not installed.",
      "i" = "{.fun install.packages} has {?it/them}; on Debian and Ubuntu so has apt, as
      {.val {paste0('r-cran-', absent)}}."
    )
  )
}
