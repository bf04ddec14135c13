# The mesh of a gear, which the engine holds (Model in src/engine/model/model.hpp). R has a handle
# of class codend_mesh to it: `mesh$bars` is a copy of a field. A handle is empty in another process
# and after readRDS(); what is kept is the recipe from which a mesh is built again.

#' @export
`[[.codend_mesh` <- function(x, i, ...) engine_mesh_field(x, i)

#' @rawNamespace S3method(base::"$",codend_mesh)
`$.codend_mesh` <- function(x, name) x[[name]]

# A mesh from all of its fields, and these. like: NULL, or the mesh that it differs from.
new_mesh <- function(fields, like = NULL) engine_mesh(fields, like)
mesh_fields <- function(mesh) engine_mesh_fields(mesh)

# A mesh like another with other values of some fields, as nested lists; NULL takes one out.
changed_mesh <- function(mesh, fields) {
  new_mesh(utils::modifyList(mesh_fields(mesh), fields), mesh)
}
