# expect_equal() compares measures by what they are, not by the errors that are told of them: these
# depend on the levels that a solve went through.
registerS3method("compare_proxy", "codend_measures", function(x, path) {
  attr(x, "error") <- NULL
  list(object = unclass(x), path = path)
}, envir = asNamespace("waldo"))
