check_netcdf <- function() check_package("RNetCDF", "A NetCDF file")

# Writes the classic format with 64-bit offsets. fill: function(nc) that defines and writes
# variables.
write_netcdf <- function(file, fill) write_file(file, function(path) fill_netcdf(path, fill))

fill_netcdf <- function(path, fill) {
  nc <- RNetCDF::create.nc(path, format = "offset64")
  fill(nc)
  close_netcdf(nc)
}

# On a full disk close.nc() fails, and its leaked memory ends R at the next garbage collection. So
# all data are written first. If that fails, the file stays open and is collected later.
close_netcdf <- function(nc) {
  RNetCDF::sync.nc(nc)
  RNetCDF::close.nc(nc)
}

# Writes a variable. Empty variables are not in the file.
put <- function(nc, name, value, start = NA, count = NA) {
  if (length(value) == 0L) return(invisible())
  RNetCDF::var.put.nc(nc, name, value, start, count, na.mode = 3)
}
