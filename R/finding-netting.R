define_finding("cells finer than meshes", "state",
  "The elements of a panel of `cells` are smaller than one mesh of the netting. Cells represent many
  meshes each; use `netting: bars` if the meshes are as large as the elements. On the shipped
  midwater trawl, with 32 m front meshes, cells give 3.6 % less drag than bars at any resolution.",
  function(gear, state) {
    model <- state$mesh$model
    if (!length(model$cells$rest)) return(list())
    panel <- cell_panel(state$si, state$mesh)
    plain <- model$cells$straight == 0
    bars_a_mesh <- 2 - is_square(panel_table(state$si$panels))
    meshes <- cell_bars(model$cells) / bars_a_mesh[panel]
    held <- vapply(split(meshes[plain], panel[plain]), stats::median, 0)
    # Skip panels for which bars would change more than the mesh size.
    stays <- vapply(state$si$panels, function(p) {
      !is.null(p$opening_stiffness) && !isTRUE(p$opening_stiffness$assumed)
    }, NA) |
      names(state$si$panels) %in% state$si$catch$panels
    held <- held[!stays[as.integer(names(held))]]
    if (!length(held) || min(held) >= 1) return(list())
    name <- names(state$si$panels)[as.integer(names(which.min(held)))]
    list(finding(paste("panel", name), min(held), figures(min(held)),
      template("each of its cells has only {n} meshes.", n = figures(min(held))),
      "Model this netting mesh by mesh (netting: bars)."))
  },
  rank = 3L
)
