# A catch that netting is settled with.

# Whether netting holds another catch than before. Netting ahead of a catch has several balances,
# and which of them steps from a state lead to depends on its catch: the one that is found from
# nothing is taken from every start.
has_other_catch <- function(si, before) {
  held <- function(si) unlist(si$catch[c("blocked", "volume")])
  any(held(si) != held(before), na.rm = TRUE)
}

abort_catch_volume <- function(si, volume) {
  abort_plan(
    sprintf(
      "Plan field `catch` is %s; the netting of `catch.panels` holds %s when full.",
      format_si(si$catch$volume, "volume"), format_si(signif(volume, 4), "volume")
    ),
    "catch", si$catch$volume
  )
}
