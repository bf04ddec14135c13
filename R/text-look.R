# How text may look where it is read: bold on a terminal.

# Whether cli has anything to say on it: loading it takes as long as settling a small gear, and
# where a script's output goes to a file or another program the answers are known.
cli_knows_more <- function() {
  wishes <- list(getOption("cli.num_colors"), getOption("cli.unicode"))
  interactive() || isatty(stdout()) || any(lengths(wishes) > 0L) ||
    nzchar(Sys.getenv("R_CLI_NUM_COLORS")) ||
    isNamespaceLoaded("cli") || isNamespaceLoaded("knitr")
}

bold <- function(text) if (cli_knows_more()) cli::style_bold(text) else text
