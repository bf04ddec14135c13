# Builds the site with pkgdown, without network access, into `site` or the given folder:
#   Rscript tools/site.R [folder]
# Needs codend installed from these sources. Fails if a link or a picture has no target, on the site
# or in a Markdown file of the sources.

folder <- c(commandArgs(TRUE), "site")[1]
options(pkgdown.internet = FALSE)
dir.create(folder, FALSE, TRUE)
destination <- normalizePath(folder)
# Use the guides knitted by `make guides`, so that pkgdown does not run them again.
if (system2("make", c("-s", "guides")) != 0L) stop("Knitting the guides failed.")
sources <- tempfile("sources")
dir.create(sources)
linked <- setdiff(list.files("."), c("vignettes", "out", "site"))
stopifnot(file.symlink(normalizePath(linked), file.path(sources, linked)))
dir.create(file.path(sources, "vignettes"))
invisible(file.copy(list.files("out/guides", full.names = TRUE), file.path(sources, "vignettes"),
  recursive = TRUE))
site <- pkgdown::as_pkgdown(sources, list(destination = destination))
pkgdown::init_site(site)
# pkgdown does not copy the gallery pictures and reports them as missing.
invisible(file.copy("gallery", site$dst_path, recursive = TRUE))
# Write a live page for every shipped gear, and its picture with a link to the page.
live <- file.path(site$dst_path, "live")
dir.create(live, showWarnings = FALSE)
shipped <- codend::gears()
figures <- Map(function(gear, title) {
  state <- suppressWarnings(codend::settle(gear, nodes = 600))
  page <- paste0("live/", gear, ".html")
  codend::share(state, file.path(site$dst_path, page))
  file.copy(system.file("app", "gears", paste0(gear, ".webp"), package = "codend"), live)
  sprintf('<figure><a href="%s"><img src="live/%s.webp" alt=""/><br/>%s: try it now</a></figure>',
    page, gear, title)
}, shipped$name, shipped$title)
withCallingHandlers(
  pkgdown::build_home(site, quiet = TRUE),
  warning = function(said) {
    if (grepl("Missing images", conditionMessage(said))) tryInvokeRestart("muffleWarning")
  }
)
index <- file.path(site$dst_path, "index.html")
text <- paste(readLines(index, encoding = "UTF-8", warn = FALSE), collapse = "\n")
writeLines(sub('(<div class="gallery">)', paste0("\\1", paste(figures, collapse = "\n")), text),
  index, useBytes = TRUE)
pkgdown::build_reference(site, devel = FALSE)
pkgdown::build_articles(site, quiet = TRUE)
pkgdown::build_news(site)

# CONTRIBUTING.md links to source files that the site lacks: replace these links by their text.
# Links to missing source files remain and fail below.
in_sources <- function(targets) {
  file.exists(targets) | file.exists(sub("[.]html$", ".md", targets))
}
for (page in list.files(site$dst_path, "[.]html$", full.names = TRUE)) {
  text <- paste(readLines(page, encoding = "UTF-8", warn = FALSE), collapse = "\n")
  links <- unique(regmatches(text, gregexpr('<a href="[^"#:]+">', text))[[1]])
  aims <- sub('<a href="([^"]*)">', "\\1", links)
  for (link in links[!file.exists(file.path(site$dst_path, aims)) & in_sources(aims)]) {
    parts <- strsplit(text, link, fixed = TRUE)[[1]]
    parts[-1] <- sub("</a>", "", parts[-1], fixed = TRUE)
    text <- paste(parts, collapse = "")
  }
  writeLines(text, page, useBytes = TRUE)
}

pages <- list.files(site$dst_path, "[.]html$", full.names = TRUE, recursive = TRUE)
pages <- stats::setNames(lapply(pages, xml2::read_html), normalizePath(pages))
attributes_of <- function(html, name) {
  xml2::xml_text(xml2::xml_find_all(html, paste0("//@", name)))
}
ids <- lapply(pages, attributes_of, "id")

# Returns the targets of links, pictures and scripts of a page that the site lacks.
dead_targets <- function(page) {
  targets <- unlist(lapply(c("href", "src"), attributes_of, html = pages[[page]]))
  targets <- unique(targets[!grepl("^([a-z]+:|//)", targets)])
  if (!length(targets)) return(NULL)
  file <- utils::URLdecode(sub("[?#].*", "", targets))
  file <- ifelse(nzchar(file), file.path(dirname(page), file), page)
  file <- normalizePath(file, mustWork = FALSE)
  anchor <- ifelse(grepl("#.", targets), utils::URLdecode(sub("^[^#]*#", "", targets)), NA)
  lacks_anchor <- mapply(function(file, anchor) {
    !is.na(anchor) && file %in% names(ids) && !anchor %in% ids[[file]]
  }, file, anchor)
  targets[!file.exists(file) | lacks_anchor]
}

# Returns the targets of links of a Markdown file that the sources lack.
dead_files <- function(file) {
  text <- paste(readLines(file, encoding = "UTF-8", warn = FALSE), collapse = "\n")
  links <- regmatches(text, gregexpr("\\]\\([^)#: ]+[)#]", text))[[1]]
  targets <- unique(substring(links, 3L, nchar(links) - 1L))
  targets[!file.exists(file.path(dirname(file), targets))]
}

# pkgdown/index.md is the front page of the site. It links to pages of the site and is checked
# there.
markdown <- setdiff(system2("git", c("ls-files", "'*.md'"), stdout = TRUE), "pkgdown/index.md")
dead <- c(
  lapply(stats::setNames(nm = names(pages)), dead_targets),
  lapply(stats::setNames(nm = markdown), dead_files)
)
dead <- dead[lengths(dead) > 0L]
cat(sprintf("%s: no target of %s\n", rep(names(dead), lengths(dead)), unlist(dead)), sep = "")
if (length(dead)) quit(status = 1L)
cat("Built", file.path(site$dst_path, "index.html"), "with", length(pages), "pages\n")
