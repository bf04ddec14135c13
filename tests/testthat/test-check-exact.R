# Adds to every map of a schema node a default field per known field, whose name starts with that
# field's name.
with_longer_names <- function(node) {
  for (part in intersect(c("items", "additionalProperties"), names(node))) {
    node[[part]] <- with_longer_names(node[[part]])
  }
  node$choices <- lapply(node$choices, with_longer_names)
  # a measure is the only field of its map
  if (length(node$properties) && is.null(node$maxProperties)) {
    node$properties <- lapply(node$properties, with_longer_names)
    longer <- paste0(names(node$properties), "_longer")
    node$defaults[longer] <- list("longer")
    # a kind of gear passes its fields on to the parts it expands to
    if (is.null(node$additionalProperties)) {
      node$additionalProperties <- list(shape = "any", choices = list(list(shape = "string")))
      node$propertyNames <- list(pattern = "_longer$")
    }
  }
  node
}

# A tree without those fields.
without_longer <- function(tree) {
  if (!is.list(tree) || is.data.frame(tree)) return(tree)
  if (!is.null(names(tree))) tree <- tree[!endsWith(names(tree), "_longer")]
  tree[] <- lapply(tree, without_longer)
  tree
}

# The result of `code` while plans are checked by other nodes of their kinds.
under_nodes <- function(nodes, code) {
  package <- asNamespace("codend")
  own <- package$kind_node
  put <- function(of) {
    unlockBinding("kind_node", package)
    assign("kind_node", of, package)
    lockBinding("kind_node", package)
  }
  on.exit(put(own))
  put(function(kind) nodes[[kind]])
  code
}

test_that("reading ignores new fields whose names begin like existing ones", {
  gears <- lapply(setNames(nm = gears()$name), read_gear)
  changed <- lapply(lapply(setNames(nm = plan_kinds), kind_node), with_longer_names)
  # a fixed collar accepts no other field
  changed$cage$properties$collar <- kind_node("cage")$properties$collar
  for (name in names(gears)) {
    with <- under_nodes(changed, as_gear(gears[[name]]$plan))
    expect_true("name_longer" %in% names(gear_checked(with)$fields), label = name)
    expect_identical(without_longer(gear_si(with)), gear_si(gears[[name]]), label = name)
  }
})

test_that("`$` reads plans, gears and SI numbers by exact names", {
  # scripts use R's `$`, tests the package's
  script <- function(code, ...) eval(substitute(code), list(...), globalenv())
  gear <- read_gear("beam_trawl")
  expect_null(script(gear$plan$tow, gear = gear))
  expect_null(script(gear$pla, gear = gear))
  expect_null(script(gear$plan[["towing"]]$spee, gear = gear))
  expect_null(script(gear$plan["towing"]$towing$spee, gear = gear))
  expect_null(script(lapply(gear$plan["towing"], function(group) group$spee)$towing, gear = gear))
  expect_null(script(gear$checked$si$panels[[1]]$mesh, gear = gear))
  expect_identical(script(gear$plan$towing$speed, gear = gear), "4 knot")
  printed <- script(utils::capture.output(print(gear$plan$towing)), gear = gear)
  expect_identical(printed, utils::capture.output(print(gear$plan$towing)))
  changed <- script({
    gear$plan$towing$speed <- "3 knot"
    gear
  }, gear = gear)
  expect_identical(changed[["plan"]], update(gear, towing.speed = "3 knot")[["plan"]])
})
