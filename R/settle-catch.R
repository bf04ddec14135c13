# TRUE if the catch differs. A codend has several equilibria. Studies use a cold start, which makes
# their results independent of the initial state.
has_other_catch <- function(si, before) {
  held <- function(si) unlist(si$catch[c("blocked", "volume")])
  any(held(si) != held(before), na.rm = TRUE)
}

abort_catch_volume <- function(si, volume) {
  abort_field("catch", si$catch$volume, NULL, sprintf(
    "is %s, but the netting of `catch.panels` holds at most %s",
    format_si(si$catch$volume, "volume"), format_si(signif(volume, 4), "volume")
  ))
}
