# The formats that a state or a trajectory is exported in. The command line, the tank's downloads
# and the help of both are made from this table; a new format is a line here and its writer.
#
# name: a word of its own; extension: how its files end; of: "state", "trajectory" or both; title:
# what a file holds; opens: what it is for; package: what it takes, or NULL; write: a function(x,
# file).
export_formats <- list(
  list(name = "vtu", extension = ".vtu", of = "state", title = "Grid",
    opens = "ParaView and other readers of VTK", write = function(x, file) write_vtk(x, file)),
  list(name = "pvd", extension = ".pvd", of = "trajectory", title = "Grids by time",
    opens = "ParaView", write = function(x, file) write_vtk(x, file)),
  list(name = "glb", extension = ".glb", of = c("state", "trajectory"), title = "Scene",
    opens = "the web and CAD", write = function(x, file) write_gltf(x, file)),
  list(name = "gltf", extension = ".gltf", of = c("state", "trajectory"), title = "Scene as text",
    opens = "the web and CAD", write = function(x, file) write_gltf(x, file)),
  list(name = "netcdf", extension = ".nc", of = "state", title = "State",
    opens = "codend and readers of NetCDF", package = "RNetCDF",
    write = function(x, file) write_state(x, file)),
  list(name = "json", extension = ".json", of = "state", title = "State as JSON",
    opens = "Python and other languages", write = function(x, file) write_state(x, file)),
  list(name = "tensions", extension = ".csv", of = "state", title = "Tensions of every line",
    opens = "spreadsheets",
    write = function(x, file) write_csv(as.data.frame(x, what = "tensions"), file))
)

# The formats of a state or of a trajectory, by name.
formats_of <- function(of) {
  found <- Filter(function(format) of %in% format$of, export_formats)
  setNames(found, vapply(found, `[[`, "", "name"))
}

# The format that the end of a file's name asks for, or NULL.
format_of_file <- function(file) {
  extension <- tolower(sub("^.*(?=[.])", "", basename(file), perl = TRUE))
  found <- Filter(function(format) format$extension == extension, export_formats)
  if (length(found)) found[[1L]]
}

# The formats of states or trajectories as a sentence's list.
formats_text <- function(of) {
  paste(vapply(formats_of(of), function(format) {
    sprintf("%s (%s, for %s)", format$extension, tolower(format$title), format$opens)
  }, ""), collapse = ", ")
}
