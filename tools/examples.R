# Runs the examples of README and guides in the order of each document: R and shell code of README,
# shell code of the guides. The lane `check` runs the R code of the guides. Works in a temporary
# folder, which is also the home of the shell. Fails if
# - a plan in README does not settle;
# - R code does not print the output that README quotes (#>);
# - a file that an example names does not exist afterwards.
#
#   Rscript tools/examples.R              all documents
#   Rscript tools/examples.R README.md    these documents

chosen <- commandArgs(TRUE)
documents <- c("README.md", Sys.glob(c("vignettes/*.Rmd", "vignettes/articles/*.Rmd")))
if (length(chosen)) documents <- chosen
root <- normalizePath(".")
folder <- tempfile("examples")
dir.create(file.path(folder, ".local", "bin"), recursive = TRUE)

# Returns the lines of a document with only the code of one language. Other lines are blank, so line
# numbers remain.
code_of <- function(lines, language) {
  fence <- startsWith(lines, "```")
  inside <- cumsum(fence) %% 2L == 1L
  language_of <- c(NA, trimws(sub("^```", "", lines[fence])))[cumsum(fence) + 1L]
  ifelse(inside & !fence & language_of == language, lines, "")
}

# Runs a command in the folder. Returns TRUE if it fails, after printing its output.
fails <- function(name, command, arguments, environment = character()) {
  here <- setwd(folder)
  on.exit(setwd(here))
  log <- file.path(folder, "log")
  status <- system2(command, arguments, stdout = log, stderr = log, stdin = "/dev/null",
    env = environment)
  if (status != 0L) {
    cat(name, "failed at the last line of code below:\n")
    cat(paste("   ", utils::tail(readLines(log, warn = FALSE), 40L)), sep = "\n")
  }
  status != 0L
}

run_r <- function(file, lines) {
  script <- file.path(folder, "example.R")
  code <- code_of(lines, "r")
  writeLines(code, script)
  session <- file.path(root, "tools", "examples", "session.R")
  if (fails(paste(file, "(R)"), "Rscript", c("--vanilla", session))) return(TRUE)
  quoted <- trimws(sub("^#>", "", grep("^#>", code, value = TRUE)))
  printed <- trimws(readLines(file.path(folder, "log"), warn = FALSE))
  differ <- setdiff(quoted, printed)
  cat(sprintf("%s: the code does not print: %s\n", file, differ), sep = "")
  length(differ) > 0L
}

run_shell <- function(file, lines) {
  script <- file.path(folder, "example.sh")
  writeLines(code_of(lines, "sh"), script)
  fails(paste(file, "(shell)"), "bash", file.path(root, "tools", "examples", "session.sh"),
    c(paste0("HOME=", shQuote(folder)), paste0("ROOT=", shQuote(root)), paste0("DOCUMENT=", file)))
}

run_plan <- function(file, lines) {
  writeLines(code_of(lines, "yaml"), file.path(folder, "plan.yaml"))
  settle <- shQuote("codend::settle('plan.yaml', nodes = 300)")
  fails(paste(file, "(plan)"), "Rscript", c("-e", settle))
}

# Returns the file names in code, without its comments.
named_files <- function(code) {
  code <- sub("#.*", "", code)
  pattern <- "[A-Za-z_][A-Za-z0-9_]*[.](html|png|nc|vtu|pvd|glb|svg|pdf|dxf|yaml|json|csv|study)\\b"
  unique(unlist(regmatches(code, gregexpr(pattern, code))))
}

run_document <- function(file) {
  lines <- readLines(file, encoding = "UTF-8")
  readme <- file == "README.md"
  parts <- list(r = run_r, sh = run_shell, yaml = run_plan)
  code <- lapply(stats::setNames(nm = names(parts)), code_of, lines = lines)
  used <- vapply(code, function(code) any(nzchar(code)), NA) & c(readme, TRUE, readme)
  failed <- vapply(parts[used], function(run) run(file, lines), NA)
  named <- if (!any(failed)) named_files(unlist(code[setdiff(names(parts)[used], "yaml")]))
  absent <- named[!file.exists(file.path(folder, named))]
  cat(sprintf("%s: no example writes %s\n", file, absent), sep = "")
  any(failed) || length(absent) > 0L
}

failed <- vapply(documents, run_document, NA)
unlink(folder, recursive = TRUE)
cat(sprintf("%d passed, %d failed, 0 skipped\n", sum(!failed), sum(failed)))
quit(status = any(failed))
