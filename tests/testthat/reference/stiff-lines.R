# Makes stiff-lines.csv: time integration of the lines of helper-stiff-lines.R. The fourth-order
# Runge-Kutta method with stable steps shares no line with the implicit schemes. Run it in this
# folder; it takes 20 CPU seconds.
library(codend)
as_gear <- codend:::as_gear
source("../helper-stiff-lines.R")

rows <- lapply(names(stiff_lines), function(name) {
  stiff_line_rows(name, integrate_stiff_line(name, scheme = "rk4"))
})
table <- do.call(rbind, rows)
table$value <- signif(table$value, 7)
utils::write.csv(table, "stiff-lines.csv", row.names = FALSE, quote = FALSE)
