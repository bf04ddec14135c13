# Damaged and forged files.

yaml_marks <- c(
  "\n", "\n---\na: 1\n", "[", "{", ": ", "- ", "&a ", "*a", "!!float ", "!expr ", "<<: ", "\t", "'",
  "\"", "|", "? "
)

changed_bytes <- function(bytes) {
  for (k in seq_len(1L + stats::rpois(1L, 1))) {
    n <- length(bytes)
    if (!n) return(bytes)
    at <- sample.int(n, 1L)
    bytes <- switch(sample.int(6L, 1L),
      replace(bytes, at, as.raw(sample.int(256L, 1L) - 1L)),
      replace(bytes, at, xor(bytes[at], as.raw(2L^(sample.int(8L, 1L) - 1L)))),
      bytes[seq_len(at)],
      bytes[-seq(at, min(n, at + sample.int(40L, 1L)))],
      append(bytes, bytes[seq(at, min(n, at + sample.int(400L, 1L)))], at),
      append(bytes, charToRaw(one_of(yaml_marks)), at)
    )
  }
  bytes
}

plan_bytes <- lapply(codend:::shipped_plans(), function(file) readBin(file, "raw", file.size(file)))

write_bytes <- function(bytes, extension) {
  file <- tempfile(fileext = extension)
  writeBin(bytes, file)
  file
}

changed_plan_file <- function() write_bytes(changed_bytes(one_of(plan_bytes)), ".yaml")

# Files of a state and of a tow that contain every kind of element.
kept_files <- function() {
  folder <- tempfile()
  dir.create(folder)
  plans <- c("midwater_trawl", "cage", "purse_seine", "towed_cable", "t90_codend")
  states <- vapply(plans, function(plan) {
    file <- file.path(folder, paste0(plan, ".nc"))
    write_result(settle(plan, nodes = 60), file)
    file
  }, "")
  tow <- file.path(folder, "tow.nc")
  tow("towed_cable", until = 20, every = 5, nodes = 30, file = tow)
  read <- function(file) readBin(file, "raw", file.size(file))
  list(state = lapply(states, read), tow = list(read(tow)), models = engine_models())
}

# Returns a damaged file; if `sealed` is TRUE, with a corrected checksum, as a forger would write.
changed_kept <- function(bytes, sealed) {
  if (!sealed) return(write_bytes(changed_bytes(bytes), ".nc"))
  bytes <- bytes[seq_len(length(bytes) - codend:::seal_bytes)]
  bytes <- if (chance(0.5)) changed_bytes(bytes) else changed_numbers(bytes)
  file <- write_bytes(bytes, ".nc")
  codend:::seal_file(file)
  file
}

# Replaces integers at random positions: most bytes of a file belong to numbers of 8 or 4 bytes.
changed_numbers <- function(bytes) {
  for (k in seq_len(1L + stats::rpois(1L, 2))) {
    at <- 4L * (sample.int(length(bytes) %/% 4L, 1L) - 1L)
    whole <- one_of(c(0L, -1L, 1L, 1000000L, .Machine$integer.max))
    new <- if (chance(0.5)) whole else one_of(c(0, -1, NaN, Inf, 1e300, 1e-300))
    new <- writeBin(new, raw(), endian = "big")
    new <- new[seq_len(min(length(new), length(bytes) - at))]
    bytes[at + seq_along(new)] <- new
  }
  bytes
}

# ---- models of the engine ------------------------------------------------------------------------

# Models as the engine reads them, of all kinds of element, each with its crude initial layout.
engine_models <- function() {
  plans <- c("midwater_trawl", "beam_trawl", "cage", "purse_seine", "towed_cable", "t90_codend")
  lapply(plans, function(plan) {
    mesh <- codend:::build_mesh(codend:::gear_si(read_gear(plan)), 60)
    list(fields = codend:::engine_model_fields(mesh$model), start = as.double(mesh$start))
  })
}

# Replaces a random array or group of a model.
changed_model <- function(group) {
  k <- sample.int(length(group), 1L)
  inner <- group[[k]]
  if (is.list(inner) && length(inner) && chance(0.9)) {
    group[[k]] <- changed_model(inner)
    return(group)
  }
  if (chance(0.1)) names(group)[k] <- one_of(c("node", "rest", "", names(group)))
  group[k] <- list(changed_array(inner))
  group
}

changed_array <- function(x) {
  n <- length(x)
  if (!n || chance(0.1)) return(one_of(list(NULL, list(), "a", 1L, 1, NA, c(1, 2, 3), TRUE)))
  at <- sample.int(n, 1L)
  way <- sample.int(6L, 1L)
  if (way == 1L) return(x[-at])
  if (way == 2L) return(c(x, x[at]))
  if (way == 3L) return(x[seq_len(at)])
  if (is.integer(x)) {
    x[at] <- one_of(c(0L, -1L, x[at] + 1L, x[at] - 1L, n, 1000000L, .Machine$integer.max, NA))
  } else if (is.double(x)) {
    x[at] <- one_of(c(odd_numbers, -x[at], 1e3 * x[at]))
  } else if (is.character(x)) {
    x[at] <- one_of(odd_texts)
  } else if (is.logical(x)) {
    x[at] <- one_of(c(TRUE, FALSE, NA))
  }
  x
}
