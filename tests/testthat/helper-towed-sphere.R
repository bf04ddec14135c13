# A sphere on one line of 10 m without weight or drag. With its drag D = C_D A rho v^2 / 2 and its
# weight in water W, the tension at the top is sqrt(D^2 + W^2). `...` replaces fields.
towed_sphere_plan <- function(...) {
  utils::modifyList(list(
    codend = 1, name = "Towed sphere", towing = list(speed = "2 m/s"),
    points = list(ship = list(position = c(0, 0, 0), held = "moved"), end = c(a = 1)[0]),
    ropes = list(line = list(
      from = "ship", to = "end", length = "10 m", diameter = "1 mm", axial_stiffness = "1200 MN",
      mass_per_length = 0, volume_per_length = 0, segments = 1,
      coefficients = list(normal = 0, tangential = 0, skin = 0)
    )),
    pieces = list(sphere = list(at = "end", mass = "200 kg", diameter = "0.5 m",
      volume = "0.01 m3")),
    measures = list(depth = list(depth = "end"), pull = list(tension = "line.start"))
  ), list(...))
}

# 30 floats of 60 N each lift a line of 20 m without weight: n floats pull with 60 n N.
buoyed_line <- function() {
  as_gear(list(
    codend = 1, name = "Buoyed line",
    points = list(anchor = list(position = c(0, 0, -50), held = "fixed"), top = c(a = 1)[0]),
    ropes = list(line = list(from = "anchor", to = "top", length = "20 m", diameter = "10 mm",
      axial_stiffness = "1 MN", mass_per_length = 0, volume_per_length = 0, segments = 4)),
    pieces = list(floats = list(at = "top", number = 30, buoyancy = "60 N", diameter = "25 cm",
      drag_coefficient = 0)),
    measures = list(pull = list(tension = "line.start"))
  ))
}
