#' Shape and tensions of fishing gear
#'
#' From a designer's plan - netting panels with their mesh counts, ropes, seams, weights, floats,
#' otter boards - codend finds the shape in which every knot and every metre of rope is in balance,
#' and says what a net maker or a skipper needs: spreads, heights, tensions, drag, slack
#' netting.
#'
#' | to do | begin with |
#' |---|---|
#' | find a plan | [gears()], [new_plan()], [read_gear()], [gear()] |
#' | find its shape | [settle()], [measures()], [summary()][summary.codend_state], [findings()] |
#' | see it | [plot()][plot.codend_state], [view_3d()], [report()], [flume()] |
#' | change it | [update()][update.codend_gear], [vary()], [sensitivities()], [optimise_gear()] |
#' | set it next to hauls | [read_sensor_log()], [calibrate()], [explain_misfit()] |
#' | move it | [tow()] |
#' | hand it on | [write_gear()], [write_result()] |
#'
#' [glossary] has the words. Guides: `browseVignettes("codend")`; to begin with
#' `vignette("from-drawing-to-plan", "codend")` and `vignette("measures", "codend")`.
#'
#' @keywords internal
#' @useDynLib codend, .registration = TRUE
#' @importFrom stats setNames
#' @examples
#' state <- settle("towed_cable")
#' state
#' plot(state, planes = "xz")
"_PACKAGE"
