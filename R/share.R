#' A gear as one page that settles by itself
#'
#' Writes a settled gear as one HTML file that anyone can open, on a computer or a phone and without
#' a network: the gear in three dimensions, sliders for fields of its plan, and codend's engine,
#' which settles the gear in the browser as they move. Next to them are the measures with the
#' estimated discretisation errors and how much they have changed, warnings, the plan drawing, the
#' plan's notes and sources, and the version of codend. A tow that is given plays.
#'
#' What a slider does to the gear's numbers is found before the page is written, by reading the plan
#' at several values of the field, and is checked against the plan at values between, to one part in
#' 10^10. The page divides the gear as the state is divided: a field that changes how, such as a
#' count of meshes, cannot be a slider. The page settles from the shape that it shows, in parts
#' where sliders go far at once; errors are those of the state, as shares of the measures, and
#' findings those of the gear as it was shared.
#'
#' The engine of the page is this package's own, compiled to WebAssembly by `make wasm` in codend's
#' sources, and is installed where that was made before. A source package holds no compiled code:
#' installed from one, `share()` stops and says so. Browsers since 2023 run it (Chrome 91, Firefox
#' 113, Safari 16.4).
#'
#' @param state A state, from [settle()]. The page answers a slider the faster the fewer nodes the
#'   state has: a few hundred suit a slow computer.
#' @param file The HTML file to write. It is written whole or not at all.
#' @param sliders Paths of the fields that the page may change, such as `"towing.speed"`, or a list
#'   of such paths that change together, as [sensitivities()] takes them. `NULL` takes a dozen that
#'   people change first, without those that cannot be sliders.
#' @param ranges A list of ranges by the paths of sliders, each two values with units, such as
#'   `list(warps.length = c("300 m", "600 m"))`. A slider without one reaches a quarter of its value
#'   to both sides, or less where the plan does not allow that.
#' @param tow `NULL`, or a trajectory of the gear, from [tow()].
#' @return The file's name, invisibly. A slider or range that cannot be is an error of class
#'   `codend_error_argument` that names it.
#' @seealso [view_3d()] for a picture alone, [report()] for a page to print, [flume()] for every
#'   field.
#' @examples
#' \dontrun{
#' share(settle("towed_cable"), "cable.html", sliders = "towing.speed")
#' }
#' @export
share <- function(state, file, sliders = NULL, ranges = NULL, tow = NULL) {
  check_given("state", "file")
  check_is_state(state)
  if (!is.null(state$time) || !isTRUE(state$report$converged)) {
    abort_argument("{.arg state} must be settled, not a moment of a tow.")
  }
  if (!is.null(tow) && !inherits(tow, "codend_trajectory")) {
    abort_argument("{.arg tow} must be a trajectory, from {.fn tow}.")
  }
  check_file_path(file, ".html")
  check_can_share()
  fields <- slider_fields(state$gear, sliders, ranges)
  with_plain_numbers({
    model <- shared_model(state, fields)
    parts <- shared_parts(state, model, tow)
    write_file(file, function(path) write_shared_page(path, state, model, parts))
  })
  invisible(file)
}

# Whether the engine for pages is installed.
can_share <- function() all(nzchar(system.file("share", engine_files, package = "codend")))

engine_files <- c("engine.js", "engine.wasm.gz")

check_can_share <- function() {
  if (can_share()) return(invisible())
  abort_argument(c(
    "{.fn share} needs codend's engine as WebAssembly, which this installation does not have:
    source packages hold no compiled code.",
    "i" = "In codend's sources, {.code make wasm} compiles it (with Debian's emscripten); then
    install codend from there."
  ))
}
