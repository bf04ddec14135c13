#' Share a gear as a page that settles it
#'
#' Writes a settled gear as one HTML file with sliders for fields of its plan. As they move,
#' codend's engine settles the gear in the browser, on a computer or a phone and without a network.
#'
#' @section Contents of the page:
#' The page is the page of [flume()] without the functions that need R:
#'
#' - the gear in three dimensions, the plan drawing, and the fields of the sliders;
#' - the measures with their changes and estimated discretisation errors, and warnings;
#' - undo, comparison of designs and units, the plan, and the version of codend;
#' - a tow, if given, which the page plays.
#'
#' @section Accuracy:
#' - `share()` reads the plan at several values of each field, and interpolates the effect of its
#'   slider on the gear. The interpolation is checked to one part in 10^10 at values in between.
#' - The page uses the mesh of the state. A field that changes the mesh, such as a count of meshes,
#'   cannot be a slider.
#' - The page settles from the displayed shape, and in several steps if sliders move far.
#' - Relative errors are copied from the state. Findings refer to the gear as shared.
#'
#' @section Requirements:
#' The page needs codend's engine as WebAssembly, which `make wasm` compiles in codend's sources.
#' Source packages contain no compiled code: after installation from a source package, `share()`
#' throws an error. Browsers since 2023 run the page (Chrome 91, Firefox 113, Safari 16.4).
#'
#' @param state A state from [settle()]. The fewer nodes it has, the faster the page is: a few
#'   hundred suit a slow computer.
#' @param file The HTML file to write. It is written atomically.
#' @param sliders Paths of the fields that the page may change, such as `"towing.speed"`, or a list
#'   of paths that change together, as in [sensitivities()]. `NULL` (default): a dozen fields that
#'   users change first, if they can be sliders.
#' @param ranges A list of ranges by path of a slider, each two values with units, such as
#'   `list(warps.length = c("300 m", "600 m"))`. Default: 25 % of the value to both sides, or less
#'   if the plan does not allow it.
#' @param tow `NULL` (default), or a trajectory of the gear from [tow()].
#' @return The name of the file, invisibly. An invalid slider or range is an error of class
#'   `codend_error_argument`, which contains its name.
#' @seealso [view_3d()] for a picture without sliders, [report()] for a page to print, [flume()] for
#'   a page with every field.
#' @examples
#' \dontrun{
#' share(settle("towed_cable"), "cable.html", sliders = "towing.speed")
#' share(settle("midwater_trawl", nodes = 500), "trawl.html", ranges = list(
#'   towing.speed = c("3 knot", "5 knot")
#' ))
#' }
#' @export
share <- function(state, file, sliders = NULL, ranges = NULL, tow = NULL) {
  check_given("state", "file")
  check_is_state(state)
  if (!is.null(state$time) || !isTRUE(state$report$converged)) {
    abort_argument("{.arg state} must be a settled state ({.fn settle}), not a moment of a tow.")
  }
  if (!is.null(tow) && !inherits(tow, "codend_trajectory")) {
    abort_argument("{.arg tow} must be a trajectory from {.fn tow}.")
  }
  check_file_path(file, ".html")
  check_can_share()
  fields <- slider_fields(state$gear, sliders, ranges)
  with_plain_numbers({
    model <- shared_model(state, fields)
    parts <- shared_parts(state, model, tow)
    write_file(file, function(path) write_shared_page(path, state, parts))
  })
  invisible(file)
}

# TRUE if the engine for pages is installed.
can_share <- function() all(nzchar(system.file("share", engine_files, package = "codend")))

engine_files <- c("engine.js", "engine.wasm.gz")

check_can_share <- function() {
  if (can_share()) return(invisible())
  abort_argument(c(
    "{.fn share} needs codend's engine as WebAssembly, but this installation does not have it:
    source packages have no compiled code.",
    "i" = "In codend's sources, {.code make wasm} compiles it (with Debian's emscripten); then
    install codend from there."
  ))
}
