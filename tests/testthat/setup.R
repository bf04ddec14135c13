# A name that is matched by its beginning alone is a mistake; tools/test.R counts its warning as a
# failure.
options(warnPartialMatchDollar = TRUE, warnPartialMatchArgs = TRUE, warnPartialMatchAttr = TRUE)
