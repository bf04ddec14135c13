# Cutting rates of netting edges, after ISO 1532: N a point (the cut runs down the netting by one
# mesh), T a mesh (across it by one mesh), B a bar (half a mesh down and half a mesh across).

# Longest cycle of points and bars that is still cut as one.
longest_cycle <- 7L

# The cutting rate of an edge that loses (or gains) `lost` meshes across in `deep` meshes down, as
# net makers write it: "AN", "AB", "1N2B", "3T2B". Where no short cycle fits, the two cycles that in
# turn make up the edge, each with how often it is cut: "9(1N2B)+1(1N3B)"; for an edge of no whole
# number of meshes the nearest short cycle: "~1N2B". "" where there is no rule: hexagonal netting,
# and square netting that tapers.
#
# Down d meshes and across l, the edge takes 2 l bars and d - l points where l < d, and 2 d bars and
# l - d meshes across where l > d.
cutting_rate <- function(lost, deep, orientation = "diamond") {
  lost <- abs(lost)
  if (deep == 0 || startsWith(orientation, "hexagonal")) return("")
  if (orientation == "square") return(if (lost == 0) "AB" else "")
  # In turned netting points and meshes change places.
  letters <- if (orientation == "turned") c("T", "N") else c("N", "T")
  if (lost == 0) return(paste0("A", letters[1]))
  if (lost == deep) return("AB")
  steps <- abs(deep - lost)
  bars <- 2 * min(lost, deep)
  letter <- letters[1L + (lost > deep)]
  # Half meshes, or thirds: as many edges as give whole numbers.
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

# Meshes across that an edge loses in a mesh down, by its cutting rate: "1N2B", "AB", or cycles in
# turn, each with how often it is cut, "9(1N2B)+1(1N3B)".
cutting_slope <- function(rate, path, orientation = "diamond") {
  if (startsWith(orientation, "hexagonal") || (orientation == "square" && rate != "AB")) {
    abort_field(path, rate, sprintf("left out of %s netting: give its counts", orientation))
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
  # in turned netting points and meshes change places
  if (orientation == "turned") cuts[c("N", "T")] <- cuts[c("T", "N")]
  down <- cuts[["N"]] + cuts[["B"]] / 2
  if (down == 0) abort_field(path, rate, "a rate that runs down the netting, such as 1N2B or AB")
  (cuts[["T"]] + cuts[["B"]] / 2) / down
}

# The cycle whose bars over points (or meshes) are nearest to a ratio.
nearest_cycle <- function(ratio, letter) {
  cycles <- expand.grid(n = seq_len(longest_cycle), b = seq_len(longest_cycle))
  best <- cycles[which.min(abs(log(cycles$b / cycles$n / ratio))), ]
  paste0(best$n, letter, best$b, "B")
}

greatest_divisor <- function(a, b) if (b == 0) a else greatest_divisor(b, a %% b)

# The rate that an edge is cut by in whole simple steps: the shortest cycle of a dozen cuts at most
# that ends within half a mesh of the counts; otherwise a cycle that ends within a mesh of them,
# where that is less than a twentieth of what the edge loses, as net makers round. All bars but for
# a few points or meshes, which a loft puts where the join has room for them, is "AB+2N"; else where
# no cycle does it is two cycles in turn.
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

# Points, or meshes across, that an edge of bars may have apart from its cycle.
few_steps <- 4
