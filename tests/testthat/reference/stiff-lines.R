# Makes stiff-lines.csv: the lines of helper-stiff-lines.R marched by Runge and Kutta's method of
# fourth order in steps surely short enough to be stable, which shares no line with the implicit
# schemes. To be run in this folder; takes 20 CPU seconds.
library(codend)
as_gear <- codend:::as_gear
source("../helper-stiff-lines.R")

rows <- lapply(names(stiff_lines), function(name) {
  stiff_line_rows(name, march_stiff_line(name, scheme = "rk4"))
})
table <- do.call(rbind, rows)
table$value <- signif(table$value, 7)
utils::write.csv(table, "stiff-lines.csv", row.names = FALSE, quote = FALSE)
