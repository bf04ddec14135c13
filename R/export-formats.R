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
    opens = "the web and CAD", write = function(x, file, ...) write_gltf(x, file, write_glb, ...)),
  list(name = "gltf", extension = ".gltf", of = c("state", "trajectory"), title = "Scene as text",
    opens = "the web and CAD",
    write = function(x, file, ...) write_gltf(x, file, write_gltf_text, ...)),
  list(name = "netcdf", extension = ".nc", of = "state", title = "State",
    opens = "codend and readers of NetCDF", package = "RNetCDF",
    write = function(x, file) write_state(x, file)),
  list(name = "json", extension = ".json", of = "state", title = "State as JSON",
    opens = "Python and other languages", write = function(x, file) write_state_json(x, file)),
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
format_of_file <- function(file, formats = export_formats) {
  extension <- tolower(sub("^.*(?=[.])", "", basename(file), perl = TRUE))
  Find(function(format) format$extension == extension, formats)
}

# The formats of states or trajectories as a sentence's list.
formats_text <- function(of) {
  paste(vapply(formats_of(of), function(format) {
    sprintf("%s (%s, for %s)", format$extension, tolower(format$title), format$opens)
  }, ""), collapse = ", ")
}

#' Results in files
#'
#' Writes a state or a trajectory to a file for other programs, or for [read_result()], which gives
#' it back to the last bit. The end of the file's name chooses the format:
#'
#' | end of the name | what is written | for |
#' |---|---|---|
#' | `.nc` | all numbers as NetCDF, CF conventions | [read_result()], most languages |
#' | `.json` | the same of a state as JSON | languages without a reader of NetCDF |
#' | `.vtu` | a state as an unstructured grid of VTK | ParaView, VisIt |
#' | `.pvd` | a trajectory as a series of such grids | ParaView |
#' | `.glb`, `.gltf` | the scene in glTF 2.0, animated for a trajectory | web, Blender, CAD |
#' | `.csv` | tensions of every line of a state | spreadsheets |
#' | `.txt` | ropes of a state as input of MoorDyn 2 | MoorDyn, [read_moordyn()] |
#'
#' @section NetCDF and JSON:
#' Dimensions are `node`, `bar`, `cell` and `part`, and of a trajectory `time`. Per node there are
#' `x`, `y`, `z` (m; of a state x aft, y to starboard, z up from the water surface; of a trajectory
#' over the ground), `x_force`, `y_force`, `z_force` (N, the net force: on a held node the opposite
#' of its support's), `held` and, in motion, velocities (m/s); per bar `bar_tension` (N, of one
#' line); per cell of netting `u_tension` and `v_tension` (N, of one twine). `bar_node` and
#' `cell_node` say which nodes they join, counted from 1, `bar_part` and `cell_part` which of the
#' parts in `part_name` they belong to. Numbers above that of the last node are points that hang
#' between two nodes. Per part there are `part_drag`, `part_side` and `part_lift` (kN, hydrodynamic
#' force along the flow, to starboard of it and up). Every measure is a number of its own, under
#' its name. The attribute `plan` is the gear's plan as text.
#'
#' A trajectory also has `straight_tension` per cell of hexagonal meshes, which are those that
#' `hexagonal_cell` numbers; with `shielding`, `wake` per point (the nodes, then the points that
#' hang between two nodes), the fraction of the free flow's speed there; per time `vessel_x`,
#' `vessel_y` (m), `vessel_speed` (m/s) and `course` (rad). A measure that the gear does not have
#' at some time is NaN there. Read only times at which `complete` is 1.
#'
#' What is named `kept_` and `resume_` serves [read_result()] and [tow()] alone: plain data, and
#' reading evaluates nothing. Functions of a schedule are not kept: give them again to go on. A
#' file that was closed ends in a checksum of all bytes before it; one that was cut short or
#' changed is an error of class `codend_error_file`, and so is one of an older format. NetCDF needs
#' the package RNetCDF. JSON follows the schema `system.file("schema", "state.schema.json", package
#' = "codend")`.
#'
#' @section VTK:
#' Cells are lines (bars of ropes and of netting), quadrilaterals and triangles (of netting that is
#' divided into cells), vertices (where pieces sit) and quadrilaterals again (free otter boards, in
#' their true size and attitude). Every cell has
#'
#' - `part`, the rope, panel, piece or board of the plan that it belongs to, as a number from 1; and
#'   `kind`: 1 rope, 2 netting, 3 piece;
#' - `tension_N` of one line or twine, in cells of netting the larger of the two families of twine,
#'   which are `u_tension_N` and `v_tension_N` (in hexagonal meshes also `straight_tension_N`), NaN
#'   in other cells; negative in poles and struts that push;
#' - `lines`, how many run in parallel, and `slack`, the fraction of its families without tension;
#' - `drag_N`, the hydrodynamic force on it as a vector, without that on knots; where there is a
#'   catch in netting, `catch_force_N`.
#'
#' Every point has `depth_m`; `force_N`, the net force on its node; `held`; with knots
#' `knot_drag_N`; in motion `velocity_m_per_s`. The first points are the nodes, in their order in
#' `as.data.frame(state, what = "nodes")`. The field data hold the measures, the names of all parts
#' as `part_names` and the text of the `plan`: both as bytes of UTF-8, with a line per part. Grids
#' of a trajectory lie next to the file in a folder of the same name (`tow/0001.vtu` for
#' `tow.pvd`); a folder that holds anything else is left alone.
#'
#' @section glTF:
#' The scene has a node for every rope, panel and piece, named as in the plan; its extras hold
#' `kind` and `role`, and of ropes and netting `largest_tension_N` of one line or twine. The
#' scene's extras hold the measures. Lengths are metres. glTF has y up, so the node above all
#' others, named after the gear, turns the gear by a quarter about x: x is aft, y up and z to port.
#' Colours are those of [view_3d()]. A trajectory plays in its own time, seen from the vessel, at
#' up to 60 kept times. Colours are those of the first time, measures those of the last.
#'
#' @section MoorDyn:
#' MoorDyn has lines and bodies, but no netting. Ropes that are laced to netting are left out, and a
#' point on which something acts that MoorDyn does not have (netting, a pole, lift, a board or kite,
#' a load) is `Fixed` where it is in the state, so tensions of the ropes agree. Other points are
#' `Free`, with the mass, the volume and the drag area of their pieces. Where water flows past the
#' gear, `current_profile.txt` is written to the same folder; one of other water that is there
#' already is an error. The damping of a line is at least critical, `-1`, without which MoorDyn
#' finds no start. A gear without such ropes, with ropes through rings or on a bed that slopes is an
#' error.
#'
#' @param x A state, from [settle()] or [state_at()], or a trajectory, from [tow()].
#' @param file Path of the file; `read_result()` reads NetCDF. It is written whole or not at all.
#' @param ... Of glTF: `colours`, `"tension"` or `"part"`, one colour for every part, in turns.
#' @return `write_result()` gives `file`, invisibly. `read_result()` gives a state as [settle()]
#'   returns it, or a trajectory as [tow()] does; of a run that did not end, one with all that was
#'   kept, whose `end` is `"interrupted"`. A file that cannot be read or written is an error of
#'   class `codend_error_file`; a missing RNetCDF one of class `codend_error_package`.
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
  check_exported(x, c("state", "trajectory"))
  kind <- if (inherits(x, "codend_state")) "state" else "trajectory"
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
