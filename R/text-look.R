# Bold text on a terminal.

# TRUE if cli must decide on colours and Unicode. Loading cli takes as long as settling a small
# gear, and output to a file or another program has neither.
cli_knows_more <- function() {
  wishes <- list(getOption("cli.num_colors"), getOption("cli.unicode"))
  interactive() || isatty(stdout()) || any(lengths(wishes) > 0L) ||
    nzchar(Sys.getenv("R_CLI_NUM_COLORS")) ||
    isNamespaceLoaded("cli") || isNamespaceLoaded("knitr")
}

bold <- function(text) if (cli_knows_more()) cli::style_bold(text) else text
