# Plans of real nets from public particulars, compared with published values. Their net drawings
# were not available. The tests show that such particulars give a one-page plan with plausible
# behaviour.

real_net <- function(name) {
  system.file("extdata", paste0(name, "_trawl.yaml"), package = "codend", mustWork = TRUE)
}

test_that("plans of real nets fit one page, mark assumptions and settle", {
  for (name in c("eastern", "four_seam", "myctophid", "nordic")) {
    text <- readLines(real_net(name))
    expect_lte(length(text), 60)
    expect_match(text, "[assumed]", fixed = TRUE, all = FALSE)
    expect_no_error(settle(read_gear(real_net(name)), nodes = 300))
  }
})

test_that("lantern fish trawl has the published netting", {
  netting <- summary(read_gear(real_net("myctophid")))$netting
  # of 412 m2 and 832 kg, its design values
  expect_lt(abs(sum(netting$twine_area_m2) / 412 - 1), 0.12)
  expect_lt(abs(sum(netting$mass_kg) / 832 - 1), 0.05)
})

test_that("Nordic trawl floats, with its published length and a mouth below its largest", {
  found <- measures(settle(read_gear(real_net("nordic")), nodes = 400))
  expect_equal(found[["net_length_m"]], 198, tolerance = 0.1)
  expect_lt(found[["headline_depth_m"]], 1)
  expect_lt(found[["wing_end_spread_m"]], 30)
  expect_gt(found[["wing_end_spread_m"]], 30 / 2)
  expect_lt(found[["net_mouth_height_m"]], 18)
  expect_gt(found[["net_mouth_height_m"]], 18 / 2)
})

test_that("plans of real nets have their published particulars", {
  sheets <- utils::read.csv(system.file("extdata", "published_nets.csv", package = "codend"),
    comment.char = "#")
  expect_gte(length(unique(sheets$plan)), 6)
  for (name in unique(sheets$plan)) {
    all <- summary(read_gear(if (name == "poly_noreastern") "poly_noreastern_trawl" else {
      real_net(name)
    }))
    mine <- sheets[sheets$plan == name, ]
    for (k in which(mine$part %in% c("netting", all$parts$part))) {
      table <- if (mine$part[k] == "netting") all$netting else all$parts
      own <- mine$part[k] == "netting" | table$part == mine$part[k]
      # the twine area of the lantern fish trawl is 10 % smaller
      expect_equal(sum(table[[mine$column[k]]][own]), mine$published[k], tolerance = 0.1,
        label = paste(name, mine$part[k]))
    }
  }
})
