# Cutting rates of netting edges (ISO 1532). N: point (one mesh down); T: mesh (one mesh across); B:
# bar (half a mesh down and half a mesh across).

# Longest cycle of points and bars that is written as one cycle.
longest_cycle <- 7L

# Returns the cutting rate of an edge that loses (or gains) `lost` meshes across in `deep` meshes
# down, in net makers' notation: "AN", "AB", "1N2B", "3T2B".
#
# If no short cycle fits, the edge alternates two cycles with their counts: "9(1N2B)+1(1N3B)".
# If the edge has no whole number of meshes, the result is the nearest short cycle: "~1N2B".
# Hexagonal netting and tapered square netting have no rule; the result is "".
#
# An edge d meshes down and l across has 2 l bars and d - l points if l < d, otherwise 2 d bars and
# l - d meshes.
cutting_rate <- function(lost, deep, orientation = "diamond") {
  lost <- abs(lost)
  if (deep == 0 || startsWith(orientation, "hexagonal")) return("")
  if (orientation == "square") return(if (lost == 0) "AB" else "")
  # Turned netting interchanges points and meshes.
  letters <- if (orientation == "turned") c("T", "N") else c("N", "T")
  if (lost == 0) return(paste0("A", letters[1]))
  if (lost == deep) return("AB")
  steps <- abs(deep - lost)
  bars <- 2 * min(lost, deep)
  letter <- letters[1L + (lost > deep)]
  # Fractional meshes become whole numbers over several identical edges.
  edges <- Find(function(k) all(abs(k * c(steps, bars) - round(k * c(steps, bars))) < 1e-6), 1:12)
  if (is.null(edges)) return(paste0("~", nearest_cycle(bars / steps, letter)))
  cycle <- round(edges * c(steps, bars))
  cycle <- cycle / greatest_divisor(cycle[1], cycle[2])
  one <- function(n, b) paste0(n, letter, b, "B")
  if (max(cycle) <= longest_cycle) return(one(cycle[1], cycle[2]))
  more <- max(cycle)
  fewer <- min(cycle)
  each <- more %/% fewer
  longer <- more - each * fewer
  pair <- function(k) if (cycle[1] >= cycle[2]) one(k, 1) else one(1, k)
  if (longer == 0) return(pair(each))
  paste0(fewer - longer, "(", pair(each), ")+", longer, "(", pair(each + 1), ")")
}

# Returns the meshes across that an edge loses per mesh of depth, from its cutting rate, for example
# "1N2B", "AB" or "9(1N2B)+1(1N3B)".
cutting_slope <- function(rate, path, orientation = "diamond") {
  if (startsWith(orientation, "hexagonal") || (orientation == "square" && rate != "AB")) {
    abort_field(path, rate, sprintf("omitted in %s netting: give the mesh counts", orientation))
  }
  if (orientation == "square") return(0)
  text <- toupper(gsub("[[:space:]]|^~", "", rate))
  text <- gsub("A([NTB])", "1\\1", text)
  cuts <- c(N = 0, T = 0, B = 0)
  for (term in strsplit(text, "+", fixed = TRUE)[[1]]) {
    times <- if (grepl("(", term, fixed = TRUE)) as.double(sub("\\(.*", "", term)) else 1
    if (is.na(times)) times <- 1
    cycle <- gsub(".*\\(|\\)", "", term)
    parts <- regmatches(cycle, gregexpr("[0-9]+[NTB]", cycle))[[1]]
    counts <- as.double(sub("[NTB]", "", parts)) * times
    letters <- sub("[0-9]+", "", parts)
    for (k in seq_along(parts)) cuts[[letters[k]]] <- cuts[[letters[k]]] + counts[k]
  }
  # Turned netting interchanges points and meshes.
  if (orientation == "turned") cuts[c("N", "T")] <- cuts[c("T", "N")]
  down <- cuts[["N"]] + cuts[["B"]] / 2
  if (down == 0) abort_field(path, rate, "a rate that advances in depth, such as 1N2B or AB")
  (cuts[["T"]] + cuts[["B"]] / 2) / down
}

# Returns the cycle with the nearest ratio of bars to points (or meshes).
nearest_cycle <- function(ratio, letter) {
  cycles <- expand.grid(n = seq_len(longest_cycle), b = seq_len(longest_cycle))
  best <- cycles[which.min(abs(log(cycles$b / cycles$n / ratio))), ]
  paste0(best$n, letter, best$b, "B")
}

greatest_divisor <- function(a, b) if (b == 0) a else greatest_divisor(b, a %% b)

# Returns a simple cutting rate, chosen in this order: 1. The shortest cycle of at most 12 cuts that
# ends within half a mesh of the counts. 2. A cycle that ends within one mesh, if this is less than
# 1/20 of the lost meshes (rounding). 3. "AB+2N": all bars with a few extra points or meshes, placed
# by the loft. 4. Two alternating cycles.
simple_cutting_rate <- function(lost, deep, orientation = "diamond") {
  exact <- cutting_rate(lost, deep, orientation)
  if (!grepl("[(~]", exact)) return(exact)
  lost <- abs(lost)
  near <- min(rounded_meshes, max(rounded_meshes / 2, lost / 20))
  straight <- if (orientation == "turned") "AT" else "AN"
  if (lost <= rounded_meshes / 2) return(straight)
  if (abs(lost - deep) <= near) return("AB")
  wide <- lost > deep
  letter <- if (xor(wide, orientation == "turned")) "T" else "N"
  cycles <- rbind(
    expand.grid(n = seq_len(5L), b = seq_len(12L)), expand.grid(n = 6:12, b = seq_len(5L)),
    cbind(n = 1, b = 13:40), cbind(n = 13:40, b = 1)
  )
  cycles <- cycles[order(cycles$n + cycles$b, cycles$n), ]
  bars <- cycles$b / 2
  slope <- if (wide) (cycles$n + bars) / bars else bars / (cycles$n + bars)
  off <- abs(slope * deep - lost)
  close <- which(off <= rounded_meshes / 2 & cycles$n + cycles$b <= 12)
  fits <- c(close, which(off <= near + 1e-9))[1]
  if (!is.na(fits)) return(paste0(cycles$n[fits], letter, cycles$b[fits], "B"))
  if (abs(lost - deep) <= few_steps) paste0("AB+", round(abs(lost - deep)), letter) else exact
}

# Largest number of extra points or meshes in an all-bar edge.
few_steps <- 4
