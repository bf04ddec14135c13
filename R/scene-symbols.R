# Symbols of pieces and supports for plane figures and the viewer. `fill` has a dark edge. `solid`
# has no edge in the viewer, so it is dark enough without.
view_symbols <- data.frame(
  role = c(
    "otter_board", "kite", "hammer", "float", "canvas", "catch", "weight", "sinker", "ring", "hook",
    "shoe_end", "other", "moved", "fixed"
  ),
  label = c(
    "otter board", "kite", "hammer", "float", "canvas", "catch", "weight", "sinker", "ring", "hook",
    "shoe", "other piece", "towing point", "fixed point"
  ),
  symbol = c(22L, 24L, 25L, 21L, 24L, 23L, 21L, 21L, 1L, 6L, 15L, 4L, 13L, 7L),
  fill = c(
    "#202428", "#202428", "#202428", "#FFFFFF", "#FFE14D", "#8A5A2B", "#5B636A", "#5B636A",
    "#5B636A", "#5B636A", "#5B636A", "#5B636A", "#2C6E9B", "#2C6E9B"
  ),
  solid = c(
    "#3D4A54", "#3D4A54", "#474F56", "#C2410C", "#7A6400", "#5E6B70", "#474F56", "#474F56",
    "#6B5A2E", "#474F56", "#474F56", "#5B636A", "#2C6E9B", "#2C6E9B"
  ),
  size = c(1.3, 1.3, 1.1, 0.7, 1.1, 1.3, 1.1, 0.7, 0.7, 0.5, 0.8, 1, 1.2, 1.1)
)

# Returns the symbols of roles; unknown roles use the symbol of other pieces.
symbol_of <- function(role) {
  known <- ifelse(role %in% view_symbols$role, role, "other")
  view_symbols[match(known, view_symbols$role), ]
}
