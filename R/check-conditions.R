#' Error and warning classes
#'
#' Every error of codend has class `codend_error` and a second class that names the kind of error. A
#' program can distinguish them with [tryCatch()].
#'
#' | class | cause | fields of the condition |
#' |---|---|---|
#' | `codend_error_plan` | a plan's field is wrong | `path`, `value`; for a file `line`, `column` |
#' | `codend_error_argument` | an argument of a function is wrong | |
#' | `codend_error_file` | a file cannot be read or written | `file`; for a tow `trajectory` |
#' | `codend_error_not_converged` | the solver did not converge | `report`; for a tow `trajectory` |
#' | `codend_error_energy` | the same, because a motion gains or loses energy | the same |
#' | `codend_error_engine` | the engine, or a check of its arrays, reports an error | `field` |
#' | `codend_error_package` | a package is not installed | |
#' | `codend_error_usage` | a command of the command line is used wrongly | |
#'
#' @section Warnings:
#' Every warning has class `codend_warning` and often a second class:
#'
#' - [settle()], otter boards: `codend_warning_board_stalled`, `_back_winded`, `_fallen_over`,
#'   `_unstable` or `_flutter`;
#' - [settle()], poles: `codend_warning_pole_unstable`;
#' - [settle()], netting full of catch: `codend_warning_catch_unstable`;
#' - [optimise_gear()]: `codend_warning_conditions_not_kept`;
#' - [calibrate()]: `codend_warning_hauls_left_out`;
#' - [sample_posterior()]: `codend_warning_few_draws`.
#'
#' @section Messages:
#' [update()][update.codend_gear] and studies raise messages of class `codend_message_units`. They
#' report how a number without a unit is read, once per session and field.
#'
#' @section Files:
#' All files are written atomically: codend writes a new file in the same folder, forces it to the
#' disk and renames it. If this fails, for example on a full disk, the old file remains.
#'
#' @name codend-conditions
#' @seealso [settle()], [write_result()]; the guide `vignette("when-it-does-not-settle", "codend")`.
#' @examples
#' tryCatch(read_gear("no_such_plan"), codend_error_plan = function(e) conditionMessage(e))
NULL
