# The table next to panels: heading, component and field of each column, and its alignment.
panel_columns <- data.frame(
  name = c("part", "deep", "mesh", "twine"), heading = c("", "deep", "mm", "Rtex"),
  component = c("panel", "meshes", "mesh_size", "twine"),
  field = c("", ".meshes.deep", ".mesh_size", ".twine.diameter"), across = c(0, 1, 1, 0)
)

# Returns the table entries of a panel.
panel_text <- function(name, si) {
  panel <- si$panels[[name]]
  c(
    part = gsub("_", " ", if (is.na(panel$part)) general_name(name) else panel$part),
    deep = mesh_number(panel$deep), mesh = short_number(in_unit(panel$mesh_size, "mm"), 6),
    twine = trimws(paste(rtex_text(panel), mesh_text(panel)))
  )
}

# Returns a panel's twine by its mass per length in tex (ISO 858), such as "R7680 PE" or "2 x R3430
# PE". unit: suffix of the number.
rtex_text <- function(panel, unit = "") {
  each <- panel$mass_per_length / panel$twine_count * 1e6
  paste0(
    if (panel$twine_count > 1) paste0(panel$twine_count, " x "),
    "R", short_number(each, 3), unit,
    if (!is.na(panel$material)) paste0(" ", material_text(panel$material))
  )
}

# Returns the cutting rates of a panel's left and right edges: from the plan, otherwise the simplest
# rate that matches the counts. given: the checked fields of the panel.
drawn_rates <- function(panel, given) {
  lost <- c(left = panel$lost_left, right = panel$lost_right)
  vapply(names(lost), function(side) {
    stated <- given$cutting
    if (is_map(stated)) stated <- stated[[side]]
    cut <- abs(lost[[side]]) > 1e-9
    if (is_text(stated) && (cut || stated %in% c("AN", "AT"))) return(gsub(" ", "", stated))
    simple_cutting_rate(lost[[side]], panel$deep, panel$orientation)
  }, "")
}

wall_text <- function(name, si) {
  panel <- si$panels[[name]]
  across <- unique(mesh_number(c(panel$upper, panel$lower)))
  c(
    name = gsub("_", " ", name),
    meshes = paste(paste(across, collapse = "/"), "x", mesh_number(panel$deep), "meshes"),
    mesh_size = paste(short_number(in_unit(panel$mesh_size, "mm"), 6), "mm"),
    twine = trimws(paste(rtex_text(panel, "tex"), mesh_text(panel)))
  )
}
