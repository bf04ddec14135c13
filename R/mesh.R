# The mesh of a gear, which the engine holds (Model in src/engine/model/model.hpp). R has a handle
# of class codend_mesh to it: `mesh$bars` is a copy of a field. A handle is empty in another process
# and after readRDS(); what is kept is the recipe from which a mesh is built again.

#' @export
`[[.codend_mesh` <- function(x, i, ...) engine_mesh_field(x, i)

#' @rawNamespace S3method(base::"$",codend_mesh)
`$.codend_mesh` <- function(x, name) x[[name]]

# A mesh like another with other values of some fields, as nested lists; NULL takes one out of its
# group.
changed_mesh <- function(mesh, fields) {
  before <- lapply(setNames(nm = names(fields)), function(name) mesh[[name]])
  engine_changed_mesh(mesh, utils::modifyList(before, fields))
}
