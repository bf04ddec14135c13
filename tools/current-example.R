# Writes inst/extdata/current_cf.nc, an artificial current off Norway in the format of ocean
# services: packed values, land, 5 depths, 3 hours. Tests compute the same current:
#   eastward  = 0.4 exp(-depth / 50) + 0.01 hour, northward = 0.1 - 0.001 depth (m/s)
#   Rscript tools/current-example.R

east <- c(4.5, 4.75, 5, 5.25)
north <- c(60, 60.25, 60.5)
depth <- c(0, 10, 25, 50, 100)
hour <- c(0, 1, 2)
file <- "inst/extdata/current_cf.nc"
nc <- RNetCDF::create.nc(file, format = "classic")
axis <- function(name, values, units, standard, more = list()) {
  RNetCDF::dim.def.nc(nc, name, length(values))
  RNetCDF::var.def.nc(nc, name, "NC_DOUBLE", name)
  said <- c(list(units = units, standard_name = standard), more)
  for (one in names(said)) RNetCDF::att.put.nc(nc, name, one, "NC_CHAR", said[[one]])
}
axis("lon", east, "degrees_east", "longitude")
axis("lat", north, "degrees_north", "latitude")
axis("depth", depth, "m", "depth", list(positive = "down"))
axis("time", hour, "hours since 2026-05-03 13:00:00", "time", list(calendar = "standard"))
axes <- c("lon", "lat", "depth", "time")
land <- array(FALSE, c(length(east), length(north), length(depth), length(hour)))
land[4, , , ] <- TRUE  # east of 5.1
land[, , 5, ] <- TRUE  # shallower than 100 m
at <- function(values, k) array(aperm(array(values, dim(land)[c(k, setdiff(1:4, k))]),
  order(c(k, setdiff(1:4, k)))), dim(land))
d <- at(depth, 3)
t <- at(hour, 4)
current <- list(
  uo = list("eastward_sea_water_velocity", 0.4 * exp(-d / 50) + 0.01 * t),
  vo = list("northward_sea_water_velocity", 0.1 - 0.001 * d)
)
for (name in names(current)) {
  RNetCDF::var.def.nc(nc, name, "NC_SHORT", axes)
  RNetCDF::att.put.nc(nc, name, "standard_name", "NC_CHAR", current[[name]][[1]])
  RNetCDF::att.put.nc(nc, name, "units", "NC_CHAR", "m s-1")
  RNetCDF::att.put.nc(nc, name, "scale_factor", "NC_DOUBLE", 1e-4)
  RNetCDF::att.put.nc(nc, name, "add_offset", "NC_DOUBLE", 0)
  RNetCDF::att.put.nc(nc, name, "_FillValue", "NC_SHORT", -32767)
}
along <- list(lon = east, lat = north, depth = depth, time = hour)
for (name in names(along)) RNetCDF::var.put.nc(nc, name, along[[name]])
for (name in names(current)) {
  packed <- round(current[[name]][[2]] / 1e-4)
  packed[land] <- -32767
  RNetCDF::var.put.nc(nc, name, packed)
}
RNetCDF::close.nc(nc)
