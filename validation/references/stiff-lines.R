# Makes stiff-lines.csv: time integration of the lines of cases/stiff-lines.R. The fourth-order
# Runge-Kutta method with stable steps shares no line with the implicit schemes. It takes 20 CPU
# seconds.
library(codend)
as_gear <- codend:::as_gear
source("validation/manifest.R")
source("validation/cases/stiff-lines.R")

rows <- lapply(names(stiff_lines), function(name) {
  stiff_line_rows(name, integrate_stiff_line(name, scheme = "rk4"))
})
table <- do.call(rbind, rows)
table$value <- signif(table$value, 7)
utils::write.csv(table, "validation/references/stiff-lines.csv", row.names = FALSE, quote = FALSE)
