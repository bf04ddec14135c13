#' Errors and their classes
#'
#' Every error of codend has class `codend_error` and one more that says what is wrong, so that a
#' program can distinguish them with [tryCatch()].
#'
#' | class | what is wrong | fields of the condition |
#' |---|---|---|
#' | `codend_error_plan` | a field of a plan | `path`, `value`; of a file `line`, `column` |
#' | `codend_error_argument` | an argument of a function | |
#' | `codend_error_file` | a file that cannot be read or written | `file`; of a tow `trajectory` |
#' | `codend_error_not_converged` | no balance is found | `report`; of a tow `trajectory` |
#' | `codend_error_energy` | of those, a motion that gains or loses energy | as above |
#' | `codend_error_engine` | the engine, or a check of its arrays, finds it wrong | `field` |
#' | `codend_error_package` | a package that is not installed | |
#' | `codend_error_usage` | a command of the command line is used wrongly | |
#'
#' Warnings have class `codend_warning`; those of [settle()] about an otter board also
#' `codend_warning_board_stalled`, `_back_winded`, `_fallen_over`, `_unstable` or `_flutter`, of a
#' pole `codend_warning_pole_unstable` and of netting full of catch `codend_warning_catch_unstable`.
#'
#' A study has `codend_warning_conditions_not_kept` ([optimise_gear()]),
#' `codend_warning_hauls_left_out` ([calibrate()]) and `codend_warning_few_draws`
#' ([sample_posterior()]).
#'
#' A file is written next to its place, forced to the disk and renamed. Where that fails, on a full
#' disk too, the old file stays.
#'
#' @name codend-conditions
#' @examples
#' tryCatch(read_gear("no_such_plan"), codend_error_plan = function(e) conditionMessage(e))
NULL
