# Partial matching of names is a mistake; tools/test.R counts its warning as a failure.
options(warnPartialMatchDollar = TRUE, warnPartialMatchArgs = TRUE, warnPartialMatchAttr = TRUE)

# The output of tests has no line per step of a search.
options(codend.steps = FALSE)
