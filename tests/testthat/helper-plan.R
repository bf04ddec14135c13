# A small valid plan, as text, in which tests change one line at a time.
small_plan <- "codend: 1
name: A net on a warp
points:
  ship: {position: [0, 0, 0], held: fixed}
  knot: {}
ropes:
  warp:
    from: ship
    to: knot
    length: 100 m
    diameter: 20 mm
    material: PA
panels:
  net:
    mesh_size: 100 mm
    meshes: {upper: 10, lower: 5, deep: 10}
    twine: {diameter: 2 mm, material: PE}
seams:
  top: {edges: [net.upper], gathered_at: knot}
"

plan_file <- function(text) {
  file <- tempfile(fileext = ".yaml")
  if (is.raw(text)) writeBin(text, file) else writeBin(charToRaw(enc2utf8(text)), file)
  file
}

read_text <- function(text) read_gear(plan_file(text))

# Returns a plan of the package's folder of examples, or of another folder.
example_gear <- function(name, folder = "examples") {
  read_gear(system.file(folder, paste0(name, ".yaml"), package = "codend", mustWork = TRUE))
}

two_seam <- function(...) update(example_gear("two_seam_trawl", "extdata"), ...)

spoil <- function(old, new, plan = small_plan) {
  stopifnot(grepl(old, plan, fixed = TRUE))
  sub(old, new, plan, fixed = TRUE)
}

# The error of the small plan with one change: its path and its message on one line.
plan_error <- function(old, new, plan = small_plan) text_error(spoil(old, new, plan))

text_error <- function(text) {
  error <- tryCatch(read_text(text), codend_error_plan = identity)
  if (!inherits(error, "codend_error_plan")) return(list(path = "no error", message = "no error"))
  list(path = error$path, message = gsub("[[:space:]]+", " ", conditionMessage(error)))
}

expect_plan_error <- function(old, new, path, message, plan = small_plan) {
  error <- plan_error(old, new, plan)
  expect_identical(error$path, path)
  expect_match(error$message, message, fixed = TRUE)
}

# Returns messages without lists of available items, which change when items are added.
without_lists <- function(text) {
  lists <- "(Shipped|Known here|Measures|units|must be any of|must be one of):? .*?"
  kept <- "((?: Did you mean [^?]*[?])?(?: \\(line \\d+, column \\d+\\))?)$"
  sub(paste0(lists, kept), "\\1 ...\\2", text, perl = TRUE)
}

# Expects that a plan, or an argument, is rejected with this message.
expect_refused <- function(code, ...) expect_error(code, ..., class = "codend_error_plan")
expect_wrong <- function(code, ...) expect_error(code, ..., class = "codend_error_argument")
