# Unusual plans: generated from the schema, or shipped plans with random changes.

shipped <- lapply(codend:::shipped_plans(), codend:::read_plan)

one_of <- function(x) x[[sample.int(length(x), 1L)]]
chance <- function(share) stats::runif(1L) < share

# ---- values --------------------------------------------------------------------------------------

odd_numbers <- c(
  0, -0, -1, 1, 1e-300, 1e-12, 1e6, 1e9, 1e12, 1e15, 1e300, .Machine$double.xmax, 0.1 + 0.2, 2^31,
  2^53, Inf, -Inf, NaN, NA
)
odd_texts <- c(
  "", " ", "\n", "a\n", "1,5", "1,5 m", "1e400 m", "-0 kg", "nan", "inf m", "0x10", "1_000",
  "5 parsec", "yes", "NA", "~", "3 m m", "net.upper", "net.upper[0:1e9]", "net.upper[-1:2]",
  "net.upper[3:2]", "a.b.c.d", ".", "..", "[", "../../etc/passwd", "{x}", "{.val x}", "%s%s%n",
  "<script>alert(1)</script>", "=1+1", "\u00e9\u00e9", "\U1F41F", "\u202e", "__proto__",
  strrep("a", 5000L), "NULL", "TRUE"
)
odd_values <- list(
  NULL, list(), stats::setNames(list(), character()), TRUE, FALSE, list(1), list(NULL), c(1, 2, 3),
  c("a", "b"), list(a = 1), list(list(list())), as.list(1:50)
)

any_value <- function() {
  switch(sample.int(3L, 1L), one_of(odd_numbers), one_of(odd_texts), one_of(odd_values))
}

# A quantity as a string: usually a common value, else one over many powers of ten.
quantity <- function(node) {
  dimension <- node[["x-dimension"]]
  units <- codend:::plan_units[[dimension]]
  power <- if (chance(0.8)) c(-2, 3) else c(-14, 14)
  number <- signif(10^stats::runif(1L, power[1L], power[2L]), 4L) * if (chance(0.05)) -1 else 1
  if (chance(0.2)) number else paste(codend:::shortest_decimal(number), one_of(names(units)))
}

number <- function(node) {
  low <- c(node$minimum, node$exclusiveMinimum, 0)[1L]
  high <- c(node$maximum, 1000)[1L]
  x <- if (chance(0.1)) one_of(c(low, high, low - 1, high + 1, 1e9)) else {
    low + (min(high, 50) - low) * stats::runif(1L)^2
  }
  if (node$shape == "integer") round(x) else x
}

# ---- from the schema -----------------------------------------------------------------------------

# Values of shipped plans by field name, so that generated plans are not all rejected.
pool <- local({
  values <- list()
  walk <- function(tree) {
    for (name in names(tree)[nzchar(names(tree))]) {
      values[[name]] <<- c(values[[name]], list(tree[[name]]))
    }
    if (is.list(tree)) for (item in tree) walk(item)
  }
  for (plan in shipped) walk(plan)
  values
})

make_up <- function(node, name = "", depth = 0L) {
  if (chance(0.02)) return(any_value())
  if (nzchar(name) && name %in% names(pool) && chance(0.6)) return(one_of(pool[[name]]))
  switch(node$shape,
    quantity = quantity(node),
    number = , integer = if (!is.null(node$const)) node$const else number(node),
    boolean = chance(0.5),
    string = c(node$const, node$enum, if (is.null(c(node$const, node$enum))) c("a", odd_texts)) |>
      one_of(),
    array = lapply(seq_len(first_number(node$minItems, 0) + sample.int(3L, 1L) - 1L), function(k) {
      make_up(node$items, "", depth + 1L)
    }),
    object = made_map(node, depth),
    any = make_up(one_of(node$choices), name, depth)
  )
}

first_number <- function(x, otherwise) if (is.null(x)) otherwise else x

made_map <- function(node, depth) {
  names <- node$required
  for (group in node$groups) names <- c(names, one_of(group$choices))
  optional <- setdiff(names(node$properties), names)
  names <- c(names, optional[stats::runif(length(optional)) < 0.25 / (1 + depth)])
  names <- unique(names[stats::runif(length(names)) < 0.98])
  made <- lapply(stats::setNames(names, names), function(name) {
    make_up(node$properties[[name]], name, depth + 1L)
  })
  if (!is.null(node$additionalProperties)) {
    for (name in c("a", "b", "net", "a-1")[seq_len(sample.int(4L, 1L))]) {
      made[[name]] <- make_up(node$additionalProperties, "", depth + 1L)
    }
  }
  if (chance(0.3)) made[sample.int(length(made))] else made
}

made_plan <- function() {
  kind <- one_of(codend:::plan_kinds)
  # the sections of a shipped plan of the same kind, some generated, or all generated
  like <- Filter(function(plan) identical(codend:::first_of(plan$kind, "assembly"), kind), shipped)
  plan <- if (chance(0.3) || !length(like)) make_up(codend:::kind_node(kind)) else {
    plan <- one_of(like)
    for (name in sample(names(plan), min(length(plan), 1L + stats::rpois(1L, 0.7)))) {
      node <- codend:::kind_node(kind)$properties[[name]]
      if (!is.null(node)) plan[name] <- list(make_up(node, if (chance(0.5)) name else "", 1L))
    }
    plan
  }
  if (is.list(plan) && chance(0.97)) {
    plan$codend <- 1
    plan$kind <- kind
  }
  plan
}

# ---- changes -------------------------------------------------------------------------------------

# Changes one random node of a tree.
change <- function(tree) {
  if (!is.list(tree) || !length(tree) || chance(0.12)) return(changed_here(tree))
  k <- sample.int(length(tree), 1L)
  tree[k] <- list(change(tree[[k]]))
  tree
}

changed_here <- function(x) {
  if (is.list(x) && length(x) && !chance(0.15)) return(changed_list(x))
  if (is.numeric(x) && length(x) && !chance(0.2)) {
    k <- sample.int(length(x), 1L)
    factor <- one_of(c(0, -1, 0.5, 2, 10, 1e3, 1e6, 1e12, 1e-6))
    x[k] <- one_of(c(x[k] * factor, one_of(odd_numbers), x[k] + 0.5))
    return(x)
  }
  if (is.character(x) && length(x) && !chance(0.2)) {
    k <- sample.int(length(x), 1L)
    x[k] <- changed_text(x[k])
    return(x)
  }
  any_value()
}

changed_text <- function(text) {
  found <- codend:::split_quantity(text)
  if (is.null(found) || chance(0.1)) {
    if (chance(0.4)) return(one_of(odd_texts))
    at <- sample.int(nchar(text) + 1L, 1L)
    put <- one_of(c("", "x", "\n", ".", "[1:2]", "_2"))
    return(paste0(substr(text, 1L, at - 1L), put, substring(text, at + chance(0.5))))
  }
  number <- as.double(found[1L]) *
    one_of(c(0, -1, 0.3, 0.9, 1.1, 3, 10, 1e3, 1e6, 1e-3, 1e-9, 1e30))
  unit <- if (chance(0.7)) found[2L] else one_of(unlist(lapply(codend:::plan_units, names)))
  paste0(sprintf("%.6g", number), " ", unit)
}

changed_list <- function(x) {
  k <- sample.int(length(x), 1L)
  other <- sample.int(length(x), 1L)
  name <- c(names(x)[k], "")[1L]
  put <- function(value) replace(x, k, list(value))
  switch(sample.int(9L, 1L),
    x[-k],
    put(any_value()),
    x[sample.int(length(x))],
    c(x, x[k]),
    put(NULL),
    put(list()),
    if (is.null(names(x))) stats::setNames(x, rep("a", length(x))) else {
      stats::setNames(x, replace(names(x), k, changed_text(name)))
    },
    replace(x, c(k, other), x[c(other, k)]),
    if (name %in% names(pool)) put(one_of(pool[[name]])) else x
  )
}

changed_plan <- function() {
  plan <- one_of(shipped)
  for (k in seq_len(1L + stats::rpois(1L, 0.6))) plan <- change(plan)
  plan
}
