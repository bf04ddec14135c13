# Class `codend_model`: a handle to the engine's mesh (Model in src/engine/model/model.hpp).
# `mesh$bars` copies a field. The handle is empty in another process and after readRDS(); files
# store a recipe to rebuild the mesh.

#' @export
`[[.codend_model` <- function(x, i, ...) engine_model_field(x, i)

#' @rawNamespace S3method(base::"$",codend_model)
`$.codend_model` <- function(x, name) x[[name]]

# Returns a copy of a mesh with changed fields (nested lists). NULL removes a field from its group.
changed_model <- function(model, fields) {
  before <- lapply(setNames(nm = names(fields)), function(name) model[[name]])
  engine_changed_model(model, utils::modifyList(before, fields))
}
