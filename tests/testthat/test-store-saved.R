# A saved file contains plain data, and damage is reported before any of it is used.

test_that("saved tree of lists and vectors is restored to the last bit", {
  tree <- list(
    a = c(1 / 3, NA, NaN, Inf, -0), b = c(x = 1L, y = NA), c = list(TRUE, NULL, c(NA, "\u00e5\n")),
    d = matrix(1:6, 2L, dimnames = list(NULL, c("p", "q", "r"))), e = list(), f = character(),
    g = data.frame(n = 1:3, t = c("a", "b", "c")), h = setNames(list(), character()),
    i = structure(list(nodes = 3L), class = "codend_mesh"), j = numeric(),
    k = setNames(1:3, c("a", NA, ""))
  )
  flat <- flatten_tree(tree)
  expect_identical(build_tree(flat$form, flat$numbers, flat$integers, stop), tree)
  expect_error(build_tree(flat$form, flat$numbers[-1], flat$integers, stop), "too short")
  expect_error(build_tree(flat$form, c(flat$numbers, 1), flat$integers, stop), "too long")
  # a file cannot restore functions, other classes, calls or environments
  expect_s3_class(build_tree(flatten_tree(list(mean))$form, numeric(), integer(), stop)[[1]],
    "codend_lost_function")
  for (tree in list(quote(a + b), globalenv(), structure(1, class = "formula"), 1i)) {
    expect_error(flatten_tree(list(tree)))
  }
  forged <- '{"kind":"double","length":1,"attributes":{"kind":"list","names":["class"],"items":[
    {"kind":"character","text":["formula"]}]}}'
  expect_error(build_tree(forged, 1, integer(), stop), "unknown")
  expect_error(build_tree('{"kind":"language"}', 1, integer(), stop), "unknown")
  expect_error(build_tree('{"kind":"double","length":1e12}', 1, integer(), stop), "too short")
})

# A copy of a file with some bytes changed by a function.
damaged <- function(file, change) {
  bytes <- change(readBin(file, "raw", file.size(file)))
  copy <- tempfile(fileext = ".nc", tmpdir = dirname(file))
  writeBin(bytes, copy)
  copy
}

test_that("read_result() reports a truncated or changed file in one error", {
  skip_if_not_installed("RNetCDF")
  folder <- test_folder()
  state <- settled("panel_in_current", nodes = 200)
  trajectory <- tow("towed_cable", until = 20, every = 5)
  kept <- list(
    write_result(state, file.path(folder, "s.nc")),
    write_result(trajectory, file.path(folder, "t.nc"))
  )
  for (file in kept) {
    size <- file.size(file)
    # positions over the whole file, densely in the header
    places <- unique(round(c(seq(1, 2000, by = 83), seq(1, size, length.out = 30))))
    for (place in places) {
      flipped <- damaged(file, function(bytes) {
        bytes[place] <- xor(bytes[place], as.raw(2^(place %% 8)))
        bytes
      })
      expect_error(read_result(flipped), class = "codend_error_file",
        label = paste("flipped", place))
      unlink(flipped)
    }
    for (length in round(seq(0, size - 1, length.out = 20))) {
      cut <- damaged(file, function(bytes) bytes[seq_len(length)])
      expect_error(read_result(cut), class = "codend_error_file", label = paste("cut to", length))
      unlink(cut)
    }
  }
})

test_that("read_result() rejects files of other formats", {
  skip_if_not_installed("RNetCDF")
  file <- file.path(test_folder(), "old.nc")
  for (what in names(saved_format)) {
    write_netcdf(file, function(nc) {
      RNetCDF::att.put.nc(nc, "NC_GLOBAL", paste0("codend_", what), "NC_INT", 2L)
    })
    expect_error(read_result(file), "has format 2; .*settle its plan again",
      class = "codend_error_file")
  }
})

test_that("read_result() rejects forged indices with a correct checksum", {
  skip_if_not_installed("RNetCDF")
  table <- list2DF(engine_fields())
  table <- table[!table$among %in% c("numbers", ""), ]
  folder <- test_folder()
  forged <- 0
  for (name in c("midwater_trawl", "beam_trawl", "cage", "purse_seine", "t90_codend")) {
    state <- settled(name, nodes = 100)
    fields <- engine_model_fields(state$mesh$model)
    for (k in seq_len(nrow(table))) {
      path <- c(strsplit(table$kind[k], ".", fixed = TRUE)[[1]], table$name[k])
      # plates and sliding ropes have a subgroup each
      if (path[1] %in% c("plates", "sliding")) path <- append(path, 1L, 1L)
      places <- tryCatch(fields[[path]], error = function(e) NULL)
      if (!length(places)) next
      # alternately too large and too small, exchanged for the next gear
      wrong <- c(1000000L, -1L)[(k + nchar(name)) %% 2 + 1]
      bad <- fields
      bad[[path]][length(places)] <- wrong
      expect_error(
        engine_model(bad), class = "codend_error_engine",
        label = paste(c(name, path, wrong), collapse = " ")
      )
      forged <- forged + 1
    }
    for (kind in c("contacts", "bends", "openings")) {
      node <- fields[[kind]]$node
      if (!length(node)) next
      bad <- state
      bad$recipe$changes <- setNames(list(list(node = replace(node, 1L, 1000000L))), kind)
      file <- write_result(bad, file.path(folder, "forged.nc"))
      expect_error(
        read_result(file), paste0("damaged.*", kind, ".node"), class = "codend_error_file"
      )
    }
    bad <- state
    bad$recipe$counts$pieces <- bad$recipe$counts$pieces[-1L]
    expect_error(
      read_result(write_result(bad, file.path(folder, "forged.nc"))), "damaged",
      class = "codend_error_file"
    )
  }
  # includes ties, bars, triangles, bodies, seabed, boards, sliding or bending ropes, and a catch
  expect_gt(forged, 40)
})

# Peak memory of this process (bytes), or NA if the system does not report it.
peak_memory <- function() {
  if (!file.exists("/proc/self/status")) return(NA)
  1024 * as.double(gsub("[^0-9]", "", grep("^VmHWM", readLines("/proc/self/status"), value = TRUE)))
}

test_that("read_result() rejects a forged header before allocating memory", {
  skip_if_not_installed("RNetCDF")
  file <- write_result(settled("towed_cable"), file.path(test_folder(), "s.nc"))
  bytes <- readBin(file, "raw", file.size(file) - seal_bytes)
  before <- peak_memory()
  refused <- 0
  # words of the header, including counts
  for (at in seq(4, 2000, by = 12)) {
    forged <- replace(bytes, at + 1:4, as.raw(c(0x0f, 0xff, 0xff, 0xff)))
    writeBin(forged, file)
    refused <- refused + tryCatch(
      {
        whole_records(file, FALSE, function(why) abort_damaged(file, why))
        0
      },
      codend_error_file = function(e) 1
    )
    if (at %% 60 == 4) {
      seal_file(file)
      read <- tryCatch(read_result(file), codend_error_file = function(e) NULL)
      if (!is.null(read)) expect_s3_class(read, "codend_state")
    }
  }
  expect_gt(refused, 30)
  if (!is.na(before)) expect_lt(peak_memory() - before, 5e8)
})
