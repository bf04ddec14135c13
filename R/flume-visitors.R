# The visitors of a flume tank and their limits. A proxy gives the address of each visitor. Without
# a proxy, each page is a separate visitor.

# Limits for one visitor: pages at a time, changes of the shared folder within `change_time` s, and
# new designs in the folder within `day` s.
most_pages <- 8L
most_changes <- 10L
change_time <- 60
most_new_designs <- 50L
day <- 86400

# Returns the address that the last proxy gives, or NULL. A visitor can only write the addresses
# before it.
visitor_of <- function(request) {
  given <- request$HTTP_X_FORWARDED_FOR
  if (!is_text(given)) return(NULL)
  address <- trimws(sub(".*,", "", substr(given, 1L, 1000L)))
  if (nzchar(address)) address
}

# Returns a function(address) that returns a visitor with these functions. enter() counts a page and
# returns FALSE above the limit; leave() ends a page. change() counts a change of the folder, and
# add() a new design in it; both fail above the limit. now: clock [s].
new_visitors <- function(now = function() proc.time()[["elapsed"]]) {
  known <- new.env(parent = emptyenv())
  # Forgets visitors that have no page and no recent design.
  forget <- function() {
    idle <- Filter(function(name) {
      known[[name]]$pages == 0L && !any(known[[name]]$added > now() - day)
    }, ls(known))
    rm(list = idle, envir = known)
  }
  counted <- function(times, within, most, message) {
    times <- c(times[times > now() - within], now())
    if (length(times) > most) abort_argument(message)
    times
  }
  function(address) {
    if (!is.null(address)) forget()
    one <- if (!is.null(address)) known[[address]]
    if (is.null(one)) {
      one <- list2env(list(pages = 0L, changed = numeric(), added = numeric()))
      if (!is.null(address)) assign(address, one, known)
    }
    list(
      enter = function() {
        if (one$pages >= most_pages) return(FALSE)
        one$pages <- one$pages + 1L
        TRUE
      },
      leave = function() one$pages <- one$pages - 1L,
      change = function() {
        one$changed <- counted(one$changed, change_time, most_changes,
          "You changed too many shared designs; try again in a minute.")
      },
      add = function() {
        one$added <- counted(one$added, day, most_new_designs,
          "You shared {most_new_designs} new designs in a day, which is the limit. Change one of
          them, or wait until tomorrow.")
      }
    )
  }
}

# TRUE if a connection comes from the tank's own page. A browser lets any page connect to any
# server, but sends the page's origin. Other programs send no origin.
same_origin <- function(request) {
  origin <- request$HTTP_ORIGIN
  if (is.null(origin)) return(TRUE)
  host <- request$HTTP_HOST
  if (!is_text(origin) || !is_text(host)) return(FALSE)
  plain <- function(place, scheme) {
    sub(if (scheme == "https") ":443$" else ":80$", "", tolower(place))
  }
  scheme <- tolower(sub("://.*", "", origin))
  grepl("^https?://", tolower(origin)) &&
    plain(sub("^[^/]*//", "", origin), scheme) == plain(host, scheme)
}

# TRUE if the host of a connection is localhost, an IP address or one of `hosts`. Another name may
# belong to a page that directs its own name to this computer.
known_host <- function(request, hosts = NULL) {
  # Every browser sends a host.
  if (is.null(request$HTTP_HOST)) return(TRUE)
  host <- tolower(sub(":[0-9]+$", "", request$HTTP_HOST))
  host %in% c("localhost", tolower(hosts)) || grepl("^([0-9.]+|\\[[0-9a-f:]+\\])$", host)
}

# Headers of every response. RStudio shows the page in a frame of its own origin.
response_headers <- c(
  "Cache-Control" = "no-cache",
  "X-Content-Type-Options" = "nosniff", "Referrer-Policy" = "no-referrer",
  "Cross-Origin-Opener-Policy" = "same-origin", "Cross-Origin-Resource-Policy" = "same-origin",
  "Permissions-Policy" = "camera=(), geolocation=(), microphone=()",
  "Content-Security-Policy" = paste(
    "default-src 'none'; script-src 'self'; style-src 'self' 'unsafe-inline';",
    "img-src 'self' data: blob:; font-src 'self' data:; media-src blob:; connect-src 'self';",
    "object-src 'none'; base-uri 'none'; form-action 'none';",
    "frame-ancestors 'self' http://localhost:* http://127.0.0.1:*"
  )
)
