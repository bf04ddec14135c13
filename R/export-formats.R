# Export formats of a state or trajectory, for the command line, the tank's downloads and their
# help. A new format needs an entry here and a writer. `of`: "state", "trajectory" or both. `title`,
# `opens`: the content of the file, and programs that open it. `package`: required package. `write`:
# function(x, file).
export_formats <- list(
  list(name = "vtu", extension = ".vtu", of = "state", title = "Grid",
    opens = "ParaView and other readers of VTK", write = function(x, file) write_vtk(x, file)),
  list(name = "pvd", extension = ".pvd", of = "trajectory", title = "Grids by time",
    opens = "ParaView", write = function(x, file) write_vtk(x, file)),
  list(name = "glb", extension = ".glb", of = c("state", "trajectory"), title = "Scene",
    opens = "the web and CAD", write = function(x, file, ...) write_gltf(x, file, write_glb, ...)),
  list(name = "gltf", extension = ".gltf", of = c("state", "trajectory"), title = "Scene as text",
    opens = "the web and CAD",
    write = function(x, file, ...) write_gltf(x, file, write_gltf_text, ...)),
  list(name = "netcdf", extension = ".nc", of = "state", title = "State",
    opens = "codend and readers of NetCDF", package = "RNetCDF",
    write = function(x, file) write_state(x, file)),
  list(name = "json", extension = ".json", of = "state", title = "State as JSON",
    opens = "Python and other languages",
    write = function(x, file) write_text(c(state_json(x), ""), file)),
  list(name = "tensions", extension = ".csv", of = "state", title = "Tensions of every line",
    opens = "spreadsheets",
    write = function(x, file) write_csv(as.data.frame(x, what = "tensions"), file))
)

formats_of <- function(of) {
  found <- Filter(function(format) of %in% format$of, export_formats)
  setNames(found, vapply(found, `[[`, "", "name"))
}

format_of_file <- function(file, formats = export_formats) {
  extension <- tolower(sub("^.*(?=[.])", "", basename(file), perl = TRUE))
  Find(function(format) format$extension == extension, formats)
}

formats_text <- function(of) {
  paste(vapply(formats_of(of), function(format) {
    sprintf("%s (%s, for %s)", format$extension, tolower(format$title), format$opens)
  }, ""), collapse = ", ")
}

#' Write and read results
#'
#' Writes a state or trajectory to a file for other programs or for [read_result()], which restores
#' it exactly. The ending of the file name selects the format:
#'
#' | ending | content | for |
#' |---|---|---|
#' | `.nc` | all numbers as NetCDF, CF conventions | [read_result()], most languages |
#' | `.json` | the same content for a state, as JSON | languages without a NetCDF reader |
#' | `.vtu` | a state as an unstructured grid of VTK | ParaView, VisIt |
#' | `.pvd` | a trajectory as a series of such grids | ParaView |
#' | `.glb`, `.gltf` | the scene in glTF 2.0, animated for a trajectory | web, Blender, CAD |
#' | `.csv` | tensions of every line of a state | spreadsheets |
#' | `.txt` | ropes of a state as input of MoorDyn 2 | MoorDyn, [read_moordyn()] |
#'
#' @section NetCDF and JSON:
#' Names end in their unit. They are the same in NetCDF, in JSON and, for nodes, parts and measures,
#' in the tables of [as.data.frame()][as.data.frame.codend_state].
#'
#' | name | across | content |
#' |---|---|---|
#' | `door_spread_m` and every other measure | | value, unit, standard `error` and `long_name` |
#' | `x_m`, `y_m`, `z_m` | `node` | position: aft, to starboard, up from the water surface |
#' | `x_force_N`, `y_force_N`, `z_force_N` | `node` | net force (fixed nodes: minus the support's) |
#' | `x_velocity_m_per_s`, `y_`, `z_` | `node` | velocity, in motion |
#' | `held` | `node` | 1 on fixed nodes |
#' | `bar_node`, `bar_part` | `bar` | the two nodes and the part of a bar |
#' | `bar_tension_N` | `bar` | tension of one line |
#' | `cell_node`, `cell_part` | `cell` | the four nodes and the part of a netting cell |
#' | `u_tension_N`, `v_tension_N` | `cell` | tension of one twine |
#' | `straight_tension_N` | `hexagonal_cell` | tension of one straight bar |
#' | `hexagonal_cell` | `hexagonal_cell` | numbers of these cells |
#' | `part` | `part` | names of ropes, panels, pieces and boards |
#' | `drag_kN`, `side_kN`, `lift_kN` | `part` | hydrodynamic force: along the flow, starboard, up |
#' | `weight_in_water_kN` | `part` | weight minus buoyancy |
#'
#' Numbers of nodes and parts start at 1. Numbers above the last node are points that hang between
#' two nodes.
#'
#' NetCDF: a measure is a scalar variable with the attributes `units`, `long_name` and `error`. The
#' global attributes are `title` (gear name and conditions) and `plan`, the plan's text.
#'
#' JSON: the top level contains `name` (of the gear), `conditions`, `converged`, `time_s`,
#' `measures`, `variables` (all other rows of the table), `findings` and `plan`. The file follows
#' the schema `system.file("schema", "state.schema.json", package = "codend")`. `codend settle
#' --json` writes the same content. `system.file("examples", package = "codend")` contains programs
#' in Python and Julia that read both formats.
#'
#' The NetCDF file of a trajectory has the dimension `time` too. Positions and velocities are over
#' the ground. It also contains
#'
#' - with `shielding`, `wake`: the fraction of the free flow speed at every point (nodes, then
#'   points that hang between two nodes);
#' - `vessel_x_m`, `vessel_y_m`, `vessel_speed_m_per_s` and `course_deg` at every time;
#' - `complete`: read only times with the value 1. A measure that is undefined at some time is NaN.
#'
#' Variables that start with `saved_` or `resume_` are for [read_result()] and [tow()] only. They
#' are plain data: reading evaluates no code. Functions of a schedule are not saved; supply them
#' again to continue a tow.
#'
#' A closed file ends in a checksum. A truncated or changed file, or a file in an older format, is
#' an error of class `codend_error_file`. NetCDF needs the package RNetCDF.
#'
#' @section VTK:
#' The cells are
#'
#' - lines: bars of ropes and netting;
#' - quadrilaterals and triangles: cells of netting;
#' - vertices: pieces;
#' - quadrilaterals: free otter boards in true size and attitude.
#'
#' Every cell has
#'
#' - `part`: number, from 1, of its rope, panel, piece or board; `kind`: 1 rope, 2 netting, 3 piece;
#' - `tension_N` of one line or twine, in cells of netting the larger of both twine families,
#'   otherwise NaN. It is negative in poles and struts under compression;
#' - `u_tension_N`, `v_tension_N` of both twine families, and in hexagonal meshes
#'   `straight_tension_N`;
#' - `lines`: number of parallel lines; `slack`: fraction of its twine families without tension;
#' - `drag_N`: hydrodynamic force as a vector, without drag of knots;
#' - `catch_force_N`, if there is catch in netting.
#'
#' Every point has `depth_m`, `force_N` (net force on its node) and `held`. With knots it has
#' `knot_drag_N`, in motion `velocity_m_per_s`. Nodes come first, in the order of
#' `as.data.frame(state, what = "nodes")`.
#'
#' The field data contain the measures, the part names (`part_names`, one line per part) and the
#' text of the `plan`, both as UTF-8 bytes. The grids of a trajectory are in a folder next to the
#' file, with the same name (`tow/0001.vtu` for `tow.pvd`). A folder with any other content is not
#' overwritten.
#'
#' @section glTF:
#' - Every rope, panel and piece is a node with its name in the plan. The node's extras are `kind`,
#'   `role` and, for ropes and netting, `largest_tension_N` of one line or twine. The scene's extras
#'   contain the measures.
#' - Lengths are in metres. glTF has y up, so the top node, named after the gear, rotates the gear
#'   by 90 deg about x. In the scene x is aft, y up and z to port.
#' - Colours are the same as in [view_3d()].
#' - A trajectory plays in real time, seen from the vessel, with at most 60 saved times. It has the
#'   colours of the first and the measures of the last time.
#'
#' @section MoorDyn:
#' MoorDyn has lines and bodies, but no netting.
#'
#' - Ropes laced to netting are omitted.
#' - Points with forces unknown to MoorDyn are `Fixed` at their position in the state, so that rope
#'   tensions agree. Such forces come from netting, poles, lift, boards, kites or loads.
#' - Other points are `Free`, with the mass, volume and drag area of their pieces.
#' - If water flows past the gear, `current_profile.txt` is written to the same folder. An existing
#'   profile of other water is an error.
#' - Drag coefficients that depend on the Reynolds number have their value at the greatest of the
#'   towing and current speeds, and at 1 m/s in still water.
#' - The damping of a line is at least critical (`-1`); with less, MoorDyn does not find an initial
#'   state.
#' - A gear without such ropes, with ropes through rings or on a sloping bed is an error.
#'
#' @param x A state ([settle()], [state_at()]) or a trajectory ([tow()]).
#' @param file Path of the file, which is written atomically. `read_result()` reads NetCDF, or the
#'   folder of a study ([vary()]).
#' @param ... For glTF: `colours = "tension"` (default), or `"part"` for a colour per part from a
#'   repeating series.
#' @return `write_result()` returns `file`, invisibly.
#'
#'   `read_result()` returns a state (class `codend_state`, see [settle()]) or a trajectory (class
#'   `codend_trajectory`, see [tow()]). If a run did not end, the trajectory contains all saved
#'   times and its `end` is `"interrupted"`. For the folder of a study it returns the finished
#'   designs (class `codend_variations`); damaged rows are left out with a warning of class
#'   `codend_warning_study`.
#'
#'   A file that cannot be read or written is an error of class `codend_error_file`. A missing
#'   RNetCDF is an error of class `codend_error_package`.
#' @seealso [view_3d()] for a page, [write_gear()] for plans.
#' @examples
#' state <- settle("towed_cable")
#' write_result(state, tempfile(fileext = ".vtu"))
#' @examplesIf requireNamespace("RNetCDF", quietly = TRUE)
#' file <- tempfile(fileext = ".nc")
#' write_result(state, file)
#' settle(update(read_gear("towed_cable"), towing.speed = "5 knot"), from = read_result(file))
#' @export
write_result <- function(x, file, ...) {
  check_given("x", "file")
  kind <- Find(function(kind) inherits(x, paste0("codend_", kind)), c("state", "trajectory"))
  if (is.null(kind)) {
    abort_argument(
      "{.arg x} must be a state or trajectory ({.fn settle}, {.fn tow}), not {.cls {class(x)}}."
    )
  }
  formats <- Filter(function(format) kind %in% format$of, c(export_formats, file_formats))
  check_file_path(file, vapply(formats, `[[`, "", "extension"))
  format_of_file(file, formats)$write(x, file, ...)
  invisible(file)
}

# Formats that the command line and the tank do not offer.
file_formats <- list(
  list(name = "trajectory", extension = ".nc", of = "trajectory", package = "RNetCDF",
    write = function(x, file) write_trajectory(x, file)),
  list(name = "moordyn", extension = ".txt", of = "state",
    write = function(x, file) write_moordyn(x, file))
)
