# The manifest: compared cases and the claims about them.

# A case's function in validation/cases.
runner <- function(id) paste0("case_", gsub("-", "_", id))

# Returns the cases of a manifest by id, each with its quantities and trends as lists. An error
# names the wrong case and field.
read_manifest <- function(file) {
  cases <- yaml::read_yaml(file)$cases
  names(cases) <- vapply(cases, function(case) case$id, "")
  twice <- names(cases)[duplicated(names(cases))]
  if (length(twice)) stop("manifest: two cases are named ", twice[1])
  for (case in cases) check_case(case)
  cases
}

check_case <- function(case) {
  wrong <- function(...) stop("manifest, case ", case$id, ": ", ..., call. = FALSE)
  need <- c("id", "title", "group", "plan", "source")
  for (field in need) {
    if (!is.character(case[[field]]) || !nzchar(case[[field]])) wrong("`", field, "` is missing")
  }
  if (!case$group %in% names(case_groups)) wrong("`group` is ", case$group)
  unknown <- setdiff(names(case), c(need, "tuned", "quantities", "trends"))
  if (length(unknown)) wrong("`", unknown[1], "` is no field")
  if (!length(case$quantities) && !length(case$trends)) wrong("nothing is compared")
  for (name in names(case$quantities)) {
    of <- case$quantities[[name]]
    check_claim(of, name, c("unit", "band", "status", "why"), wrong)
    if (!is.numeric(of$band) || of$band <= 0) wrong(name, " has no `band` in percent")
    if (!is.character(of$unit)) wrong(name, " has no `unit`")
    if (of$status == "tuned" && is.null(case$tuned)) wrong("`tuned` must name an input and data")
  }
  for (name in names(case$trends)) {
    check_claim(case$trends[[name]], name, c("status", "why"), wrong)
  }
  invisible(case)
}

# status: held, missed, or tuned, which does not count; why: cause of a miss, one sentence.
check_claim <- function(of, name, fields, wrong) {
  unknown <- setdiff(names(of), fields)
  if (length(unknown)) wrong(name, ": `", unknown[1], "` is no field")
  if (!isTRUE(of$status %in% c("held", "missed", "tuned"))) {
    wrong(name, ": `status` must be held, missed or tuned")
  }
  if (of$status == "missed" && !is.character(of$why)) wrong(name, " is missed without a `why`")
}

case_groups <- c(
  exact = "Closed forms and equations integrated apart",
  motion = "Motions compared with closed forms, integrated equations and explicit steps",
  program = "Another program",
  coefficients = "Published coefficients",
  flume = "Flume tests",
  hauls = "Hauls at sea",
  other = "Cages, seines, longlines and published figures of whole gears"
)

# Evaluates the functions and tables of a test file, without its tests, to reuse plans and
# analytical solutions.
use_tests <- function(name, into = parent.frame()) {
  for (said in parse(file.path("tests/testthat", paste0(name, ".R")), keep.source = FALSE)) {
    if (is.call(said) && identical(said[[1]], as.name("<-"))) eval(said, into)
  }
}
test_path <- function(...) file.path("tests/testthat", ...)
use_tests("helper-mesh")
use_tests("helper-bag")

# Rows of a case. Rows that were used to tune a value of the gear are marked and do not count.
compared <- function(quantity, at, measured, computed, tuned = FALSE) {
  data.frame(kind = "quantity", quantity = quantity, at = at, measured = measured,
    computed = computed, tuned = tuned)
}

# Dependence of a quantity on the varied value: slope of log(y) by log(x), or of y by x if `power`
# is FALSE.
trend <- function(quantity, at, x, measured, computed, power = TRUE) {
  keep <- is.finite(measured) & is.finite(computed)
  slope <- function(y) {
    of <- if (power) log(cbind(x, y)[keep, ]) else cbind(x, y)[keep, ]
    unname(stats::coef(stats::lm(of[, 2] ~ of[, 1]))[2])
  }
  data.frame(kind = "trend", quantity = quantity, at = at, measured = slope(measured),
    computed = slope(computed), tuned = FALSE)
}
