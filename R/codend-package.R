#' Shape and tensions of fishing gear in water
#'
#' codend predicts the shape, tensions and drag of trawls, seines, set nets, longlines and cages
#' from a designer's plan. The plan lists netting panels with their mesh counts, ropes, seams,
#' weights, floats and otter boards.
#'
#' New users start with the guide "Get started": `vignette("get-started", "codend")`. [glossary]
#' explains the terms. `browseVignettes("codend")` lists all guides.
#'
#' @section Workflow:
#' 1. Choose a shipped plan ([gears()]), make one from a few numbers ([new_plan()]), or write your
#'    own; then read it with [read_gear()].
#' 2. Compute the equilibrium shape with [settle()].
#' 3. Read the result: [measures()], [summary()][summary.codend_state], [plot()][plot.codend_state].
#' 4. Check it: [findings()] lists unusual values, and [uncertainty()] estimates intervals.
#' 5. Change the plan with [update()][update.codend_gear], then settle again from the last state.
#' 6. Find the value that gives a required result ([find_value()]), compare designs ([vary()]), or
#'    search for the best one ([optimise_gear()]).
#' 7. Share it: [report()], [share()], [write_gear()], [write_result()].
#'
#' @section Plans:
#' - Find, make and read plans: [gears()], [new_plan()], [read_gear()], [write_gear()].
#' - Build a gear in R: [gear()], [netting_panel()], [rope()], [seam()], [piece()], [otter_board()],
#'   [kite()], [assembly()].
#' - Sections of a plan: [netting], [catch], [vessel], [board_polar()], [catalogue()].
#' - Measures in a plan: [measure()].
#' - Guides: `vignette("from-drawing-to-plan", "codend")`, `vignette("design-a-trawl", "codend")`.
#'
#' @section Shape and forces:
#' - Settle a gear: [settle()], [tow_speed()].
#' - Numbers: [measures()], [findings()], [summary()][summary.codend_state],
#'   [as.data.frame()][as.data.frame.codend_state]; in other units: [in_units()].
#' - Forces of water: [force_coefficients()].
#' - Guides: `vignette("measures", "codend")`, `vignette("forces", "codend")`,
#'   `vignette("drag-models", "codend")`, `vignette("when-it-does-not-settle", "codend")`.
#'
#' @section Pictures and pages:
#' - Draw: [plot() of a plan][plot.codend_gear], [plot() of a state][plot.codend_state],
#'   [view_3d()], [codend_charts].
#' - Pages: [report()], [share()], [flume()] (live flume tank).
#' - Guides: `vignette("pictures", "codend")`, `vignette("serve-the-tank", "codend")`.
#'
#' @section Designs and uncertainty:
#' - Effect of each field: [sensitivities()], [uncertainty()].
#' - Many designs: [vary()], [designs()], [effects()][effects.codend_variations].
#' - Value for a required result: [find_value()].
#' - Best design: [optimise_gear()], [trade_off()].
#' - Studies in files: [vary()], [run_study()], [read_result()].
#' - Guides: `vignette("how-sure", "codend")`, `vignette("optimise-a-trawl", "codend")`.
#'
#' @section Measured hauls:
#' - Read sensors and currents: [read_sensor_log()], [haul_means()], [read_currents()].
#' - Fit a gear to hauls: [calibrate()], [explain_misfit()], [sample_posterior()].
#' - Guide: `vignette("calibrate-to-your-sensors", "codend")`.
#'
#' @section Motion:
#' - Simulate: [tow()], [tow_schedule()], [track_schedule()].
#' - Read: [state_at()], [summary()][summary.codend_trajectory],
#'   [as.data.frame()][as.data.frame.codend_trajectory].
#' - Guide: `vignette("motion", "codend")`.
#'
#' @section Files and command line:
#' - Files: [write_result()], [read_result()], [read_moordyn()].
#' - Guide to the command `codend`: `vignette("command-line", "codend")`.
#'
#' @section Guides by gear:
#' - Trawls: `vignette("bottom-trawl", "codend")`, `vignette("design-a-trawl", "codend")`.
#' - Seines: `vignette("purse-seine", "codend")`, `vignette("demersal-seine", "codend")`.
#' - Other gears: `vignette("longline", "codend")`, `vignette("set-nets", "codend")`,
#'   `vignette("cage", "codend")`.
#'
#' @seealso [glossary], [measures()], [settle()].
#' @keywords internal
#' @useDynLib codend, .registration = TRUE
#' @importFrom stats setNames
#' @importFrom generics tidy glance augment
#' @rawNamespace export(tidy, glance, augment)
#' @examples
#' state <- settle("midwater_trawl", nodes = 300)
#' state
#' plot(state, planes = "xz")
"_PACKAGE"
