#' Design gear in a live flume tank
#'
#' Opens a page in the browser that settles a gear again after every change, so that its shape,
#' measures and warnings follow a slider. Start from a shipped gear, a new gear ([new_plan()]) or a
#' plan of your own.
#'
#' @section Parts of the page:
#' - **Main fields** below the pictures: fields that users change most and the fields in `fields`.
#' - **Form** at the right with every field of the plan. The form is generated from the schema, in
#'   groups like a net drawing, with the meaning and the allowed values of each field. You can
#'   search, add and remove fields. An invalid value is reported next to its field.
#' - **Tank**: the gear in three dimensions. Drag or the arrow keys turn it; the wheel, two fingers
#'   or `+` and `-` zoom. Buttons select the net or the whole gear and the direction of view. A
#'   click on a part opens its fields. A part that you choose in the form or the drawing is
#'   highlighted, also in the tables. The key T enlarges the tank, D the drawing, and dividers
#'   between drawing, tank and form move. Colours show tension as in [plot.codend_state()].
#'   While a slider moves, the tank first shows a marked prediction, the settled shape plus its
#'   derivative by the field times the change.
#' - **Measures** and warnings ([findings()]), with changes from a stored design. They are updated
#'   when a slider pauses, and twice a second while it moves.
#' - **Designs**: the gear as opened and designs that you store with *Keep this design*. A table
#'   compares them, and each can be opened again. The tank draws them with the present design, over
#'   it or side by side, aligned at the bosom or at the towing point. If there is a sea bed, the
#'   alignment keeps their heights above it.
#' - **Graphs** of measures against any field. The values are settled in the background as in
#'   [vary()].
#' - **Sensitivities** of the measures to any field ([sensitivities()]), with kinks marked.
#' - **Tow** ([tow()]): a change of speed, a turn, warps that are paid out, or the section `tow` of
#'   the plan. The page plays the tow with graphs.
#' - **Net drawing** ([plot.codend_gear()]), which is an editor. Click a number to type another,
#'   click a panel or a rope to open its fields, or drag the lower edge of a selected panel. The
#'   wheel, two fingers, `+`, `-` and the arrow keys zoom and move it.
#' - **Tables**: tensions by part with the margin to the breaking load, drag by part,
#'   and differences from the stored design.
#' - **Text**: the plan, which you can edit, and R code for the designs.
#'
#' @section Editing:
#' - Every step can be undone and redone.
#' - The address of the page contains the designs. A reload loses no design, and a link shares them.
#' - A design may be incomplete. The page accepts changes in any order and marks contradictions in
#'   the form and the drawing, while the tank shows the last consistent design.
#' - A bare number has the unit at its field; `20,5`, `20.5 m` and `11 fm` are also accepted. You
#'   can choose the units in which lengths, forces and speeds are displayed.
#' - A plan file replaces the gear if you drop it on the page or choose it there. Errors in the file
#'   are reported as in [read_gear()].
#' - A design that does not settle leaves the last shape on screen. The message gives the location
#'   of the largest residual.
#' - A long computation can be cancelled.
#' - Text that you type or load is never run as code.
#'
#' @section Downloads:
#' The page saves
#'
#' - a report ([report()]), the plan with its remarks ([write_gear()]), the drawing, plane views,
#'   the picture and the tow;
#' - all designs in one file that the page can open;
#' - tables as CSV, graphs as pictures, and R code that settles the present and the stored design.
#'
#' @section Languages:
#' The page is in English, French, Spanish or Norwegian: as the browser prefers, as `?lang=` in the
#' address requires, or as you choose at the top. Names of gears, descriptions of fields and error
#' messages are in English. A search for a field accepts all four languages. A machine translation
#' that nobody has checked is marked.
#'
#' @section Catalogue and shared designs:
#' You can add rows of your own to the catalogue ([catalogue()]). They are part of the page's
#' address and of saved or shared designs.
#'
#' With a `folder`, the page lists the designs in it. Everybody may open a copy. To share a design,
#' you give an author's name and a name of the design. Only the same browser can change or remove
#' it.
#'
#' @section As a server for others:
#' `codend flume PLAN --port 3838` opens the same page from a shell. It accepts connections only
#' from the same computer, because the page has no login. `vignette("serve-the-tank")` describes how
#' to give others access, and the limits for each user: sizes of plans, designs and messages, times,
#' memory, and the number of users at a time.
#'
#' Each browser has its own gear, which a separate process settles. The process ends when the
#' browser leaves. The page uses no network connection except to its R process.
#'
#' @param gear `NULL` for the gallery, or a gear from [read_gear()] or the constructors, or the name
#'   or file of a plan.
#' @param fields Additional fields with a control at the top: paths as in [update.codend_gear()],
#'   such as `"otter_boards.lift_coefficient"`. In a list, one item may have several paths, which
#'   change together; its name is the label. A field must be a number, a choice, or yes or no.
#' @param nodes Approximate number of nodes of each net (default 1500); see [settle()].
#' @param folder A writable folder in which users of the page share designs, or `NULL`.
#' @param hosts Names under which a proxy serves the page, such as `"tank.example.org"`, or `NULL`
#'   (default): only `localhost` and IP addresses are accepted.
#' @return An object of class `codend_flume`. Printing it serves the page until you interrupt R. The
#'   function throws errors of class `codend_error_argument` (invalid argument),
#'   `codend_error_plan` (invalid plan), `codend_error_not_converged` (the gear does not settle) or
#'   `codend_error_package` (missing package).
#' @seealso [settle()], [vary()] and [tow()] for the same computations in R, [share()] for a page
#'   that needs no R, `vignette("serve-the-tank")`.
#' @examplesIf interactive()
#' flume()
#' flume("towed_cable", fields = c("ropes.cable.length", "pieces.sphere.mass"))
#' flume("midwater_trawl", fields = list(
#'   "Hand ropes" = c("hand_ropes.upper.length", "hand_ropes.lower.length")
#' ))
#' @export
flume <- function(gear = NULL, fields = NULL, nodes = 1500, folder = NULL, hosts = NULL) {
  check_flume_packages()
  if (!is.null(hosts) && (!is.character(hosts) || anyNA(hosts))) {
    abort_argument("{.arg hosts} must be names of hosts, such as {.val tank.example.org}, or NULL.")
  }
  if (!is.null(folder)) {
    if (!is_text(folder) || !dir.exists(folder) || file.access(folder, 2L) != 0L) {
      abort_argument("{.arg folder} must be the path of a writable folder, or NULL.")
    }
  }
  start <- NULL
  if (is.null(gear)) {
    check_settle_arguments(read_gear("towed_cable"), nodes, NULL)
    if (!is.null(fields)) {
      abort_argument("{.arg fields} needs {.arg gear}: the fields belong to the plan of a gear.")
    }
    marked <- list()
  } else {
    if (is.character(gear)) gear <- read_gear(gear)
    check_settle_arguments(gear, nodes, NULL)
    marked <- check_marked(first_of(fields, character()), gear$plan)
    start <- settled_start(gear, nodes)
  }
  structure(
    list(open_page = flume_server(start, marked, nodes, folder = folder, hosts = hosts)),
    class = "codend_flume"
  )
}

check_flume_packages <- function() {
  needed <- c("httpuv", "callr", "later", "ps")
  absent <- needed[!vapply(needed, requireNamespace, NA, quietly = TRUE)]
  if (!length(absent)) return(invisible())
  abort_package(
    c(
      "The flume tank needs the R package{?s} {.pkg {absent}}, which {?is/are} not installed.",
      "i" = "Install {?it/them} with {.fun install.packages}; on Debian and Ubuntu also with apt, as
      {.val {paste0('r-cran-', absent)}}."
    )
  )
}
