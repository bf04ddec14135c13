# Prints of sensitivities.

# Smallest elasticity in prints, % per %.
smallest_elasticity <- 0.01

#' @rdname sensitivities
#' @param x Sensitivities.
#' @param n Number of fields to print. Default 20. `Inf` prints all fields and all measures.
#' @param ... Not used.
#' @export
print.codend_sensitivities <- function(x, n = most_rows, ...) {
  check_rows(n)
  # A subset of the columns prints as a plain data frame.
  if (!all(c("measure", "field", "value", "unit", "elasticity", "smooth") %in% names(x))) {
    print(as.data.frame(x), ...)
    return(invisible(x))
  }
  given <- x
  x <- in_printed_units(x)
  cat_wrapped("Sensitivities of \"", attr(x, "gear_name"),
    "\", % of the measure per % of the field", indent = 0L)
  shown <- printed_columns(x, n)
  size <- ifelse(is.na(x$elasticity), 0, abs(x$elasticity))
  large <- x$measure %in% shown & (size >= smallest_elasticity | is.infinite(n))
  most <- tapply(ifelse(large, size, -1), factor(x$field, unique(x$field)), max)
  fields <- names(most)[order(-most)]
  fields <- fields[most[fields] >= 0]
  small <- list(fields = setdiff(names(most), fields), measures = setdiff(shown, x$measure[large]))
  if (length(fields)) {
    kept <- x[x$field %in% fields & !x$measure %in% small$measures, ]
    kept <- kept[order(match(kept$field, fields)), ]
    cat_by_measure(kept, kept$field, function(rows) {
      list(headed("field", NULL, field_labels(kept$field[rows])))
    }, function(rows) elasticity_text(kept[rows, ]), n, "field", units = FALSE)
    if (!all(kept$smooth[kept$measure %in% shown])) {
      cat("  * not smooth: other values at 1 % less and 1 % more, see `secant_below`\n")
    }
  } else {
    cat("  No field changes these measures by ", smallest_elasticity, " % per % or more.\n",
      sep = "")
    return(invisible(given))
  }
  for (kind in names(small)) {
    if (length(small[[kind]])) {
      cat_wrapped("Below ", smallest_elasticity, " % per %: ", kind, " ",
        paste(small[[kind]], collapse = ", "))
    }
  }
  invisible(given)
}

elasticity_text <- function(rows) {
  text <- paste0(sprintf("%+.2f", rows$elasticity), ifelse(rows$smooth, " ", "*"))
  text[abs(rows$elasticity) < smallest_elasticity] <- "0 "
  text[is.na(rows$elasticity)] <- ""
  text
}

# Returns field names of at most 34 characters. Fields that change together have the name of the
# first.
field_labels <- function(fields) {
  name <- sub(" [+] .*", " ...", fields)
  ifelse(nchar(name) > 34L, paste0("... ", substring(name, nchar(name) - 29L)), name)
}

# Formats numbers with four digits.
sensitivity_digits <- function(x) {
  with_plain_numbers(vapply(x, function(one) format(signif(one, 4)), ""))
}
