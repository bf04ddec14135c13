# Compares rows of cases with the bands of the manifest.

# rows: of all cases, from compared() and trend(). A quantity is `held` if the mean absolute misfit
# is within its band, a trend if all its signs are right. Tuned rows count only if there are no
# others: the quantity is then `tuned`. Returns a row per quantity and per trend of every case and
# varied value (by), with misfits in percent of the measured value.
judge <- function(rows, manifest) {
  # the first word of a trend's label is the varied value
  varied <- ifelse(rows$kind == "trend", sub(" .*", "", rows$at), "")
  key <- paste(rows$case, rows$kind, rows$quantity, varied, sep = "\r")
  by <- split(rows, factor(key, unique(key)))
  do.call(rbind, unname(lapply(by, function(of) {
    case <- manifest[[of$case[1]]]
    trend <- of$kind[1] == "trend"
    claim <- (if (trend) case$trends else case$quantities)[[of$quantity[1]]]
    if (is.null(claim)) stop("manifest, case ", case$id, ": it has no entry for ", of$quantity[1])
    counted <- of[!of$tuned, ]
    shown <- if (nrow(counted)) counted else of
    misfit <- 100 * (shown$computed / shown$measured - 1)
    right <- if (trend) {
      all(sign(shown$measured) == sign(shown$computed))
    } else {
      mean(abs(misfit)) <= claim$band
    }
    data.frame(
      case = case$id, group = case$group, kind = of$kind[1], quantity = of$quantity[1],
      by = if (trend) sub(" .*", "", of$at[1]) else "",
      unit = if (trend) "" else claim$unit, values = nrow(shown),
      measured = mean(shown$measured), computed = mean(shown$computed),
      bias = mean(misfit), misfit = mean(abs(misfit)), largest = max(abs(misfit)),
      band = if (trend) NA else claim$band,
      found = if (!nrow(counted)) "tuned" else if (right) "held" else "missed",
      status = claim$status, why = if (is.null(claim$why)) "" else claim$why
    )
  })))
}

# Overall misfit of the book: trawls against measured trawls, without tuned values.
trawl_misfit <- function(judged) {
  of <- judged[judged$group %in% c("flume", "hauls") & judged$kind == "quantity" &
    judged$found != "tuned", ]
  c(mean = mean(of$misfit), quantities = nrow(of))
}
