# Worth a look: what a gear or a state has that practice and measurement do not know, each with its
# number, its place and what to try. A new check is a new entry in a file `finding-*.R`.

# Every check, by name: list(name, words, of, test) as define_finding() makes them. The files of
# checks fill it while the package is built.
finding_checks <- new.env(parent = emptyenv())

# name: of the check, in words; words: what is worth a look, in one sentence, with the bounds and
# where they come from; of: "plan" where the plan alone tells it, "state" where a settled shape is
# needed; test(gear, state): a list of finding(), `state` being NULL for a check of a plan.
define_finding <- function(name, of, words, test) {
  finding_checks[[name]] <- list(name = name, words = words, of = of, test = test)
}

# place: the plan's field, or the parts of the gear; value: the number, as it is told with its unit
# in `shown`; words: what is odd; advice: what to try.
finding <- function(place, value, shown, words, advice) {
  list(place = place, value = value, shown = shown, words = one_line(words),
    advice = one_line(advice))
}
