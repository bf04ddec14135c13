# NetCDF files, which take the package RNetCDF.

check_netcdf <- function() check_package("RNetCDF", "A NetCDF file")

# A file in the classic format with 64-bit offsets; fill: a function(nc) that defines and puts all.
write_netcdf <- function(file, fill) write_file(file, function(path) fill_netcdf(path, fill))

fill_netcdf <- function(path, fill) {
  nc <- RNetCDF::create.nc(path, format = "offset64")
  fill(nc)
  close_netcdf(nc)
}

# On a full disk close.nc() fails, and the memory that it leaves behind ends R at the next garbage
# collection. So all is written first: where that fails, the file is left open and collected.
close_netcdf <- function(nc) {
  RNetCDF::sync.nc(nc)
  RNetCDF::close.nc(nc)
}

# Nothing is written where there is nothing to write: such a variable is not in the file.
put <- function(nc, name, value, start = NA, count = NA) {
  if (length(value) == 0L) return(invisible())
  # without a change to what is missing
  RNetCDF::var.put.nc(nc, name, value, start, count, na.mode = 3)
}
