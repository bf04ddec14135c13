# Registers the C++ functions of src/binding*.cpp: writes src/cpp11.cpp and R/cpp11.R. Lines of
# R/cpp11.R that exceed 100 columns are wrapped at a comma.
#   Rscript tools/register.R

cpp11::cpp_register(quiet = TRUE)

wrap <- function(line, most = 100L) {
  if (nchar(line) <= most) return(line)
  commas <- gregexpr(", ", line, fixed = TRUE)[[1L]]
  at <- max(commas[commas <= most])
  c(substr(line, 1L, at), wrap(paste0("    ", substr(line, at + 2L, nchar(line)))))
}
file <- file.path("R", "cpp11.R")
writeLines(unlist(lapply(readLines(file), wrap)), file)
