# Units that plans accept: the SI unit of each dimension first, then factors to it.
plan_units <- list(
  length = c(
    m = 1, metre = 1, metres = 1, meter = 1, meters = 1,
    mm = 1e-3, millimetre = 1e-3, millimetres = 1e-3, millimeter = 1e-3, millimeters = 1e-3,
    cm = 1e-2, centimetre = 1e-2, centimetres = 1e-2, centimeter = 1e-2, centimeters = 1e-2,
    km = 1e3, kilometre = 1e3, kilometres = 1e3, kilometer = 1e3, kilometers = 1e3,
    ft = 0.3048, foot = 0.3048, feet = 0.3048, "in" = 0.0254, inch = 0.0254, inches = 0.0254,
    fathom = 1.8288, fathoms = 1.8288, fm = 1.8288,
    "nautical mile" = 1852, "nautical miles" = 1852, nmi = 1852
  ),
  area = c(m2 = 1, cm2 = 1e-4, mm2 = 1e-6),
  volume = c(m3 = 1, litre = 1e-3, litres = 1e-3, liter = 1e-3, liters = 1e-3, l = 1e-3, L = 1e-3),
  mass = c(
    kg = 1, kilogram = 1, kilograms = 1, g = 1e-3, gram = 1e-3, grams = 1e-3,
    t = 1e3, tonne = 1e3, tonnes = 1e3, lb = 0.45359237, lbs = 0.45359237
  ),
  force = c(
    N = 1, newton = 1, newtons = 1, kN = 1e3, MN = 1e6,
    kgf = 9.80665, tf = 9806.65, tonnef = 9806.65, lbf = 4.4482216152605
  ),
  speed = c(
    "m/s" = 1, knot = 1852 / 3600, knots = 1852 / 3600, kn = 1852 / 3600, kt = 1852 / 3600,
    kts = 1852 / 3600, "km/h" = 1 / 3.6
  ),
  density = c("kg/m3" = 1, "g/cm3" = 1e3),
  mass_per_length = c("kg/m" = 1, "g/m" = 1e-3, "kg/100 m" = 1e-2),
  bending_stiffness = c("N m2" = 1, "kN m2" = 1e3, "MN m2" = 1e6),
  viscosity = c("m2/s" = 1),
  power = c(W = 1, kW = 1e3, MW = 1e6, hp = 745.69987, PS = 735.49875),
  consumption = c("kg/J" = 1, "g/kWh" = 1e-3 / 3.6e6),
  stress = c(Pa = 1, kPa = 1e3, MPa = 1e6, GPa = 1e9),
  # setNames() is needed: in a C locale an argument name loses the degree sign.
  angle = stats::setNames(
    c(1, 1, 1, pi / 180, pi / 180, pi / 180, pi / 180),
    c("rad", "radian", "radians", "deg", "degree", "degrees", "\u00b0")
  ),
  time = c(
    s = 1, second = 1, seconds = 1, min = 60, minute = 60, minutes = 60,
    h = 3600, hour = 3600, hours = 3600
  ),
  number = c("%" = 0.01, percent = 0.01)
)

# Largest allowed quantities, SI: far beyond any gear, so that forces cannot overflow. Towed sonars,
# the fastest gears, reach 15 m/s.
plan_largest <- c(
  length = 1e7, area = 1e12, volume = 1e15, mass = 1e12, force = 1e18, speed = 30, density = 1e6,
  mass_per_length = 1e9, bending_stiffness = 1e15, viscosity = 1e3, power = 1e12,
  consumption = 1, stress = 1e15, angle = 1e3, time = 1e10, number = 1e12
)

quantity_pattern <- paste0(
  "^[[:space:]]*([-+]?(?:[0-9]+[.]?[0-9]*|[.][0-9]+)(?:[eE][-+]?[0-9]+)?)",
  "[[:space:]]*([^[:space:]0-9].*?)?[[:space:]]*$"
)

# Returns a unit in the spelling of `plan_units`: superscripts and carets become plain digits.
plain_unit <- function(unit) {
  if (grepl("[^A-Za-z0-9/]", unit)) {
    unit <- gsub("\u00b2", "2", unit, fixed = TRUE)
    unit <- gsub("\u00b3", "3", unit, fixed = TRUE)
    unit <- gsub("^", "", unit, fixed = TRUE)
    unit <- gsub("[[:space:]]*/[[:space:]]*", "/", unit)
    unit <- gsub("[[:space:]]+", " ", unit)
  }
  if (unit == "kg/100m") "kg/100 m" else unit
}

# Returns number and unit of a string such as "4.5 knot" (unit "" if there is none), or NULL.
split_quantity <- function(text) {
  found <- regexpr(quantity_pattern, text, perl = TRUE)
  if (found == -1) return(NULL)
  start <- attr(found, "capture.start")
  substring(text, start, start + attr(found, "capture.length") - 1)
}

# Returns the SI value of a quantity, given as a number (already SI) or as a string with a unit. NA
# if `value` does not have this dimension.
quantity_si <- function(value, dimension) {
  if (is.numeric(value)) return(as.double(value))
  found <- split_quantity(value)
  if (is.null(found)) return(NA_real_)
  number <- as.double(found[1])
  if (!nzchar(found[2])) return(number)
  number * plan_units[[dimension]][plain_unit(found[2])][[1]]
}

# TRUE for angles without a unit that are beyond a turn in rad: they are nearly always degrees.
in_bare_degrees <- function(value, si, dimension) {
  if (dimension != "angle") return(logical(length(si)))
  bare <- is.numeric(value) | !grepl("[^-+0-9.eE[:space:]]", value)
  bare & !is.na(si) & abs(si) > 2 * pi * (1 + 1e-9)
}

# Describes the allowed values in the error about such an angle.
bare_degrees_text <- function(value) {
  number <- trimws(if (is.numeric(value)) shortest_decimal(value) else value)
  sprintf("from -2 pi to 2 pi without a unit (rad). Write \"%s deg\" for degrees", number)
}

# Returns the dimension of a quantity string from its unit, or NA.
quantity_dimension <- function(text) {
  found <- split_quantity(text)
  if (is.null(found)) return(NA_character_)
  holds <- vapply(plan_units, function(u) plain_unit(found[2]) %in% names(u), logical(1))
  if (any(holds)) names(plan_units)[holds][1] else NA_character_
}

# Returns an SI number as a string for messages, for example "4 m".
format_si <- function(value, dimension) {
  unit <- if (dimension == "number") "" else paste0(" ", names(plan_units[[dimension]])[1])
  paste0(with_plain_numbers(format(value, digits = 6, trim = TRUE, scientific = 2L)), unit)
}

# Returns a bound (SI) as a string in the unit of a given value, or in SI if it has no unit.
format_like <- function(bound, dimension, value) {
  unit <- if (is_text(value)) plain_unit(first_of(split_quantity(value)[2L], ""))
  factor <- if (length(unit) && nzchar(unit)) plan_units[[dimension]][unit]
  if (is.null(factor) || is.na(factor)) return(format_si(bound, dimension))
  paste(with_plain_numbers(format(bound / factor[[1L]], digits = 6, trim = TRUE)), unit)
}
